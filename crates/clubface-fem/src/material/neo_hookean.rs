//! The simplest rubber, `W = mu/2 (I1 - 3)` (Treloar, 1943).

use super::{Description, Elastic, Family, FromValues, Invariants, OfInvariants, Symmetric};
use crate::constants;
use clubface_math::{Pack, Scalar};

constants! {
    /// Neo-Hookean rubber.
    NeoHookean {
        shear ["pressure"] in 0.0 ..= 1e12, "Shear modulus, Pa.";
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

impl Family for NeoHookean<()> {
    const DESCRIPTION: Description = Description {
        name: "neo-hookean",
        summary: "rubber, W = shear/2 (I1 - 3)",
        source: "L. R. G. Treloar, Trans. Faraday Soc. 39, 1943",
        constants: Self::CONSTANTS,
        needed: 1,
        group: 1,
        listed: true,
        state: &[],
        cost: 30,
        example: &[10e6],
    };
    type Over<P: Pack> = Elastic<Invariants<NeoHookean<P>>>;
    #[inline(always)]
    fn over<P: Pack>(constants: &[P]) -> Self::Over<P> {
        Elastic(Invariants(NeoHookean::from_values(constants)))
    }
    fn shear<S: Scalar>(constants: &[S]) -> S {
        constants[0]
    }
}
