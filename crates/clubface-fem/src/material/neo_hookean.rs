//! The simplest rubber, `W = mu/2 (I1 - 3)` (Treloar, 1943).

use super::{Isochoric, Symmetric};
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

impl<S: Scalar> Isochoric<S> for NeoHookean<S> {
    #[inline(always)]
    fn stress(&self, _c: &Symmetric<S>) -> Symmetric<S> {
        Symmetric::diagonal(self.shear)
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>) -> S {
        self.shear * (c.trace() - 3.0) * 0.5
    }
}
