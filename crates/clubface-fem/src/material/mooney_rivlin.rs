//! Rubber after Mooney (1940) and Rivlin (1948): `W = C10 (I1 - 3) + C01 (I2 - 3)`, the core of Roh and Lee's ball.

use super::{Description, Elastic, Family, FromValues, Invariants, OfInvariants, Symmetric};
use crate::constants;
use clubface_math::{Pack, Scalar};

// With a negative constant it would soften until it runs away.
constants! {
    /// Mooney's and Rivlin's rubber; its shear modulus is `2 (C10 + C01)`.
    MooneyRivlin {
        c10 ["pressure"] in 0.0 ..= 1e12, "Factor of the first invariant, Pa.";
        c01 ["pressure"] in 0.0 ..= 1e12, "Factor of the second invariant, Pa.";
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

impl Family for MooneyRivlin<()> {
    const DESCRIPTION: Description = Description {
        name: "mooney-rivlin",
        summary: "rubber, W = c10 (I1 - 3) + c01 (I2 - 3)",
        source: "M. Mooney, J. Appl. Phys. 11, 1940; R. S. Rivlin, Phil. Trans. R. Soc. A 241, 1948",
        constants: Self::CONSTANTS,
        needed: 2,
        group: 2,
        listed: true,
        state: &[],
        cost: 30,
        example: &[4e6, 1e6],
    };
    type Over<P: Pack> = Elastic<Invariants<MooneyRivlin<P>>>;
    #[inline(always)]
    fn over<P: Pack>(constants: &[P]) -> Self::Over<P> {
        Elastic(Invariants(MooneyRivlin::from_values(constants)))
    }
    fn shear<S: Scalar>(constants: &[S]) -> S {
        (constants[0] + constants[1]) * 2.0
    }
}
