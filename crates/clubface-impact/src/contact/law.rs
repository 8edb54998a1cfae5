//! What a contact law is: forces from penetration, sliding and their rates.

use super::state::ContactPoint;
use clubface_math::{Dual, Scalar, Vec3};

/// A contact law: forces from the state of contact.
pub trait ContactLaw<S: Scalar> {
    /// Tolerance of a Rosenbrock step at which launch is correct to 1e-4.
    const FAST_TOLERANCE: f64;

    /// Normal force, N, never negative. `depth`: penetration, m, positive; `rate`: its time derivative, m/s;
    /// `curvature`: mean curvature of the face, 1/m; `radius`: of the ball, m. Derivatives carry through for implicit
    /// steps.
    fn normal_force<const K: usize>(
        &self,
        depth: Dual<S, K>,
        rate: Dual<S, K>,
        curvature: Dual<S, K>,
        radius: S,
    ) -> Dual<S, K>;

    /// Friction per sliding speed, N s/m, as a function of normal force, N, rate of penetration, m/s, and squared
    /// sliding speed `w`, m2/s2: the force on the ball is minus this times the sliding velocity.
    fn drag<const K: usize>(
        &self,
        normal_force: Dual<S, K>,
        rate: Dual<S, K>,
        radius: S,
        w: Dual<S, K>,
    ) -> Dual<S, K>;

    /// Friction on the ball, N, of a law that remembers the sliding distance `slip` along y' and z', m, or nothing
    /// for a law that is all in [`ContactLaw::drag`].
    fn remembered(&self, _point: &ContactPoint<S>, _normal_force: S, _slip: [S; 2]) -> Option<Vec3<S>> {
        None
    }

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
