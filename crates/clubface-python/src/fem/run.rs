//! Runs a simulation, and returns its result to Python.

use super::element_fields::ElementFields;
use super::inputs::{RunValues, error_of};
use clubface_fem::FemError;
use clubface_fem::contact::ContactMethod;
use clubface_fem::solve::{Options, Simulation, SimulationResult, Snapshot};
use clubface_impact::first_touch::FirstTouch;
use numpy::{PyArray1, PyArray2, PyArray3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

pub(super) fn options_of(run: &RunValues) -> PyResult<Options> {
    Ok(Options {
        duration: run.duration,
        safety: run.safety,
        interval: run.interval,
        until_separation: run.until_separation,
        contact: ContactMethod::from_name(&run.contact).map_err(|e| error_of(&e))?,
        bulk_viscosity: run.bulk_viscosity,
        ..Options::default()
    })
}

/// Threads of a run alone: rayon's global pool has none in a process that was forked from one that used it.
pub(super) fn pool_of(run: &RunValues) -> PyResult<Arc<rayon::ThreadPool>> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(run.threads)
        .build()
        .map(Arc::new)
        .map_err(|e| PyValueError::new_err(("threads", "", e.to_string())))
}

/// Does some work on the threads of a pool that calls Python now and then. Python's state of the thread is created
/// once, not for every call.
pub(super) fn on_threads<T: Send>(pool: &rayon::ThreadPool, work: impl FnOnce() -> T + Send) -> T {
    pool.install(|| Python::attach(|py| py.detach(work)))
}

/// The result of a run, with the frames and contact forces collected on the way.
pub(super) struct RunResult {
    simulation: SimulationResult<f64>,
    times: Vec<f64>,
    positions: Vec<f64>,
    contact_points: Vec<ContactPoint>,
    fields: ElementFields,
    /// Whether elements have failed; then only what came before is kept.
    failed: bool,
}

/// A node of the ball in contact: its position along the face relative to the mass centre (m), the forces on it (N),
/// and the part of the undeformed surface that belongs to it (m2).
struct ContactPoint {
    time: f64,
    up: f64,
    toe: f64,
    normal: f64,
    tangential: f64,
    area: f64,
}

fn add_contact_points(snapshot: &Snapshot<f64>, points: &mut Vec<ContactPoint>) {
    let [normal, up, toe] = snapshot.axes();
    for node in snapshot.contact_forces() {
        let (position, force) = (node.position - snapshot.centre, node.force);
        points.push(ContactPoint {
            time: snapshot.progress.time,
            up: position.dot(up),
            toe: position.dot(toe),
            normal: force.dot(normal),
            tangential: -force.dot(up),
            area: node.area,
        });
    }
}

/// Adds the positions of all nodes and, if asked for, stress and strain of the elements.
fn add_frame(simulation: &mut Simulation<f64>, positions: &mut Vec<f64>, fields: Option<&mut ElementFields>) {
    let rows = &simulation.structure.positions[..simulation.structure.translations];
    positions.extend(rows.iter().flat_map(|row| [row.0[0], row.0[1], row.0[2]]));
    if let Some(fields) = fields {
        fields.add(simulation);
    }
}

pub(super) fn run_simulation<'py>(
    py: Python<'py>,
    simulation: &mut Simulation<f64>,
    pool: &rayon::ThreadPool,
    run: &RunValues,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<RunResult> {
    let options = options_of(run)?;
    let progress = progress.map(Bound::unbind);
    let frame_gap = if run.frames > 1 { run.duration / (run.frames - 1) as f64 } else { f64::INFINITY };
    let (frames, interval) = (run.frames, run.interval);
    let (mut times, mut positions, mut contact_points) = (Vec::new(), Vec::new(), Vec::new());
    let (mut fields, mut raised) = (ElementFields::default(), None);
    let result = py.detach(|| {
        let mut observer = |mut snapshot: Snapshot<f64>| {
            let at = snapshot.progress;
            let due = if times.is_empty() { 0.0 } else { times.len() as f64 * frame_gap - 0.5 * interval };
            // A run until separation may be longer than its duration.
            if times.len() < frames && at.time >= due {
                times.push(at.time);
                add_frame(snapshot.synchronised(), &mut positions, run.fields.then_some(&mut fields));
            }
            add_contact_points(&snapshot, &mut contact_points);
            // Signals reach Python's main thread alone, which ends a run through its progress.
            let called = Python::attach(|py| {
                progress.as_ref().map_or(Ok(()), |f| f.call1(py, (at.time, at.duration)).map(|_| ()))
            });
            match called {
                Ok(()) => true,
                Err(error) => {
                    raised = Some(error);
                    false
                }
            }
        };
        on_threads(pool, || simulation.run(&options, &mut observer))
    });
    let result = result.map_err(|e| error_of(&e))?;
    if let Some(error) = raised {
        if !error.is_instance_of::<pyo3::exceptions::PyKeyboardInterrupt>(py) {
            return Err(error);
        }
    }
    // The last frame is due when the run ends, between two records.
    let end = result.steps as f64 * result.step;
    let failed = result.stopped.as_ref().is_some_and(FemError::failed);
    let interrupted = matches!(result.stopped, Some(FemError::Interrupted { .. }));
    if !failed && !interrupted && !times.is_empty() && times.len() < frames && end > run.duration {
        times.push(end);
        add_frame(simulation, &mut positions, run.fields.then_some(&mut fields));
    }
    if failed {
        let last = result.records.energy.last().map_or(0.0, |frame| frame.time);
        let (all, kept) = (times.len(), times.partition_point(|&time| time <= last));
        times.truncate(kept);
        positions.truncate(positions.len() / all.max(1) * kept);
        contact_points.retain(|point: &ContactPoint| point.time <= last);
        fields.truncate(kept, all);
    }
    Ok(RunResult { simulation: result, times, positions, contact_points, fields, failed })
}

pub(super) fn to_dict<'py>(
    py: Python<'py>,
    simulation: &Simulation<f64>,
    run: &RunResult,
    touch: Option<&FirstTouch<f64>>,
) -> PyResult<Bound<'py, PyDict>> {
    let result = &run.simulation;
    let records = &result.records;
    let summary = records.summary(simulation.radius);
    let dict = PyDict::new(py);
    macro_rules! set_summary {
        ($($name:ident)+) => { $(dict.set_item(stringify!($name), summary.$name)?;)+ };
    }
    set_summary!(peak_force peak_force_time contact_time tangential_max tangential_min reversal_time spin_max contraction contraction_time f_prime f energy_error);
    dict.set_item("ball_velocity", result.ball.velocity.array().to_vec())?;
    dict.set_item("ball_spin", result.ball.spin.array().to_vec())?;
    dict.set_item("axes", PyArray2::from_vec2(py, &simulation.axes.map(|a| a.array().to_vec()))?)?;
    let along = simulation.axes.map(|axis| axis.dot(simulation.head_velocity));
    dict.set_item("frame_velocity", PyArray1::from_slice(py, &along))?;
    let attitude = touch.map_or(clubface_math::Mat3::diagonal(1.0), |t| t.attitude);
    dict.set_item("attitude", PyArray2::from_vec2(py, &attitude.rows.map(|r| r.array().to_vec()))?)?;
    dict.set_item("steps", result.steps)?;
    dict.set_item("safety", result.safety)?;
    dict.set_item("step", result.step)?;
    dict.set_item("wall", result.wall)?;
    dict.set_item("stopped", result.stopped.as_ref().map(ToString::to_string))?;
    dict.set_item("failed", run.failed)?;
    dict.set_item("over_edge", result.over_edge)?;
    let unfinished = matches!(result.stopped, Some(FemError::Unfinished { .. }));
    dict.set_item("unfinished", unfinished)?;
    dict.set_item("interrupted", matches!(result.stopped, Some(FemError::Interrupted { .. })))?;
    if let Some(touch) = touch {
        let mut launch = touch.launch(result.ball, result.head);
        launch.contact_time = summary.contact_time;
        launch.peak_force = summary.peak_force;
        let known = if run.failed || records.in_contact() { f64::NAN } else { 1.0 };
        let outputs = launch.outputs().map(|output| output * known);
        dict.set_item("launch", PyArray1::from_slice(py, &outputs))?;
    }
    let contact = PyDict::new(py);
    macro_rules! columns {
        ($into:ident, $frames:expr, $($name:ident)+) => {
            $($into.set_item(stringify!($name), PyArray1::from_iter(py, $frames.iter().map(|f| f.$name)))?;)+
        };
    }
    columns!(contact, records.contact, time normal tangential toe area);
    dict.set_item("contact", contact)?;
    let motion = PyDict::new(py);
    columns!(motion, records.motion, time radius);
    let rows = |pick: fn(&clubface_fem::solve::MotionRecord) -> [f64; 3]| -> Vec<Vec<f64>> {
        records.motion.iter().map(|f| pick(f).to_vec()).collect()
    };
    motion.set_item("velocity", PyArray2::from_vec2(py, &rows(|f| f.velocity))?)?;
    motion.set_item("spin", PyArray2::from_vec2(py, &rows(|f| f.spin))?)?;
    dict.set_item("motion", motion)?;
    let energy = PyDict::new(py);
    columns!(energy, records.energy, time kinetic contact friction damping);
    macro_rules! element_energies {
        ($($name:ident)+) => {
            $(energy.set_item(stringify!($name), PyArray1::from_iter(py, records.energy.iter().map(|f| f.elements.$name)))?;)+
        };
    }
    element_energies!(strain hourglass viscous plastic);
    dict.set_item("energy", energy)?;
    let patch = PyDict::new(py);
    columns!(patch, run.contact_points, time up toe normal tangential area);
    dict.set_item("patch", patch)?;
    let nodes = simulation.structure.translations;
    let frames: Vec<Vec<Vec<f64>>> =
        run.positions.chunks(nodes * 3).map(|frame| frame.chunks(3).map(<[f64]>::to_vec).collect()).collect();
    dict.set_item("fields", run.fields.to_list(py)?)?;
    dict.set_item("ball_nodes", simulation.ball_nodes)?;
    dict.set_item("frame_times", PyArray1::from_slice(py, &run.times))?;
    dict.set_item("frames", PyArray3::from_vec3(py, &frames)?)?;
    Ok(dict)
}
