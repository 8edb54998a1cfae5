//! Heads of shells: the parametric driver as a mesh, mass properties of any mesh.

use super::inputs::{AnyHead, build_head, to_py_error};
use clubface_fem::element::{Isotropic, ShellMaterial};
use clubface_fem::head::Driver;
use clubface_fem::mesh::{
    DriverFineness, DriverShape, DriverThickness, IronFineness, IronShape, MassProperties, Target, Trim,
};
use clubface_math::Vec3;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A mass that may be added: name, place (m), most (kg).
type TrimValues = (String, [f64; 3], f64);

/// A parametric driver head.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct DriverValues {
    /// Loft, bulge, roll, width, depth, crown, sole, rounding.
    shape: [f64; 8],
    elements: [usize; 3],
    /// Face centre, face edge, crown, sole, skirt.
    thickness: [f64; 5],
    /// Young's modulus, Poisson's ratio, density.
    metal: [f64; 3],
    scales: (f64, f64),
    trims: Vec<TrimValues>,
    mass: f64,
    centre: [Option<f64>; 3],
    /// Height of the mass centre above the normal at the face centre.
    above: Option<f64>,
    inertia: [Option<f64>; 3],
}

fn build_driver(values: DriverValues) -> Driver<f64> {
    let [loft, bulge, roll, width, depth, crown, sole, rounding] = values.shape;
    let shape = DriverShape { loft, bulge, roll, width, depth, crown, sole, rounding };
    let [face_centre, face_edge, crown, sole, skirt] = values.thickness;
    let [young, poisson, density] = values.metal;
    let trims = values.trims.into_iter();
    let (mass, centre, inertia) = (values.mass, values.centre, values.inertia);
    Driver {
        shape,
        fineness: DriverFineness(values.elements),
        thickness: DriverThickness { face_centre, face_edge, crown, sole, skirt },
        metal: ShellMaterial::elastic(Isotropic { young, poisson }, density),
        scales: values.scales,
        trims: trims.map(|(name, at, most)| Trim { name, at: Vec3::from_f64(at), most }).collect(),
        target: Target { mass, centre, above: values.above, inertia },
    }
}

/// The mesh of a parametric driver, tuned: {nodes, quads, thickness, added, parts: [(name, elements)], scale, trims}.
#[pyfunction]
pub fn fem_driver(py: Python<'_>, driver: DriverValues) -> PyResult<Bound<'_, PyDict>> {
    let meshed = build_driver(driver).mesh().map_err(|e| to_py_error(&e))?;
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

/// The mesh of a parametric iron: {nodes, elements: 8 an element in binary order, face}. `shape`: loft, length, height
/// at heel and toe, thickness of face, sole and top line, rim, rounding.
#[pyfunction]
pub fn fem_iron(py: Python<'_>, shape: [f64; 9], elements: [usize; 3]) -> PyResult<Bound<'_, PyDict>> {
    let [loft, length, heel_height, toe_height, face, sole, top, rim, rounding] = shape;
    let shape = IronShape { loft, length, heel_height, toe_height, face, sole, top, rim, rounding };
    let mesh = shape.mesh(IronFineness(elements));
    let dict = PyDict::new(py);
    dict.set_item("nodes", PyArray1::from_iter(py, mesh.solid.nodes.iter().flat_map(|p| p.array())))?;
    dict.set_item("elements", PyArray1::from_iter(py, mesh.solid.elements.iter().copied().flatten()))?;
    dict.set_item("face", PyArray1::from_iter(py, mesh.face.iter().copied().flatten()))?;
    Ok(dict)
}

/// Mass properties of a head that deforms: {mass, centre, inertia: (3, 3)}, in the axes of its nodes.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_head_properties<'py>(py: Python<'py>, head: AnyHead<'py>) -> PyResult<Bound<'py, PyDict>> {
    let head = build_head(&head)?;
    head.check().map_err(|e| to_py_error(&e))?;
    let MassProperties { mass, centre, inertia } = head.mass_properties();
    let dict = PyDict::new(py);
    dict.set_item("mass", mass)?;
    dict.set_item("centre", centre.array())?;
    dict.set_item("inertia", PyArray2::from_vec2(py, &inertia.rows.map(|r| r.array().to_vec()))?)?;
    Ok(dict)
}
