//! Numbers of eight elements side by side, as packs read them.

use clubface_math::{Pack, Real};

/// Elements a block holds, whatever the width of the packs that read it.
pub const BLOCK: usize = 8;

/// Numbers that stand on a boundary of the cache's lines, so that no pack straddles two.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Aligned<A>(pub A);

/// One number of each element of a block: the values, then each derivative.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Eight<R: Real>(R::Parts<[f64; BLOCK]>);

impl<R: Real> Eight<R> {
    /// The same number for all.
    pub fn alike(number: R) -> Self {
        let mut eight = Self(R::each_part([0.0; BLOCK]));
        (0..BLOCK).for_each(|lane| eight.set(lane, number));
        eight
    }
    /// The number of an element.
    pub fn get(&self, lane: usize) -> R {
        assert!(lane < BLOCK);
        // SAFETY of these: eight numbers for each part.
        unsafe { R::from_parts(std::ptr::from_ref(self).cast::<f64>().add(lane), BLOCK) }
    }
    /// Sets the number of an element.
    pub fn set(&mut self, lane: usize, number: R) {
        assert!(lane < BLOCK);
        unsafe { number.put_parts(std::ptr::from_mut(self).cast::<f64>().add(lane), BLOCK) };
    }
    /// The numbers of a pack of elements, which begins with the element `first`.
    #[inline(always)]
    pub fn load<P: Pack<Real = R>>(&self, first: usize) -> P {
        assert!(first + P::LANES <= BLOCK);
        unsafe { P::read_parts(std::ptr::from_ref(self).cast::<f64>().add(first), BLOCK) }
    }
    /// Writes them.
    #[inline(always)]
    pub fn store<P: Pack<Real = R>>(&mut self, first: usize, pack: P) {
        assert!(first + P::LANES <= BLOCK);
        unsafe { pack.write_parts(std::ptr::from_mut(self).cast::<f64>().add(first), BLOCK) };
    }
}
