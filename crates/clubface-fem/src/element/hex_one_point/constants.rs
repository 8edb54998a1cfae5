//! What a hexahedron with one integration point keeps of its undeformed shape.

use crate::block::{Eight, BLOCK};
use crate::mesh::{base_vectors, signs, CORNERS};
use clubface_math::{Mat3, Pack, Real, Scalar, Vec3};
use std::sync::Arc;

/// Numbers of an element's shape: `J^-1 / 8` (rows of base vectors, upper triangle), the negative of each hourglass
/// shape in base vectors, what a pattern adds to each base vector in the mean gradient, volume. Where they stand:
const SKEW: usize = 6;
const MEAN: usize = 18;
const VOLUME: usize = 27;
const SHAPE: usize = 28;
/// Stiffnesses, one a pattern.
const STIFFNESSES: usize = 4;

/// Mode of each uniform deformation, and of each hourglass pattern: bits are the reference coordinates in the product.
const LINEAR: [usize; 3] = [1, 2, 4];
const PATTERNS: [usize; 4] = [6, 5, 3, 7];

/// Constants of an element from its corners: those of its shape, and the stiffnesses, which depend on the material.
fn constants<G: Scalar, R: Scalar>(
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

/// Constants of the elements of a block, their shapes in one number and their stiffnesses in another.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Block<G: Real, R: Real> {
    shape: [Eight<G>; SHAPE],
    stiffness: [Eight<R>; STIFFNESSES],
}

/// Constants of a pack of elements, their shapes in packs `G`: lanes `first..` of a block.
#[derive(Clone, Copy)]
pub struct Constants<'a, G: Pack, R: Real> {
    block: &'a Block<G::Real, R>,
    first: usize,
}

impl<'a, G: Pack, R: Real> Constants<'a, G, R> {
    /// Of a block, from lane `first` on.
    #[inline(always)]
    pub fn new(block: &'a Block<G::Real, R>, first: usize) -> Self {
        assert!(first + G::LANES <= BLOCK);
        Self { block, first }
    }
    /// Of a pack from a lane on, counted over all blocks.
    #[inline(always)]
    pub fn at(blocks: &'a [Block<G::Real, R>], lane: usize) -> Self {
        Self::new(&blocks[lane / BLOCK], lane % BLOCK)
    }
    /// Reference volume, m3; 0 for a lane that holds no element.
    #[inline(always)]
    pub fn volume(&self) -> G {
        self.load(VOLUME)
    }
    #[inline(always)]
    fn load(&self, which: usize) -> G {
        debug_assert!(which < SHAPE);
        // SAFETY: `which` is below SHAPE for what an element has, three base vectors and four patterns.
        unsafe { self.block.shape.get_unchecked(which) }.load(self.first)
    }
    /// Part of a base vector in the negative of an hourglass shape.
    #[inline(always)]
    pub(super) fn skew(&self, pattern: usize, base: usize) -> G {
        self.load(SKEW + 3 * pattern + base)
    }
    /// What a pattern adds to a base vector in the mean gradient.
    #[inline(always)]
    pub(super) fn mean(&self, pattern: usize, base: usize) -> G {
        self.load(MEAN + 3 * pattern + base)
    }
    /// Rows of `J^-1 / 8`, without their zeros.
    #[inline(always)]
    pub(super) fn inverse(&self) -> ([G; 3], [G; 2], G) {
        ([self.load(0), self.load(1), self.load(2)], [self.load(3), self.load(4)], self.load(5))
    }
    /// Minus the stiffness of a pattern, N/m.
    #[inline(always)]
    pub(super) fn stiffness<P: Pack<Real = R>>(&self, pattern: usize) -> P {
        self.block.stiffness[pattern].load(self.first)
    }
}

/// Constants of the blocks of a patch.
#[derive(Clone)]
pub enum Shapes<R: Real> {
    /// Of elements whose shape depends on no variable.
    Fixed(Arc<[Block<f64, R>]>),
    /// Of others.
    Varying(Arc<[Block<R, R>]>),
}

impl<R: Real> Shapes<R> {
    /// Of some elements by their corners, in some blocks: given the slots of the elements. Slots of no element have no
    /// volume.
    pub fn new(elements: &[(usize, [Vec3<R>; CORNERS])], blocks: usize, shear: R) -> Self {
        if elements.iter().all(|(_, corners)| keeps_shape(corners)) {
            let plain = |v: Vec3<R>| Vec3::new(v.x.re(), v.y.re(), v.z.re());
            let of = |corners: &[Vec3<R>; CORNERS]| constants(&corners.map(plain), shear, R::from_f64);
            Self::Fixed(stored(elements, blocks, of))
        } else {
            Self::Varying(stored(elements, blocks, |corners| constants(corners, shear, |number| number)))
        }
    }
    /// Number of blocks.
    pub fn len(&self) -> usize {
        match self {
            Self::Fixed(blocks) => blocks.len(),
            Self::Varying(blocks) => blocks.len(),
        }
    }
    /// Where they stand.
    pub fn address(&self) -> usize {
        match self {
            Self::Fixed(blocks) => blocks.as_ptr() as usize,
            Self::Varying(blocks) => blocks.as_ptr() as usize,
        }
    }
    /// Reference volumes of all lanes, m3.
    pub fn volumes(&self) -> Vec<f64> {
        fn of<G: Real, R: Real>(blocks: &[Block<G, R>]) -> Vec<f64> {
            let lanes =
                |block: &Block<G, R>| [0, 1, 2, 3, 4, 5, 6, 7].map(|lane| block.shape[VOLUME].get(lane).re());
            blocks.iter().flat_map(lanes).collect()
        }
        match self {
            Self::Fixed(blocks) => of(blocks),
            Self::Varying(blocks) => of(blocks),
        }
    }
    /// Whether constants and their derivatives are the same to rounding.
    pub fn alike(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Fixed(one), Self::Fixed(other)) => alike(one, other),
            (Self::Varying(one), Self::Varying(other)) => alike(one, other),
            _ => false,
        }
    }
}

/// Blocks of constants.
fn stored<G: Real, R: Real>(
    elements: &[(usize, [Vec3<R>; CORNERS])],
    blocks: usize,
    of: impl Fn(&[Vec3<R>; CORNERS]) -> ([G; SHAPE], [R; STIFFNESSES]),
) -> Arc<[Block<G, R>]> {
    let nothing =
        Block { shape: [Eight::alike(G::zero()); SHAPE], stiffness: [Eight::alike(R::zero()); STIFFNESSES] };
    let mut stored = vec![nothing; blocks];
    for (slot, corners) in elements {
        let (block, lane) = (&mut stored[slot / BLOCK], slot % BLOCK);
        let (shape, stiffness) = of(corners);
        block.shape.iter_mut().zip(shape).for_each(|(eight, number)| eight.set(lane, number));
        block.stiffness.iter_mut().zip(stiffness).for_each(|(eight, number)| eight.set(lane, number));
    }
    stored.into()
}

/// How far constants may differ that are the same but for the rounding of positions: those of a ball half a metre
/// from the origin have lost 5e-17 m, of edges of a tenth of a millimetre, and differences of differences lose a
/// hundred times that.
const ROUNDING: f64 = 1e-10;

/// Whether no distance between corners depends on a variable: an element that variables move and turn keeps its shape
/// to rounding, and so its constants.
fn keeps_shape<R: Real>(corners: &[Vec3<R>; CORNERS]) -> bool {
    let slopes = |v: &Vec3<R>, which: usize| {
        let [x, y, z] = v.array().map(|number| number.derivatives()[which]);
        x.abs().max(y.abs()).max(z.abs())
    };
    (0..R::PARTS - 1).all(|which| {
        let most = corners.iter().map(|corner| slopes(corner, which)).fold(0.0, f64::max);
        (1..CORNERS).all(|a| {
            (0..a).all(|b| {
                let distance = (corners[a] - corners[b]).norm();
                distance.derivatives()[which].abs() <= ROUNDING * most
            })
        })
    })
}

/// Whether constants and their derivatives are the same to rounding.
fn alike<G: Real, R: Real>(a: &[Block<G, R>], b: &[Block<G, R>]) -> bool {
    // Beside the largest of its kind: values and derivatives of a constant are kinds of their own. Those of the
    // inverse Jacobian are of one kind.
    let lines = SHAPE * G::PARTS + STIFFNESSES * R::PARTS;
    let kind = |line: usize| if line < SKEW * G::PARTS { line % G::PARTS } else { line };
    let mut largest = vec![0.0_f64; lines];
    for block in a {
        for (line, numbers) in block.lines().iter().enumerate() {
            let largest = &mut largest[kind(line)];
            *largest = numbers.iter().fold(*largest, |largest, number| largest.max(number.abs()));
        }
    }
    let allowed = |line: usize| {
        // Shapes of hourglass patterns are relative to the edges; they may all be zero but for rounding.
        let least = if (SKEW * G::PARTS..VOLUME * G::PARTS).contains(&line) { 1.0 } else { 0.0 };
        ROUNDING * largest[kind(line)].max(least)
    };
    let allowed: Vec<f64> = (0..lines).map(allowed).collect();
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| {
            let lines = a.lines().iter().zip(b.lines()).zip(&allowed);
            lines.into_iter().all(|((a, b), allowed)| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= *allowed))
        })
}

impl<G: Real, R: Real> Block<G, R> {
    /// All numbers of it: those of a constant for eight elements, then each of its derivatives.
    fn lines(&self) -> &[[f64; BLOCK]] {
        let count = size_of::<Self>() / size_of::<[f64; BLOCK]>();
        // SAFETY: constants are as many lines of eight numbers as they have parts, and nothing else.
        unsafe { std::slice::from_raw_parts(std::ptr::from_ref(self).cast(), count) }
    }
}
