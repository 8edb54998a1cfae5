//! The motion of a body as a whole, from the moments of its nodes.

use crate::moments::{Moments, Origin};
use clubface_math::{Mat3, Real, Vec3};

/// Mass and mean motion of some nodes.
#[derive(Clone, Copy, Debug)]
pub struct BodyMotion<R> {
    /// Mass, kg.
    pub mass: R,
    /// Mass centre, m.
    pub centre: Vec3<R>,
    /// Velocity of the mass centre, m/s.
    pub velocity: Vec3<R>,
    /// Angular velocity of the rigid rotation that fits the velocities best, weighted by mass, rad/s.
    pub spin: Vec3<R>,
    /// Angular momentum about the mass centre, kg m2/s.
    pub angular_momentum: Vec3<R>,
    /// Kinetic energy, J.
    pub energy: R,
}

impl<R: Real> BodyMotion<R> {
    /// From moments about an origin, of at least one node.
    pub fn from_moments(moments: &Moments<R>, origin: &Origin<R>) -> Self {
        let Moments { mass, first, momentum, angular, second, square } = *moments;
        let (x, v) = (origin.position, origin.velocity);
        let (centre, velocity) = (first * mass.recip(), momentum * mass.recip());
        let about = angular - centre.cross(momentum);
        let [xx, yy, zz, xy, xz, yz] = second;
        let (trace, shift) = (xx + yy + zz, first.dot(centre));
        let inertia = Mat3::symmetric([
            trace - xx - shift + first.x * centre.x,
            trace - yy - shift + first.y * centre.y,
            trace - zz - shift + first.z * centre.z,
            first.x * centre.y - xy,
            first.x * centre.z - xz,
            first.y * centre.z - yz,
        ]);
        Self {
            mass,
            centre: x + centre,
            velocity: v + velocity,
            spin: inertia.inverse() * about,
            angular_momentum: about,
            energy: (square + v.dot(momentum) * 2.0 + v.norm_squared() * mass) * 0.5,
        }
    }
}
