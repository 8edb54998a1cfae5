//! Heads: the parametric driver and iron as meshes, mass properties of any mesh, metals and walls as the solver takes them.

use super::described::{Described, to_py_error};
use clubface_fem::description::{DriverDescription, HeadDescription, PlasticDescription};
use clubface_fem::element::Rule;
use clubface_fem::mesh::{IronFineness, IronShape, MassProperties};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The mesh of a parametric driver, tuned: {nodes, quads, thickness, added, parts: [(name, elements)], scale, trims}.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_driver(py: Python<'_>, driver: Described<DriverDescription>) -> PyResult<Bound<'_, PyDict>> {
    let meshed = driver.0.build().mesh().map_err(|e| to_py_error(&e))?;
    let shells = &meshed.head.shells;
    let dict = PyDict::new(py);
    dict.set_item("nodes", PyArray1::from_iter(py, shells.nodes.iter().flat_map(|p| p.array())))?;
    dict.set_item("quads", PyArray1::from_iter(py, shells.quads.iter().copied().flatten()))?;
    dict.set_item("thickness", PyArray1::from_slice(py, &shells.thickness))?;
    dict.set_item("added", PyArray1::from_slice(py, &meshed.head.added))?;
    let parts: Vec<_> =
        meshed.head.parts.iter().map(|part| (part.name.clone(), part.elements.len())).collect();
    dict.set_item("parts", parts)?;
    dict.set_item("scale", meshed.tuned.scale)?;
    dict.set_item("trims", meshed.tuned.trims)?;
    Ok(dict)
}

/// The mesh of a parametric iron: {nodes, elements: 8 an element in binary order, face}.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_iron(
    py: Python<'_>,
    shape: Described<IronShape>,
    elements: [usize; 3],
) -> PyResult<Bound<'_, PyDict>> {
    let mesh = shape.0.mesh(IronFineness(elements));
    let dict = PyDict::new(py);
    dict.set_item("nodes", PyArray1::from_iter(py, mesh.solid.nodes.iter().flat_map(|p| p.array())))?;
    dict.set_item("elements", PyArray1::from_iter(py, mesh.solid.elements.iter().copied().flatten()))?;
    dict.set_item("face", PyArray1::from_iter(py, mesh.face.iter().copied().flatten()))?;
    Ok(dict)
}

/// Mass properties of a head that deforms: {mass, centre, inertia: (3, 3)}, in the axes of its nodes.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_head_properties(py: Python<'_>, head: Described<HeadDescription>) -> PyResult<Bound<'_, PyDict>> {
    let head = head.0.build().map_err(|e| to_py_error(&e))?;
    head.check().map_err(|e| to_py_error(&e))?;
    let MassProperties { mass, centre, inertia } = head.mass_properties();
    let dict = PyDict::new(py);
    dict.set_item("mass", mass)?;
    dict.set_item("centre", centre.array())?;
    dict.set_item("inertia", PyArray2::from_vec2(py, &inertia.rows.map(|r| r.array().to_vec()))?)?;
    Ok(dict)
}

/// Yield stress (Pa) of a metal at equivalent plastic strains.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_yield_stress(metal: Described<PlasticDescription>, strains: Vec<f64>) -> PyResult<Vec<f64>> {
    let law = metal.0.build("metal").map_err(|e| to_py_error(&e))?;
    Ok(strains.into_iter().map(|strain| law.at(strain).0).collect())
}

/// Points through the thickness of a shell by a rule: places from -1 to 1, and weights, 2 in all.
#[pyfunction]
pub fn fem_thickness_points(count: usize, rule: &str) -> PyResult<Vec<(f64, f64)>> {
    Ok(Rule::from_name(rule, count).map_err(|e| to_py_error(&e))?.points())
}
