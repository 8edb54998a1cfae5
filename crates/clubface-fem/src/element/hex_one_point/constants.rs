//! What a hexahedron with one integration point keeps of its undeformed shape.

use super::numbers::{Block, Lines, MEAN, SHAPE, SKEW, STIFFNESSES, VOLUME, constants};
use super::sameness::{alike, keeps_shape, similar};
use crate::block::{BLOCK, Eight};
use crate::mesh::CORNERS;
use clubface_math::{Pack, Part, Real, Vec3};
use std::marker::PhantomData;
use std::sync::Arc;

/// How shapes depend on a variable.
#[derive(Clone)]
struct Slopes {
    /// Whether elements grow without a change of shape, so that only base vectors and volumes depend on the variable.
    similar: bool,
    /// Derivatives, by block.
    blocks: Arc<[Lines]>,
}

/// Constants of the blocks of a patch.
#[derive(Clone)]
pub struct Shapes<R: Real> {
    blocks: Arc<[Block<R>]>,
    /// By variable; none for one that no shape depends on.
    slopes: Vec<Option<Slopes>>,
}

/// Constants of a pack of elements: lanes `first..` of a block. Without `SLOPES` their shapes are taken to depend on no
/// variable, and no time is spent on finding out.
#[derive(Clone, Copy)]
pub struct Constants<'a, R: Real, const SLOPES: bool> {
    shapes: &'a Shapes<R>,
    number: usize,
    block: &'a Block<R>,
    first: usize,
}

/// The shapes of a pack of elements as a pass `G` of a linear map of packs `P` needs them.
#[derive(Clone, Copy)]
pub struct Shape<'a, P, G> {
    values: &'a Lines,
    slopes: &'a Lines,
    first: usize,
    packs: PhantomData<(P, G)>,
}

impl<'a, R: Real, const SLOPES: bool> Constants<'a, R, SLOPES> {
    /// Constants of a block with its number, from lane `first` on.
    #[inline(always)]
    pub fn new(shapes: &'a Shapes<R>, number: usize, block: &'a Block<R>, first: usize) -> Self {
        Self { shapes, number, block, first }
    }
    /// Constants of a pack from a lane on, counted over all blocks.
    #[inline(always)]
    pub fn at(shapes: &'a Shapes<R>, lane: usize) -> Self {
        let number = lane / BLOCK;
        Self::new(shapes, number, &shapes.blocks[number], lane % BLOCK)
    }
    /// Where they stand.
    #[inline(always)]
    pub fn block(&self) -> &'a Block<R> {
        self.block
    }
    /// Whether base vectors and volumes depend on the variable of a pass.
    #[inline(always)]
    pub fn size_varies(&self, pass: usize) -> bool {
        SLOPES && self.shapes.slopes(pass).is_some()
    }
    /// Whether hourglass shapes and mean gradients do.
    #[inline(always)]
    pub fn pattern_varies(&self, pass: usize) -> bool {
        SLOPES && self.shapes.pattern_varies(pass)
    }
    /// As a pass needs them.
    #[inline(always)]
    pub fn shape<P: Pack<Real = R>, G: Part<P>>(&self, pass: usize) -> Shape<'a, P, G> {
        assert!(self.first + P::LANES <= BLOCK);
        let values = &self.block.shape;
        let slopes = if SLOPES { self.shapes.slopes(pass) } else { None };
        let slopes = slopes.map_or(values, |slopes| &slopes.blocks[self.number]);
        Shape { values, slopes, first: self.first, packs: PhantomData }
    }
    /// Reference volume, m3; 0 for a lane that holds no element.
    #[inline(always)]
    pub fn volume<P: Pack<Real = R>>(&self) -> P {
        let mut volume = P::zero();
        volume.set_part(0, self.shape::<P, P::Value>(0).volume());
        for pass in 1..R::PARTS {
            if self.size_varies(pass) {
                volume.set_part(pass, self.shape::<P, P::Pair>(pass).volume().into_value());
            }
        }
        volume
    }
    /// Minus the stiffness of a pattern, N/m.
    #[inline(always)]
    pub(super) fn stiffness<P: Pack<Real = R>>(&self, pattern: usize) -> P {
        self.block.stiffness[pattern].load(self.first)
    }
}

impl<P: Pack, G: Part<P>> Shape<'_, P, G> {
    #[inline(always)]
    fn load(&self, index: usize) -> G {
        debug_assert!(index < SHAPE);
        // SAFETY: `which` is below SHAPE for what an element has, three base vectors and four patterns; a block has
        // room for a pack from `first` on.
        unsafe {
            let at = |lines: &Lines| std::ptr::from_ref(lines.get_unchecked(index)).cast::<f64>();
            G::coefficient(at(self.values).add(self.first), at(self.slopes).add(self.first))
        }
    }
    /// Reference volume, m3.
    #[inline(always)]
    pub(super) fn volume(&self) -> G {
        self.load(VOLUME)
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
}

impl<R: Real> Shapes<R> {
    /// Shapes of elements, given by slot and corners, in a number of blocks. Slots without an element have no volume.
    pub fn new(elements: &[(usize, [Vec3<R>; CORNERS])], blocks: usize, shear: R) -> Self {
        let varies: Vec<bool> = (1..R::PARTS)
            .map(|part| !elements.iter().all(|(_, corners)| keeps_shape(corners, part - 1)))
            .collect();
        let plain = |v: Vec3<R>| Vec3::new(v.x.re(), v.y.re(), v.z.re());
        let nothing = [Eight::alike(0.0); SHAPE];
        let mut stored =
            vec![Block { shape: nothing, stiffness: [Eight::alike(R::zero()); STIFFNESSES] }; blocks];
        let mut slopes: Vec<_> = varies.iter().map(|varies| varies.then(|| vec![nothing; blocks])).collect();
        for (slot, corners) in elements {
            let (block, lane) = (slot / BLOCK, slot % BLOCK);
            let (shape, mut stiffness) = constants(&corners.map(plain), shear, R::from_f64);
            stored[block].shape.iter_mut().zip(shape).for_each(|(eight, number)| eight.set(lane, number));
            if varies.contains(&true) {
                let (shape, stiff) = constants(corners, shear, |number| number);
                stiffness = stiff;
                for (index, lines) in slopes.iter_mut().enumerate() {
                    for (eight, number) in lines.iter_mut().flat_map(|lines| &mut lines[block]).zip(&shape) {
                        eight.set(lane, number.derivatives()[index]);
                    }
                }
            }
            let eights = stored[block].stiffness.iter_mut();
            eights.zip(stiffness).for_each(|(eight, number)| eight.set(lane, number));
        }
        let slopes = slopes.into_iter().map(|lines| {
            let blocks: Arc<[Lines]> = lines?.into();
            Some(Slopes { similar: similar(&stored, &blocks), blocks })
        });
        Self { slopes: slopes.collect(), blocks: stored.into() }
    }
    /// Number of blocks.
    pub fn len(&self) -> usize {
        self.blocks.len()
    }
    /// Where they stand.
    pub fn address(&self) -> usize {
        self.blocks.as_ptr() as usize
    }
    /// Reference volumes of all lanes, m3.
    pub fn volumes(&self) -> Vec<f64> {
        let lanes = |block: &Block<R>| [0, 1, 2, 3, 4, 5, 6, 7].map(|lane| block.shape[VOLUME].get(lane));
        self.blocks.iter().flat_map(lanes).collect()
    }
    /// Whether constants and their derivatives are the same to rounding.
    pub fn alike(&self, other: &Self) -> bool {
        alike(&self.blocks, &other.blocks, R::PARTS)
            && self.slopes.iter().zip(&other.slopes).all(|pair| match pair {
                (Some(one), Some(other)) => {
                    one.similar == other.similar && alike(&one.blocks, &other.blocks, 0)
                }
                (one, other) => one.is_none() && other.is_none(),
            })
    }
    /// The blocks, without their derivatives by variables.
    #[inline(always)]
    pub fn blocks(&self) -> &[Block<R>] {
        &self.blocks
    }
    /// How shapes depend on the variable of a pass.
    #[inline(always)]
    fn slopes(&self, pass: usize) -> Option<&Slopes> {
        // Known to the compiler for plain numbers, which have no other pass than the first.
        if R::PARTS == 1 || pass == 0 {
            return None;
        }
        self.slopes[pass - 1].as_ref()
    }
    /// Whether hourglass shapes and mean gradients depend on the variable of a pass.
    #[inline(always)]
    pub fn pattern_varies(&self, pass: usize) -> bool {
        self.slopes(pass).is_some_and(|slopes| !slopes.similar)
    }
    /// Whether shapes depend on a variable.
    pub fn vary(&self) -> bool {
        self.slopes.iter().any(Option::is_some)
    }
}
