//! Flights: batches, trajectories, derivatives.

use crate::columns::{Computed, Derivatives, Values, arrays, column, columns, run_in_pieces, value_error};
use clubface_impact::batch::CHUNK;
use clubface_impact::columns::Column;
use clubface_impact::error::all_inputs;
use clubface_impact::flight::shot_shape::{curve_from, shot_shape};
use clubface_impact::flight::{self, DIFFERENTIATED, FlightBatch, FlightSensitivities, OUTPUT_COUNT};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Flights of `n` launches: (array of outputs by flights, [(row, input, message), ...]).
///
/// `inputs` are columns in the order of `flight_inputs()`, each a number or a contiguous array of n numbers. Rows that
/// cannot be flown are NaN and listed.
#[pyfunction]
#[pyo3(signature = (inputs, n, threads=0, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fly<'py>(
    py: Python<'py>,
    inputs: Vec<Values<'py>>,
    n: usize,
    threads: usize,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Computed<'py>> {
    let inputs: Vec<Column> = columns(&inputs)?;
    let batch = FlightBatch { inputs: &inputs };
    batch.validate(n).map_err(|e| value_error(&e))?;
    run_in_pieces(py, OUTPUT_COUNT, n, CHUNK, threads, progress.as_ref(), |rows, out| batch.run(rows, out))
}

/// Chosen outputs of `n` flights with their derivatives by chosen inputs: (array, [(row, input, message), ...]).
///
/// The array has n columns and, for each output, a row of its values and one of derivatives a variable. `outputs` and
/// `variables` are indices into `flight_outputs()` and `flight_inputs()`. The rest as for `fly`.
#[pyfunction]
#[pyo3(signature = (inputs, n, outputs, variables, threads=0, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn fly_sensitivities<'py>(
    py: Python<'py>,
    inputs: Vec<Values<'py>>,
    n: usize,
    outputs: Vec<usize>,
    variables: Vec<usize>,
    threads: usize,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Computed<'py>> {
    let inputs: Vec<Column> = columns(&inputs)?;
    let batch = FlightBatch { inputs: &inputs };
    let wanted = FlightSensitivities { batch, outputs: &outputs, variables: &variables };
    wanted.validate(n).map_err(|e| value_error(&e))?;
    let count = wanted.columns();
    run_in_pieces(py, count, n, DIFFERENTIATED, threads, progress.as_ref(), |rows, out| wanted.run(rows, out))
}

/// Path of one flight: arrays time, position, velocity and spin over its points.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn trajectory(py: Python<'_>, inputs: Vec<f64>) -> PyResult<Bound<'_, PyDict>> {
    let track = all_inputs(&inputs).and_then(flight::trajectory).map_err(|e| value_error(&e))?;
    arrays(py, track.series())
}

/// One flight and its derivatives: (outputs, array of outputs by inputs).
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn fly_sensitivity<'py>(py: Python<'py>, inputs: Vec<f64>) -> PyResult<Derivatives<'py>> {
    let result = all_inputs(&inputs).and_then(flight::sensitivity).map_err(|e| value_error(&e))?;
    let rows: Vec<Vec<f64>> = result.jacobian.iter().map(|row| row.to_vec()).collect();
    Ok((PyArray1::from_slice(py, &result.values), PyArray2::from_vec2(py, &rows)?))
}

/// What golfers call `n` shots: a list of names, empty for one that does not fly. Each column is a number or n numbers.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn shot_shape_names(
    azimuth: Values<'_>,
    curve: Values<'_>,
    carry: Values<'_>,
    hand: Values<'_>,
    n: usize,
) -> PyResult<Vec<&'static str>> {
    let [azimuth, curve, carry, hand] = [&azimuth, &curve, &carry, &hand].map(column);
    let (azimuth, curve, carry, hand) = (azimuth?, curve?, carry?, hand?);
    Ok((0..n).map(|i| shot_shape(azimuth.at(i), curve.at(i), carry.at(i), hand.at(i))).collect())
}

/// How far `n` shots curve, m, from launch direction, carry and side. Each column is a number or n numbers.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn curves<'py>(
    py: Python<'py>,
    azimuth: Values<'py>,
    carry: Values<'py>,
    side: Values<'py>,
    n: usize,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let [azimuth, carry, side] = [&azimuth, &carry, &side].map(column);
    let (azimuth, carry, side) = (azimuth?, carry?, side?);
    let values: Vec<f64> = (0..n).map(|i| curve_from(azimuth.at(i), carry.at(i), side.at(i))).collect();
    Ok(PyArray1::from_vec(py, values))
}
