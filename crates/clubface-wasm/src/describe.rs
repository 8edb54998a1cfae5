//! Tables of the core: models, inputs and outputs of impacts and flights.

use clubface_impact::flight;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::registry;
use clubface_impact::shot::INPUTS;
use clubface_impact::{Law, ModelInfo};
use serde_json::{json, Value};

fn laws(laws: &[Law]) -> Vec<&'static str> {
    laws.iter().map(|law| law.name()).collect()
}

fn model(info: &ModelInfo) -> Value {
    let parameters: Vec<Value> = info
        .parameters
        .iter()
        .map(|p| {
            json!({
                "name": p.name, "unit": p.unit, "meaning": p.meaning, "default": p.default, "lower": p.lower,
                "upper": p.upper, "source": p.source,
            })
        })
        .collect();
    json!({
        "name": info.name, "title": info.title, "kind": info.kind.name(), "summary": info.summary,
        "reference": info.reference, "laws": laws(info.laws),
        "face_in": info.face_in,
        "laws_without": info.laws_without.map(|(name, without)| json!([name, laws(without)])),
        "parameters": parameters,
    })
}

/// Leaves a description of all that can be computed: `models`, `inputs`, `outputs`, `flight_inputs`, `flight_outputs`,
/// as the functions of these names give Python. A default that is not a number is null.
#[no_mangle]
pub extern "C" fn describe() -> u32 {
    let models: Vec<Value> = registry::ALL.iter().map(|each| model(each.info())).collect();
    let inputs: Vec<Value> = INPUTS
        .iter()
        .map(|i| {
            json!({
                "name": i.name, "group": i.group, "unit": i.unit, "meaning": i.meaning,
                "differentiable": i.differentiable,
            })
        })
        .collect();
    let outputs: Vec<Value> =
        OUTPUTS.iter().map(|o| json!({"name": o.name, "unit": o.unit, "meaning": o.meaning})).collect();
    let flight_inputs: Vec<Value> = flight::INPUTS
        .iter()
        .map(|i| {
            json!({
                "name": i.name, "group": i.group, "unit": i.unit, "meaning": i.meaning, "sign": i.sign,
                "default": i.default, "lower": i.bounds.lower, "upper": i.bounds.upper,
            })
        })
        .collect();
    let flight_outputs: Vec<Value> = flight::OUTPUTS
        .iter()
        .map(|o| json!({"name": o.name, "unit": o.unit, "meaning": o.meaning, "sign": o.sign}))
        .collect();
    crate::finish(Ok(json!({
        "models": models, "inputs": inputs, "outputs": outputs, "flight_inputs": flight_inputs,
        "flight_outputs": flight_outputs,
    })))
}
