//! Named arrays over the records of a computation, as bindings hand them to other languages.

/// An array with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name.
    pub name: &'static str,
    /// Its shape: the number of records, and of numbers in each where there are several.
    pub shape: Vec<usize>,
    /// Its numbers, record after record.
    pub values: Vec<f64>,
}

impl Series {
    /// A number of each record.
    pub fn scalars<T>(name: &'static str, records: &[T], value: impl FnMut(&T) -> f64) -> Self {
        Self { name, shape: vec![records.len()], values: records.iter().map(value).collect() }
    }

    /// Several numbers of each record.
    pub fn vectors<T, const N: usize>(
        name: &'static str,
        records: &[T],
        value: impl FnMut(&T) -> [f64; N],
    ) -> Self {
        Self { name, shape: vec![records.len(), N], values: records.iter().flat_map(value).collect() }
    }
}
