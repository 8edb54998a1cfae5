//! Faces: outlines, and what is integrated and searched over them.

use crate::columns::value_error;
use clubface_design::face_map::{FINE, Field, LAUNCHED, QUANTITIES, Scatter};
use clubface_design::outline::{Outline, SLACK};
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// What is known of a point of a face, that of the launch first, and how many these are.
#[pyfunction]
pub fn face_quantities() -> (Vec<&'static str>, usize) {
    (QUANTITIES.to_vec(), LAUNCHED)
}

/// Points along a side of the grid on which the area of a computed face is measured, at least.
#[pyfunction]
pub fn face_fine() -> usize {
    FINE
}

/// Share of swings that miss the face; mean, deviation and loss of each quantity.
type Costs = (f64, Vec<f64>, Vec<f64>, Vec<f64>);

/// The outline of a face: see `clubface.design.face_surface.Outline`.
#[pyclass(module = "clubface._core", frozen)]
pub struct FaceOutline(Outline);

#[pymethods]
impl FaceOutline {
    /// Of corners, towards the toe and up the face.
    #[new]
    fn new(corners: Vec<[f64; 2]>) -> PyResult<Self> {
        Outline::new(corners).map(Self).map_err(|e| value_error(&e))
    }

    /// Least and greatest heights at places towards the toe.
    #[allow(clippy::needless_pass_by_value)]
    fn extent<'py>(
        &self,
        py: Python<'py>,
        toe: PyReadonlyArray1<'py, f64>,
    ) -> (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>) {
        let (low, top): (Vec<f64>, Vec<f64>) = toe.as_array().iter().map(|&toe| self.0.extent(toe)).unzip();
        (PyArray1::from_vec(py, low), PyArray1::from_vec(py, top))
    }

    /// Whether points are inside, on the outline, or less than `slack` off it.
    #[pyo3(signature = (toe, high, slack=SLACK))]
    #[allow(clippy::needless_pass_by_value)]
    fn holds<'py>(
        &self,
        py: Python<'py>,
        toe: PyReadonlyArray1<'py, f64>,
        high: PyReadonlyArray1<'py, f64>,
        slack: f64,
    ) -> Bound<'py, PyArray1<bool>> {
        let (toe, high) = (toe.as_array(), high.as_array());
        let points = toe.iter().zip(high);
        PyArray1::from_iter(py, points.map(|(&toe, &high)| self.0.holds_about(toe, high, slack)))
    }

    fn area(&self) -> f64 {
        self.0.area()
    }

    /// Where values over a grid, and those that `at` returns of arrays of points, are greatest: the point and the value.
    #[allow(clippy::needless_pass_by_value)]
    fn greatest<'py>(
        &self,
        py: Python<'py>,
        toe: Vec<f64>,
        high: Vec<f64>,
        values: PyReadonlyArray2<'py, f64>,
        at: Bound<'py, PyAny>,
    ) -> PyResult<Option<(f64, f64, f64)>> {
        let values = grid_values(&values, &toe, &high)?;
        let field = Field { toe: &toe, high: &high, values: &values };
        let best = field.greatest(&self.0, |toe, high| numbers(&called(py, &at, toe, high)?))?;
        Ok(best.map(|best| (best.toe, best.high, best.value)))
    }

    /// The area within which values over a grid, and those that `at` returns of arrays of points, are at least so great.
    #[allow(clippy::needless_pass_by_value)]
    fn area_above<'py>(
        &self,
        py: Python<'py>,
        toe: Vec<f64>,
        high: Vec<f64>,
        values: PyReadonlyArray2<'py, f64>,
        least: f64,
        at: Bound<'py, PyAny>,
    ) -> PyResult<f64> {
        let values = grid_values(&values, &toe, &high)?;
        let field = Field { toe: &toe, high: &high, values: &values };
        field.area(&self.0, least, |toe, high| numbers(&called(py, &at, toe, high)?))
    }

    /// What impacts cost that scatter about a point; `at` returns quantities by points.
    #[allow(clippy::needless_pass_by_value)]
    fn scatter<'py>(
        &self,
        py: Python<'py>,
        about: [f64; 2],
        deviations: [f64; 2],
        at: Bound<'py, PyAny>,
    ) -> PyResult<Costs> {
        let costs = Scatter { about, deviations }.forgiveness(&self.0, |toe, high| {
            let table = called(py, &at, toe, high)?.extract::<PyReadonlyArray2<'py, f64>>()?;
            Ok::<_, PyErr>(table.as_array().rows().into_iter().map(|row| row.to_vec()).collect())
        })?;
        Ok((costs.missed, costs.mean, costs.deviation, costs.loss))
    }
}

fn called<'py>(
    py: Python<'py>,
    at: &Bound<'py, PyAny>,
    toe: &[f64],
    high: &[f64],
) -> PyResult<Bound<'py, PyAny>> {
    at.call1((PyArray1::from_slice(py, toe), PyArray1::from_slice(py, high)))
}

fn numbers(values: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    Ok(values.extract::<PyReadonlyArray1<'_, f64>>()?.as_array().to_vec())
}

/// Values row by row, as many as there are points.
fn grid_values(values: &PyReadonlyArray2<'_, f64>, toe: &[f64], high: &[f64]) -> PyResult<Vec<f64>> {
    if values.shape() != [high.len(), toe.len()] || values.is_empty() {
        return Err(PyValueError::new_err("values: other points than those of the grid"));
    }
    Ok(values.as_array().iter().copied().collect())
}
