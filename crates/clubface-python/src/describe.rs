//! Tables of the core: quantities, units, models, inputs, outputs.

use clubface_impact::flight;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::quantity::{QUANTITIES, Quantity};
use clubface_impact::registry;
use clubface_impact::shot::INPUTS;
use clubface_impact::unit::{DIMENSIONS, Reading, UNITS};
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

/// Fills the keys of a quantity into a description.
fn set_quantity(dict: &Bound<'_, PyDict>, quantity: &Quantity) -> PyResult<()> {
    let reading = |reading: Reading| (reading.unit, reading.digits);
    dict.set_item("name", quantity.name)?;
    dict.set_item("symbol", quantity.symbol)?;
    dict.set_item("unit", quantity.unit)?;
    dict.set_item("metric", reading(quantity.metric))?;
    dict.set_item("golf", reading(quantity.golf))?;
    dict.set_item("label", quantity.label)?;
    dict.set_item("meaning", quantity.meaning)?;
    dict.set_item("sign", quantity.sign)?;
    dict.set_item("sides", quantity.sides)?;
    dict.set_item("synonyms", quantity.synonyms)
}

/// Every quantity: name, symbol, SI unit, metric and golf (the unit people read, and digits behind the point), label,
/// meaning, sign (what positive means, or empty), sides (words for negative and positive, or None), synonyms in files.
#[pyfunction]
pub fn quantities(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    QUANTITIES
        .iter()
        .map(|quantity| {
            let dict = PyDict::new(py);
            set_quantity(&dict, quantity)?;
            Ok(dict)
        })
        .collect()
}

/// Every unit: symbol, spellings, dimension, numerator, denominator and offset (SI value = value * numerator /
/// denominator + offset).
#[pyfunction]
pub fn units(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    UNITS
        .iter()
        .map(|unit| {
            let dict = PyDict::new(py);
            dict.set_item("symbol", unit.symbol)?;
            dict.set_item("spellings", unit.spellings.split_terminator(',').collect::<Vec<_>>())?;
            dict.set_item("dimension", unit.dimension)?;
            dict.set_item("numerator", unit.numerator)?;
            dict.set_item("denominator", unit.denominator)?;
            dict.set_item("offset", unit.offset)?;
            Ok(dict)
        })
        .collect()
}

/// Every dimension: name, SI unit, metric and golf (how people read a quantity of it that has no entry of its own).
#[pyfunction]
pub fn dimensions(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    DIMENSIONS
        .iter()
        .map(|dimension| {
            let dict = PyDict::new(py);
            dict.set_item("name", dimension.name)?;
            dict.set_item("unit", dimension.unit)?;
            dict.set_item("metric", (dimension.metric.unit, dimension.metric.digits))?;
            dict.set_item("golf", (dimension.golf.unit, dimension.golf.digits))?;
            Ok(dict)
        })
        .collect()
}

/// What a column says of its quantity: name, unit, and meaning with the sign.
fn column<'py>(py: Python<'py>, quantity: &Quantity) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("name", quantity.name)?;
    dict.set_item("unit", quantity.unit)?;
    dict.set_item("meaning", quantity.description())?;
    Ok(dict)
}

/// Inputs of an impact, in the order of the columns: name, unit, meaning, group, differentiable.
#[pyfunction]
pub fn inputs(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    INPUTS
        .iter()
        .map(|input| {
            let dict = column(py, input.quantity)?;
            dict.set_item("group", input.group)?;
            dict.set_item("differentiable", input.differentiable)?;
            Ok(dict)
        })
        .collect()
}

/// Outputs of an impact, in order: name, unit, meaning.
#[pyfunction]
pub fn outputs(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    OUTPUTS.iter().map(|quantity| column(py, quantity)).collect()
}

/// Inputs of a flight, in order: name, unit, meaning, group, default, lower, upper.
#[pyfunction]
pub fn flight_inputs(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    flight::INPUTS
        .iter()
        .map(|input| {
            let dict = column(py, input.quantity)?;
            dict.set_item("group", input.group)?;
            dict.set_item("default", input.default)?;
            dict.set_item("lower", input.bounds.lower)?;
            dict.set_item("upper", input.bounds.upper)?;
            Ok(dict)
        })
        .collect()
}

/// Outputs of a flight, in order: name, unit, meaning.
#[pyfunction]
pub fn flight_outputs(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    flight::OUTPUTS.iter().map(|quantity| column(py, quantity)).collect()
}

/// Air pressure, Pa, at an altitude, m, of the standard atmosphere.
#[pyfunction]
pub fn pressure_at_altitude(altitude: f64) -> f64 {
    flight::air::pressure_at_altitude(altitude)
}
