//! What Python describes, and errors about it.

use clubface_fem::FemError;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pythonize::depythonize;
use serde::de::DeserializeOwned;

/// What Python describes by dictionaries, lists and numbers.
pub struct Described<T>(pub(super) T);

impl<'py, T: DeserializeOwned> FromPyObject<'_, 'py> for Described<T> {
    type Error = PyErr;
    fn extract(value: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(depythonize(&value)?))
    }
}

pub(super) fn to_py_error(error: &FemError) -> PyErr {
    match error {
        FemError::Input { name, value, allowed } => {
            PyValueError::new_err((name.clone(), value.clone(), allowed.clone()))
        }
        other => PyValueError::new_err(("", "", other.to_string())),
    }
}
