//! A contact whose bodies someone else moves: motion in, forces out, with the internal state of the law in the caller's
//! hands.

use super::dynamics::{Contact, Loads};
use super::law::{ContactLaw, Core};
use super::state::*;
use crate::first_touch::FirstTouch;
use clubface_math::{Scalar, Vec3};

/// How head and ball move against each other at one instant, in axes fixed in the head.
#[derive(Clone, Copy, Debug)]
pub struct RelativeMotion<S> {
    /// Ball centre from the CG of the head, m.
    pub position: Vec3<S>,
    /// Velocity of the ball less that of the CG, m/s.
    pub velocity: Vec3<S>,
    /// Angular velocity of the head, rad/s.
    pub head_spin: Vec3<S>,
    /// Angular velocity of the ball, or of the cover of a layered one, rad/s.
    pub surface_spin: Vec3<S>,
}

/// What a contact is at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Instant<S> {
    /// What acts.
    pub loads: Loads<S>,
    /// Normal force, N.
    pub normal_force: S,
    /// Penetration, m; negative when apart.
    pub depth: S,
    /// Its rate, m/s.
    pub rate: S,
}

/// A contact of one model that an integrator of someone's own steps through.
///
/// Its internal states are what the law needs besides the motion of the bodies. They begin as [`SteppedContact::initial`];
/// [`SteppedContact::evaluate`] gives their rates. A law with a memory (rings) keeps it in them besides, with the rate
/// zero, and [`SteppedContact::commit`] brings it up to date at the end of every step that is accepted.
pub trait SteppedContact<S: Scalar>: Send {
    /// Names of the internal states.
    fn names(&self) -> Vec<String>;
    /// The internal states at first touch.
    fn initial(&self) -> &[S];
    /// The contact at one instant; the rates of the internal states go into `rates`. A function of its arguments alone.
    fn evaluate(&self, motion: &RelativeMotion<S>, internal: &[S], rates: &mut [S]) -> Instant<S>;
    /// Ends a step at this instant: brings the memory among the internal states up to date.
    fn commit(&self, motion: &RelativeMotion<S>, internal: &mut [S]);
    /// The core of a layered ball.
    fn core(&self) -> Option<Core<S>>;
}

/// The contact of [`super::run`] in the hands of someone else. `N`: as there on a face that gives.
struct Stepped<S, L, const N: usize> {
    contact: Contact<S, L>,
    initial: Vec<S>,
}

/// The contact of a law, from first touch. `N`: [`SOLID_GIVING`], [`SLIDING`] or [`LAYERED_GIVING`].
pub fn stepped<S: Scalar, L: ContactLaw<S> + Send + 'static, const N: usize>(
    touch: &FirstTouch<S>,
    law: L,
) -> Box<dyn SteppedContact<S>> {
    let mut initial = initial::<S, N>(touch)[SOLID..].to_vec();
    initial.extend(law.memory());
    Box::new(Stepped::<S, L, N> { contact: Contact::new(touch, law), initial })
}

impl<S: Scalar, L: ContactLaw<S>, const N: usize> Stepped<S, L, N> {
    fn state(motion: &RelativeMotion<S>, internal: &[S]) -> [S; N] {
        let mut y = [S::zero(); N];
        motion.position.put(&mut y, POSITION);
        motion.velocity.put(&mut y, VELOCITY);
        motion.head_spin.put(&mut y, CLUB_SPIN);
        motion.surface_spin.put(&mut y, BALL_SPIN);
        y[SOLID..].copy_from_slice(&internal[..N - SOLID]);
        y
    }
}

impl<S: Scalar, L: ContactLaw<S> + Send, const N: usize> SteppedContact<S> for Stepped<S, L, N> {
    fn names(&self) -> Vec<String> {
        let axes = |name: &str| ["x", "y", "z"].map(|axis| format!("{name}_{axis}"));
        let mut names = vec![String::new(); N - SOLID];
        if layered(N) {
            names[CORE_SPIN - SOLID..][..3].clone_from_slice(&axes("core_spin"));
            names[TWIST - SOLID..][..3].clone_from_slice(&axes("twist"));
        }
        if sliding(N) {
            names[SLIP - SOLID..][..2].clone_from_slice(&["slip_y", "slip_z"].map(String::from));
        }
        if let Some(at) = face(N) {
            names[at - SOLID..].clone_from_slice(&["face_depth", "face_rate"].map(String::from));
        }
        let remembered = self.initial.len() - names.len();
        names.extend((0..remembered).map(|i| format!("memory_{i}")));
        names
    }

    fn initial(&self) -> &[S] {
        &self.initial
    }

    fn evaluate(&self, motion: &RelativeMotion<S>, internal: &[S], rates: &mut [S]) -> Instant<S> {
        let y = Self::state(motion, internal);
        self.contact.law.remember(&internal[N - SOLID..]);
        let t = self.contact.touching(&y);
        let normal_force = self.contact.normal_force(&t);
        let friction = self.contact.tangential_force(&y, &t, normal_force);
        let mut rate = [S::zero(); N];
        let loads = self.contact.loads(&y, &t, normal_force, friction, &mut rate);
        rates.fill(S::zero());
        rates[..N - SOLID].copy_from_slice(&rate[SOLID..]);
        Instant { loads, normal_force, depth: t.depth, rate: t.rate }
    }

    fn commit(&self, motion: &RelativeMotion<S>, internal: &mut [S]) {
        let (states, memory) = internal.split_at_mut(N - SOLID);
        if memory.is_empty() {
            return;
        }
        let y = Self::state(motion, states);
        self.contact.law.remember(memory);
        let t = self.contact.touching(&y);
        self.contact.tangential_force(&y, &t, self.contact.normal_force(&t));
        self.contact.law.commit();
        memory.copy_from_slice(&self.contact.law.memory());
    }

    fn core(&self) -> Option<Core<S>> {
        self.contact.core()
    }
}
