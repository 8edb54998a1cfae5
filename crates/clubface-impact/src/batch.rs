//! Launches of many shots: columns in, columns out.

use crate::columns::{Column, Reject, Shots};
use crate::error::ImpactError;
use crate::impact::Accuracy;
use crate::impact_model::ImpactModel;
use crate::shot::INPUT_COUNT;
use core::ops::Range;

/// Shots to compute.
#[derive(Clone, Copy, Debug)]
pub struct Batch<'a> {
    /// The model.
    pub model: ImpactModel,
    /// Columns in the order of [`INPUTS`](crate::shot::INPUTS).
    pub inputs: &'a [Column<'a>],
    /// Columns in the order of the model's parameters.
    pub parameters: &'a [Column<'a>],
    /// Accuracy of contact models.
    pub accuracy: Accuracy,
}

/// Shots a task takes: whole packs of any width, and few enough that even rings, at some 0.3 ms a shot, let a caller
/// look at signals within 0.1 s.
pub const CHUNK: usize = 64;

impl Batch<'_> {
    /// Checks that the batch is complete: columns, parameters, lengths.
    ///
    /// # Errors
    /// What does not fit.
    pub fn validate(&self, rows: usize) -> Result<(), ImpactError> {
        let info = self.model.info();
        let wanted =
            [("inputs", INPUT_COUNT, self.inputs), ("parameters", info.parameters.len(), self.parameters)];
        for (name, count, columns) in wanted {
            if columns.len() != count {
                let message = format!("{} columns given, {count} needed", columns.len());
                return Err(ImpactError::new(name, message));
            }
            for column in columns {
                if let Column::Values(values) = column
                    && values.len() != rows
                {
                    let message = format!("a column has {} rows, the batch {rows}", values.len());
                    return Err(ImpactError::new(name, message));
                }
            }
        }
        Ok(())
    }

    /// Computes `rows` into `outputs`, one slice an output, each as long as `rows`, on the calling thread. Rows that
    /// cannot be computed are NaN and returned with reasons. A shot does not depend on its neighbours, so rows may be
    /// shared out among threads, [`CHUNK`] at a time.
    #[must_use]
    pub fn run(&self, rows: Range<usize>, mut outputs: Vec<&mut [f64]>) -> Vec<Reject> {
        let Self { model, inputs, parameters, accuracy } = *self;
        model.launches(&Shots { inputs, parameters, accuracy }, rows, &mut outputs)
    }
}
