//! Tables of the core: quantities, units, models, inputs and outputs of impacts and flights.

use clubface_impact::flight::{self, FlightInput};
use clubface_impact::launch::OUTPUTS;
use clubface_impact::quantity::{QUANTITIES, Quantity};
use clubface_impact::registry;
use clubface_impact::shot::{INPUTS, Input};
use clubface_impact::unit::{DIMENSIONS, Dimension, Reading, UNITS, Unit};
use clubface_impact::{Law, ModelInfo};
use serde_json::{Value, json};

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

fn quantity(quantity: &Quantity) -> Value {
    let reading = |reading: Reading| json!([reading.unit, reading.digits]);
    json!({
        "name": quantity.name, "symbol": quantity.symbol, "unit": quantity.unit, "metric": reading(quantity.metric),
        "golf": reading(quantity.golf), "label": quantity.label, "meaning": quantity.meaning, "sign": quantity.sign,
        "sides": quantity.sides, "synonyms": quantity.synonyms,
    })
}

fn unit(unit: &Unit) -> Value {
    json!({
        "symbol": unit.symbol, "spellings": unit.spellings.split_terminator(',').collect::<Vec<_>>(),
        "dimension": unit.dimension, "numerator": unit.numerator, "denominator": unit.denominator,
        "offset": unit.offset,
    })
}

fn dimension(dimension: &Dimension) -> Value {
    json!({
        "name": dimension.name, "unit": dimension.unit,
        "metric": [dimension.metric.unit, dimension.metric.digits],
        "golf": [dimension.golf.unit, dimension.golf.digits],
    })
}

fn output(quantity: &&Quantity) -> Value {
    json!({"name": quantity.name, "unit": quantity.unit, "meaning": quantity.description()})
}

fn input(input: &Input) -> Value {
    json!({
        "name": input.quantity.name, "unit": input.quantity.unit, "meaning": input.quantity.description(),
        "group": input.group, "differentiable": input.differentiable,
    })
}

fn flight_input(input: &FlightInput) -> Value {
    json!({
        "name": input.quantity.name, "unit": input.quantity.unit, "meaning": input.quantity.description(),
        "group": input.group, "default": input.default, "lower": input.bounds.lower, "upper": input.bounds.upper,
    })
}

fn list<T>(entries: &[T], describe: impl Fn(&T) -> Value) -> Vec<Value> {
    entries.iter().map(describe).collect()
}

/// Leaves a description of all that can be computed: `quantities`, `units`, `dimensions`, `models`, `inputs`, `outputs`,
/// `flight_inputs`, `flight_outputs`, as the functions of these names give Python. A default that is not a number is
/// null.
#[unsafe(no_mangle)]
pub extern "C" fn describe() -> u32 {
    crate::finish(Ok(json!({
        "quantities": list(QUANTITIES, quantity), "units": list(UNITS, unit), "dimensions": list(DIMENSIONS, dimension),
        "models": list(registry::ALL, |each| model(each.info())), "inputs": list(&INPUTS, input),
        "outputs": list(&OUTPUTS, output), "flight_inputs": list(&flight::INPUTS, flight_input),
        "flight_outputs": list(&flight::OUTPUTS, output),
    })))
}
