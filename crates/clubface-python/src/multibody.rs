//! Contacts for programs that move the bodies.

use crate::columns::value_error;
use clubface_impact::ImpactError;
use clubface_impact::error::all_inputs;
use clubface_impact::impact_model::Tangents;
use clubface_impact::multibody::{BODY, Body, HEAD, Head, HeadContact, check_motion};
use clubface_impact::registry::named;
use clubface_impact::struck_ball::StruckBall;
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use std::sync::{Mutex, MutexGuard};

fn exactly<const N: usize>(values: &[f64], name: &'static str) -> PyResult<[f64; N]> {
    values.try_into().map_err(|_| {
        value_error(&ImpactError::new(name, format!("{} numbers given, {N} needed", values.len())))
    })
}

/// A contact between a head and a ball that the caller moves (see `clubface.SteppedContact`).
#[pyclass(frozen)]
pub struct ContactHandle {
    plain: Mutex<HeadContact<f64>>,
    differentiated: Mutex<HeadContact<Tangents>>,
}

/// A place of head and ball, and the internal states.
type Given = ([f64; HEAD], [f64; BODY], Vec<f64>);

impl ContactHandle {
    fn given(&self, py: Python<'_>, head: &[f64], ball: &[f64], internal: Vec<f64>) -> PyResult<Given> {
        let (head, ball) = (exactly(head, "head")?, exactly(ball, "ball")?);
        check_motion(&head, &ball).map_err(|e| value_error(&e))?;
        let needed = lock(py, &self.plain)?.initial().len();
        if internal.len() != needed {
            let message = format!("{} numbers given, {needed} needed", internal.len());
            return Err(value_error(&ImpactError::new("internal", message)));
        }
        Ok((head, ball, internal))
    }
}

/// Waits detached from Python: whoever holds the lock may make arrays, and with that wait for all other threads.
fn lock<'a, T>(py: Python<'_>, held: &'a Mutex<T>) -> PyResult<MutexGuard<'a, T>> {
    held.lock_py_attached(py)
        .map_err(|_| PyValueError::new_err("a fault of clubface ended this contact; please report it"))
}

#[pymethods]
impl ContactHandle {
    #[new]
    #[allow(clippy::needless_pass_by_value)]
    fn new(
        model: &str,
        inputs: Vec<f64>,
        parameters: Vec<f64>,
        head: Vec<f64>,
        ball: Vec<f64>,
    ) -> PyResult<Self> {
        let (head, ball) = (exactly(&head, "head")?, exactly(&ball, "ball")?);
        let begin = || {
            let (model, inputs) = (named(model)?, all_inputs(&inputs)?);
            Ok((
                HeadContact::begin(model, inputs, &parameters, &head, &ball)?,
                HeadContact::begin(model, inputs, &parameters, &head, &ball)?,
            ))
        };
        let (plain, differentiated) = begin().map_err(|e| value_error(&e))?;
        Ok(Self { plain: Mutex::new(plain), differentiated: Mutex::new(differentiated) })
    }

    /// Names of the internal states.
    #[getter]
    fn names(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        Ok(lock(py, &self.plain)?.names())
    }

    /// The internal states at first touch.
    #[getter]
    fn initial<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_slice(py, lock(py, &self.plain)?.initial()))
    }

    /// What acts, and the rates of the internal states.
    #[allow(clippy::needless_pass_by_value, clippy::type_complexity)]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        head: Vec<f64>,
        ball: Vec<f64>,
        internal: Vec<f64>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>)> {
        let (head, ball, internal) = self.given(py, &head, &ball, internal)?;
        let mut rates = vec![0.0; internal.len()];
        let contact = lock(py, &self.plain)?;
        let wrench =
            contact.evaluate(&Head::from_values(&head), &Body::from_values(&ball), &internal, &mut rates);
        Ok((PyArray1::from_slice(py, &wrench.values()), PyArray1::from_vec(py, rates)))
    }

    /// What acts and the rates, each with its derivatives: a row a number, value first.
    #[allow(clippy::needless_pass_by_value)]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        head: Vec<f64>,
        ball: Vec<f64>,
        internal: Vec<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (head, ball, internal) = self.given(py, &head, &ball, internal)?;
        let rows = lock(py, &self.differentiated)?.jacobian(&head, &ball, &internal);
        Ok(PyArray2::from_vec2(py, &rows)?)
    }

    /// The internal states after a step that ends here.
    #[allow(clippy::needless_pass_by_value)]
    fn commit<'py>(
        &self,
        py: Python<'py>,
        head: Vec<f64>,
        ball: Vec<f64>,
        internal: Vec<f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let (head, ball, mut internal) = self.given(py, &head, &ball, internal)?;
        lock(py, &self.plain)?.commit(&Head::from_values(&head), &Body::from_values(&ball), &mut internal);
        Ok(PyArray1::from_vec(py, internal))
    }
}

/// A ball that is moved through the contact with a head that the caller moves (see `clubface.StruckBall`).
#[pyclass(frozen)]
pub struct BallHandle {
    ball: Mutex<StruckBall>,
}

#[pymethods]
impl BallHandle {
    #[new]
    #[allow(clippy::needless_pass_by_value)]
    fn new(
        model: &str,
        inputs: Vec<f64>,
        parameters: Vec<f64>,
        ball: Vec<f64>,
        gives_way: bool,
    ) -> PyResult<Self> {
        let ball = exactly(&ball, "ball")?;
        let place = || StruckBall::new(named(model)?, all_inputs(&inputs)?, &parameters, &ball, gives_way);
        Ok(Self { ball: Mutex::new(place().map_err(|e| value_error(&e))?) })
    }

    /// Moves the ball on: mean force and torque on the head, normal force and penetration at the end.
    #[allow(clippy::needless_pass_by_value)]
    fn advance<'py>(
        &self,
        py: Python<'py>,
        head: Vec<f64>,
        duration: f64,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let head = exactly(&head, "head")?;
        let step = lock(py, &self.ball)?.advance(&head, duration).map_err(|e| value_error(&e))?;
        let mut loads = [0.0; 8];
        step.force.put(&mut loads, 0);
        step.torque.put(&mut loads, 3);
        loads[6..].copy_from_slice(&[step.normal_force, step.depth]);
        Ok(PyArray1::from_slice(py, &loads))
    }

    /// Position, velocity and angular velocity of the ball.
    #[getter]
    fn motion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_slice(py, &lock(py, &self.ball)?.ball().values()))
    }

    /// 0 before the contact, 1 in it, 2 after it.
    #[getter]
    fn phase(&self, py: Python<'_>) -> PyResult<u8> {
        Ok(lock(py, &self.ball)?.phase() as u8)
    }

    /// The outputs of the impact, once the ball has left the face.
    #[getter]
    fn launch(&self, py: Python<'_>) -> PyResult<Option<Vec<f64>>> {
        Ok(lock(py, &self.ball)?.launch().map(|launch| launch.to_vec()))
    }
}
