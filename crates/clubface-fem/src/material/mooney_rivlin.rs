//! Rubber after Mooney (1940) and Rivlin (1948): `W = C10 (I1 - 3) + C01 (I2 - 3)`, the core of P2's ball.

use super::{OfInvariants, Symmetric};
use clubface_math::{Pack, Scalar};

/// Constants in Pa; the shear modulus is `2 (C10 + C01)`.
#[derive(Clone, Copy, Debug)]
pub struct MooneyRivlin<S> {
    /// Factor of the first invariant, Pa.
    pub c10: S,
    /// Factor of the second invariant, Pa.
    pub c01: S,
}

impl<R> MooneyRivlin<R> {
    #[inline(always)]
    pub(super) fn splat<P: Pack<Real = R>>(&self) -> MooneyRivlin<P>
    where
        R: Copy,
    {
        MooneyRivlin { c10: P::splat(self.c10), c01: P::splat(self.c01) }
    }
}

impl<S: Scalar> OfInvariants<S> for MooneyRivlin<S> {
    #[inline(always)]
    fn factors(&self, first: S, _second: S) -> [S; 2] {
        let twice = self.c01 + self.c01;
        [twice.mul_add(first, self.c10 + self.c10), -twice]
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>) -> S {
        let first = c.trace();
        let second = (first * first - c.contract(c)) * 0.5;
        self.c10 * (first - 3.0) + self.c01 * (second - 3.0)
    }
}
