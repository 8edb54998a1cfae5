//! Finite element impacts: a ball and what it meets go in, histories come out.

use crate::columns::Derivatives;
use clubface_fem::ball::{Ball, Piece};
use clubface_fem::cases::{against_head, against_plane};
use clubface_fem::element::Element;
use clubface_fem::material::{Material, Maxwell, Shape, LAWS};
use clubface_fem::sensitivity::Setting;
use clubface_fem::solve::{Impact, Options, Outcome, Progress};
use clubface_fem::FemError;
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::shot::{Shot, INPUT_COUNT};
use numpy::{PyArray1, PyArray2, PyArray3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

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
    #[pyo3(default = "one-point".to_owned())]
    element: String,
    mass: Option<f64>,
}

/// How to run.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct RunValues {
    duration: f64,
    safety: f64,
    interval: f64,
    until_separation: bool,
    threads: usize,
    frames: usize,
}

fn error_of(error: &FemError) -> PyErr {
    match error {
        FemError::Input { name, value, allowed } => {
            PyValueError::new_err((name.clone(), value.clone(), allowed.clone()))
        }
        other => PyValueError::new_err(("", "", other.to_string())),
    }
}

fn ball_of(values: &BallValues) -> PyResult<Ball<f64>> {
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

/// The laws of materials: [{name, constants, summary}, ...].
#[pyfunction]
pub fn fem_laws(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    let list = PyList::empty(py);
    for law in LAWS {
        let entry = PyDict::new(py);
        entry.set_item("name", law.name)?;
        entry.set_item("constants", law.constants.to_vec())?;
        entry.set_item("summary", law.summary)?;
        list.append(entry)?;
    }
    Ok(list)
}

/// Mass properties of a ball as meshed: {mass, inertia, core_density, radius, nodes, elements}.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_ball<'py>(py: Python<'py>, ball: BallValues) -> PyResult<Bound<'py, PyDict>> {
    let ball = ball_of(&ball)?;
    let still = clubface_math::Mat3::diagonal(1.0);
    let meshed = ball.mesh(&still, clubface_math::Vec3::zero()).map_err(|e| error_of(&e))?;
    let dict = PyDict::new(py);
    dict.set_item("mass", meshed.mass)?;
    dict.set_item("inertia", meshed.inertia)?;
    dict.set_item("core_density", meshed.core_density)?;
    dict.set_item("radius", meshed.radius)?;
    dict.set_item("nodes", meshed.mesh.nodes.len())?;
    dict.set_item("elements", meshed.mesh.elements.len())?;
    Ok(dict)
}

/// The mesh of a ball about the origin, its pole of first contact along -x: {nodes: (n, 3), elements: (m, 8) in the order round the bottom, then
/// round the top, piece: (m,), density: one a piece}.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_mesh<'py>(py: Python<'py>, ball: BallValues) -> PyResult<Bound<'py, PyDict>> {
    const ROUND: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];
    let ball = ball_of(&ball)?;
    let still = clubface_math::Mat3::diagonal(1.0);
    let meshed = ball.mesh(&still, clubface_math::Vec3::zero()).map_err(|e| error_of(&e))?;
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
) -> PyResult<Bound<'py, PyDict>> {
    let ball = ball_of(&ball)?;
    let mut impact = against_plane(&ball, speed, angle, friction).map_err(|e| error_of(&e))?;
    let ran = simulate(py, &mut impact, &run, progress)?;
    to_dict(py, &impact, &ran, None)
}

/// A shot with a rigid head; `inputs` in the order of `inputs()`. Mass, radius and inertia of the ball come from the mesh.
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
) -> PyResult<Bound<'py, PyDict>> {
    let inputs: &[f64; INPUT_COUNT] =
        inputs.as_slice().try_into().map_err(|_| PyValueError::new_err(("inputs", "", "all are needed")))?;
    clubface_impact::check::check(inputs).map_err(|e| PyValueError::new_err((e.input, "", e.message)))?;
    let touch = FirstTouch::of(&Shot::from_inputs(inputs));
    let ball = ball_of(&ball)?;
    let mut impact = against_head(&ball, &touch, friction).map_err(|e| error_of(&e))?;
    let ran = simulate(py, &mut impact, &run, progress)?;
    to_dict(py, &impact, &ran, Some(&touch))
}

/// The shot of a ball and a rigid head whose launch is differentiated.
fn setting_of(ball: &BallValues, inputs: &[f64], friction: f64) -> PyResult<Setting> {
    let inputs = inputs.try_into().map_err(|_| PyValueError::new_err(("inputs", "", "all are needed")))?;
    Ok(Setting { ball: ball_of(ball)?, inputs, friction })
}

/// Names of the variables of [`fem_sensitivity`].
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_variables(ball: BallValues, inputs: Vec<f64>) -> PyResult<Vec<String>> {
    Ok(setting_of(&ball, &inputs, 0.0)?.variables())
}

/// Launch of a shot with a rigid head, and its derivatives by some variables: (outputs, array of outputs by variables). `progress` is called with
/// the run (one for every four variables), simulated time and duration.
#[pyfunction]
#[pyo3(signature = (ball, inputs, friction, run, variables, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fem_sensitivity<'py>(
    py: Python<'py>,
    ball: BallValues,
    inputs: Vec<f64>,
    friction: f64,
    run: RunValues,
    variables: Vec<String>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Derivatives<'py>> {
    let setting = setting_of(&ball, &inputs, friction)?;
    clubface_impact::check::check(&setting.inputs)
        .map_err(|e| PyValueError::new_err((e.input, "", e.message)))?;
    let pool = pool_of(&run)?;
    let mut raised = None;
    let found = py.detach(|| {
        let mut watch = |which: usize, at: &Progress| {
            // Signals reach Python's main thread alone, which ends a run through its progress.
            let looked = Python::attach(|py| {
                progress.as_ref().map_or(Ok(()), |f| f.call1(py, (which, at.time, at.duration)).map(|_| ()))
            });
            looked.map_err(|error| raised = Some(error)).is_ok()
        };
        pool.install(|| setting.sensitivity(&variables, &options_of(&run), &mut watch))
    });
    if let Some(error) = raised {
        return Err(error);
    }
    let found = found.map_err(|e| error_of(&e))?;
    Ok((PyArray1::from_slice(py, &found.values), PyArray2::from_vec2(py, &found.jacobian)?))
}

fn options_of(run: &RunValues) -> Options {
    Options {
        duration: run.duration,
        safety: run.safety,
        interval: run.interval,
        until_separation: run.until_separation,
        ..Options::default()
    }
}

fn pool_of(run: &RunValues) -> PyResult<rayon::ThreadPool> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(run.threads)
        .build()
        .map_err(|e| PyValueError::new_err(("threads", "", e.to_string())))
}

/// A finished run with the shapes and contact patches kept on the way.
struct Ran {
    outcome: Outcome<f64>,
    times: Vec<f64>,
    positions: Vec<f64>,
    patch: Vec<PatchPoint>,
}

/// A node of the ball in contact at some time: its place along the face relative to the mass centre (m), its forces (N).
struct PatchPoint {
    time: f64,
    up: f64,
    toe: f64,
    normal: f64,
    tangential: f64,
}

fn patch_points(time: f64, now: &Impact<f64>, into: &mut Vec<PatchPoint>) {
    let [normal, up, toe] = now.axes;
    let mut centre = None;
    for (&node, row) in now.contact.nodes().iter().zip(now.contact.forces()) {
        let force = row.vec();
        if node as usize >= now.ball_nodes || force.norm_squared() == 0.0 {
            continue;
        }
        let middle = *centre.get_or_insert_with(|| now.structure.kinetics(0..now.ball_nodes).centre);
        let place = now.structure.positions[node as usize].vec() - middle;
        into.push(PatchPoint {
            time,
            up: place.dot(up),
            toe: place.dot(toe),
            normal: force.dot(normal),
            tangential: -force.dot(up),
        });
    }
}

fn simulate<'py>(
    py: Python<'py>,
    impact: &mut Impact<f64>,
    run: &RunValues,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Ran> {
    let options = options_of(run);
    let progress = progress.map(Bound::unbind);
    let frame_gap = if run.frames > 1 { run.duration / (run.frames - 1) as f64 } else { f64::INFINITY };
    let (frames, interval) = (run.frames, run.interval);
    let (mut times, mut positions, mut patch) = (Vec::new(), Vec::new(), Vec::new());
    let mut raised = None;
    let pool = pool_of(run)?;
    let outcome = py.detach(|| {
        let mut watch = |at: &Progress, now: &Impact<f64>| {
            if frames > 0 && at.time >= times.len() as f64 * frame_gap - 0.5 * interval {
                times.push(at.time);
                positions
                    .extend(now.structure.positions.iter().flat_map(|row| [row.0[0], row.0[1], row.0[2]]));
            }
            patch_points(at.time, now, &mut patch);
            // Signals reach Python's main thread alone, which ends a run through its progress.
            let looked = Python::attach(|py| {
                progress.as_ref().map_or(Ok(()), |f| f.call1(py, (at.time, at.duration)).map(|_| ()))
            });
            match looked {
                Ok(()) => true,
                Err(error) => {
                    raised = Some(error);
                    false
                }
            }
        };
        pool.install(|| impact.run(&options, &mut watch))
    });
    let outcome = outcome.map_err(|e| error_of(&e))?;
    if let Some(error) = raised {
        if !error.is_instance_of::<pyo3::exceptions::PyKeyboardInterrupt>(py) {
            return Err(error);
        }
    }
    Ok(Ran { outcome, times, positions, patch })
}

fn to_dict<'py>(
    py: Python<'py>,
    impact: &Impact<f64>,
    ran: &Ran,
    touch: Option<&FirstTouch<f64>>,
) -> PyResult<Bound<'py, PyDict>> {
    let outcome = &ran.outcome;
    let history = &outcome.history;
    let figures = history.figures(impact.radius);
    let dict = PyDict::new(py);
    macro_rules! figure {
        ($($name:ident)+) => { $(dict.set_item(stringify!($name), figures.$name)?;)+ };
    }
    figure!(peak_force peak_force_time contact_time tangential_max tangential_min reversal_time spin_max contraction contraction_time f_prime f energy_error);
    dict.set_item("ball_velocity", outcome.ball.velocity.array().to_vec())?;
    dict.set_item("ball_spin", outcome.ball.spin.array().to_vec())?;
    dict.set_item("axes", PyArray2::from_vec2(py, &impact.axes.map(|a| a.array().to_vec()))?)?;
    let along = impact.axes.map(|axis| axis.dot(impact.head_velocity));
    dict.set_item("frame_velocity", PyArray1::from_slice(py, &along))?;
    let attitude = touch.map_or(clubface_math::Mat3::diagonal(1.0), |t| t.attitude);
    dict.set_item("attitude", PyArray2::from_vec2(py, &attitude.rows.map(|r| r.array().to_vec()))?)?;
    dict.set_item("steps", outcome.steps)?;
    dict.set_item("step", outcome.step)?;
    dict.set_item("wall", outcome.wall)?;
    dict.set_item("stopped", outcome.stopped.as_ref().map(ToString::to_string))?;
    dict.set_item("interrupted", matches!(outcome.stopped, Some(FemError::Interrupted { .. })))?;
    if let Some(touch) = touch {
        let mut launch = touch.launch(outcome.ball, outcome.head);
        launch.contact_time = figures.contact_time;
        launch.peak_force = figures.peak_force;
        dict.set_item("launch", PyArray1::from_slice(py, &launch.outputs()))?;
    }
    let contact = PyDict::new(py);
    macro_rules! columns {
        ($into:ident, $frames:expr, $($name:ident)+) => {
            $($into.set_item(stringify!($name), PyArray1::from_iter(py, $frames.iter().map(|f| f.$name)))?;)+
        };
    }
    columns!(contact, history.contact, time normal tangential toe area);
    dict.set_item("contact", contact)?;
    let motion = PyDict::new(py);
    columns!(motion, history.motion, time radius);
    let rows = |pick: fn(&clubface_fem::solve::MotionFrame) -> [f64; 3]| -> Vec<Vec<f64>> {
        history.motion.iter().map(|f| pick(f).to_vec()).collect()
    };
    motion.set_item("velocity", PyArray2::from_vec2(py, &rows(|f| f.velocity))?)?;
    motion.set_item("spin", PyArray2::from_vec2(py, &rows(|f| f.spin))?)?;
    dict.set_item("motion", motion)?;
    let energy = PyDict::new(py);
    columns!(energy, history.energy, time kinetic contact friction damping);
    macro_rules! element_energies {
        ($($name:ident)+) => {
            $(energy.set_item(stringify!($name), PyArray1::from_iter(py, history.energy.iter().map(|f| f.elements.$name)))?;)+
        };
    }
    element_energies!(strain hourglass viscous plastic);
    dict.set_item("energy", energy)?;
    let patch = PyDict::new(py);
    columns!(patch, ran.patch, time up toe normal tangential);
    dict.set_item("patch", patch)?;
    let nodes = impact.structure.positions.len();
    let frames: Vec<Vec<Vec<f64>>> =
        ran.positions.chunks(nodes * 3).map(|frame| frame.chunks(3).map(<[f64]>::to_vec).collect()).collect();
    dict.set_item("frame_times", PyArray1::from_slice(py, &ran.times))?;
    dict.set_item("frames", PyArray3::from_vec3(py, &frames)?)?;
    Ok(dict)
}
