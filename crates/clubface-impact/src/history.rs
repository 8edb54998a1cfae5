//! The history of a contact, step by step.

use crate::batch::MOST_PARAMETERS;
use crate::check::{check, check_approach, check_parameters, unseparated};
use crate::contact::{Contact, ContactLaw, Frame};
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::launch::{Launch, OUTPUT_COUNT};
use crate::model::{Accuracy, Kind};
use crate::registry::ModelKind;
use crate::shot::INPUT_COUNT;
use clubface_math::Scalar;

/// Sees the state after every step of a contact.
pub trait Recorder<S: Scalar> {
    /// False for a recorder that wants nothing, so that plain runs pay nothing.
    const ACTIVE: bool;
    /// Called at first touch and after every accepted step.
    fn record<L: ContactLaw<S>, const N: usize>(&mut self, contact: &Contact<S, L>, time: S, y: &[S; N]);
    /// Called after `record` by models that cut the contact into rings.
    fn record_rings(&mut self, _rings: &[RingFrame]) {}
}

/// Records nothing.
pub struct Unrecorded;

impl<S: Scalar> Recorder<S> for Unrecorded {
    const ACTIVE: bool = false;
    #[inline(always)]
    fn record<L: ContactLaw<S>, const N: usize>(&mut self, _: &Contact<S, L>, _: S, _: &[S; N]) {}
}

/// One ring of the contact at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RingFrame {
    /// Mid-radius, m.
    pub radius: f64,
    /// Traction on the ball along y' and z', Pa.
    pub traction: [f64; 2],
    /// Whether it slips; false for a ring that sticks or is outside the contact.
    pub slipping: bool,
    /// Whether it is inside the contact.
    pub inside: bool,
}

/// Every step of a contact, world axes.
#[derive(Clone, Debug, Default)]
pub struct History {
    /// One frame a step, the first at first touch.
    pub frames: Vec<Frame>,
    /// Rings of each frame; empty for models without rings.
    pub rings: Vec<Vec<RingFrame>>,
    touch: Option<FirstTouch<f64>>,
}

impl Recorder<f64> for History {
    const ACTIVE: bool = true;
    fn record<L: ContactLaw<f64>, const N: usize>(
        &mut self,
        contact: &Contact<f64, L>,
        time: f64,
        y: &[f64; N],
    ) {
        if let Some(touch) = &self.touch {
            self.frames.push(Frame::of(touch, contact, time, y));
        }
    }
    fn record_rings(&mut self, rings: &[RingFrame]) {
        self.rings.push(rings.to_vec());
    }
}

/// Runs one shot by a contact model and keeps every step.
///
/// # Errors
/// A model without a contact, a faulty input, a club that moves away from the ball, or a contact that does not end.
pub fn history(
    model: ModelKind,
    inputs: &[f64; INPUT_COUNT],
    parameters: &[f64],
    accuracy: Accuracy,
) -> Result<(History, [f64; OUTPUT_COUNT]), ImpactError> {
    let info = model.info();
    if info.kind == Kind::Impulse {
        let message = format!("{} is an impulse model: it has no time scale and so no history", info.name);
        return Err(ImpactError::new("model", message));
    }
    check(inputs)?;
    check_parameters(info, parameters)?;
    debug_assert!(parameters.len() <= MOST_PARAMETERS);
    let touch = FirstTouch::of_inputs(inputs);
    check_approach(touch.approach())?;
    let mut history = History { touch: Some(touch), ..History::default() };
    let impact = model.impact(&touch, parameters, accuracy, &mut history);
    if !impact.separated {
        return Err(unseparated());
    }
    let launch: Launch<f64> = impact.launch;
    Ok((history, launch.outputs()))
}
