//! Shots of golfers, and where they go.

use crate::columns::{run_in_pieces, value_error};
use clubface_design::dispersion::{LAUNCHED, QUANTITIES};
use clubface_design::feasibility::{self, Envelope, MassProperties, Matrix, Shape, Volume};
use clubface_design::golfer::Golfer;
use clubface_design::sequence::{MOST_DIMENSIONS, Sequence};
use clubface_design::strokes::{Hole, StrokesTable};
use clubface_design::tally::{Scale, Tally};
use clubface_impact::parallel::thread_pool;
use numpy::{PyArray1, PyArray2, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Shots that a thread takes at a time.
const CHUNK: usize = 1024;

/// Numbers between 0 and 1 of a scrambled Sobol sequence, from index `first` on: an array of dimensions by points.
#[pyfunction]
#[pyo3(signature = (dimensions, count, seed=0, first=0, threads=0))]
pub fn quasi_random(
    py: Python<'_>,
    dimensions: usize,
    count: usize,
    seed: u64,
    first: u32,
    threads: usize,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    if dimensions > MOST_DIMENSIONS {
        let message = format!("{dimensions} dimensions; at most {MOST_DIMENSIONS}");
        return Err(PyValueError::new_err(("dimensions", message)));
    }
    let sequences: Vec<Sequence> = (0..dimensions).map(|dimension| Sequence::new(dimension, seed)).collect();
    let (numbers, _) = run_in_pieces(py, dimensions, count, CHUNK, threads, None, |rows, out| {
        for (sequence, numbers) in sequences.iter().zip(out) {
            sequence.fill(first.wrapping_add(rows.start as u32), numbers);
        }
        Vec::new()
    })?;
    Ok(numbers)
}

/// Deliveries of a golfer, an array of variables by shots, from numbers between 0 and 1: a contiguous array a
/// dimension. The covariance is given row by row.
#[pyfunction]
#[pyo3(signature = (mean, covariance, mirrored, mishit_share, mishit_scale, uniform, threads=0))]
#[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
pub fn golfer_deliveries<'py>(
    py: Python<'py>,
    mean: Vec<f64>,
    covariance: Vec<f64>,
    mirrored: Vec<bool>,
    mishit_share: f64,
    mishit_scale: f64,
    uniform: Vec<PyReadonlyArray1<'py, f64>>,
    threads: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let golfer = Golfer::new(mean, &covariance, mirrored, mishit_share, mishit_scale);
    let golfer = golfer.map_err(|e| value_error(&e))?;
    let uniform = slices(&uniform)?;
    let count = uniform.first().map_or(0, |column| column.len());
    let (deliveries, _) =
        run_in_pieces(py, golfer.variables(), count, CHUNK, threads, None, |rows, mut out| {
            let part: Vec<&[f64]> = uniform.iter().map(|column| &column[rows.clone()]).collect();
            golfer.deliveries(&part, &mut out);
            Vec::new()
        })?;
    Ok(deliveries)
}

fn table((distance, strokes): (Vec<f64>, Vec<f64>)) -> PyResult<StrokesTable> {
    StrokesTable::new(distance, strokes).map_err(|e| value_error(&e))
}

/// Strokes at distances by a table of distances and strokes.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn strokes_at<'py>(
    py: Python<'py>,
    distance: Vec<f64>,
    strokes: Vec<f64>,
    at: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let table = table((distance, strokes))?;
    Ok(PyArray1::from_iter(py, at.as_array().iter().map(|&distance| table.at(distance))))
}

/// Places among the lies, and strokes.
type LiesAndStrokes<'py> = (Bound<'py, PyArray1<u32>>, Bound<'py, PyArray1<f64>>);

/// Lies and strokes of balls at rest on a hole of length, widths of fairway and rough, and radius of the green; tables
/// of distances and strokes from green, fairway, rough and recovery.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn hole_strokes<'py>(
    py: Python<'py>,
    ahead: PyReadonlyArray1<'py, f64>,
    right: PyReadonlyArray1<'py, f64>,
    hole: (f64, f64, f64, f64),
    tables: [(Vec<f64>, Vec<f64>); 4],
) -> PyResult<LiesAndStrokes<'py>> {
    let (length, fairway, rough, green) = hole;
    let [a, b, c, d] = tables.map(table);
    let hole = Hole { length, fairway, rough, green, tables: [a?, b?, c?, d?] };
    let places = ahead.as_array().into_iter().zip(right.as_array());
    let (lies, strokes): (Vec<u32>, Vec<f64>) = places
        .map(|(&ahead, &right)| hole.after(ahead, right))
        .map(|(lie, strokes)| (lie as u32, strokes))
        .unzip();
    Ok((PyArray1::from_vec(py, lies), PyArray1::from_vec(py, strokes)))
}

/// What is counted of shots: (name, least, most, bins), those of the launch first, and how many these are.
#[pyfunction]
pub fn dispersion_quantities() -> (Vec<(&'static str, f64, f64, usize)>, usize) {
    let all = QUANTITIES.iter().map(|(name, scale)| (*name, scale.least, scale.most, scale.bins));
    (all.collect(), LAUNCHED)
}

/// Shape, centre and size of a volume.
type Space = (String, [f64; 3], [f64; 3]);

fn volume((shape, centre, size): &Space) -> PyResult<Volume> {
    let shape = Shape::named(shape).map_err(|e| value_error(&e))?;
    Volume::new(shape, *centre, *size).map_err(|e| value_error(&e))
}

/// The pseudo-inertia of a body with these mass properties, row by row.
#[pyfunction]
pub fn pseudo_inertia(values: MassProperties) -> Matrix {
    feasibility::pseudo_inertia(&values)
}

/// Quadratic forms of which no body in a volume has a negative trace: what is wrong otherwise, and the matrix by rows.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn volume_forms(space: Space) -> PyResult<Vec<(String, Matrix)>> {
    Ok(volume(&space)?.forms().into_iter().map(|form| (form.words, form.matrix)).collect())
}

/// Margins of a head, each its name, value and reason: with a `shell`, and a `budget` that may be `placed` in a volume.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn head_margins(
    placed: Space,
    whole: Space,
    shell: Matrix,
    budget: f64,
    pseudo: Matrix,
) -> PyResult<Vec<(String, f64, String)>> {
    let envelope = Envelope::new(volume(&placed)?, volume(&whole)?, shell, Some(budget));
    let envelope = envelope.map_err(|e| value_error(&e))?;
    Ok((envelope.margins(&pseudo).into_iter()).map(|each| (each.name, each.value, each.reason)).collect())
}

fn slices<'a>(columns: &'a [PyReadonlyArray1<'_, f64>]) -> PyResult<Vec<&'a [f64]>> {
    (columns.iter().map(PyReadonlyArray1::as_slice).collect::<Result<_, _>>())
        .map_err(|_| PyValueError::new_err("a column is not contiguous in memory; pass a copy of it"))
}

/// Counts of shots: see `clubface.design.dispersion.ShotTally`.
#[pyclass(module = "clubface._core")]
pub struct ShotTally(Tally);

#[pymethods]
impl ShotTally {
    /// Of quantities, each (least, most, bins, centre); `landing`: places of carry and side among them.
    #[new]
    #[pyo3(signature = (quantities, landing=None))]
    #[allow(clippy::needless_pass_by_value)]
    fn new(quantities: Vec<(f64, f64, usize, f64)>, landing: Option<[usize; 2]>) -> Self {
        let scales: Vec<(Scale, f64)> = quantities
            .iter()
            .map(|&(least, most, bins, centre)| (Scale { least, most, bins }, centre))
            .collect();
        Self(Tally::new(&scales, landing))
    }

    #[getter]
    fn shots(&self) -> u64 {
        self.0.shots
    }

    #[getter]
    fn lost(&self) -> u64 {
        self.0.lost
    }

    /// Counts shots: a contiguous array a quantity.
    #[pyo3(signature = (columns, threads=0))]
    #[allow(clippy::needless_pass_by_value)]
    fn add(
        &mut self,
        py: Python<'_>,
        columns: Vec<PyReadonlyArray1<'_, f64>>,
        threads: usize,
    ) -> PyResult<()> {
        let columns = slices(&columns)?;
        let pool = thread_pool(threads).map_err(|e| PyValueError::new_err(format!("threads: {e}")))?;
        let tally = &mut self.0;
        py.detach(|| pool.install(|| tally.add(&columns)));
        Ok(())
    }

    fn mean(&self, quantity: usize) -> f64 {
        self.0.mean(quantity)
    }

    fn spread(&self, quantity: usize) -> f64 {
        self.0.spread(quantity)
    }

    fn quantile(&self, quantity: usize, share: f64) -> f64 {
        self.0.quantile(quantity, share)
    }

    /// Edges and counts.
    fn histogram<'py>(
        &self,
        py: Python<'py>,
        quantity: usize,
        width: f64,
    ) -> (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u64>>) {
        let (edges, counts) = self.0.histogram(quantity, width);
        (PyArray1::from_vec(py, edges), PyArray1::from_vec(py, counts))
    }

    /// Mean landing; variances ahead and to the right, and covariance.
    fn landing(&self) -> ([f64; 2], [f64; 3]) {
        self.0.landing()
    }

    /// Centre, half axes and angle of the ellipse that holds a share of the landings.
    fn ellipse(&self, share: f64) -> ([f64; 2], [f64; 2], f64) {
        let ellipse = self.0.ellipse(share);
        (ellipse.centre, ellipse.half_axes, ellipse.angle)
    }
}
