//! One shot with every step of its contact.

use super::run::Run;
use crate::check::{check, check_approach, check_parameters, unseparated};
use crate::contact::History;
use crate::description::FromValues;
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::impact::Accuracy;
use crate::launch::OUTPUT_COUNT;
use crate::model::Describe;
use crate::shot::INPUT_COUNT;
use clubface_math::Computation;

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
    let touch = FirstTouch::of_inputs(inputs);
    check_approach(touch.approach())?;
    let mut history = History::new(touch);
    let model = M::Over::<f64>::from_values(parameters);
    let impact = Run { model, touch: &touch, accuracy, recorder: &mut history }.run();
    if !impact.separated {
        return Err(unseparated());
    }
    Ok((history, impact.launch.outputs()))
}
