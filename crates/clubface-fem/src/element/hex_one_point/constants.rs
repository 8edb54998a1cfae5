//! What a hexahedron with one integration point keeps of its undeformed shape.

use crate::block::{Aligned, BLOCK};
use crate::mesh::{base_vectors, signs, CORNERS};
use clubface_math::{Mat3, Pack, Real, Scalar, Vec3};

/// Constants an element keeps.
pub const CONSTANTS: usize = 32;

/// Where they stand: `J^-1 / 8` (rows of base vectors, upper triangle), the negative of each hourglass shape in base
/// vectors, what a pattern adds to each base vector in the mean gradient, stiffnesses of the patterns, volume.
const SKEW: usize = 6;
const MEAN: usize = 18;
/// Numbers that describe the shape: those above, of which the first have a unit, 1/m.
const SHAPES: usize = 27;
const STIFFNESS: usize = 27;
pub const VOLUME: usize = 31;

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
    // Hourglass stiffness: with edges l and e = 4/l^2, a pattern across two edges has mu V/48 e along either of them,
    // and along the third a quarter of that with the sum of both. One for all directions must be neither of the
    // stiffest, which would lock a thin element that bends, nor of the softest: its period is the mean of theirs.
    // Eight corners a sum: a quarter of it is the edge.
    let e = [a, b, c].map(|base| base.norm_squared().recip() * 64.0);
    let scale = shear * stored[VOLUME] * (-1.0 / 48.0);
    for i in 0..3 {
        let across = [e[(i + 1) % 3], e[(i + 2) % 3]];
        let directions = [across[0], across[1], (across[0] + across[1]) * 0.25];
        let period =
            directions.into_iter().fold(R::zero(), |sum, one| sum + one.sqrt().recip()) * (1.0 / 3.0);
        stored[STIFFNESS + i] = scale * (period * period).recip();
    }
    stored[STIFFNESS + 3] = scale * 0.25 * (e[0] * e[1] * e[2]).powf(1.0 / 3.0);
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
    stored
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
    /// Of a pack from a lane on, counted over all blocks.
    #[inline(always)]
    pub fn at(blocks: &'a [Block<P::Real>], lane: usize) -> Self {
        Self::new(&blocks[lane / BLOCK].0, lane % BLOCK)
    }
    /// Reference volume, m3; 0 for a lane that holds no element.
    #[inline(always)]
    pub fn volume(&self) -> P {
        self.load(VOLUME)
    }
    #[inline(always)]
    fn load(&self, which: usize) -> P {
        debug_assert!(which < CONSTANTS);
        // SAFETY: `which` is below CONSTANTS for what an element has, three base vectors and four patterns, and `new`
        // has checked the lanes.
        unsafe { P::read(self.block.as_ptr().add(which * BLOCK + self.first)) }
    }
    /// Part of a base vector in the negative of an hourglass shape.
    #[inline(always)]
    pub(super) fn skew(&self, pattern: usize, base: usize) -> P {
        self.load(SKEW + 3 * pattern + base)
    }
    /// What a pattern adds to a base vector in the mean gradient.
    #[inline(always)]
    pub(super) fn mean(&self, pattern: usize, base: usize) -> P {
        self.load(MEAN + 3 * pattern + base)
    }
    /// Rows of `J^-1 / 8`, without their zeros.
    #[inline(always)]
    pub(super) fn inverse(&self) -> ([P; 3], [P; 2], P) {
        ([self.load(0), self.load(1), self.load(2)], [self.load(3), self.load(4)], self.load(5))
    }
    /// Minus the stiffness of a pattern, N/m.
    #[inline(always)]
    pub(super) fn stiffness(&self, pattern: usize) -> P {
        self.load(STIFFNESS + pattern)
    }
}

/// Constants of the elements of a block.
pub type Block<R> = Aligned<[R; CONSTANTS * BLOCK]>;

/// How far constants may differ that are the same but for the rounding of positions: those of a ball half a metre
/// from the origin have lost 5e-17 m, of edges of a tenth of a millimetre, and differences of differences lose a
/// hundred times that.
const ROUNDING: f64 = 1e-10;

/// Whether constants and their derivatives are the same to rounding.
pub fn alike<R: Real>(a: &[Block<R>], b: &[Block<R>]) -> bool {
    // Beside the largest of its kind: values and derivatives of a constant are kinds of their own. Those of the
    // inverse Jacobian are of one kind.
    let count = numbers(&R::zero()).count();
    let kind = |at: usize| if at < SKEW * BLOCK { 0 } else { at / BLOCK * count };
    let mut largest = vec![0.0_f64; CONSTANTS * count];
    for (at, value) in a.iter().flat_map(|block| block.0.iter().enumerate()) {
        for (largest, number) in largest[kind(at)..].iter_mut().zip(numbers(value)) {
            *largest = largest.max(number.abs());
        }
    }
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| {
            (0..CONSTANTS * BLOCK).all(|at| {
                // Shapes of hourglass patterns are relative to the edges; they may all be zero but for rounding.
                let least = if (SKEW * BLOCK..SHAPES * BLOCK).contains(&at) { 1.0 } else { 0.0 };
                let sizes = &largest[kind(at)..];
                numbers(&(a.0[at] - b.0[at]))
                    .zip(sizes)
                    .all(|(off, size)| off.abs() <= ROUNDING * size.max(least))
            })
        })
}

/// Value and derivatives.
fn numbers<R: Real>(value: &R) -> impl Iterator<Item = f64> + '_ {
    std::iter::once(value.re()).chain(value.derivatives().iter().copied())
}
