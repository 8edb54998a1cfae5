//! Tables of the core: models, inputs, outputs.

use clubface_impact::flight;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::registry;
use clubface_impact::shot::INPUTS;
use clubface_impact::{Law, ModelInfo};
use pyo3::prelude::*;
use pyo3::types::PyDict;

fn model<'py>(py: Python<'py>, info: &ModelInfo) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("name", info.name)?;
    dict.set_item("title", info.title)?;
    dict.set_item("kind", info.kind.name())?;
    dict.set_item("summary", info.summary)?;
    dict.set_item("reference", info.reference)?;
    dict.set_item("laws", info.laws.iter().copied().map(Law::name).collect::<Vec<_>>())?;
    let without =
        info.laws_without.map(|(name, laws)| (name, laws.iter().copied().map(Law::name).collect::<Vec<_>>()));
    dict.set_item("laws_without", without)?;
    dict.set_item("face_in", info.face_in)?;
    let mut parameters = Vec::new();
    for parameter in info.parameters {
        let entry = PyDict::new(py);
        entry.set_item("name", parameter.name)?;
        entry.set_item("unit", parameter.unit)?;
        entry.set_item("meaning", parameter.meaning)?;
        entry.set_item("default", parameter.default)?;
        entry.set_item("lower", parameter.lower)?;
        entry.set_item("upper", parameter.upper)?;
        entry.set_item("source", parameter.source)?;
        parameters.push(entry);
    }
    dict.set_item("parameters", parameters)?;
    Ok(dict)
}

/// Every impact model: name, title, kind, summary, reference, laws and parameters (name, unit, meaning, default,
/// lower, upper, source).
#[pyfunction]
pub fn models(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    registry::ALL.iter().map(|each| model(py, each.info())).collect()
}

fn entry<'py>(py: Python<'py>, fields: &[(&str, &str)]) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for (key, value) in fields {
        dict.set_item(key, value)?;
    }
    Ok(dict)
}

/// Inputs of an impact, in the order of the columns: name, group, unit, meaning, differentiable.
#[pyfunction]
pub fn inputs(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    INPUTS
        .iter()
        .map(|i| {
            let fields = [("name", i.name), ("group", i.group), ("unit", i.unit), ("meaning", i.meaning)];
            let dict = entry(py, &fields)?;
            dict.set_item("differentiable", i.differentiable)?;
            Ok(dict)
        })
        .collect()
}

/// Outputs of an impact, in order: name, unit, meaning.
#[pyfunction]
pub fn outputs(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    OUTPUTS.iter().map(|o| entry(py, &[("name", o.name), ("unit", o.unit), ("meaning", o.meaning)])).collect()
}

/// Inputs of a flight, in order: name, group, unit, meaning, sign, default, lower, upper.
#[pyfunction]
pub fn flight_inputs(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    flight::INPUTS
        .iter()
        .map(|i| {
            let fields = [
                ("name", i.name),
                ("group", i.group),
                ("unit", i.unit),
                ("meaning", i.meaning),
                ("sign", i.sign),
            ];
            let dict = entry(py, &fields)?;
            dict.set_item("default", i.default)?;
            dict.set_item("lower", i.bounds.lower)?;
            dict.set_item("upper", i.bounds.upper)?;
            Ok(dict)
        })
        .collect()
}

/// Outputs of a flight, in order: name, unit, meaning, sign.
#[pyfunction]
pub fn flight_outputs(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    flight::OUTPUTS
        .iter()
        .map(|o| entry(py, &[("name", o.name), ("unit", o.unit), ("meaning", o.meaning), ("sign", o.sign)]))
        .collect()
}

/// Air pressure, Pa, at an altitude, m, of the standard atmosphere.
#[pyfunction]
pub fn pressure_at_altitude(altitude: f64) -> f64 {
    flight::air::pressure_at_altitude(altitude)
}
