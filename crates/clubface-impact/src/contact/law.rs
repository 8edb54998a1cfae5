//! What a contact law is: forces from penetration, sliding and their rates.

use super::state::ContactPoint;
use clubface_math::{Dual, Scalar, Vec3};

/// A ball that has entered a face.
#[derive(Clone, Copy, Debug)]
pub struct Indentation<S, const K: usize> {
    /// Penetration, m, positive.
    pub depth: Dual<S, K>,
    /// Its time derivative, m/s.
    pub rate: Dual<S, K>,
    /// Mean curvature of the face, 1/m.
    pub curvature: Dual<S, K>,
    /// Radius of the ball, m.
    pub radius: S,
}

/// A ball that slides on a face.
#[derive(Clone, Copy, Debug)]
pub struct Sliding<S, const K: usize> {
    /// Normal force, N.
    pub normal_force: Dual<S, K>,
    /// Time derivative of the penetration, m/s.
    pub rate: Dual<S, K>,
    /// Radius of the ball, m.
    pub radius: S,
    /// Squared sliding speed, m2/s2.
    pub w: Dual<S, K>,
}

/// A contact law: forces from the state of contact.
pub trait ContactLaw<S: Scalar> {
    /// Tolerance of a Rosenbrock step at which launch is correct to 1e-4.
    const FAST_TOLERANCE: f64;

    /// Normal force, N, never negative. Derivatives carry through for implicit steps.
    fn normal_force<const K: usize>(&self, at: Indentation<S, K>) -> Dual<S, K>;

    /// Friction per sliding speed, N s/m: the force on the ball is minus this times the sliding velocity.
    fn drag<const K: usize>(&self, at: Sliding<S, K>) -> Dual<S, K>;

    /// Friction on the ball, N, of a law that depends on the sliding distance `slip` along y' and z', m, or nothing
    /// for a law that is all in [`ContactLaw::drag`].
    fn remembered(&self, _point: &ContactPoint<S>, _normal_force: S, _slip: [S; 2]) -> Option<Vec3<S>> {
        None
    }

    /// Makes the instant of the last call of [`ContactLaw::remembered`] the one that the law remembers.
    fn commit(&self) {}

    /// What the law remembers of the last committed instant, beyond the state of the contact.
    fn memory(&self) -> Vec<S> {
        Vec::new()
    }

    /// Makes this, once read by [`ContactLaw::memory`], what the law remembers.
    fn remember(&self, _memory: &[S]) {}

    /// Contact area, m2.
    fn area(&self, depth: S, curvature: S, radius: S) -> S;

    /// The ball's core, if the ball has one that turns inside its cover. `inertia`: of the whole ball, kg m2.
    fn core(&self, _inertia: S, _radius: S) -> Option<Core<S>> {
        None
    }
}

/// A core joined to the cover by a three-axis rotary spring and damper.
#[derive(Clone, Copy, Debug)]
pub struct Core<S> {
    /// Moment of inertia of the core, kg m2.
    pub inertia: S,
    /// Spring stiffness, N m/rad.
    pub stiffness: S,
    /// Damper rate, N m s/rad.
    pub damping: S,
}
