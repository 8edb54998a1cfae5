//! Impacts: batches, histories, derivatives.

use crate::columns::{Computed, Derivatives, Values, arrays, columns, run_in_pieces, value_error};
use clubface_impact::batch::{Batch, CHUNK};
use clubface_impact::check::{check_ball, check_club};
use clubface_impact::columns::Column;
use clubface_impact::error::all_inputs;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::registry::named;
use clubface_impact::sensitivity::{CHUNK as DIFFERENTIATED, Sensitivities, sensitivity_to_all};
use clubface_impact::{Accuracy, ImpactError};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

fn batch<'a>(
    model: &str,
    inputs: &'a [Column<'a>],
    parameters: &'a [Column<'a>],
    accuracy: Option<f64>,
) -> Result<Batch<'a>, ImpactError> {
    Ok(Batch { model: named(model)?, inputs, parameters, accuracy: Accuracy::from_tolerance(accuracy)? })
}

/// Launches of `n` shots: (array of outputs by shots, [(row, input, message), ...]).
///
/// `inputs` and `parameters` are columns in the order of `inputs()` and of the model's parameters, each a number or a
/// contiguous array of n numbers. Rows that cannot be computed are NaN and listed.
#[pyfunction]
#[pyo3(signature = (model, inputs, parameters, n, accuracy=None, threads=0, progress=None))]
#[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
pub fn impact<'py>(
    py: Python<'py>,
    model: &str,
    inputs: Vec<Values<'py>>,
    parameters: Vec<Values<'py>>,
    n: usize,
    accuracy: Option<f64>,
    threads: usize,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Computed<'py>> {
    let (inputs, parameters) = (columns(&inputs)?, columns(&parameters)?);
    let batch = batch(model, &inputs, &parameters, accuracy).map_err(|e| value_error(&e))?;
    batch.validate(n).map_err(|e| value_error(&e))?;
    run_in_pieces(py, OUTPUT_COUNT, n, CHUNK, threads, progress.as_ref(), |rows, out| batch.run(rows, out))
}

/// Chosen outputs of `n` shots with their derivatives by chosen variables: (array, [(row, input, message), ...]).
///
/// The array has n columns and, for each output, a row of its values and one of derivatives a variable. `outputs` and
/// `variables` are indices: into `outputs()`, and into the inputs followed by the parameters. The rest as for `impact`.
#[pyfunction]
#[pyo3(signature = (model, inputs, parameters, n, outputs, variables, accuracy=None, threads=0, progress=None))]
#[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
pub fn sensitivities<'py>(
    py: Python<'py>,
    model: &str,
    inputs: Vec<Values<'py>>,
    parameters: Vec<Values<'py>>,
    n: usize,
    outputs: Vec<usize>,
    variables: Vec<usize>,
    accuracy: Option<f64>,
    threads: usize,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Computed<'py>> {
    let (inputs, parameters) = (columns(&inputs)?, columns(&parameters)?);
    let batch = batch(model, &inputs, &parameters, accuracy).map_err(|e| value_error(&e))?;
    let wanted = Sensitivities { batch, outputs: &outputs, variables: &variables };
    wanted.validate(n).map_err(|e| value_error(&e))?;
    let count = wanted.columns();
    run_in_pieces(py, count, n, DIFFERENTIATED, threads, progress.as_ref(), |rows, out| wanted.run(rows, out))
}

/// What is wrong with the club or the ball ("club", "ball") among the inputs of a shot: None, or (input, message).
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn check(group: &str, inputs: Vec<f64>) -> PyResult<Option<(&'static str, String)>> {
    let inputs = all_inputs(&inputs).map_err(|e| value_error(&e))?;
    let computed = if group == "ball" { check_ball(inputs) } else { check_club(inputs) };
    Ok(computed.err().map(|e| (e.input, e.message)))
}

/// Launch of one shot and its derivatives: (outputs, array of outputs by (inputs + parameters)). The derivative by an
/// input that is not differentiable is NaN.
#[pyfunction]
#[pyo3(signature = (model, inputs, parameters, accuracy=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn sensitivity<'py>(
    py: Python<'py>,
    model: &str,
    inputs: Vec<f64>,
    parameters: Vec<f64>,
    accuracy: Option<f64>,
) -> PyResult<Derivatives<'py>> {
    let shot = || {
        let accuracy = Accuracy::from_tolerance(accuracy)?;
        sensitivity_to_all(named(model)?, all_inputs(&inputs)?, &parameters, accuracy)
    };
    let result = py.detach(shot).map_err(|e| value_error(&e))?;
    Ok((PyArray1::from_slice(py, &result.values), PyArray2::from_vec2(py, &result.jacobian)?))
}

/// History of one shot by a contact model: a dictionary of arrays over the steps (see `clubface.history`), and its
/// outputs under "launch".
#[pyfunction]
#[pyo3(signature = (model, inputs, parameters, accuracy=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn history<'py>(
    py: Python<'py>,
    model: &str,
    inputs: Vec<f64>,
    parameters: Vec<f64>,
    accuracy: Option<f64>,
) -> PyResult<Bound<'py, PyDict>> {
    let shot = || {
        let accuracy = Accuracy::from_tolerance(accuracy)?;
        named(model)?.history(all_inputs(&inputs)?, &parameters, accuracy)
    };
    let (history, launch) = py.detach(shot).map_err(|e| value_error(&e))?;
    let dict = arrays(py, history.series())?;
    dict.set_item("launch", PyArray1::from_slice(py, &launch))?;
    Ok(dict)
}
