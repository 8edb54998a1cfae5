//! The impact of one model, and one shot with every step of its contact.

use crate::check::{check, check_approach, check_parameters, unseparated};
#[cfg(feature = "multibody")]
use crate::contact::SteppedContact;
use crate::contact::{History, Recorder};
use crate::description::FromValues;
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::launch::OUTPUT_COUNT;
use crate::model::{Describe, Model};
use crate::shot::INPUT_COUNT;
use clubface_math::{Computation, Scalar};

/// Largest number of parameters a model may have.
pub const MOST_PARAMETERS: usize = 152;

/// The impact of a model, a function of its own for each kind of number.
pub(super) struct Run<'a, M, S, R> {
    pub(super) model: &'a M,
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

/// The contact of a model from first touch, for a program that moves the bodies itself.
#[cfg(feature = "multibody")]
pub fn stepped<M: Describe, S: Scalar>(
    touch: &FirstTouch<S>,
    parameters: &[S],
) -> Option<Box<dyn SteppedContact<S>>> {
    M::Over::<S>::from_values(parameters).stepped(touch)
}

/// The history of one shot and its outputs.
///
/// # Errors
/// A faulty input, a club that moves away from the ball, or a contact that does not end.
pub fn history<M: Describe>(
    inputs: &[f64; INPUT_COUNT],
    parameters: &[f64],
    accuracy: Accuracy,
) -> Result<(History, [f64; OUTPUT_COUNT]), ImpactError> {
    check(inputs)?;
    check_parameters(&M::INFO, parameters)?;
    let touch = FirstTouch::from_inputs(inputs);
    check_approach(touch.approach())?;
    let mut history = History::new(touch);
    let model = M::Over::<f64>::from_values(parameters);
    let impact = Run { model: &model, touch: &touch, accuracy, recorder: &mut history }.run();
    if !impact.separated {
        return Err(unseparated());
    }
    Ok((history, impact.launch.outputs()))
}
