//! The simplest rubber, `W = mu/2 (I1 - 3)` (Treloar, 1943).

use super::{OfInvariants, Symmetric};
use clubface_math::{Pack, Scalar};

/// Shear modulus.
#[derive(Clone, Copy, Debug)]
pub struct NeoHookean<S> {
    /// Shear modulus, Pa.
    pub shear: S,
}

impl<R> NeoHookean<R> {
    #[inline(always)]
    pub(super) fn splat<P: Pack<Real = R>>(&self) -> NeoHookean<P>
    where
        R: Copy,
    {
        NeoHookean { shear: P::splat(self.shear) }
    }
}

impl<S: Scalar> OfInvariants<S> for NeoHookean<S> {
    #[inline(always)]
    fn factors(&self, _first: S, _second: S) -> [S; 2] {
        [self.shear, S::zero()]
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>) -> S {
        self.shear * (c.trace() - 3.0) * 0.5
    }
}
