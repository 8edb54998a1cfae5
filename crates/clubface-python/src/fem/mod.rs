//! Impacts by finite elements: a ball and what it meets go in, records come out.

mod heads;
mod inputs;
mod metals;
mod run;

pub use heads::{fem_driver, fem_head_properties, fem_iron};
pub use metals::{fem_thickness_points, fem_yield_stress};

use crate::columns::Derivatives;
use clubface_fem::cases::{ball_against_deformable_head, ball_against_plane, ball_against_rigid_head};
use clubface_fem::environment::Environment;
use clubface_fem::material::{LAWS, entry_from_name, law_from_name};
use clubface_fem::sensitivity::ImpactSetup;
use clubface_fem::solve::Progress;
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::shot::{INPUT_COUNT, Shot};
use clubface_math::Dual;
use inputs::{
    AnyHead, BallValues, HeadValues, RunValues, build_ball, build_head, build_shell_head, to_py_error,
};
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
pub use run::FemImpact;
use run::{on_threads, record, run_options, run_pool};

/// The laws that files choose by name: [{name, summary, source, constants, dimensions, meanings, bounds: (least, most),
/// each one a constant, needed: how many of them, group: how many more at a time}, ...].
#[pyfunction]
pub fn fem_laws(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    let list = PyList::empty(py);
    for law in LAWS.iter().map(|entry| entry.description).filter(|law| law.listed) {
        let entry = PyDict::new(py);
        entry.set_item("name", law.name)?;
        entry.set_item("constants", law.constants.iter().map(|c| c.name).collect::<Vec<_>>())?;
        entry.set_item("dimensions", law.constants.iter().map(|c| c.dimension).collect::<Vec<_>>())?;
        entry.set_item("needed", law.needed)?;
        entry.set_item("group", law.group)?;
        entry.set_item("summary", law.summary)?;
        entry.set_item("source", law.source)?;
        entry.set_item("meanings", law.constants.iter().map(|c| c.meaning).collect::<Vec<_>>())?;
        entry.set_item("bounds", law.constants.iter().map(|c| (c.least, c.most)).collect::<Vec<_>>())?;
        list.append(entry)?;
    }
    Ok(list)
}

/// Raises ValueError(name, value, allowed) for constants (SI) that a law does not allow.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_check_law(law: &str, constants: Vec<f64>) -> PyResult<()> {
    law_from_name(law, &constants).map(|_| ()).map_err(|e| to_py_error(&e))
}

/// Shear modulus of a law by name (Pa), and its derivatives by the constants (SI), which are not checked.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_shear(law: &str, constants: Vec<f64>) -> PyResult<(f64, Vec<f64>)> {
    let entry = entry_from_name(LAWS, law, constants.len()).map_err(|e| to_py_error(&e))?;
    let slope = |i: usize| {
        let mut lifted: Vec<_> = constants.iter().map(|&value| Dual::constant(value)).collect();
        lifted[i] = Dual::variable(constants[i], 0);
        (entry.derived)(&lifted).shear().tangent[0]
    };
    Ok(((entry.plain)(&constants).shear(), (0..constants.len()).map(slope).collect()))
}

/// Mass properties of a meshed ball: {mass, inertia, core_density, radius, nodes, elements}.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_ball<'py>(py: Python<'py>, ball: BallValues) -> PyResult<Bound<'py, PyDict>> {
    let ball = build_ball(&ball)?;
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
pub fn fem_mesh<'py>(py: Python<'py>, ball: BallValues) -> PyResult<Bound<'py, PyDict>> {
    const ROUND: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];
    let ball = build_ball(&ball)?;
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

/// A ball thrown at a rigid plane at `speed` (m/s) and `angle` (rad) from its normal.
#[pyfunction]
#[pyo3(signature = (ball, speed, angle, friction, run, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_plane<'py>(
    py: Python<'py>,
    ball: BallValues,
    speed: f64,
    angle: f64,
    friction: f64,
    run: RunValues,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<FemImpact> {
    let (pool, ball) = (run_pool(&run)?, build_ball(&ball)?);
    let mut simulation = ball_against_plane(&ball, speed, angle, friction, &Environment::with_pool(&pool))
        .map_err(|e| to_py_error(&e))?;
    record(py, &mut simulation, &pool, &run, None, progress)
}

/// A shot with a rigid head; `inputs` in the order of `inputs()`. Mass, radius and inertia of the ball come from the
/// mesh.
#[pyfunction]
#[pyo3(signature = (ball, inputs, friction, run, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_head<'py>(
    py: Python<'py>,
    ball: BallValues,
    inputs: Vec<f64>,
    friction: f64,
    run: RunValues,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<FemImpact> {
    let (pool, touch, ball) = (run_pool(&run)?, first_touch(&inputs)?, build_ball(&ball)?);
    let mut simulation = ball_against_rigid_head(&ball, &touch, friction, &Environment::with_pool(&pool))
        .map_err(|e| to_py_error(&e))?;
    record(py, &mut simulation, &pool, &run, Some(&touch), progress)
}

/// A shot with a head that deforms; `inputs` as for [`fem_head`]; those of the clubhead are the head's.
#[pyfunction]
#[pyo3(signature = (ball, head, inputs, friction, run, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_deformable<'py>(
    py: Python<'py>,
    ball: BallValues,
    head: AnyHead<'py>,
    inputs: Vec<f64>,
    friction: f64,
    run: RunValues,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<FemImpact> {
    let (pool, touch, ball, head) =
        (run_pool(&run)?, first_touch(&inputs)?, build_ball(&ball)?, build_head(&head)?);
    let mut simulation =
        ball_against_deformable_head(&*head, &ball, &touch, friction, &Environment::with_pool(&pool))
            .map_err(|e| to_py_error(&e))?;
    record(py, &mut simulation, &pool, &run, Some(&touch), progress)
}

/// Both bodies at first touch, for inputs in the order of `inputs()`.
fn first_touch(inputs: &[f64]) -> PyResult<FirstTouch<f64>> {
    let inputs: &[f64; INPUT_COUNT] =
        inputs.try_into().map_err(|_| PyValueError::new_err(("inputs", "", "all are needed")))?;
    clubface_impact::check::check(inputs).map_err(|e| PyValueError::new_err((e.input, "", e.message)))?;
    Ok(FirstTouch::from_shot(&Shot::from_inputs(inputs)))
}

/// The shot of a ball and a head whose launch is differentiated.
fn build_setup(
    ball: &BallValues,
    head: Option<&HeadValues<'_>>,
    inputs: &[f64],
    friction: f64,
) -> PyResult<ImpactSetup> {
    let inputs = inputs.try_into().map_err(|_| PyValueError::new_err(("inputs", "", "all are needed")))?;
    Ok(ImpactSetup {
        ball: build_ball(ball)?,
        head: head.map(build_shell_head).transpose()?,
        inputs,
        friction,
    })
}

/// Names of the variables of [`fem_sensitivity`].
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_variables(
    ball: BallValues,
    head: Option<HeadValues<'_>>,
    inputs: Vec<f64>,
) -> PyResult<Vec<String>> {
    Ok(build_setup(&ball, head.as_ref(), &inputs, 0.0)?.variables())
}

/// Launch of a shot with a head of shells, or else the rigid one of the inputs, and its derivatives in some directions,
/// each a list of variables and how much they change: (outputs, array of outputs by directions). `progress` is called
/// with the run (one for every four directions), simulated time and duration.
#[pyfunction]
#[pyo3(signature = (ball, head, inputs, friction, run, directions, progress=None))]
#[allow(clippy::needless_pass_by_value, clippy::too_many_arguments)]
pub fn fem_sensitivity<'py>(
    py: Python<'py>,
    ball: BallValues,
    head: Option<HeadValues<'py>>,
    inputs: Vec<f64>,
    friction: f64,
    run: RunValues,
    directions: Vec<Vec<(String, f64)>>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Derivatives<'py>> {
    let setting = build_setup(&ball, head.as_ref(), &inputs, friction)?;
    clubface_impact::check::check(&setting.inputs)
        .map_err(|e| PyValueError::new_err((e.input, "", e.message)))?;
    let (pool, options) = (run_pool(&run)?, run_options(&run)?);
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
