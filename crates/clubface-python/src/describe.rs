//! Tables of the core: quantities, units, models, inputs, outputs.

use clubface_impact::describe::Tables;
use clubface_impact::flight::air;
use pyo3::prelude::*;
use pythonize::pythonize;
use serde::Serialize;

/// What serializes, as dictionaries, lists and numbers of Python.
pub fn describe<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    Ok(pythonize(py, value)?)
}

/// Every impact model: name, title, kind, summary, reference, laws, laws_without, face_in, lacks, gear_effect,
/// ball, valid (name, lower, upper) and parameters (name, unit, meaning, default, lower, upper, source).
#[pyfunction]
pub fn models(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().models)
}

/// Every quantity: name, symbol, SI unit, metric and golf (the unit people read, and digits behind the point), label,
/// meaning, sign (what positive means, or empty), sides (words for negative and positive, or None), synonyms in files.
#[pyfunction]
pub fn quantities(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().quantities)
}

/// Every unit: symbol, spellings, dimension, numerator, denominator and offset (SI value = value * numerator /
/// denominator + offset).
#[pyfunction]
pub fn units(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().units)
}

/// Every dimension: name, SI unit, metric and golf (how people read a quantity of it that has no entry of its own).
#[pyfunction]
pub fn dimensions(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().dimensions)
}

/// Inputs of an impact, in the order of the columns: name, unit, meaning, group, differentiable, lower, upper, half_of,
/// usual (least and greatest value).
#[pyfunction]
pub fn inputs(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().inputs)
}

/// Outputs of an impact, in order: name, unit, meaning.
#[pyfunction]
pub fn outputs(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().outputs)
}

/// Inputs of a flight, in order: name, unit, meaning, group, default, lower, upper, usual.
#[pyfunction]
pub fn flight_inputs(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().flight_inputs)
}

/// Outputs of a flight, in order: name, unit, meaning.
#[pyfunction]
pub fn flight_outputs(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().flight_outputs)
}

/// The shapes of shots: names by start and curve, and the limits straight_start, straight_curve and big_curve.
#[pyfunction]
pub fn shot_shapes(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    describe(py, &Tables::all().shot_shapes)
}

/// Air pressure, Pa, at an altitude, m, of the standard atmosphere.
#[pyfunction]
pub fn pressure_at_altitude(altitude: f64) -> f64 {
    air::pressure_at_altitude(altitude)
}
