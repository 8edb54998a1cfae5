//! 3 x 3 matrices: closed forms, since a library's pivoted factorisation costs ten times as much at this size.

use crate::scalar::{Scalar, operators};
use crate::vec3::Vec3;

/// A matrix by rows.
#[derive(Clone, Copy, Debug)]
pub struct Mat3<S> {
    /// Rows.
    pub rows: [Vec3<S>; 3],
}

impl<S: Scalar> Mat3<S> {
    /// From rows.
    #[inline(always)]
    pub fn from_rows(a: Vec3<S>, b: Vec3<S>, c: Vec3<S>) -> Self {
        Self { rows: [a, b, c] }
    }
    /// From columns.
    #[inline(always)]
    pub fn from_columns(a: Vec3<S>, b: Vec3<S>, c: Vec3<S>) -> Self {
        Self::from_rows(a, b, c).transpose()
    }
    /// Symmetric matrix from its six elements xx, yy, zz, xy, xz, yz.
    #[inline(always)]
    pub fn symmetric(e: [S; 6]) -> Self {
        Self::from_rows(Vec3::new(e[0], e[3], e[4]), Vec3::new(e[3], e[1], e[5]), Vec3::new(e[4], e[5], e[2]))
    }
    /// `value` times the identity.
    #[inline(always)]
    pub fn diagonal(value: S) -> Self {
        let o = S::zero();
        Self::from_rows(Vec3::new(value, o, o), Vec3::new(o, value, o), Vec3::new(o, o, value))
    }
    /// Matrix of `v x .`.
    #[inline(always)]
    pub fn cross(v: Vec3<S>) -> Self {
        let o = S::zero();
        Self::from_rows(Vec3::new(o, -v.z, v.y), Vec3::new(v.z, o, -v.x), Vec3::new(-v.y, v.x, o))
    }
    /// `a b^T`.
    #[inline(always)]
    pub fn outer(a: Vec3<S>, b: Vec3<S>) -> Self {
        Self::from_rows(b * a.x, b * a.y, b * a.z)
    }
    /// Rotation about x by an angle given as (sine, cosine).
    #[inline(always)]
    pub fn rotation_x((s, c): (S, S)) -> Self {
        let (o, l) = (S::zero(), S::one());
        Self::from_rows(Vec3::new(l, o, o), Vec3::new(o, c, -s), Vec3::new(o, s, c))
    }
    /// Rotation about y by an angle given as (sine, cosine).
    #[inline(always)]
    pub fn rotation_y((s, c): (S, S)) -> Self {
        let (o, l) = (S::zero(), S::one());
        Self::from_rows(Vec3::new(c, o, s), Vec3::new(o, l, o), Vec3::new(-s, o, c))
    }
    /// Rotation about z by an angle given as (sine, cosine).
    #[inline(always)]
    pub fn rotation_z((s, c): (S, S)) -> Self {
        let (o, l) = (S::zero(), S::one());
        Self::from_rows(Vec3::new(c, -s, o), Vec3::new(s, c, o), Vec3::new(o, o, l))
    }
    /// Transpose.
    #[inline(always)]
    #[must_use]
    pub fn transpose(self) -> Self {
        let [a, b, c] = self.rows;
        Self::from_rows(Vec3::new(a.x, b.x, c.x), Vec3::new(a.y, b.y, c.y), Vec3::new(a.z, b.z, c.z))
    }
    /// Multiplied by a number.
    #[inline(always)]
    #[must_use]
    pub fn scale(self, s: S) -> Self {
        let [a, b, c] = self.rows;
        Self::from_rows(a * s, b * s, c * s)
    }
    /// Inverse by cofactors; not finite if the matrix is singular.
    #[inline(always)]
    #[must_use]
    pub fn inverse(self) -> Self {
        let [a, b, c] = self.rows;
        let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
        let scale = a.dot(bc).recip();
        Self::from_columns(bc * scale, ca * scale, ab * scale)
    }
}

operators! { [S: Scalar] Mat3<S>;
    Mul mul Vec3<S> => Vec3<S>, |m, v| Vec3::new(m.rows[0].dot(v), m.rows[1].dot(v), m.rows[2].dot(v));
    Mul mul Self => Self, |a, b| {
        let columns = b.transpose().rows;
        Self::from_columns(a * columns[0], a * columns[1], a * columns[2])
    };
    Add add Self => Self, |a, b| {
        Self::from_rows(a.rows[0] + b.rows[0], a.rows[1] + b.rows[1], a.rows[2] + b.rows[2])
    };
}
