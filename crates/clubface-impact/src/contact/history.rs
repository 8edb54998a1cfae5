//! The history of a contact, step by step.

use super::dynamics::Contact;
use super::frame::Frame;
use super::law::ContactLaw;
use super::recorder::{Recorder, RingFrame};
use crate::first_touch::FirstTouch;

/// Every step of a contact, world axes.
#[derive(Clone, Debug)]
pub struct History {
    /// One frame a step, the first at first touch.
    pub frames: Vec<Frame>,
    /// Rings of each frame; empty for models without rings.
    pub rings: Vec<Vec<RingFrame>>,
    touch: FirstTouch<f64>,
}

impl History {
    /// History of a contact that has not begun.
    #[must_use]
    pub fn new(touch: FirstTouch<f64>) -> Self {
        Self { frames: Vec::new(), rings: Vec::new(), touch }
    }
}

impl Recorder<f64> for History {
    const ACTIVE: bool = true;
    fn record<L: ContactLaw<f64>, const N: usize>(
        &mut self,
        contact: &Contact<f64, L>,
        time: f64,
        y: &[f64; N],
    ) {
        self.frames.push(Frame::record(&self.touch, contact, time, y));
    }
    fn record_rings(&mut self, rings: &[RingFrame]) {
        self.rings.push(rings.to_vec());
    }
}
