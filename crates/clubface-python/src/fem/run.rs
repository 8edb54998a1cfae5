//! Runs a simulation and gives its record to Python.

use super::described::to_py_error;
use crate::columns::arrays;
use clubface_fem::description::RunDescription;
use clubface_fem::solve::{ElementHistory, ImpactRecord, Progress, Simulation};
use clubface_impact::first_touch::FirstTouch;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Threads of a run alone: rayon's global pool has none in a process that was forked from one that used it.
pub(super) fn run_pool(run: &RunDescription) -> PyResult<Arc<rayon::ThreadPool>> {
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

/// Runs and records a simulation. A KeyboardInterrupt raised by `progress` ends the run and keeps what it has; any other
/// error is raised.
pub(super) fn record(
    py: Python<'_>,
    simulation: &mut Simulation<f64>,
    pool: &rayon::ThreadPool,
    run: &RunDescription,
    touch: Option<&FirstTouch<f64>>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<FemImpact> {
    let (options, recording) = (run.options().map_err(|e| to_py_error(&e))?, run.recording());
    let progress = progress.map(Bound::unbind);
    let mut raised = None;
    let result = py.detach(|| {
        let mut report = |at: &Progress| {
            // Signals reach Python's main thread alone, which ends a run through its progress.
            let called = Python::attach(|py| {
                progress.as_ref().map_or(Ok(()), |f| f.call1(py, (at.time, at.duration)).map(|_| ()))
            });
            called.map_err(|error| raised = Some(error)).is_ok()
        };
        on_threads(pool, || simulation.record(&options, recording, touch, &mut report))
    });
    let record = result.map_err(|e| to_py_error(&e))?;
    match raised {
        Some(error) if !error.is_instance_of::<PyKeyboardInterrupt>(py) => Err(error),
        _ => Ok(FemImpact::new(record)),
    }
}

/// Declares the record as Python sees it: numbers as attributes, and the record that the other attributes are made of.
macro_rules! record {
    ($(#[$class:meta])* $type:ident { $($(#[$doc:meta])* $name:ident: $number:ty = $($field:ident).+;)+ }) => {
        $(#[$class])*
        #[pyclass(frozen, module = "clubface._core")]
        pub struct $type {
            $($(#[$doc])* #[pyo3(get)] $name: $number,)+
            record: ImpactRecord,
        }
        impl $type {
            fn new(record: ImpactRecord) -> Self {
                Self { $($name: record.$($field).+,)+ record }
            }
        }
    };
}

record! {
    /// An impact after its run, in SI units; every array is a copy.
    FemImpact {
        /// Largest normal force, N.
        peak_force: f64 = summary.peak_force;
        /// Its time, s.
        peak_force_time: f64 = summary.peak_force_time;
        /// Time of the last touch, s; NaN if the ball is still on the face.
        contact_time: f64 = summary.contact_time;
        /// Largest force along the face, N; making backspin is positive.
        tangential_max: f64 = summary.tangential_max;
        /// Smallest force along the face, N.
        tangential_min: f64 = summary.tangential_min;
        /// When the force along the face turns from making spin to taking it, s; NaN if it does not.
        reversal_time: f64 = summary.reversal_time;
        /// Largest backspin during the impact, rad/s.
        spin_max: f64 = summary.spin_max;
        /// Greatest loss of the distance from mass centre to face, over the radius.
        contraction: f64 = summary.contraction;
        /// Its time, s.
        contraction_time: f64 = summary.contraction_time;
        /// Compression factor f' of Roh and Lee, Eq. (9).
        f_prime: f64 = summary.f_prime;
        /// Compression factor f of Roh and Lee, Eq. (11).
        f: f64 = summary.f;
        /// Largest error of the energy balance over the initial kinetic energy.
        energy_error: f64 = summary.energy_error;
        /// Steps taken.
        steps: usize = steps;
        /// Time step, s.
        step: f64 = step;
        /// Time step over the stable step of the undeformed structure.
        safety: f64 = safety;
        /// Time that the steps took, s.
        wall: f64 = wall;
        /// Whether the ball has reached round the edge of the face, where contact ends.
        over_edge: bool = over_edge;
    }
}

#[pymethods]
impl FemImpact {
    /// Why there is no launch, or None.
    #[getter]
    fn stopped(&self) -> Option<String> {
        self.record.stopped.as_ref().map(ToString::to_string)
    }
    /// Number of nodes of the ball, the first ones of `frames`.
    #[getter]
    fn ball_nodes(&self) -> usize {
        self.record.nodes.0
    }
    /// Whether elements failed; only what came before is kept.
    #[getter]
    fn failed(&self) -> bool {
        self.record.failed()
    }
    /// Whether the caller stopped the run.
    #[getter]
    fn interrupted(&self) -> bool {
        self.record.interrupted()
    }
    /// Whether the ball was still on the face at the end.
    #[getter]
    fn unfinished(&self) -> bool {
        self.record.unfinished()
    }
    /// Launch in the order of `outputs()`, NaN if there is none; None for a plane.
    #[getter]
    fn launch<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.record.launch.map(|launch| PyArray1::from_slice(py, &launch))
    }
    /// Velocity of the ball after the impact in the axes of the nodes, m/s.
    #[getter]
    fn ball_velocity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.record.ball.velocity.array())
    }
    /// Its angular velocity, rad/s.
    #[getter]
    fn ball_spin<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.record.ball.spin.array())
    }
    /// Directions at first touch in the axes of the nodes, one a row: normal, up the face, towards the toe.
    #[getter]
    fn axes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        Ok(PyArray2::from_vec2(py, &self.record.axes.map(|axis| axis.array().to_vec()))?)
    }
    /// Rotation from the axes of the nodes to world axes.
    #[getter]
    fn attitude<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        Ok(PyArray2::from_vec2(py, &self.record.attitude.rows.map(|row| row.array().to_vec()))?)
    }
    /// Velocity of the head at first touch along `axes`, m/s.
    #[getter]
    fn frame_velocity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.record.frame_velocity.array())
    }
    /// Arrays over the steps: time, normal, tangential, toe (N), area (m2).
    #[getter]
    fn contact<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        arrays(py, self.record.contact_series())
    }
    /// Arrays over the motion records: time, radius; velocity and spin with a row a record.
    #[getter]
    fn motion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        arrays(py, self.record.motion_series())
    }
    /// Arrays over the energy records, J: time (s), kinetic, contact, friction, damping, strain, hourglass, viscous,
    /// plastic.
    #[getter]
    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        arrays(py, self.record.energy_series())
    }
    /// Arrays over the nodes of the ball in contact at the motion records: time, up, toe (m), normal, tangential (N),
    /// area (m2).
    #[getter]
    fn patch<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        arrays(py, self.record.patch_series())
    }
    /// Times of the deformed shapes, s.
    #[getter]
    fn frame_times<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.record.frame_times)
    }
    /// Positions of the nodes, m: by frame, node and axis.
    #[getter]
    fn frames<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let shape = [self.record.frame_times.len(), self.record.nodes.1, 3];
        PyArray1::from_slice(py, &self.record.frames).reshape(shape)
    }
    /// Stress and strain in ball and head: stress (Pa) and strain flat, by frame, element, side and component (xx, yy,
    /// zz, xy, xz, yz), and plastic strain by frame and element.
    #[getter]
    fn fields<'py>(&self, py: Python<'py>) -> Vec<[Bound<'py, PyArray1<f32>>; 3]> {
        let arrays = |body: &ElementHistory| {
            [&body.stress, &body.strain, &body.plastic_strain].map(|values| PyArray1::from_slice(py, values))
        };
        self.record.fields.iter().map(arrays).collect()
    }
}
