//! Linear maps of packs, one part of the numbers after the other.

use super::traits::{Lanes, Pack};
use crate::Dual;

/// What one pass of a linear map acts on. Such a map goes through the parts of a pack `P` one after the other, each in a
/// pass of its own, so that the numbers of one pass fit the registers. Where its coefficients depend on no variable,
/// passes act on plain packs. Where they depend on the variable of a pass, this acts on pairs of value and derivative,
/// and what it finds is the derivative; the value belongs to the first pass.
pub trait Part<P: Pack>: Pack {
    /// What a pass acts on.
    fn of(pack: &P, pass: usize) -> Self;
    /// The first part that a pass reads, and how far apart those are that it reads.
    fn places(pass: usize) -> [usize; 2];
    /// A coefficient from the addresses of its value and of its derivative by the variable of a pass, which a pass
    /// with plain coefficients does not read.
    ///
    /// # Safety
    /// `LANES` consecutive numbers can be read from each.
    unsafe fn coefficient(value: *const f64, derivative: *const f64) -> Self;
    /// What a pass has found.
    fn found(self) -> P::Value;
    /// What adds up to something found: with pairs, its value does not count.
    fn from_found(found: P::Value) -> Self;
}

impl<S: Lanes, const N: usize> Part<Dual<S, N>> for S {
    #[inline(always)]
    fn of(pack: &Dual<S, N>, pass: usize) -> Self {
        pack.part(pass)
    }
    #[inline(always)]
    fn places(pass: usize) -> [usize; 2] {
        [pass, 0]
    }
    #[inline(always)]
    unsafe fn coefficient(value: *const f64, _derivative: *const f64) -> Self {
        // SAFETY: the caller's promise.
        unsafe { S::read(value) }
    }
    #[inline(always)]
    fn found(self) -> S {
        self
    }
    #[inline(always)]
    fn from_found(found: S) -> Self {
        found
    }
}

/// Pairs of value and derivative.
impl<S: Lanes, const N: usize> Part<Dual<S, N>> for Dual<S, 1> {
    #[inline(always)]
    fn of(pack: &Dual<S, N>, pass: usize) -> Self {
        Self { value: pack.value, tangent: [pack.part(pass)] }
    }
    #[inline(always)]
    fn places(pass: usize) -> [usize; 2] {
        [0, pass]
    }
    #[inline(always)]
    unsafe fn coefficient(value: *const f64, derivative: *const f64) -> Self {
        // SAFETY: the caller's promise.
        unsafe { Self { value: S::read(value), tangent: [S::read(derivative)] } }
    }
    #[inline(always)]
    fn found(self) -> S {
        self.tangent[0]
    }
    #[inline(always)]
    fn from_found(found: S) -> Self {
        Self { value: S::zero(), tangent: [found] }
    }
}
