//! What a metal and a wall of it are to the solver, for those who write them down for others.

use super::inputs::{PlasticValues, build_hardening, to_py_error};
use clubface_fem::element::Rule;
use pyo3::prelude::*;

/// Yield stress (Pa) of a metal at equivalent plastic strains.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_yield_stress(metal: PlasticValues, strains: Vec<f64>) -> PyResult<Vec<f64>> {
    let law = build_hardening(&metal, "metal")?;
    Ok(strains.into_iter().map(|strain| law.at(strain).0).collect())
}

/// Points through the thickness of a shell by a rule: places from -1 to 1, and weights, 2 in all.
#[pyfunction]
pub fn fem_thickness_points(count: usize, rule: &str) -> PyResult<Vec<(f64, f64)>> {
    Ok(Rule::from_name(rule, count).map_err(|e| to_py_error(&e))?.points())
}
