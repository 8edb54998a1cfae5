//! Rubber after Ogden (Proc. R. Soc. Lond. A 326, 1972): `W = sum of mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3)`
//! over one to three terms, with the principal stretches l of the change of shape.
//!
//! In this convention the shear modulus is half the sum of `mu alpha`; one term with alpha = 2 is the neo-Hookean
//! solid of modulus mu, and a second with alpha = -2 makes it Mooney's and Rivlin's (`mu = 2 C10`, `mu = -2 C01`).
//! Some programs write `2 mu / alpha^2` instead of `mu / alpha`.

use super::stretch::{Function, Stretches};
use super::{Constant, Description, Elastic, Family, Invariants, OfInvariants, Symmetric};
use crate::error::FemError;
use clubface_math::{Pack, Scalar};

/// Most terms.
pub const OGDEN_TERMS: usize = 3;

/// Largest exponent, positive or negative.
const EXPONENT: f64 = 30.0;

/// One term: its factor `mu` (Pa) and the exponent of the stretches.
#[derive(Clone, Copy, Debug)]
pub struct OgdenTerm<S> {
    /// Factor, Pa.
    pub mu: S,
    /// Exponent of the stretches.
    pub alpha: S,
}

/// The terms; those behind the last have no factor.
#[derive(Clone, Copy, Debug)]
pub struct Ogden<S> {
    terms: [OgdenTerm<S>; OGDEN_TERMS],
    count: usize,
}

impl<S: Scalar> Ogden<S> {
    /// From the constants of one to three terms, `mu` and `alpha` in turn.
    #[inline(always)]
    fn from_slice(constants: &[S]) -> Self {
        let mut terms = [OgdenTerm { mu: S::zero(), alpha: S::from_f64(2.0) }; OGDEN_TERMS];
        let count = constants.len() / 2;
        for i in 0..count {
            terms[i] = OgdenTerm { mu: constants[2 * i], alpha: constants[2 * i + 1] };
        }
        Self { terms, count }
    }
    #[inline(always)]
    fn terms(&self) -> &[OgdenTerm<S>] {
        &self.terms[..self.count]
    }
}

impl<S: Scalar> OfInvariants<S> for Ogden<S> {
    #[inline(always)]
    fn factors(&self, first: S, second: S) -> [S; 2] {
        // W = sum of mu/alpha tr C^(alpha/2), so 2 dW/dC = sum of mu C^(alpha/2 - 1).
        let stretches = Stretches::new(first, second);
        let logarithm = stretches.logarithm();
        let mut sum = Function::zero();
        for term in self.terms() {
            sum = sum.plus(term.mu, stretches.exponential(&logarithm, term.alpha * 0.5 - 1.0));
        }
        // C^2 = I C - II + C^-1.
        let [one, linear, square] = stretches.factors(&sum);
        [one - square * second, square.mul_add(first, linear)]
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>) -> S {
        let stretches = Stretches::new(c.trace(), c.second());
        let logarithm = stretches.logarithm();
        let mut sum = S::zero();
        for term in self.terms() {
            let power = stretches.exponential(&logarithm, term.alpha * 0.5);
            sum += term.mu / term.alpha * (stretches.trace(&power) - 3.0);
        }
        sum
    }
}

const fn mu(name: &'static str) -> Constant {
    let meaning = "Factor of a term, Pa, of the sign of its exponent.";
    Constant { name, dimension: "pressure", meaning, least: -1e12, most: 1e12 }
}
const fn alpha(name: &'static str) -> Constant {
    let meaning = "Exponent of the stretches in a term, not zero.";
    Constant { name, dimension: "dimensionless", meaning, least: -EXPONENT, most: EXPONENT }
}

impl Family for Ogden<()> {
    const DESCRIPTION: Description = Description {
        name: "ogden",
        summary: "rubber, W = sum of mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3), one to three terms",
        source: "R. W. Ogden, Proc. R. Soc. Lond. A 326, 1972",
        constants: &[mu("mu1"), alpha("alpha1"), mu("mu2"), alpha("alpha2"), mu("mu3"), alpha("alpha3")],
        needed: 2,
        group: 2,
        listed: true,
        state: &[],
        cost: 36,
        // Half the sum of mu alpha: 10 MPa.
        example: &[10e6, 1.3, 0.6e6, 5.0, -2e6, -2.0],
    };
    type Over<P: Pack> = Elastic<Invariants<Ogden<P>>>;
    #[inline(always)]
    fn over<P: Pack>(constants: &[P]) -> Self::Over<P> {
        Elastic(Invariants(Ogden::from_slice(constants)))
    }
    fn shear<S: Scalar>(constants: &[S]) -> S {
        let mut sum = S::zero();
        for term in constants.chunks_exact(2) {
            sum += term[0] * term[1];
        }
        sum * 0.5
    }
    fn check(constants: &[f64], name: &str) -> Result<(), FemError> {
        for (number, term) in constants.chunks_exact(2).enumerate() {
            let (mu, alpha, number) = (term[0], term[1], number + 1);
            if !(alpha != 0.0 && alpha.abs() <= EXPONENT) {
                let allowed = format!("it must be -{EXPONENT} to {EXPONENT}, not 0");
                return Err(FemError::input(format!("alpha{number} of {name}"), alpha, allowed));
            }
            if !(mu * alpha > 0.0 && mu.is_finite()) {
                let why = "otherwise the rubber may lose its stiffness";
                let allowed = format!("it must be of the sign of alpha{number}, {why}");
                return Err(FemError::input(format!("mu{number} of {name}"), format!("{mu} Pa"), allowed));
            }
        }
        Ok(())
    }
}
