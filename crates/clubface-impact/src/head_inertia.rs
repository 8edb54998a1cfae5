//! Inertia of a clubhead as the ball meets it: its own, and what is added by the mechanism it hangs in.
//!
//! Shaft and hands add a spatial inertia, the operational-space inertia of the attached head (O. Khatib, IEEE J. Robot.
//! Autom. 3, 1987, 43-53, doi 10.1109/JRA.1987.1087068) less that of the head alone. It takes part in what the impact
//! changes: in a frame that moves as the CG did at first touch, the momenta of head and mechanism are P = A u + B w and
//! L = B' u + D w, with u the velocity of the CG there, w the angular velocity, all in head axes. They follow the
//! equations of Kirchhoff for a body with added mass (H. Lamb, Hydrodynamics, 6th ed., 1932, art. 124),
//!
//! P' = P x w + F, L' = L x w + P x u + T,
//!
//! which keep momentum and energy. For a free head A = m, B = 0, D = I, and they are those of Newton and Euler.

use clubface_math::{Computation, Mat3, Scalar, Vec3};

/// What heads that hang in a mechanism are made of: without the feature "multibody" there is no value of it, and the
/// compiler leaves out all code of such heads.
#[cfg(feature = "multibody")]
#[derive(Clone, Copy, Debug)]
struct Attachable;
#[cfg(not(feature = "multibody"))]
#[derive(Clone, Copy, Debug)]
enum Attachable {}

/// A symmetric 6 x 6 matrix of forces and moments at the CG by velocities there, or its inverse: [A B; B' D].
#[derive(Clone, Copy, Debug)]
pub struct SpatialMatrix<S> {
    /// A: force by velocity (kg), or its inverse.
    pub linear: Mat3<S>,
    /// B: force by angular velocity (kg m), or its inverse.
    pub coupling: Mat3<S>,
    /// D: moment by angular velocity (kg m2), or its inverse.
    pub angular: Mat3<S>,
    #[allow(dead_code)]
    attachable: Attachable,
}

/// Number of values of a [`SpatialMatrix`].
pub const SPATIAL_COUNT: usize = 21;

impl<S: Scalar> SpatialMatrix<S> {
    /// From A (xx, yy, zz, xy, xz, yz), B (row by row) and D (as A); None where all of it is zero.
    #[inline(always)]
    pub fn from_values(v: &[S; SPATIAL_COUNT]) -> Option<Self> {
        #[cfg(feature = "multibody")]
        if !v.iter().all(|value| value.vanishes()) {
            let symmetric =
                |i: usize| Mat3::symmetric([v[i], v[i + 1], v[i + 2], v[i + 3], v[i + 4], v[i + 5]]);
            let row = |i: usize| Vec3::from_slice(v, i);
            let coupling = Mat3::from_rows(row(6), row(9), row(12));
            return Some(Self::new(symmetric(0), coupling, symmetric(15)));
        }
        _ = v;
        None
    }

    /// From its blocks A, B and D.
    #[cfg(feature = "multibody")]
    #[inline(always)]
    pub fn new(linear: Mat3<S>, coupling: Mat3<S>, angular: Mat3<S>) -> Self {
        Self { linear, coupling, angular, attachable: Attachable }
    }

    /// Product with a linear and an angular vector.
    #[inline(always)]
    pub fn multiply(&self, linear: Vec3<S>, angular: Vec3<S>) -> (Vec3<S>, Vec3<S>) {
        (
            self.linear * linear + self.coupling * angular,
            self.coupling.transpose() * linear + self.angular * angular,
        )
    }

    /// All its elements, velocities before angular velocities.
    pub fn rows(&self) -> [[S; 6]; 6] {
        let back = self.coupling.transpose();
        let row = |a: Vec3<S>, b: Vec3<S>| [a.x, a.y, a.z, b.x, b.y, b.z];
        core::array::from_fn(|i| match i {
            0..3 => row(self.linear.rows[i], self.coupling.rows[i]),
            _ => row(back.rows[i - 3], self.angular.rows[i - 3]),
        })
    }

    /// The same matrix in other axes; `turn` leads from those to the present ones.
    #[inline(always)]
    #[must_use]
    pub fn in_axes(&self, turn: Mat3<S>) -> Self {
        let back = turn.transpose();
        let [linear, coupling, angular] =
            [self.linear, self.coupling, self.angular].map(|block| back * (block * turn));
        Self { linear, coupling, angular, ..*self }
    }

    #[inline(always)]
    fn inverse(&self) -> Self {
        let inverse = self.linear.inverse();
        let carried = inverse * self.coupling;
        let negative = |block: Mat3<S>| block.scale(-S::one());
        let angular = (self.angular + negative(self.coupling.transpose() * carried)).inverse();
        let coupling = negative(carried * angular);
        Self { linear: inverse + negative(coupling * carried.transpose()), coupling, angular, ..*self }
    }
}

/// Inertia of a head about its CG, in axes fixed in the head.
#[derive(Clone, Copy, Debug)]
pub struct HeadInertia<S> {
    /// Mass of the head, kg.
    pub mass: S,
    /// Inertia of the head, kg m2.
    pub inertia: Mat3<S>,
    /// What the mechanism adds; None for a free head.
    pub added: Option<SpatialMatrix<S>>,
}

impl<S: Scalar> HeadInertia<S> {
    /// With another mass at the CG besides, kg.
    #[inline(always)]
    #[must_use]
    pub fn with_mass(self, extra: S) -> Self {
        Self { mass: self.mass + extra, ..self }
    }

    /// The whole matrix of an attached head.
    #[inline(always)]
    fn total(&self, added: &SpatialMatrix<S>) -> SpatialMatrix<S> {
        SpatialMatrix {
            linear: added.linear + Mat3::diagonal(self.mass),
            coupling: added.coupling,
            angular: added.angular + self.inertia,
            ..*added
        }
    }

    /// Velocities by impulses.
    #[inline(always)]
    pub fn mobility(&self) -> HeadMobility<S> {
        S::outline(Invert(self))
    }

    /// Momenta of head and mechanism by velocities in the frame that moves as the CG did at first touch.
    #[cfg_attr(not(feature = "multibody"), allow(unreachable_code))]
    #[inline(always)]
    pub fn momenta(&self, velocity: Vec3<S>, spin: Vec3<S>) -> (Vec3<S>, Vec3<S>) {
        match &self.added {
            None => (velocity * self.mass, self.inertia * spin),
            Some(added) => self.total(added).multiply(velocity, spin),
        }
    }
}

struct Invert<'a, S>(&'a HeadInertia<S>);

impl<S: Scalar> Computation for Invert<'_, S> {
    type Output = HeadMobility<S>;
    #[inline(always)]
    fn run(self) -> HeadMobility<S> {
        let head = self.0;
        HeadMobility {
            inverse_mass: head.mass.recip(),
            inverse_inertia: head.inertia.inverse(),
            attached: head.added.as_ref().map(|added| head.total(added).inverse()),
        }
    }
}

/// How a head moves under impulses at its CG, in axes fixed in the head.
#[derive(Clone, Copy, Debug)]
pub struct HeadMobility<S> {
    inverse_mass: S,
    inverse_inertia: Mat3<S>,
    /// None for a free head.
    attached: Option<SpatialMatrix<S>>,
}

impl<S: Scalar> HeadMobility<S> {
    /// Velocity of the CG and angular velocity by an impulse and a moment about the CG; accelerations by a force and its
    /// moment.
    #[inline(always)]
    pub fn response(&self, impulse: Vec3<S>, moment: Vec3<S>) -> (Vec3<S>, Vec3<S>) {
        match &self.attached {
            None => (impulse * self.inverse_mass, self.inverse_inertia * moment),
            Some(attached) => S::outline(Response { attached, impulse, moment }),
        }
    }

    /// Velocity at one point by an impulse at another, both from the CG (m).
    #[inline(always)]
    pub fn between(&self, seen: Vec3<S>, point: Vec3<S>) -> Mat3<S> {
        match &self.attached {
            None => {
                let turning = Mat3::cross(seen) * (self.inverse_inertia * Mat3::cross(point));
                Mat3::diagonal(self.inverse_mass) + turning.scale(-S::one())
            }
            Some(attached) => S::outline(Between { attached, seen, point }),
        }
    }

    /// Velocity along a direction by an impulse along it at a point from the CG (m), 1/kg.
    #[inline(always)]
    pub fn along(&self, point: Vec3<S>, direction: Vec3<S>) -> S {
        let arm = point.cross(direction);
        let (velocity, spin) = self.response(direction, arm);
        direction.dot(velocity) + arm.dot(spin)
    }

    /// A matrix times that of the velocity of the CG by an impulse through it.
    #[inline(always)]
    pub fn times_central(&self, matrix: Mat3<S>) -> Mat3<S> {
        match &self.attached {
            None => matrix.scale(self.inverse_mass),
            Some(attached) => matrix * attached.linear,
        }
    }
}

struct Response<'a, S> {
    attached: &'a SpatialMatrix<S>,
    impulse: Vec3<S>,
    moment: Vec3<S>,
}

impl<S: Scalar> Computation for Response<'_, S> {
    type Output = (Vec3<S>, Vec3<S>);
    #[inline(always)]
    fn run(self) -> Self::Output {
        self.attached.multiply(self.impulse, self.moment)
    }
}

struct Between<'a, S> {
    attached: &'a SpatialMatrix<S>,
    seen: Vec3<S>,
    point: Vec3<S>,
}

impl<S: Scalar> Computation for Between<'_, S> {
    type Output = Mat3<S>;
    #[inline(always)]
    fn run(self) -> Mat3<S> {
        let SpatialMatrix { linear, coupling, angular, .. } = *self.attached;
        let (seen, point) = (Mat3::cross(self.seen), Mat3::cross(self.point));
        let velocity = linear + coupling * point;
        let spin = coupling.transpose() + angular * point;
        velocity + (seen * spin).scale(-S::one())
    }
}
