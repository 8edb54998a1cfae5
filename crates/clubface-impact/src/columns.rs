//! Shots in columns: what goes into a batch, and how packs read it.

use crate::error::ImpactError;
use crate::impact::Accuracy;
use clubface_math::Numbers;

/// One input of a batch: the same for all shots, or one value a shot.
#[derive(Clone, Copy, Debug)]
pub enum Column<'a> {
    /// The same for all shots.
    Constant(f64),
    /// One value a shot.
    Values(&'a [f64]),
}

impl Column<'_> {
    /// Value for one shot.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, row: usize) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Values(values) => values[row],
        }
    }
}

/// A shot that could not be computed; its outputs are NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct Reject {
    /// Row of the batch, from 0.
    pub row: usize,
    /// What is wrong.
    pub error: ImpactError,
}

/// What the kernel of a model is given.
#[derive(Clone, Copy, Debug)]
pub struct Shots<'a> {
    /// Columns in the order of [`INPUTS`](crate::shot::INPUTS).
    pub inputs: &'a [Column<'a>],
    /// Columns in the order of the model's parameters.
    pub parameters: &'a [Column<'a>],
    /// Accuracy of contact models.
    pub accuracy: Accuracy,
}

/// The widest pack.
pub const MOST_LANES: usize = 8;
/// Two of them side by side.
pub const MOST_ROWS: usize = 2 * MOST_LANES;

/// Values of `used` rows from `start`, one a lane; lanes beyond the last row repeat it.
#[inline(always)]
pub fn gather<S: Numbers, const N: usize>(columns: &[Column], start: usize, used: usize) -> [S; N] {
    let mut values = [S::zero(); N];
    gather_into(&mut values, columns, start, used);
    values
}

/// The same into the first places of `values`.
#[inline(always)]
pub fn gather_into<S: Numbers>(values: &mut [S], columns: &[Column], start: usize, used: usize) {
    for (value, column) in values.iter_mut().zip(columns) {
        *value = match column {
            Column::Constant(constant) => S::from_f64(*constant),
            Column::Values(column) if used == S::LANES => S::from_slice(&column[start..]),
            Column::Values(column) => S::from_fn(|lane| column[start + lane.min(used - 1)]),
        };
    }
}
