//! The eight-node hexahedron with one integration point, in total Lagrangian form, with physical hourglass control.
//!
//! Positions are taken apart into eight modes by sums and differences: one of translation, three of uniform deformation (the base vectors
//! at the centre), four of bending (hourglass), to which one point is blind (Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17,
//! 1981). The hourglass modes get the stiffness that a rectangular, incompressible block of the element's size has in bending, shear and
//! torsion, without bulk stiffness (after Belytschko and Bindeman, Comput. Methods Appl. Mech. Eng. 105, 1993), as an energy of the
//! products of current base vectors and modes: it knows no rotation, and forces follow as its exact derivative.
//!
//! The materials are isotropic, so each element may look at its undeformed shape from a frame of its own: one in which the first base
//! vector lies along x and the second in the xy plane. Its Jacobian is then triangular (six numbers instead of nine), and elements that
//! differ by a rotation share their constants.

use super::side::{empty, Face};
use super::BLOCK;
use crate::mesh::{base_vectors, signs, CORNERS};
use clubface_math::{Mat3, Pack, Scalar, Vec3};

/// Constants an element keeps.
pub const CONSTANTS: usize = 35;

/// Where they stand: `J^-1 / 8` (rows of base vectors, upper triangle), the negative of each hourglass shape in base vectors, what a pattern adds
/// to each base vector in the mean gradient, reciprocal squares of the edges, volume.
const SKEW: usize = 6;
const MEAN: usize = 18;
/// Numbers that tell the shape: those above.
pub const SHAPES: usize = 27;
const PLATE: usize = 27;
const SHEAR: usize = 30;
const TWIST: usize = 33;
pub const VOLUME: usize = 34;

/// Mode of each uniform deformation, and of each hourglass pattern: bits are the reference coordinates in the product.
const LINEAR: [usize; 3] = [1, 2, 4];
const PATTERNS: [usize; 4] = [6, 5, 3, 7];

/// Constants of an element from its corners.
pub fn constants<R: Scalar>(corners: &[Vec3<R>; CORNERS], shear: R) -> [R; CONSTANTS] {
    let mut modes = [Vec3::zero(); CORNERS];
    for (mode, sum) in modes.iter_mut().enumerate() {
        for (corner, position) in corners.iter().enumerate() {
            let s = signs(corner);
            let sign: f64 = (0..3).filter(|axis| mode >> axis & 1 == 1).map(|axis| s[axis]).product();
            *sum += *position * R::from_f64(sign);
        }
    }
    let [a, b, c] = LINEAR.map(|mode| modes[mode]);
    let inverse = Mat3::from_columns(a, b, c).inverse();
    let mut stored = [R::zero(); CONSTANTS];
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
    // Hourglass stiffness: with edges l and e = 4/l^2, half of mu V/3 (sum of e) times the square of (x.q) / (32 l), and 1/(32 l)^2 = e/4096.
    // Eight corners a sum: a quarter of it is the edge.
    let e = [a, b, c].map(|base| base.norm_squared().recip() * 64.0);
    let scale = shear * stored[VOLUME] * (-1.0 / (3.0 * 4096.0));
    for i in 0..3 {
        stored[PLATE + i] = scale * e[i] * e[i] * 4.0;
        stored[SHEAR + i] = scale * e[i] * (e[(i + 1) % 3] + e[(i + 2) % 3]);
    }
    stored[TWIST] = scale * 64.0 * (e[0] * e[1] * e[2]).powf(1.0 / 3.0);
    // The volume is 8 [a.(b x c) + (a.(m_ab x m_ac) + b.(m_bc x m_ab) + c.(m_ac x m_bc)) / 3] with a, b, c and the modes m an eighth of these
    // sums; the mean gradient is its derivative over it. The twist has no part in it.
    let [bc, ac, ab, _] = PATTERNS.map(|mode| modes[mode]);
    let slopes = [ab.cross(b) + c.cross(ac), bc.cross(c) + a.cross(ab), b.cross(bc) + ac.cross(a)];
    let scale = (stored[VOLUME] * (3.0 * 64.0)).recip();
    for (pattern, slope) in slopes.into_iter().enumerate() {
        for (i, base) in [a, b, c].into_iter().enumerate() {
            stored[MEAN + 3 * pattern + i] = slope.dot(base) * scale;
        }
    }
    stored
}

/// `a + s b` for vectors.
#[inline(always)]
fn plus<P: Scalar>(a: Vec3<P>, s: P, b: Vec3<P>) -> Vec3<P> {
    Vec3::new(b.x.mul_add(s, a.x), b.y.mul_add(s, a.y), b.z.mul_add(s, a.z))
}

#[inline(always)]
fn dot<P: Scalar>(a: Vec3<P>, b: Vec3<P>) -> P {
    a.z.mul_add(b.z, a.y.mul_add(b.y, a.x * b.x))
}

/// Constants of a pack of elements: lanes `first..` of a block.
#[derive(Clone, Copy)]
pub struct Constants<'a, P: Pack> {
    block: &'a [P::Real; CONSTANTS * BLOCK],
    first: usize,
}

impl<'a, P: Pack> Constants<'a, P> {
    /// Of a block, from lane `first` on.
    #[inline(always)]
    pub fn new(block: &'a [P::Real; CONSTANTS * BLOCK], first: usize) -> Self {
        assert!(first + P::LANES <= BLOCK);
        Self { block, first }
    }
    /// Reference volume, m3; 0 for a lane that holds no element.
    #[inline(always)]
    pub fn volume(&self) -> P {
        self.load(VOLUME)
    }
    #[inline(always)]
    fn load(&self, which: usize) -> P {
        debug_assert!(which < CONSTANTS);
        // SAFETY: `which` is below CONSTANTS wherever this is called, and `new` has checked the lanes.
        unsafe { P::read(self.block.as_ptr().add(which * BLOCK + self.first)) }
    }
    #[inline(always)]
    fn triple(&self, from: usize) -> [P; 3] {
        [self.load(from), self.load(from + 1), self.load(from + 2)]
    }
}

/// One element a lane.
#[derive(Clone, Copy)]
pub struct Hexahedron<P> {
    /// Eight times the base vectors: means over the element, as is the deformation gradient.
    bases: [Vec3<P>; 3],
    /// Hourglass patterns: modes without the part that belongs to the element's shape.
    patterns: [Vec3<P>; 4],
}

impl<P: Pack> Hexahedron<P> {
    /// With every corner at the origin.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { bases: [Vec3::zero(); 3], patterns: [Vec3::zero(); 4] }
    }

    /// From the positions of its sides.
    #[inline(always)]
    pub fn new(constants: &Constants<P>, low: &Face<P>, high: &Face<P>) -> Self {
        let (mut linear, mut modes) = ([[P::zero(); 3]; 3], [[P::zero(); 3]; 4]);
        for axis in 0..3 {
            let (l, h) = (&low[axis], &high[axis]);
            linear[0][axis] = l[1] + h[1];
            linear[1][axis] = l[2] + h[2];
            linear[2][axis] = h[0] - l[0];
            modes[0][axis] = h[2] - l[2];
            modes[1][axis] = h[1] - l[1];
            modes[2][axis] = l[3] + h[3];
            modes[3][axis] = h[3] - l[3];
        }
        let mut bases = [vector(linear[0]), vector(linear[1]), vector(linear[2])];
        let mut patterns = [vector(modes[0]), vector(modes[1]), vector(modes[2]), vector(modes[3])];
        for which in 0..4 {
            let skew = constants.triple(SKEW + 3 * which);
            for i in 0..3 {
                patterns[which] = plus(patterns[which], skew[i], bases[i]);
            }
        }
        for which in 0..3 {
            let mean = constants.triple(MEAN + 3 * which);
            for i in 0..3 {
                bases[i] = plus(bases[i], mean[i], patterns[which]);
            }
        }
        Self { bases, patterns }
    }

    /// Mean deformation gradient, seen from the element's own frame; the identity where there is no element.
    #[inline(always)]
    pub fn gradient(&self, constants: &Constants<P>) -> Mat3<P> {
        // F = a r^T + b s^T + c t^T.
        let [a, b, c] = [self.bases[0].array(), self.bases[1].array(), self.bases[2].array()];
        let (r, s, t) = (constants.triple(0), [constants.load(3), constants.load(4)], constants.load(5));
        let unit = P::select(constants.volume().gt(P::zero()), P::zero(), P::one());
        let row = [
            [a[0].mul_add(r[0], unit), a[0] * r[1], a[0] * r[2]],
            [a[1] * r[0], a[1].mul_add(r[1], unit), a[1] * r[2]],
            [a[2] * r[0], a[2] * r[1], a[2].mul_add(r[2], unit)],
        ];
        let mut rows = [Vec3::zero(); 3];
        for i in 0..3 {
            let [x, y, z] = row[i];
            rows[i] = Vec3::new(x, b[i].mul_add(s[0], y), c[i].mul_add(t, b[i].mul_add(s[1], z)));
        }
        Mat3 { rows }
    }

    /// Forces, N, on the sides below (added to those given) and above, of the hourglass patterns and of a stress: minus the first
    /// Piola-Kirchhoff stress (Pa) times the volume.
    #[inline(always)]
    pub fn forces(&self, constants: &Constants<P>, stress: &Mat3<P>, below: &Face<P>) -> (Face<P>, Face<P>) {
        let mut on_bases = on_bases(constants, stress);
        let mut on_patterns = [Vec3::zero(); 4];
        on_patterns[3] = self.patterns[3] * constants.load(TWIST);
        for which in 0..3 {
            let pattern = self.patterns[which];
            let mut force = Vec3::zero();
            for along in 0..3 {
                let stiffness = constants.load(stiffness(which, along));
                let size = stiffness * dot(self.bases[along], pattern);
                on_bases[along] = plus(on_bases[along], size, pattern);
                force = plus(force, size, self.bases[along]);
            }
            on_patterns[which] = force;
        }
        // What acts on base vectors acts on the patterns in their means, and what acts on patterns on the base vectors they were freed of.
        for which in 0..3 {
            let mean = constants.triple(MEAN + 3 * which);
            for i in 0..3 {
                on_patterns[which] = plus(on_patterns[which], mean[i], on_bases[i]);
            }
        }
        for which in 0..4 {
            let skew = constants.triple(SKEW + 3 * which);
            for i in 0..3 {
                on_bases[i] = plus(on_bases[i], skew[i], on_patterns[which]);
            }
        }
        let (mut low, mut high) = (*below, empty());
        let [a, b, c] = [on_bases[0].array(), on_bases[1].array(), on_bases[2].array()];
        let [p, q, r, s] =
            [on_patterns[0].array(), on_patterns[1].array(), on_patterns[2].array(), on_patterns[3].array()];
        for axis in 0..3 {
            let (first, second, third) = (a[axis], b[axis], c[axis]);
            let (yz, xz, xy, twist) = (p[axis], q[axis], r[axis], s[axis]);
            low[axis][0] -= third;
            low[axis][1] += first - xz;
            low[axis][2] += second - yz;
            low[axis][3] += xy - twist;
            high[axis] = [third, first + xz, second + yz, xy + twist];
        }
        (low, high)
    }

    /// Energy of the hourglass patterns, J.
    #[inline(always)]
    pub fn hourglass_energy(&self, constants: &Constants<P>) -> P {
        let mut sum = constants.load(TWIST) * self.patterns[3].norm_squared();
        for which in 0..3 {
            for along in 0..3 {
                let product = dot(self.bases[along], self.patterns[which]);
                sum += constants.load(stiffness(which, along)) * product * product;
            }
        }
        sum * -0.5
    }
}

/// Place of the stiffness of a pattern along a base vector.
#[inline(always)]
fn stiffness(pattern: usize, along: usize) -> usize {
    along + if along == pattern { SHEAR } else { PLATE }
}

/// Forces of a stress on base vectors: the transpose of [`Hexahedron::gradient`].
#[inline(always)]
fn on_bases<P: Pack>(constants: &Constants<P>, stress: &Mat3<P>) -> [Vec3<P>; 3] {
    let (r, s, t) = (constants.triple(0), [constants.load(3), constants.load(4)], constants.load(5));
    let mut on = [[P::zero(); 3]; 3];
    for axis in 0..3 {
        let p = stress.rows[axis];
        on[0][axis] = p.z.mul_add(r[2], p.y.mul_add(r[1], p.x * r[0]));
        on[1][axis] = p.z.mul_add(s[1], p.y * s[0]);
        on[2][axis] = p.z * t;
    }
    [vector(on[0]), vector(on[1]), vector(on[2])]
}

#[inline(always)]
fn vector<P: Scalar>(v: [P; 3]) -> Vec3<P> {
    Vec3::new(v[0], v[1], v[2])
}
