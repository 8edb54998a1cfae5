//! Laws of contact that are functions of Python or of C.

use crate::columns::{Derivatives, value_error};
use clubface_impact::error::all_inputs;
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::impact_model::Tangents;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::own_law::{FORCES, MOST_STATES, OwnLaw, TOUCH, Unfinished, run};
use clubface_impact::shot::INPUT_COUNT;
use clubface_math::Scalar;
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::cell::RefCell;

/// A function of C: touch, values of the parameters and states in; forces and rates of the states out.
type Real = unsafe extern "C" fn(*const f64, *const f64, *const f64, *mut f64);

/// Derivatives at a time.
const WIDTH: usize = 8;
/// The step of derivatives by a complex step: no difference is taken, so it may be as small as numbers are.
const STEP: f64 = 1e-100;
/// Numbers that a law receives and returns at most.
const MOST: usize = FORCES + MOST_STATES;

/// How a law is called.
enum Call {
    /// With tuples of numbers: touch, values, states; returns forces and rates. For real numbers, and for numbers with
    /// derivatives, each as its value and then eight derivatives.
    Python(Py<PyAny>, Py<PyAny>),
    /// By address. The complex function takes and returns pairs of real and imaginary part.
    Address(Real, Option<Real>),
}

/// A law of contact (see `clubface.register_law`).
#[pyclass(frozen)]
pub struct LawHandle {
    call: Call,
    /// Natural sizes of the states.
    sizes: Vec<f64>,
}

/// A law with the values of its parameters, in one contact.
struct Valued<'a, S> {
    law: &'a LawHandle,
    values: &'a [S],
    fault: &'a RefCell<Option<PyErr>>,
}

impl<S> Valued<'_, S> {
    /// Keeps the first fault; a contact ends where its forces are not numbers.
    fn fail(&self, error: PyErr, out: &mut [f64]) {
        self.fault.borrow_mut().get_or_insert(error);
        out.fill(f64::NAN);
    }

    fn real(&self, touch: &[f64], values: &[f64], states: &[f64], out: &mut [f64]) {
        if self.fault.borrow().is_some() {
            return out.fill(f64::NAN);
        }
        match &self.law.call {
            // SAFETY: whoever registered the law promised a function of this kind.
            Call::Address(function, _) => unsafe {
                function(touch.as_ptr(), values.as_ptr(), states.as_ptr(), out.as_mut_ptr());
            },
            Call::Python(function, _) => Python::attach(|py| {
                let mut called = || -> PyResult<()> {
                    let given =
                        (PyTuple::new(py, touch)?, PyTuple::new(py, values)?, PyTuple::new(py, states)?);
                    let returned = function.bind(py).call1(given)?;
                    for (i, value) in out.iter_mut().enumerate() {
                        *value = returned.get_item(i)?.extract()?;
                    }
                    Ok(())
                };
                if let Err(error) = called() {
                    self.fail(error, out);
                }
            }),
        }
    }

    /// The law for numbers with derivatives, each given and returned as its value and then its derivatives.
    fn dual(&self, parts: [&[Tangents]; 3], out: &mut [Tangents]) -> PyResult<()> {
        let Call::Python(_, function) = &self.law.call else { return Ok(()) };
        Python::attach(|py| {
            let flat = |part: &[Tangents]| {
                let numbers = part.iter().flat_map(|each| [each.value].into_iter().chain(each.tangent));
                PyTuple::new(py, numbers.collect::<Vec<_>>())
            };
            let returned = function.bind(py).call1((flat(parts[0])?, flat(parts[1])?, flat(parts[2])?))?;
            for (i, each) in out.iter_mut().enumerate() {
                let at = i * (1 + WIDTH);
                each.value = returned.get_item(at)?.extract()?;
                for (k, tangent) in each.tangent.iter_mut().enumerate() {
                    *tangent = returned.get_item(at + 1 + k)?.extract()?;
                }
            }
            Ok(())
        })
    }

    /// The law for numbers with derivatives: the value by a call with real numbers, each derivative by one with a complex
    /// step along its direction.
    fn complex_steps(&self, real: Real, complex: Real, parts: [&[Tangents]; 3], out: &mut [Tangents]) {
        let values = parts.map(|part| part.iter().map(|each| each.value).collect::<Vec<_>>());
        let mut returned = [0.0; 2 * MOST];
        let [touch, parameters, states] = values.each_ref().map(Vec::as_ptr);
        // SAFETY: whoever registered the law promised functions of these kinds.
        unsafe { real(touch, parameters, states, returned.as_mut_ptr()) };
        for (each, value) in out.iter_mut().zip(returned) {
            *each = Tangents::constant(value);
        }
        for i in 0..WIDTH {
            if parts.iter().all(|part| part.iter().all(|each| each.tangent[i] == 0.0)) {
                continue;
            }
            let pairs = parts.map(|part| {
                part.iter().flat_map(|each| [each.value, each.tangent[i] * STEP]).collect::<Vec<_>>()
            });
            let [touch, parameters, states] = pairs.each_ref().map(Vec::as_ptr);
            // SAFETY: as above.
            unsafe { complex(touch, parameters, states, returned.as_mut_ptr()) };
            for (j, each) in out.iter_mut().enumerate() {
                each.tangent[i] = returned[2 * j + 1] / STEP;
            }
        }
    }
}

impl OwnLaw<f64> for Valued<'_, f64> {
    fn evaluate(&self, touch: &[f64; TOUCH], states: &[f64], out: &mut [f64]) {
        self.real(touch, self.values, states, out);
    }
}

impl OwnLaw<Tangents> for Valued<'_, Tangents> {
    fn evaluate(&self, touch: &[Tangents; TOUCH], states: &[Tangents], out: &mut [Tangents]) {
        let parts: [&[Tangents]; 3] = [touch, self.values, states];
        let failed = self.fault.borrow().is_some();
        let done = match &self.law.call {
            _ if failed => Ok(()),
            Call::Python(..) => self.dual(parts, out),
            Call::Address(real, Some(complex)) => {
                self.complex_steps(*real, *complex, parts, out);
                Ok(())
            }
            Call::Address(_, None) => Err(PyTypeError::new_err("the law has no function of complex numbers")),
        };
        if let Err(error) = done {
            self.fault.borrow_mut().get_or_insert(error);
        }
        if self.fault.borrow().is_some() {
            out.fill(Tangents::from_f64(f64::NAN));
        }
    }
}

impl LawHandle {
    fn launch<S: Scalar>(
        &self,
        touch: &FirstTouch<S>,
        values: &[S],
        tolerance: f64,
    ) -> PyResult<Result<[S; OUTPUT_COUNT], Unfinished>>
    where
        for<'a> Valued<'a, S>: OwnLaw<S>,
    {
        let fault = RefCell::new(None);
        let law = Valued { law: self, values, fault: &fault };
        let launched = run(touch, &law, &self.sizes, tolerance).map_err(|e| value_error(&e))?;
        match fault.into_inner() {
            Some(error) => Err(error),
            None => Ok(launched.map(|launch| launch.outputs())),
        }
    }
}

/// What keeps a contact from having a launch, as a word.
fn word(unfinished: Unfinished) -> &'static str {
    match unfinished {
        Unfinished::NeverPushes => "never pushes",
        Unfinished::StillTouching => "still touching",
        Unfinished::TooStiff => "too stiff",
    }
}

/// A function by its address; None for zero.
fn function(address: usize) -> Option<Real> {
    // SAFETY: whoever registered the law promised a function of this kind at the address.
    (address != 0).then(|| unsafe { std::mem::transmute::<usize, Real>(address) })
}

#[pymethods]
impl LawHandle {
    /// Of functions of tuples (touch, values, states), for real numbers and for numbers with derivatives.
    #[new]
    fn new(call: Py<PyAny>, dual_call: Py<PyAny>, sizes: Vec<f64>) -> Self {
        Self { call: Call::Python(call, dual_call), sizes }
    }

    /// Of functions of C by their addresses; 0 for none of complex numbers.
    #[staticmethod]
    fn at(address: usize, complex_address: usize, sizes: Vec<f64>) -> PyResult<Self> {
        let real = function(address).ok_or_else(|| PyValueError::new_err("a null address"))?;
        Ok(Self { call: Call::Address(real, function(complex_address)), sizes })
    }

    /// The outputs of one shot, or a word for why there are none.
    #[allow(clippy::needless_pass_by_value)]
    fn impact<'py>(
        &self,
        py: Python<'py>,
        inputs: Vec<f64>,
        parameters: Vec<f64>,
        tolerance: f64,
    ) -> PyResult<(Option<Bound<'py, PyArray1<f64>>>, &'static str)> {
        let touch = FirstTouch::from_inputs(all_inputs(&inputs).map_err(|e| value_error(&e))?);
        Ok(match self.launch(&touch, &parameters, tolerance)? {
            Ok(outputs) => (Some(PyArray1::from_slice(py, &outputs)), ""),
            Err(unfinished) => (None, word(unfinished)),
        })
    }

    /// The outputs of one shot and their derivatives by `variables`, indices into the inputs followed by the parameters:
    /// (outputs, outputs by variables), or a word for why there are none.
    #[allow(clippy::needless_pass_by_value)]
    fn sensitivity<'py>(
        &self,
        py: Python<'py>,
        inputs: Vec<f64>,
        parameters: Vec<f64>,
        variables: Vec<usize>,
        tolerance: f64,
    ) -> PyResult<(Option<Derivatives<'py>>, &'static str)> {
        let inputs: &[f64; INPUT_COUNT] = all_inputs(&inputs).map_err(|e| value_error(&e))?;
        let mut outputs = [f64::NAN; OUTPUT_COUNT];
        let mut jacobian = vec![vec![0.0; variables.len()]; OUTPUT_COUNT];
        for (chunk, chosen) in variables.chunks(WIDTH).enumerate() {
            let seed = |index: usize, value: f64| {
                let mut dual = Tangents::constant(value);
                for (tangent, &variable) in dual.tangent.iter_mut().zip(chosen) {
                    *tangent = f64::from(u8::from(variable == index));
                }
                dual
            };
            let seeded: [Tangents; INPUT_COUNT] = std::array::from_fn(|i| seed(i, inputs[i]));
            let values: Vec<_> =
                parameters.iter().enumerate().map(|(i, &value)| seed(INPUT_COUNT + i, value)).collect();
            match self.launch(&FirstTouch::from_inputs(&seeded), &values, tolerance)? {
                Err(unfinished) => return Ok((None, word(unfinished))),
                Ok(launched) => {
                    for (row, value) in launched.iter().enumerate() {
                        outputs[row] = value.value;
                        let at = chunk * WIDTH;
                        jacobian[row][at..at + chosen.len()].copy_from_slice(&value.tangent[..chosen.len()]);
                    }
                }
            }
        }
        Ok((Some((PyArray1::from_slice(py, &outputs), PyArray2::from_vec2(py, &jacobian)?)), ""))
    }
}
