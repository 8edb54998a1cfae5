//! Quantities at the corners of a quadrilateral as modes of the reference square, and vectors in its plane.

use clubface_math::{Scalar, Vec3};

/// Nodes of a quadrilateral.
pub const CORNERS: usize = 4;

/// One quantity at the corners as modes of the reference square: mean, slopes, bilinear part.
#[derive(Clone, Copy)]
pub struct Modes<T> {
    pub mean: T,
    pub xi: T,
    pub eta: T,
    pub skew: T,
}

impl<P: Scalar> Modes<Vec3<P>> {
    /// Modes of vectors at the corners (-1,-1), (1,-1), (1,1), (-1,1), four times as large.
    #[inline(always)]
    pub fn from_corners(x: &[Vec3<P>; CORNERS]) -> Self {
        let (a, b, c, d) = (x[1] + x[0], x[2] + x[3], x[1] - x[0], x[2] - x[3]);
        Self { mean: b + a, eta: b - a, xi: d + c, skew: d - c }
    }
    /// The transpose of [`Modes::from_corners`].
    #[inline(always)]
    pub fn back(self) -> [Vec3<P>; CORNERS] {
        let (a, b) = (self.mean - self.eta, self.mean + self.eta);
        let (c, d) = (self.xi - self.skew, self.xi + self.skew);
        [a - c, a + c, b + d, b - d]
    }
}

/// A vector in the plane of the element.
pub type Flat<P> = [P; 2];

#[inline(always)]
pub fn inner<P: Scalar>(a: Flat<P>, b: Flat<P>) -> P {
    a[1].mul_add(b[1], a[0].product(b[0]))
}

/// `a - b c`.
#[inline(always)]
pub fn less<P: Scalar>(a: P, b: P, c: P) -> P {
    (-b).mul_add(c, a)
}

/// `a - b c` with a number that depends on no variable.
#[inline(always)]
pub fn less_f64<P: Scalar>(a: P, b: P, c: f64) -> P {
    b.mul_add_f64(-c, a)
}

/// A vector turned by a small angle.
#[inline(always)]
pub fn turned<P: Scalar>(v: Flat<P>, angle: P) -> Flat<P> {
    [less(v[0], angle, v[1]), angle.mul_add(v[0], v[1])]
}

/// `v s`.
#[inline(always)]
pub fn times<P: Scalar>(v: Vec3<P>, s: P) -> Vec3<P> {
    Vec3::new(v.x.product(s), v.y.product(s), v.z.product(s))
}

/// The same with a number that depends on no variable.
#[inline(always)]
pub fn times_f64<P: Scalar>(v: Vec3<P>, s: f64) -> Vec3<P> {
    Vec3::new(v.x * s, v.y * s, v.z * s)
}

/// `a + b s`.
#[inline(always)]
pub fn plus<P: Scalar>(a: Vec3<P>, b: Vec3<P>, s: P) -> Vec3<P> {
    Vec3::new(b.x.mul_add(s, a.x), b.y.mul_add(s, a.y), b.z.mul_add(s, a.z))
}
