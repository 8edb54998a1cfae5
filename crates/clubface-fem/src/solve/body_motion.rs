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
    pub(super) fn from_moments(moments: &Moments<R>, origin: &Origin<R>) -> Self {
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

#[cfg(test)]
mod tests {
    use super::{BodyMotion, Origin};
    use crate::moments::Nodes;
    use clubface_math::{with_lanes, Row, Vec3};

    /// Fifteen bodies of different mass in a rigid motion: an odd number, so that packs are not full.
    #[test]
    fn a_rigid_motion_is_found_again() {
        let (drift, spin) = (Vec3::new(3.0, -2.0, 1.0), Vec3::new(40.0, 300.0, -7.0));
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / f64::from(1 << 24)
        };
        let x: Vec<_> =
            (0..15).map(|_| Vec3::new(0.04 * random() + 0.1, 0.04 * random(), 0.04 * random())).collect();
        let masses: Vec<f64> = (0..15).map(|_| 1e-3 * (1.0 + random())).collect();
        let mass: f64 = masses.iter().sum();
        let centre = x.iter().zip(&masses).fold(Vec3::zero(), |sum, (x, m)| sum + *x * *m) * mass.recip();
        let v: Vec<_> = x.iter().map(|x| drift + spin.cross(*x - centre)).collect();
        let angular = x
            .iter()
            .zip(&v)
            .zip(&masses)
            .fold(Vec3::zero(), |sum, ((x, v), m)| sum + (*x - centre).cross(*v) * *m);
        let energy: f64 = v.iter().zip(&masses).map(|(v, m)| 0.5 * m * v.norm_squared()).sum();
        let rows = |v: &[Vec3<f64>]| v.iter().map(|v| Row::from_vec(*v)).collect::<Vec<_>>();
        for lanes in [1, 4, 8] {
            let (positions, velocities) = (&rows(&x)[..], &rows(&v)[..]);
            let nodes = Nodes { positions, velocities, masses: &masses };
            let origin = Origin { position: positions[7].vec(), velocity: velocities[7].vec() };
            let all: Vec<u32> = (0..15).collect();
            // In two lists, of which the first fills its packs.
            let sums = with_lanes(lanes, || {
                nodes.moments(&all[..8], origin).plus(&nodes.moments(&all[8..], origin))
            });
            let found = BodyMotion::from_moments(&sums, &origin);
            // Rounding, as large as the products are.
            assert!((found.mass - mass).abs() < 1e-16, "{found:?}");
            assert!((found.centre - centre).norm() < 1e-15, "{found:?}");
            assert!((found.velocity - drift).norm() < 1e-13, "{found:?}");
            assert!((found.spin - spin).norm() < 1e-10, "{found:?}");
            assert!((found.angular_momentum - angular).norm() < 1e-16, "{found:?}");
            assert!((found.energy - energy).abs() < 1e-14 * energy, "{found:?}");
        }
    }
}
