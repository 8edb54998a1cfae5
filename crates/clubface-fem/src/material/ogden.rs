//! Rubber after Ogden (Proc. R. Soc. Lond. A 326, 1972): `W = sum of mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3)` over one to three terms,
//! with the principal stretches l of the change of shape.
//!
//! In this convention the shear modulus is half the sum of `mu alpha`; one term with alpha = 2 is the neo-Hookean solid of modulus mu, and a second
//! with alpha = -2 makes it Mooney's and Rivlin's (`mu = 2 C10`, `mu = -2 C01`). Some programs write `2 mu / alpha^2` instead of `mu / alpha`.

use super::stretch::{Function, Stretches};
use super::{OfInvariants, Symmetric};
use clubface_math::{Pack, Real, Scalar};

/// Most terms.
pub const OGDEN_TERMS: usize = 3;

/// One term.
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

impl<R: Real> Ogden<R> {
    /// Of one to three terms.
    ///
    /// # Panics
    /// If there are more, or none.
    pub fn new(terms: &[OgdenTerm<R>]) -> Self {
        assert!((1..=OGDEN_TERMS).contains(&terms.len()), "one to {OGDEN_TERMS} terms");
        let nothing = OgdenTerm { mu: R::zero(), alpha: R::from_f64(2.0) };
        let mut all = [nothing; OGDEN_TERMS];
        all[..terms.len()].copy_from_slice(terms);
        Self { terms: all, count: terms.len() }
    }
    /// Shear modulus of small deformation, Pa.
    pub fn shear(&self) -> R {
        let mut sum = R::zero();
        for term in self.terms() {
            sum += term.mu * term.alpha;
        }
        sum * 0.5
    }
    #[inline(always)]
    pub(super) fn splat<P: Pack<Real = R>>(&self) -> Ogden<P> {
        let [a, b, c] = self.terms;
        let splat = |t: OgdenTerm<R>| OgdenTerm { mu: P::splat(t.mu), alpha: P::splat(t.alpha) };
        Ogden { terms: [splat(a), splat(b), splat(c)], count: self.count }
    }
}

impl<S> Ogden<S> {
    /// The terms.
    #[inline(always)]
    pub fn terms(&self) -> &[OgdenTerm<S>] {
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
