//! Who sees the steps of a contact.

use super::dynamics::Contact;
use super::law::ContactLaw;
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
