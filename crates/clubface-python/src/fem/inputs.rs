//! Balls, heads and runs as Python describes them.

use clubface_fem::FemError;
use clubface_fem::ball::{BallConstruction, BallPiece};
use clubface_fem::contact::Grooves;
use clubface_fem::element::{DEFAULT_POINTS, Element, Isotropic, Rule, ShellMaterial};
use clubface_fem::head::{DeformableHead, ShellHead, ShellPart, SolidHead};
use clubface_fem::material::{Hardening, Hencky, Material, Maxwell, VonMises, law_from_name};
use clubface_fem::mesh::{ShellMesh, SolidMesh};
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
    pub(super) safety: Option<f64>,
    pub(super) interval: f64,
    pub(super) until_separation: bool,
    pub(super) contact: String,
    pub(super) bulk_viscosity: f64,
    pub(super) threads: usize,
    pub(super) frames: usize,
    pub(super) fields: bool,
}

pub(super) fn to_py_error(error: &FemError) -> PyErr {
    match error {
        FemError::Input { name, value, allowed } => {
            PyValueError::new_err((name.clone(), value.clone(), allowed.clone()))
        }
        other => PyValueError::new_err(("", "", other.to_string())),
    }
}

pub(super) fn build_ball(values: &BallValues) -> PyResult<BallConstruction<f64>> {
    let mut pieces = Vec::new();
    for piece in &values.pieces {
        let law = law_from_name(&piece.law, &piece.constants).map_err(|e| to_py_error(&e))?;
        let maxwell = piece.maxwell.iter().map(|&(modulus, time)| Maxwell { modulus, time }).collect();
        let material = Material { law, bulk: piece.bulk, maxwell, density: piece.density };
        pieces.push(BallPiece {
            name: piece.name.clone(),
            radius: piece.radius,
            layers: piece.layers,
            material,
        });
    }
    let element = Element::from_name(&values.element).map_err(|e| to_py_error(&e))?;
    Ok(BallConstruction { pieces, cube: values.cube, element, mass: values.mass })
}

/// When and how a metal yields.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PlasticValues {
    yield_stress: f64,
    modulus: f64,
    gain: f64,
    rate: f64,
    /// Plastic strains and yield stresses, or none.
    table: Vec<(f64, f64)>,
}

pub(super) fn build_hardening(values: &PlasticValues, name: &str) -> PyResult<Hardening<f64>> {
    let law = if values.table.is_empty() {
        Hardening::linear(values.yield_stress, values.modulus)
    } else {
        Hardening::table(&values.table, name).map_err(|e| to_py_error(&e))?
    };
    Ok(if values.gain > 0.0 { law.saturating(values.gain, values.rate) } else { law })
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
    plastic: Option<PlasticValues>,
    /// Points through the thickness, and their rule.
    points: Option<usize>,
    rule: String,
    face: bool,
}

/// A solid head of one material that is linear in logarithmic strain.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct SolidValues<'py> {
    nodes: PyReadonlyArray1<'py, f64>,
    /// Eight nodes an element, in binary order.
    elements: PyReadonlyArray1<'py, u32>,
    face: PyReadonlyArray1<'py, u32>,
    added: PyReadonlyArray1<'py, f64>,
    shear: f64,
    bulk: f64,
    density: f64,
    plastic: Option<PlasticValues>,
    element: String,
    loft: f64,
    /// Width, depth, pitch, width of a wall.
    grooves: Option<[f64; 4]>,
}

/// A head that deforms.
#[derive(FromPyObject)]
pub enum AnyHead<'py> {
    #[pyo3(transparent)]
    Shells(HeadValues<'py>),
    #[pyo3(transparent)]
    Solid(SolidValues<'py>),
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

fn read_nodes(values: &PyReadonlyArray1<'_, f64>) -> PyResult<Vec<Vec3<f64>>> {
    Ok(values.as_slice()?.chunks_exact(3).map(|p| Vec3::new(p[0], p[1], p[2])).collect())
}

fn read_groups<const N: usize>(values: &PyReadonlyArray1<'_, u32>) -> PyResult<Vec<[u32; N]>> {
    Ok(values.as_slice()?.chunks_exact(N).map(|g| std::array::from_fn(|i| g[i])).collect())
}

fn check_one_mesh(fits: bool) -> PyResult<()> {
    let error = || PyValueError::new_err(("mesh of the head", "", "its arrays must belong to one mesh"));
    if fits { Ok(()) } else { Err(error()) }
}

pub(super) fn build_head(values: &AnyHead<'_>) -> PyResult<Box<dyn DeformableHead<f64>>> {
    Ok(match values {
        AnyHead::Shells(values) => Box::new(build_shell_head(values)?),
        AnyHead::Solid(values) => Box::new(build_solid_head(values)?),
    })
}

fn build_solid_head(values: &SolidValues<'_>) -> PyResult<SolidHead<f64>> {
    let (nodes, elements) = (read_nodes(&values.nodes)?, read_groups::<8>(&values.elements)?);
    let (face, added) = (read_groups::<4>(&values.face)?, values.added.as_slice()?.to_vec());
    let count = nodes.len();
    let named = elements.iter().flatten().chain(face.iter().flatten());
    check_one_mesh(added.len() == count && named.into_iter().all(|&n| (n as usize) < count))?;
    let shear = values.shear;
    let law = match &values.plastic {
        None => Hencky { shear }.law(),
        Some(plastic) => VonMises { shear, hardening: build_hardening(plastic, "head")? }.law(),
    };
    let material = Material { law, bulk: values.bulk, maxwell: vec![], density: values.density };
    let element = Element::from_name(&values.element).map_err(|e| to_py_error(&e))?;
    let layer = vec![0; elements.len()];
    let solid = SolidMesh { nodes, elements, layer };
    let grooves = values.grooves.map(|[width, depth, pitch, wall]| Grooves { width, depth, pitch, wall });
    Ok(SolidHead { solid, face, material, grooves, element, added, loft: values.loft })
}

pub(super) fn build_shell_head(values: &HeadValues<'_>) -> PyResult<ShellHead<f64>> {
    let (nodes, quads) = (read_nodes(&values.nodes)?, read_groups::<4>(&values.quads)?);
    let (thickness, added) = (values.thickness.as_slice()?.to_vec(), values.added.as_slice()?.to_vec());
    let (mut parts, mut start) = (Vec::new(), 0);
    for part in &values.parts {
        let elastic = Isotropic { young: part.youngs, poisson: part.poisson };
        let hardening =
            part.plastic.as_ref().map(|values| build_hardening(values, &part.name)).transpose()?;
        let points = part.points.or(hardening.map(|_| DEFAULT_POINTS));
        let points = points.map(|points| Rule::from_name(&part.rule, points).map_err(|e| to_py_error(&e)));
        let material =
            ShellMaterial { elastic, density: part.density, hardening, points: points.transpose()? };
        let elements = start..start + part.elements;
        start = elements.end;
        parts.push(ShellPart { name: part.name.clone(), elements, material, face: part.face });
    }
    let count = nodes.len();
    let named = quads.iter().flatten().all(|&n| (n as usize) < count);
    check_one_mesh(start == quads.len() && thickness.len() == start && added.len() == count && named)?;
    Ok(ShellHead { shells: ShellMesh { nodes, quads, thickness }, parts, added, loft: values.loft })
}
