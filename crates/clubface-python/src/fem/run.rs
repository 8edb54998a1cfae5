//! Running an impact and telling Python what came out.

use super::fields::Fields;
use super::values::{error_of, RunValues};
use clubface_fem::contact::Method;
use clubface_fem::solve::{Impact, Options, Outcome, View};
use clubface_fem::FemError;
use clubface_impact::first_touch::FirstTouch;
use numpy::{PyArray1, PyArray2, PyArray3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

pub(super) fn options_of(run: &RunValues) -> PyResult<Options> {
    Ok(Options {
        duration: run.duration,
        safety: run.safety,
        interval: run.interval,
        until_separation: run.until_separation,
        contact: Method::from_name(&run.contact).map_err(|e| error_of(&e))?,
        bulk_viscosity: run.bulk_viscosity,
        ..Options::default()
    })
}

pub(super) fn pool_of(run: &RunValues) -> PyResult<rayon::ThreadPool> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(run.threads)
        .build()
        .map_err(|e| PyValueError::new_err(("threads", "", e.to_string())))
}

/// Does something with the threads of a pool that calls Python now and then: what Python keeps of a thread is made once, not for every call.
pub(super) fn on_threads<T: Send>(pool: &rayon::ThreadPool, work: impl FnOnce() -> T + Send) -> T {
    pool.install(|| Python::attach(|py| py.detach(work)))
}

/// A finished run with the shapes and contact patches kept on the way.
pub(super) struct Ran {
    outcome: Outcome<f64>,
    times: Vec<f64>,
    positions: Vec<f64>,
    patch: Vec<PatchPoint>,
    fields: Fields,
    /// Whether elements failed; then all that is kept is from before.
    failed: bool,
}

/// A node of the ball in contact at some time: its place along the face relative to the mass centre (m), its forces (N), its share of the
/// undeformed surface (m2).
struct PatchPoint {
    time: f64,
    up: f64,
    toe: f64,
    normal: f64,
    tangential: f64,
    area: f64,
}

fn patch_points(now: &View<f64>, into: &mut Vec<PatchPoint>) {
    let [normal, up, toe] = now.axes();
    for node in now.touches() {
        let (place, force) = (node.place - now.centre, node.force);
        into.push(PatchPoint {
            time: now.progress.time,
            up: place.dot(up),
            toe: place.dot(toe),
            normal: force.dot(normal),
            tangential: -force.dot(up),
            area: node.area,
        });
    }
}

/// Adds the places of all nodes, and what the elements feel if that is asked for.
fn add_frame(now: &mut Impact<f64>, positions: &mut Vec<f64>, fields: Option<&mut Fields>) {
    let places = &now.structure.positions[..now.structure.translations];
    positions.extend(places.iter().flat_map(|row| [row.0[0], row.0[1], row.0[2]]));
    if let Some(fields) = fields {
        fields.add(now);
    }
}

pub(super) fn simulate<'py>(
    py: Python<'py>,
    impact: &mut Impact<f64>,
    run: &RunValues,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Ran> {
    let options = options_of(run)?;
    let progress = progress.map(Bound::unbind);
    let frame_gap = if run.frames > 1 { run.duration / (run.frames - 1) as f64 } else { f64::INFINITY };
    let (frames, interval) = (run.frames, run.interval);
    let (mut times, mut positions, mut patch) = (Vec::new(), Vec::new(), Vec::new());
    let (mut fields, mut raised) = (Fields::default(), None);
    let pool = pool_of(run)?;
    let outcome = py.detach(|| {
        let mut watch = |mut now: View<f64>| {
            let at = now.progress;
            let due = if times.is_empty() { 0.0 } else { times.len() as f64 * frame_gap - 0.5 * interval };
            // A run until separation may be longer than its duration.
            if times.len() < frames && at.time >= due {
                times.push(at.time);
                add_frame(now.whole(), &mut positions, run.fields.then_some(&mut fields));
            }
            patch_points(&now, &mut patch);
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
        on_threads(&pool, || impact.run(&options, &mut watch))
    });
    let outcome = outcome.map_err(|e| error_of(&e))?;
    if let Some(error) = raised {
        if !error.is_instance_of::<pyo3::exceptions::PyKeyboardInterrupt>(py) {
            return Err(error);
        }
    }
    // The last frame is due when the run ends, between two records.
    let end = outcome.steps as f64 * outcome.step;
    let failed = outcome.stopped.as_ref().is_some_and(FemError::failed);
    let interrupted = matches!(outcome.stopped, Some(FemError::Interrupted { .. }));
    if !failed && !interrupted && !times.is_empty() && times.len() < frames && end > run.duration {
        times.push(end);
        add_frame(impact, &mut positions, run.fields.then_some(&mut fields));
    }
    if failed {
        let last = outcome.history.energy.last().map_or(0.0, |frame| frame.time);
        let (all, kept) = (times.len(), times.partition_point(|&time| time <= last));
        times.truncate(kept);
        positions.truncate(positions.len() / all.max(1) * kept);
        patch.retain(|point: &PatchPoint| point.time <= last);
        fields.keep(kept, all);
    }
    Ok(Ran { outcome, times, positions, patch, fields, failed })
}

pub(super) fn to_dict<'py>(
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
    dict.set_item("safety", outcome.safety)?;
    dict.set_item("step", outcome.step)?;
    dict.set_item("wall", outcome.wall)?;
    dict.set_item("stopped", outcome.stopped.as_ref().map(ToString::to_string))?;
    dict.set_item("failed", ran.failed)?;
    dict.set_item("over_edge", outcome.over_edge)?;
    let unfinished = matches!(outcome.stopped, Some(FemError::Unfinished { .. }));
    dict.set_item("unfinished", unfinished)?;
    dict.set_item("interrupted", matches!(outcome.stopped, Some(FemError::Interrupted { .. })))?;
    if let Some(touch) = touch {
        let mut launch = touch.launch(outcome.ball, outcome.head);
        launch.contact_time = figures.contact_time;
        launch.peak_force = figures.peak_force;
        let known = if ran.failed || history.touching() { f64::NAN } else { 1.0 };
        let outputs = launch.outputs().map(|output| output * known);
        dict.set_item("launch", PyArray1::from_slice(py, &outputs))?;
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
    columns!(patch, ran.patch, time up toe normal tangential area);
    dict.set_item("patch", patch)?;
    let nodes = impact.structure.translations;
    let frames: Vec<Vec<Vec<f64>>> =
        ran.positions.chunks(nodes * 3).map(|frame| frame.chunks(3).map(<[f64]>::to_vec).collect()).collect();
    dict.set_item("fields", ran.fields.to_list(py)?)?;
    dict.set_item("ball_nodes", impact.ball_nodes)?;
    dict.set_item("frame_times", PyArray1::from_slice(py, &ran.times))?;
    dict.set_item("frames", PyArray3::from_vec3(py, &frames)?)?;
    Ok(dict)
}
