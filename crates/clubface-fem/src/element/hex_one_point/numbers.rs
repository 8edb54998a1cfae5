//! The numbers that a hexahedron with one integration point keeps of its undeformed shape.

use crate::block::Eight;
use crate::mesh::{CORNERS, base_vectors, signs};
use clubface_math::{Mat3, Real, Scalar, Vec3};

/// Numbers of an element's shape: `J^-1 / 8` (rows of base vectors, upper triangle), the negative of each hourglass
/// shape in base vectors, what a pattern adds to each base vector in the mean gradient, volume. Where they stand:
pub const SKEW: usize = 6;
pub const MEAN: usize = 18;
pub const VOLUME: usize = 27;
pub const SHAPE: usize = 28;
/// Stiffnesses, one a pattern.
pub const STIFFNESSES: usize = 4;

/// Mode of each uniform deformation, and of each hourglass pattern: bits are the reference coordinates in the product.
const LINEAR: [usize; 3] = [1, 2, 4];
const PATTERNS: [usize; 4] = [6, 5, 3, 7];

/// Constants of an element from its corners: those of its shape, and the stiffnesses, which depend on the material.
pub fn constants<G: Scalar, R: Scalar>(
    corners: &[Vec3<G>; CORNERS],
    shear: R,
    lift: impl Fn(G) -> R,
) -> ([G; SHAPE], [R; STIFFNESSES]) {
    let mut modes = [Vec3::zero(); CORNERS];
    for (mode, sum) in modes.iter_mut().enumerate() {
        for (corner, position) in corners.iter().enumerate() {
            let s = signs(corner);
            let sign: f64 = (0..3).filter(|axis| mode >> axis & 1 == 1).map(|axis| s[axis]).product();
            *sum += *position * G::from_f64(sign);
        }
    }
    let [a, b, c] = LINEAR.map(|mode| modes[mode]);
    let inverse = Mat3::from_columns(a, b, c).inverse();
    let (mut stored, mut stiffness) = ([G::zero(); SHAPE], [R::zero(); STIFFNESSES]);
    // The element's own frame: x along a, y in the plane of a and b.
    let x = a * a.norm().recip();
    let z = a.cross(b) * a.cross(b).norm().recip();
    let y = z.cross(x);
    let [r, s, t] = inverse.rows;
    stored[..SKEW].copy_from_slice(&[r.dot(x), r.dot(y), r.dot(z), s.dot(y), s.dot(z), t.dot(z)]);
    for (pattern, mode) in PATTERNS.into_iter().enumerate() {
        (-(inverse * modes[mode])).put(&mut stored, SKEW + 3 * pattern);
    }
    let at = 1.0 / 3.0_f64.sqrt();
    for point in 0..CORNERS {
        let [a, b, d] = base_vectors(corners, signs(point).map(|s| s * at));
        stored[VOLUME] += a.dot(b.cross(d));
    }
    // Hourglass stiffness: with edges l and e = 4/l^2, a pattern across two edges has mu V/48 e along either of them,
    // and along the third a quarter of that with the sum of both. One for all directions must be neither of the
    // stiffest, which would lock a thin element that bends, nor of the softest: its period is the mean of theirs.
    // Eight corners a sum: a quarter of it is the edge.
    let e = [a, b, c].map(|base| base.norm_squared().recip() * 64.0);
    let scale = shear * lift(stored[VOLUME]) * (-1.0 / 48.0);
    for i in 0..3 {
        let across = [e[(i + 1) % 3], e[(i + 2) % 3]];
        let directions = [across[0], across[1], (across[0] + across[1]) * 0.25];
        let period =
            directions.into_iter().fold(G::zero(), |sum, one| sum + one.sqrt().recip()) * (1.0 / 3.0);
        stiffness[i] = scale * lift((period * period).recip());
    }
    stiffness[3] = scale * 0.25 * lift((e[0] * e[1] * e[2]).powf(1.0 / 3.0));
    // The volume is 8 [a.(b x c) + (a.(m_ab x m_ac) + b.(m_bc x m_ab) + c.(m_ac x m_bc)) / 3] with a, b, c and the
    // modes m an eighth of these sums; the mean gradient is its derivative over it. The twist has no part in it.
    let [bc, ac, ab, _] = PATTERNS.map(|mode| modes[mode]);
    let slopes = [ab.cross(b) + c.cross(ac), bc.cross(c) + a.cross(ab), b.cross(bc) + ac.cross(a)];
    let scale = (stored[VOLUME] * (3.0 * 64.0)).recip();
    for (pattern, slope) in slopes.into_iter().enumerate() {
        for (i, base) in [a, b, c].into_iter().enumerate() {
            stored[MEAN + 3 * pattern + i] = slope.dot(base) * scale;
        }
    }
    (stored, stiffness)
}

/// Shapes of the elements of a block, or their derivatives by one variable.
pub type Lines = [Eight<f64>; SHAPE];

/// Constants of the elements of a block: values of their shapes, and stiffnesses.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Block<R: Real> {
    pub shape: Lines,
    pub stiffness: [Eight<R>; STIFFNESSES],
}
