//! What an element keeps of an integration point: how the deformation gradient follows from the base vectors of its
//! reference coordinates there, and the part of the volume that the point stands for.

use crate::block::BLOCK;
use clubface_math::{Mat3, Pack, Scalar, Vec3};

/// Constants of a point: gradients of the three reference coordinates (9), share of the reference volume (1).
pub const POINT: usize = 10;

/// Puts the constants of a point into `values`, from the undeformed base vectors and the volume of reference
/// coordinates that the point stands for.
pub fn put_point<R: Scalar>([u, v, w]: [Vec3<R>; 3], weight: f64, values: &mut [R]) {
    let inverse = Mat3::from_columns(u, v, w).inverse();
    for i in 0..3 {
        inverse.rows[i].put(values, 3 * i);
    }
    values[9] = u.dot(v.cross(w)) * R::from_f64(weight);
}

/// Reference volume, m3, of the element in a lane of a block of constants.
pub fn reference_volume<R: Scalar>(block: &[R], lane: usize) -> f64 {
    block.chunks_exact(POINT * BLOCK).map(|point| point[(POINT - 1) * BLOCK + lane].re()).sum()
}

/// Constants of a point of one element a lane.
pub struct Point<P> {
    /// Gradients of the reference coordinates, 1/m.
    pub gradients: [Vec3<P>; 3],
    /// Share of the reference volume, m3.
    pub volume: P,
}

impl<P: Pack> Point<P> {
    /// From a block of constants (from lane `first` on).
    #[inline(always)]
    pub fn load(constants: &[P::Real], first: usize, point: usize) -> Self {
        let at = |index: usize| P::load(&constants[(POINT * point + index) * BLOCK + first..]);
        let mut gradients = [Vec3::zero(); 3];
        for i in 0..3 {
            gradients[i] = Vec3::new(at(3 * i), at(3 * i + 1), at(3 * i + 2));
        }
        Self { gradients, volume: at(9) }
    }

    /// Deformation gradient from the base vectors at the point: F = a r^T + b s^T + c t^T.
    #[inline(always)]
    pub fn gradient(&self, [a, b, c]: [Vec3<P>; 3]) -> Mat3<P> {
        let [r, s, t] = self.gradients;
        Mat3::from_rows(
            plus(plus(r * a.x, b.x, s), c.x, t),
            plus(plus(r * a.y, b.y, s), c.y, t),
            plus(plus(r * a.z, b.z, s), c.z, t),
        )
    }
}

/// `a + s b`.
#[inline(always)]
pub fn plus<P: Scalar>(a: Vec3<P>, s: P, b: Vec3<P>) -> Vec3<P> {
    Vec3::new(b.x.mul_add(s, a.x), b.y.mul_add(s, a.y), b.z.mul_add(s, a.z))
}
