//! Mass, momentum and spin of some nodes.

use crate::element::BLOCK;
use clubface_math::{Mat3, Pack, PackKernel, Real, Row, Scalar, Vec3};
use std::ops::Range;

/// Mass, momentum and the like of some nodes.
#[derive(Clone, Copy, Debug)]
pub struct Kinetics<R> {
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

impl<R: Real> Kinetics<R> {
    /// Of the nodes in a range of all nodes, at least one, with the given positions (m), velocities (m/s) and masses (kg).
    pub(super) fn of(nodes: Range<usize>, positions: &[Row<R>], velocities: &[Row<R>], masses: &[R]) -> Self {
        let (x, v) = (positions[nodes.start].vec(), velocities[nodes.start].vec());
        // Near the mass centre little is lost when the moments about it follow from those about the first node.
        let moments = R::dispatch(Moments {
            positions: &positions[nodes.clone()],
            velocities: &velocities[nodes.clone()],
            masses: &masses[nodes],
            origin: (x, v),
        });
        let Sums { mass, first, momentum, angular, second, square } = moments;
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

/// Sums over nodes: mass, mass times position and velocity, moment of momentum, mass times products of positions (xx, yy, zz, xy, xz, yz) and
/// times the square of velocity.
#[derive(Clone, Copy)]
struct Sums<P> {
    mass: P,
    first: Vec3<P>,
    momentum: Vec3<P>,
    angular: Vec3<P>,
    second: [P; 6],
    square: P,
}

impl<P: Scalar> Sums<P> {
    #[inline(always)]
    fn zero() -> Self {
        let o = Vec3::zero();
        Self { mass: P::zero(), first: o, momentum: o, angular: o, second: [P::zero(); 6], square: P::zero() }
    }
    #[inline(always)]
    fn add(&mut self, m: P, x: Vec3<P>, v: Vec3<P>) {
        let p = v * m;
        self.mass += m;
        self.first += x * m;
        self.momentum += p;
        self.angular += x.cross(p);
        self.square += v.dot(p);
        let y = x * m;
        let products = [x.x * y.x, x.y * y.y, x.z * y.z, x.x * y.y, x.x * y.z, x.y * y.z];
        for (sum, product) in self.second.iter_mut().zip(products) {
            *sum += product;
        }
    }
}

impl<P: Pack> Sums<P> {
    /// Of all lanes.
    #[inline(always)]
    fn total(&self) -> Sums<P::Real> {
        fn sum<P: Pack>(of: P) -> P::Real {
            let mut sum = P::Real::zero();
            for lane in 0..P::LANES {
                sum += of.real(lane);
            }
            sum
        }
        let each = |v: Vec3<P>| Vec3::new(sum(v.x), sum(v.y), sum(v.z));
        Sums {
            mass: sum(self.mass),
            first: each(self.first),
            momentum: each(self.momentum),
            angular: each(self.angular),
            second: self.second.map(sum),
            square: sum(self.square),
        }
    }
}

/// Sums about an origin: positions and velocities of nodes are taken relative to it.
struct Moments<'a, R> {
    positions: &'a [Row<R>],
    velocities: &'a [Row<R>],
    masses: &'a [R],
    origin: (Vec3<R>, Vec3<R>),
}

impl<R: Real> PackKernel<R> for Moments<'_, R> {
    type Output = Sums<R>;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Sums<R> {
        let Self { positions, velocities, masses, origin } = self;
        let count = masses.len();
        assert!(positions.len() == count && velocities.len() == count);
        let splat = |v: Vec3<R>| Vec3::new(P::splat(v.x), P::splat(v.y), P::splat(v.z));
        let (x0, v0) = (splat(origin.0), splat(origin.1));
        let mut sums = Sums::zero();
        let mut last = [R::zero(); BLOCK];
        for at in (0..count).step_by(P::LANES) {
            let mut index = [0; BLOCK];
            for lane in 0..P::LANES {
                index[lane] = (at + lane).min(count - 1) as u32;
            }
            let mass = if at + P::LANES <= count {
                P::load(&masses[at..])
            } else {
                // Lanes behind the last node repeat it without mass.
                last[..count - at].copy_from_slice(&masses[at..]);
                P::load(&last)
            };
            // SAFETY: every index is that of a node.
            let (x, v) = unsafe { (P::gather(positions, &index), P::gather(velocities, &index)) };
            sums.add(mass, x - x0, v - v0);
        }
        sums.total()
    }
}

#[cfg(test)]
mod tests {
    use super::Kinetics;
    use clubface_math::{lanes::with_lanes, Row, Vec3};

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
            let found = with_lanes(lanes, || Kinetics::of(0..15, &rows(&x), &rows(&v), &masses));
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
