//! What Python says about balls, heads and runs.

use clubface_fem::ball::{Ball, Piece};
use clubface_fem::element::{Element, Isotropic, ShellMaterial};
use clubface_fem::head::{ShellHead, ShellPart};
use clubface_fem::material::{Material, Maxwell, Shape};
use clubface_fem::mesh::ShellMesh;
use clubface_fem::FemError;
use clubface_math::Vec3;
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// One piece of a ball.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PieceValues {
    name: String,
    radius: f64,
    layers: usize,
    law: String,
    constants: Vec<f64>,
    bulk: f64,
    maxwell: Vec<(f64, f64)>,
    density: f64,
}

/// A ball.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct BallValues {
    pieces: Vec<PieceValues>,
    cube: usize,
    element: String,
    mass: Option<f64>,
}

/// How to run.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct RunValues {
    pub(super) duration: f64,
    pub(super) safety: f64,
    pub(super) interval: f64,
    pub(super) until_separation: bool,
    pub(super) threads: usize,
    pub(super) frames: usize,
}

pub(super) fn error_of(error: &FemError) -> PyErr {
    match error {
        FemError::Input { name, value, allowed } => {
            PyValueError::new_err((name.clone(), value.clone(), allowed.clone()))
        }
        other => PyValueError::new_err(("", "", other.to_string())),
    }
}

pub(super) fn ball_of(values: &BallValues) -> PyResult<Ball<f64>> {
    let mut pieces = Vec::new();
    for piece in &values.pieces {
        let shape = Shape::from_name(&piece.law, &piece.constants).map_err(|e| error_of(&e))?;
        let maxwell = piece.maxwell.iter().map(|&(modulus, time)| Maxwell { modulus, time }).collect();
        let material = Material { shape, bulk: piece.bulk, maxwell, density: piece.density };
        pieces.push(Piece { name: piece.name.clone(), radius: piece.radius, layers: piece.layers, material });
    }
    let element = Element::from_name(&values.element).map_err(|e| error_of(&e))?;
    Ok(Ball { pieces, cube: values.cube, element, mass: values.mass })
}

/// Shells of a head that follow each other.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PartValues {
    name: String,
    elements: usize,
    youngs: f64,
    poisson: f64,
    density: f64,
    face: bool,
}

/// A head of shells.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct HeadValues<'py> {
    nodes: PyReadonlyArray1<'py, f64>,
    quads: PyReadonlyArray1<'py, u32>,
    thickness: PyReadonlyArray1<'py, f64>,
    added: PyReadonlyArray1<'py, f64>,
    parts: Vec<PartValues>,
    loft: f64,
}

pub(super) fn head_of(values: &HeadValues<'_>) -> PyResult<ShellHead<f64>> {
    let nodes: Vec<_> =
        values.nodes.as_slice()?.chunks_exact(3).map(|p| Vec3::new(p[0], p[1], p[2])).collect();
    let quads: Vec<_> = values.quads.as_slice()?.chunks_exact(4).map(|q| [q[0], q[1], q[2], q[3]]).collect();
    let (thickness, added) = (values.thickness.as_slice()?.to_vec(), values.added.as_slice()?.to_vec());
    let (mut parts, mut start) = (Vec::new(), 0);
    for part in &values.parts {
        let elastic = Isotropic { young: part.youngs, poisson: part.poisson };
        let material = ShellMaterial { elastic, density: part.density };
        let elements = start..start + part.elements;
        start = elements.end;
        parts.push(ShellPart { name: part.name.clone(), elements, material, face: part.face });
    }
    let count = nodes.len();
    if start != quads.len()
        || thickness.len() != start
        || added.len() != count
        || quads.iter().flatten().any(|&n| n as usize >= count)
    {
        return Err(PyValueError::new_err(("mesh of the head", "", "arrays of one mesh are needed")));
    }
    Ok(ShellHead { shells: ShellMesh { nodes, quads, thickness }, parts, added, loft: values.loft })
}
