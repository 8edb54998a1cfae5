//! Rubber whose chains end, `W = -mu/2 Jm ln(1 - (I1 - 3) / Jm)`: a law that stands here and not in the crate, to
//! show that a law is one file and one line of a table.

use clubface_fem::constants;
use clubface_fem::material::{Description, Elastic, Family, FromValues, Invariants, OfInvariants, Symmetric};
use clubface_math::{Pack, Scalar};

constants! {
    /// Gent's rubber.
    Gent {
        shear ["pressure"] in 0.0 ..= 1e12, "Shear modulus, Pa.";
        limit ["dimensionless"] in 1.0 ..= 1e6, "I1 - 3 at which the chains are stretched out.";
    }
}

impl<S: Scalar> OfInvariants<S> for Gent<S> {
    #[inline(always)]
    fn factors(&self, first: S, _second: S) -> [S; 2] {
        [self.shear * self.limit / (self.limit - first + 3.0), S::zero()]
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>) -> S {
        let left = -((c.trace() - 3.0) / self.limit) + 1.0;
        self.shear * self.limit * left.ln() * -0.5
    }
}

impl Family for Gent<()> {
    const DESCRIPTION: Description = Description {
        name: "gent",
        summary: "rubber, W = -shear/2 limit ln(1 - (I1 - 3) / limit)",
        source: "A. N. Gent, Rubber Chem. Technol. 69, 1996",
        constants: Self::CONSTANTS,
        needed: 2,
        group: 2,
        listed: true,
        state: &[],
        cost: 36,
        example: &[10e6, 20.0],
    };
    type Over<P: Pack> = Elastic<Invariants<Gent<P>>>;
    #[inline(always)]
    fn over<P: Pack>(constants: &[P]) -> Self::Over<P> {
        Elastic(Invariants(Gent::from_values(constants)))
    }
    fn shear<S: Scalar>(constants: &[S]) -> S {
        constants[0]
    }
}
