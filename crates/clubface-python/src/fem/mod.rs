//! Impacts by finite elements: a ball and what it meets go in, records come out.

mod described;
mod heads;
mod run;

pub use heads::{fem_driver, fem_head_properties, fem_iron, fem_thickness_points, fem_yield_stress};
pub use run::FemImpact;

use crate::columns::Derivatives;
use crate::describe::describe;
use clubface_fem::FemError;
use clubface_fem::description::{BallDescription, CaseDescription};
use clubface_fem::environment::Environment;
use clubface_fem::material::{
    DERIVATIVES, Energy, LAWS, Law, LawFunction, OwnFunction, Volumetric, map_law, register_law,
    unchecked_law,
};
use clubface_fem::solve::Progress;
use clubface_math::Dual;
use described::{Described, to_py_error};
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use run::{on_threads, record, run_pool};
use std::sync::Arc;

/// The laws that files choose by name: [{name, summary, source, constants: [{name, dimension, meaning, least, most}, ...],
/// needed: how many of them, group: how many more at a time}, ...].
#[pyfunction]
pub fn fem_laws(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let laws: Vec<_> = LAWS.iter().map(|entry| entry.description).filter(|law| law.listed).collect();
    describe(py, &laws)
}

/// Makes a function of C at an address a law that materials name, with the names of its constants, values of them (SI) to
/// check it with, and its number of state variables; returns its shear modulus (Pa).
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_register_law(
    name: &str,
    address: usize,
    constants: Vec<String>,
    values: Vec<f64>,
    states: usize,
) -> PyResult<f64> {
    if address == 0 {
        return Err(PyValueError::new_err("a null address"));
    }
    // SAFETY: whoever registers the law promises a function of this kind at the address.
    let function = unsafe { std::mem::transmute::<usize, LawFunction>(address) };
    // SAFETY: as above.
    let function = unsafe { OwnFunction::new(name, constants, states, function) };
    function.and_then(|function| register_law(function, &values)).map_err(|e| to_py_error(&e))
}

/// The law of a piece: one by name, or an energy with its constants.
fn law_of(law: &str, constants: &[f64], energy: Option<&str>) -> Result<Arc<dyn Law<f64>>, FemError> {
    match energy {
        Some(energy) => Arc::new(Energy::new(energy)?).law(constants),
        None => unchecked_law(law, constants),
    }
}

/// Raises ValueError(name, value, allowed) for constants (SI) that a law, or an energy, does not allow.
#[pyfunction]
#[pyo3(signature = (law, constants, energy=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_check_law(law: &str, constants: Vec<f64>, energy: Option<&str>) -> PyResult<()> {
    law_of(law, &constants, energy).and_then(|made| made.check(law)).map_err(|e| to_py_error(&e))
}

/// Shear modulus of a law by name, or of an energy (Pa), and its derivatives by the constants (SI), which are not
/// checked.
#[pyfunction]
#[pyo3(signature = (law, constants, energy=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_shear(law: &str, constants: Vec<f64>, energy: Option<&str>) -> PyResult<(f64, Vec<f64>)> {
    let made = law_of(law, &constants, energy).map_err(|e| to_py_error(&e))?;
    let slope = |chosen: usize| {
        let mut place = 0;
        let lifted: Arc<dyn Law<Dual<f64, DERIVATIVES>>> = map_law(&*made, &mut |_, value| {
            place += 1;
            if place == chosen + 1 { Dual::variable(value, 0) } else { Dual::constant(value) }
        });
        lifted.shear().tangent[0]
    };
    Ok((made.shear(), (0..constants.len()).map(slope).collect()))
}

/// Names of the constants of an energy, in the order in which they come in it.
#[pyfunction]
pub fn fem_energy(energy: &str) -> PyResult<Vec<String>> {
    Ok(Energy::new(energy).map_err(|e| to_py_error(&e))?.constants().to_vec())
}

/// Energy of the change of volume (J/m3) and its first two derivatives (Pa) at some ratios of volumes, a row each; raises
/// ValueError(name, value, allowed) for one that is not allowed.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_volumetric(energy: &str, bulk: f64, ratios: Vec<f64>) -> PyResult<Vec<[f64; 3]>> {
    let energy = Volumetric::new(energy).map_err(|e| to_py_error(&e))?;
    Ok(ratios.into_iter().map(|ratio| energy.evaluate(bulk, ratio)).collect())
}

/// Energy (J/m3) and its derivatives by both invariants (Pa) at some of these, a row each.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_energy_values(
    energy: &str,
    constants: Vec<f64>,
    invariants: Vec<[f64; 2]>,
) -> PyResult<Vec<[f64; 3]>> {
    let energy = Arc::new(Energy::new(energy).map_err(|e| to_py_error(&e))?);
    energy.law(&constants).map_err(|e| to_py_error(&e))?;
    let row = |at: [f64; 2]| {
        let (value, [first, second], _) = energy.evaluate(&constants, at);
        [value, first, second]
    };
    Ok(invariants.into_iter().map(row).collect())
}

/// Where a material of an energy loses its stiffness within the stretches of impacts: (kind of stretch, stretch, whether
/// the energy is no number there); None if nowhere.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_energy_instability(
    energy: &str,
    constants: Vec<f64>,
) -> PyResult<Option<(&'static str, f64, bool)>> {
    let energy = Arc::new(Energy::new(energy).map_err(|e| to_py_error(&e))?);
    energy.law(&constants).map_err(|e| to_py_error(&e))?;
    Ok(energy.instability(&constants).map(|at| (at.mode, at.stretch, at.undefined)))
}

/// Mass properties of a meshed ball: {mass, inertia, core_density, radius, nodes, elements}.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_ball(py: Python<'_>, ball: Described<BallDescription>) -> PyResult<Bound<'_, PyDict>> {
    let ball = ball.0.build().map_err(|e| to_py_error(&e))?;
    let still = clubface_math::Mat3::diagonal(1.0);
    let meshed = ball.mesh(&still, clubface_math::Vec3::zero()).map_err(|e| to_py_error(&e))?;
    let dict = PyDict::new(py);
    dict.set_item("mass", meshed.mass)?;
    dict.set_item("inertia", meshed.inertia)?;
    dict.set_item("core_density", meshed.core_density)?;
    dict.set_item("radius", meshed.radius)?;
    dict.set_item("nodes", meshed.mesh.nodes.len())?;
    dict.set_item("elements", meshed.mesh.elements.len())?;
    Ok(dict)
}

/// The mesh of a ball about the origin, its pole of first contact along -x: {nodes: (n, 3), elements: (m, 8) in the
/// order round the bottom, then round the top, piece: (m,), density: one a piece}.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_mesh(py: Python<'_>, ball: Described<BallDescription>) -> PyResult<Bound<'_, PyDict>> {
    const ROUND: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];
    let ball = ball.0.build().map_err(|e| to_py_error(&e))?;
    let still = clubface_math::Mat3::diagonal(1.0);
    let meshed = ball.mesh(&still, clubface_math::Vec3::zero()).map_err(|e| to_py_error(&e))?;
    let nodes: Vec<Vec<f64>> = meshed.mesh.nodes.iter().map(|p| p.array().to_vec()).collect();
    let elements: Vec<Vec<u32>> =
        meshed.mesh.elements.iter().map(|e| ROUND.iter().map(|&corner| e[corner]).collect()).collect();
    let dict = PyDict::new(py);
    dict.set_item("nodes", PyArray2::from_vec2(py, &nodes)?)?;
    dict.set_item("elements", PyArray2::from_vec2(py, &elements)?)?;
    dict.set_item("piece", PyArray1::from_slice(py, &meshed.mesh.layer))?;
    let densities = ball.pieces.iter().skip(1).map(|piece| piece.material.density);
    dict.set_item("density", std::iter::once(meshed.core_density).chain(densities).collect::<Vec<f64>>())?;
    Ok(dict)
}

/// An impact: a case as a dictionary of `ball`, `face`, `friction` and `run` (see `clubface_fem::description`).
#[pyfunction]
#[pyo3(signature = (case, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_impact<'py>(
    py: Python<'py>,
    case: Described<CaseDescription>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<FemImpact> {
    let Described(case) = case;
    let pool = run_pool(&case.run)?;
    // Threads that look for the stable step call laws of one's own, which may be Python's.
    let built = py.detach(|| case.simulation(&Environment::with_pool(&pool)));
    let (mut simulation, touch) = built.map_err(|e| to_py_error(&e))?;
    record(py, &mut simulation, &pool, &case.run, touch.as_ref(), progress)
}

/// Names of the variables of [`fem_sensitivity`].
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_variables(case: Described<CaseDescription>) -> PyResult<Vec<String>> {
    Ok(case.0.setup().map_err(|e| to_py_error(&e))?.variables())
}

/// Launch of a shot with a head of shells, or else the rigid one of the inputs, and its derivatives in some directions,
/// each a list of variables and how much they change: (outputs, array of outputs by directions). `progress` is called
/// with the run (one for every four directions), simulated time and duration.
#[pyfunction]
#[pyo3(signature = (case, directions, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_sensitivity<'py>(
    py: Python<'py>,
    case: Described<CaseDescription>,
    directions: Vec<Vec<(String, f64)>>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Derivatives<'py>> {
    let Described(case) = case;
    let setting = case.setup().map_err(|e| to_py_error(&e))?;
    let (pool, options) = (run_pool(&case.run)?, case.run.options().map_err(|e| to_py_error(&e))?);
    let mut raised = None;
    let result = py.detach(|| {
        let mut observer = |index: usize, at: &Progress| {
            // Signals reach Python's main thread alone, which ends a run through its progress.
            let called = Python::attach(|py| {
                progress.as_ref().map_or(Ok(()), |f| f.call1(py, (index, at.time, at.duration)).map(|_| ()))
            });
            called.map_err(|error| raised = Some(error)).is_ok()
        };
        on_threads(&pool, || {
            setting.sensitivity(&directions, &options, &Environment::with_pool(&pool), &mut observer)
        })
    });
    if let Some(error) = raised {
        return Err(error);
    }
    let result = result.map_err(|e| to_py_error(&e))?;
    Ok((PyArray1::from_slice(py, &result.values), PyArray2::from_vec2(py, &result.jacobian)?))
}
