//! Columns from Python, and long work in pieces between which Python may interrupt.

use clubface_impact::columns::{Column, Reject};
use clubface_impact::parallel::{in_parallel, thread_pool};
use clubface_impact::series::Series;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat};
use std::ops::Range;
use std::time::{Duration, Instant};

/// A number, or one number a row.
pub enum Values<'py> {
    /// The same for all rows.
    Constant(f64),
    /// One a row.
    Rows(PyReadonlyArray1<'py, f64>),
}

// Not derived: an array of one is rows, though NumPy before 2.4 takes it for a number, with a warning.
impl<'py> FromPyObject<'_, 'py> for Values<'py> {
    type Error = PyErr;

    fn extract(value: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if !value.is_instance_of::<PyFloat>() && value.cast::<PyArray1<f64>>().is_ok() {
            return Ok(Values::Rows(value.extract()?));
        }
        Ok(Values::Constant(value.extract()?))
    }
}

/// Columns as the core takes them.
pub fn columns<'a>(values: &'a [Values<'_>]) -> PyResult<Vec<Column<'a>>> {
    values.iter().map(column).collect()
}

/// A column as the core takes it.
pub fn column<'a>(values: &'a Values<'_>) -> PyResult<Column<'a>> {
    match values {
        Values::Constant(constant) => Ok(Column::Constant(*constant)),
        Values::Rows(rows) => rows
            .as_slice()
            .map(Column::Values)
            .map_err(|_| PyValueError::new_err("a column is not contiguous in memory; pass a copy of it")),
    }
}

/// An error of the core as `ValueError(name, message)`.
pub fn value_error(error: &clubface_impact::ImpactError) -> PyErr {
    PyValueError::new_err((error.input, error.message.clone()))
}

/// Longest time without a look at signals.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(40);

/// Computed rows: outputs by rows, and rejects as (row, input, message).
pub type Computed<'py> = (Bound<'py, PyArray2<f64>>, Vec<(usize, &'static str, String)>);

/// Values of the outputs, and their derivatives: outputs by variables.
pub type Derivatives<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

/// Runs `work` over `rows` on `threads` threads (0: all), in pieces of at most about 40 ms, into an array of `outputs`
/// by `rows`; a thread takes `chunk` rows at a time. Between pieces, reports the rows done to `progress` and lets
/// Python interrupt.
#[allow(clippy::too_many_arguments)]
pub fn run_in_pieces<'py>(
    py: Python<'py>,
    outputs: usize,
    rows: usize,
    chunk: usize,
    threads: usize,
    progress: Option<&Bound<'py, PyAny>>,
    work: impl Fn(Range<usize>, Vec<&mut [f64]>) -> Vec<Reject> + Sync + Send,
) -> PyResult<Computed<'py>> {
    // SAFETY: every element is written below before the array is returned, or the array is dropped.
    let array = unsafe { PyArray2::<f64>::new(py, [outputs, rows], false) };
    let mut rejects = Vec::new();
    {
        let mut writer = array.readwrite();
        let all =
            writer.as_slice_mut().map_err(|_| PyValueError::new_err("output array is not contiguous"))?;
        // Few rows: a thread hand-over would cost more than the GIL held for them.
        let pool = (rows > chunk)
            .then(|| thread_pool(threads))
            .transpose()
            .map_err(|e| PyValueError::new_err(format!("threads: {e}")))?;
        let workers = pool.as_ref().map_or(1, |pool| pool.current_num_threads());
        let mut columns: Vec<&mut [f64]> = all.chunks_mut(rows.max(1)).collect();
        let mut start = 0;
        let mut piece = chunk * workers;
        while start < rows {
            let count = piece.min(rows - start);
            let mut parts = Vec::with_capacity(outputs);
            for column in &mut columns {
                let (part, rest) = std::mem::take(column).split_at_mut(count);
                parts.push(part);
                *column = rest;
            }
            let began = Instant::now();
            let result = match &pool {
                None => work(start..start + count, parts),
                Some(pool) => {
                    py.detach(|| pool.install(|| in_parallel(chunk, start..start + count, parts, &work)))
                }
            };
            rejects.extend(result.into_iter().map(|r| (r.row, r.error.input, r.error.message)));
            start += count;
            let elapsed = began.elapsed();
            if elapsed < SIGNAL_INTERVAL / 4 {
                piece *= 2;
            } else if elapsed > SIGNAL_INTERVAL && piece > chunk {
                piece = (piece / 2).next_multiple_of(chunk);
            }
            if rows > chunk {
                py.check_signals()?;
            }
            if let Some(progress) = progress {
                progress.call1((start,))?;
            }
        }
    }
    Ok((array, rejects))
}

/// A dictionary of arrays.
pub fn arrays(py: Python<'_>, all: impl IntoIterator<Item = Series>) -> PyResult<Bound<'_, PyDict>> {
    let dict = PyDict::new(py);
    for Series { name, shape, values } in all {
        dict.set_item(name, PyArray1::from_vec(py, values).reshape(shape)?)?;
    }
    Ok(dict)
}
