//! What is compiled once for every model: launches in packs, launches with derivatives, one launch with its history.
//!
//! Only the impact itself is compiled for each model; what stands around it is one function for each kind of number.

mod derivatives;
mod history;
mod launches;

pub use derivatives::{derivatives, Differentiated};
pub use history::history;
pub use launches::launches;

use crate::contact::Recorder;
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::model::Model;
use clubface_math::{Computation, Scalar};

/// Largest number of parameters a model may have.
pub const MOST_PARAMETERS: usize = 16;

/// The impact of a model, a function of its own for each kind of number.
struct Run<'a, M, S, R> {
    model: M,
    touch: &'a FirstTouch<S>,
    accuracy: Accuracy,
    recorder: &'a mut R,
}

impl<M: Model<S>, S: Scalar, R: Recorder<S>> Computation for Run<'_, M, S, R> {
    type Output = Impact<S>;
    #[inline(always)]
    fn run(self) -> Impact<S> {
        self.model.impact(self.touch, self.accuracy, self.recorder)
    }
}
