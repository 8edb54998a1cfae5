//! The impact of one model.

use crate::contact::Recorder;
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::model::Model;
use clubface_math::{Computation, Scalar};

/// Largest number of parameters a model may have.
pub const MOST_PARAMETERS: usize = 16;

/// The impact of a model, a function of its own for each kind of number.
pub(super) struct Run<'a, M, S, R> {
    pub(super) model: M,
    pub(super) touch: &'a FirstTouch<S>,
    pub(super) accuracy: Accuracy,
    pub(super) recorder: &'a mut R,
}

impl<M: Model<S>, S: Scalar, R: Recorder<S>> Computation for Run<'_, M, S, R> {
    type Output = Impact<S>;
    #[inline(always)]
    fn run(self) -> Impact<S> {
        self.model.impact(self.touch, self.accuracy, self.recorder)
    }
}
