//! What can be wrong with an impact.

use std::fmt;

/// An input or parameter that makes no sense, or an integration that failed.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactError {
    /// Name of the input or parameter at fault.
    pub input: &'static str,
    /// Its value, what is allowed and what to do.
    pub message: String,
}

impl std::error::Error for ImpactError {}

impl fmt::Display for ImpactError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.input, self.message)
    }
}

impl ImpactError {
    /// An error about one input.
    pub fn new(input: &'static str, message: impl Into<String>) -> Self {
        Self { input, message: message.into() }
    }
}

/// As many values as there are inputs.
///
/// # Errors
/// Another number of values.
pub fn all_inputs<const N: usize>(values: &[f64]) -> Result<&[f64; N], ImpactError> {
    values
        .try_into()
        .map_err(|_| ImpactError::new("inputs", format!("{} values given, {N} needed", values.len())))
}
