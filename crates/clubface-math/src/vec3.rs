//! Vectors in space.

use crate::scalar::{Scalar, operators};
use core::ops::Neg;

/// A vector with components along x, y, z (or x', y', z').
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<S> {
    /// First component.
    pub x: S,
    /// Second component.
    pub y: S,
    /// Third component.
    pub z: S,
}

impl<S: Scalar> Vec3<S> {
    /// A vector from its components.
    #[inline(always)]
    pub fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new(S::zero(), S::zero(), S::zero())
    }
    /// A constant vector.
    #[inline(always)]
    pub fn from_f64(v: [f64; 3]) -> Self {
        Self::new(S::from_f64(v[0]), S::from_f64(v[1]), S::from_f64(v[2]))
    }
    /// Components as an array.
    #[inline(always)]
    pub fn array(self) -> [S; 3] {
        [self.x, self.y, self.z]
    }
    /// Three consecutive numbers of a slice as a vector.
    #[inline(always)]
    pub fn from_slice(values: &[S], start: usize) -> Self {
        Self::new(values[start], values[start + 1], values[start + 2])
    }
    /// Writes the components into three consecutive places.
    #[inline(always)]
    pub fn put(self, values: &mut [S], start: usize) {
        values[start] = self.x;
        values[start + 1] = self.y;
        values[start + 2] = self.z;
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> S {
        self.x * o.x + self.y * o.y + self.z * o.z
    }
    /// Vector product.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, o: Self) -> Self {
        Self::new(self.y * o.z - self.z * o.y, self.z * o.x - self.x * o.z, self.x * o.y - self.y * o.x)
    }
    /// Squared length.
    #[inline(always)]
    pub fn norm_squared(self) -> S {
        self.dot(self)
    }
    /// Length; its derivative at zero is taken as zero.
    #[inline(always)]
    pub fn norm(self) -> S {
        self.norm_squared().safe_sqrt()
    }
    /// Part perpendicular to a unit vector.
    #[inline(always)]
    #[must_use]
    pub fn reject(self, unit: Self) -> Self {
        self - unit * self.dot(unit)
    }
    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: S::Mask, a: Self, b: Self) -> Self {
        Self::new(S::select(mask, a.x, b.x), S::select(mask, a.y, b.y), S::select(mask, a.z, b.z))
    }
}

operators! { [S: Scalar] Vec3<S>;
    Add add Self => Self, |a, b| Self::new(a.x + b.x, a.y + b.y, a.z + b.z);
    Sub sub Self => Self, |a, b| Self::new(a.x - b.x, a.y - b.y, a.z - b.z);
    Mul mul S => Self, |v, s| Self::new(v.x * s, v.y * s, v.z * s);
    &mut AddAssign add_assign +;
}

impl<S: Scalar> Neg for Vec3<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}
