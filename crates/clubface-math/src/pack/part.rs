//! Linear maps of packs with derivatives, one part of the numbers after the other.

use super::traits::{Lanes, Pack, Part};
use crate::Dual;

impl<S: Lanes, const N: usize> Part<Dual<S, N>> for S {
    #[inline(always)]
    fn from_pack(pack: &Dual<S, N>, pass: usize) -> Self {
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
    fn into_value(self) -> S {
        self
    }
    #[inline(always)]
    fn from_value(value: S) -> Self {
        value
    }
}

/// Pairs of value and derivative.
impl<S: Lanes, const N: usize> Part<Dual<S, N>> for Dual<S, 1> {
    #[inline(always)]
    fn from_pack(pack: &Dual<S, N>, pass: usize) -> Self {
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
    fn into_value(self) -> S {
        self.tangent[0]
    }
    #[inline(always)]
    fn from_value(value: S) -> Self {
        Self { value: S::zero(), tangent: [value] }
    }
}
