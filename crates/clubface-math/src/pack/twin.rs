//! Two packs side by side as one, for computations whose steps wait for each other.
//!
//! A flight or a contact is one long chain: each operation needs the result of the one before, and the arithmetic units
//! idle meanwhile. With two packs there is always a second chain to work on.

use super::operators::{primal_functions, primal_operators};
use super::traits::Numbers;
use crate::elementary::Primal;
use crate::scalar::{Computation, Mask, Scalar, operators};
use core::ops::Neg;

/// Two packs: the lanes of the first, then those of the second.
#[derive(Clone, Copy, Debug)]
pub struct Twin<S>(S, S);

/// Truth values of both.
#[derive(Clone, Copy, Debug)]
pub struct TwinMask<M>(M, M);

impl<M: Mask> Mask for TwinMask<M> {
    const LANES: usize = 2 * M::LANES;
    #[inline(always)]
    fn any(self) -> bool {
        self.0.or(self.1).any()
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.0.and(self.1).all()
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(self.0.and(other.0), self.1.and(other.1))
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(self.0.or(other.0), self.1.or(other.1))
    }
    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.not(), self.1.not())
    }
    #[inline(always)]
    fn splat(value: bool) -> Self {
        Self(M::splat(value), M::splat(value))
    }
    #[inline(always)]
    fn lane(self, index: usize) -> bool {
        if index < M::LANES { self.0.lane(index) } else { self.1.lane(index - M::LANES) }
    }
}

operators! { [S: Numbers] Twin<S>;
    Add add Self => Self, |a, b| Self(a.0 + b.0, a.1 + b.1);
    Sub sub Self => Self, |a, b| Self(a.0 - b.0, a.1 - b.1);
    Mul mul Self => Self, |a, b| Self(a.0 * b.0, a.1 * b.1);
    Div div Self => Self, |a, b| Self(a.0 / b.0, a.1 / b.1);
}
primal_operators!([S: Numbers] Twin<S>);

impl<S: Numbers> Neg for Twin<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<S: Numbers> Scalar for Twin<S> {
    type Mask = TwinMask<S::Mask>;
    const LANES: usize = 2 * S::LANES;
    primal_functions!();
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(S::from_f64(value), S::from_f64(value))
    }
    #[inline(always)]
    fn lane(self, index: usize) -> f64 {
        if index < S::LANES { self.0.lane(index) } else { self.1.lane(index - S::LANES) }
    }
    #[inline(always)]
    fn outline<C: Computation>(computation: C) -> C::Output {
        S::outline(computation)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        TwinMask(self.0.lt(other.0), self.1.lt(other.1))
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        TwinMask(self.0.le(other.0), self.1.le(other.1))
    }
    #[inline(always)]
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self {
        Self(S::select(mask.0, a.0, b.0), S::select(mask.1, a.1, b.1))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0), self.1.max(other.1))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0), self.1.min(other.1))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(self.0.mul_add(factor.0, term.0), self.1.mul_add(factor.1, term.1))
    }
    #[inline(always)]
    fn ln(self) -> Self {
        Self(self.0.ln(), self.1.ln())
    }
}

impl<S: Numbers> Primal for Twin<S> {
    #[inline(always)]
    fn pow2_shifted(shifted: Self) -> Self {
        Self(S::pow2_shifted(shifted.0), S::pow2_shifted(shifted.1))
    }
}

impl<S: Numbers> Numbers for Twin<S> {
    #[inline(always)]
    fn from_fn(mut value: impl FnMut(usize) -> f64) -> Self {
        let first = S::from_fn(&mut value);
        Self(first, S::from_fn(|lane| value(S::LANES + lane)))
    }
    #[inline(always)]
    fn from_slice(values: &[f64]) -> Self {
        let (first, second) = values.split_at(S::LANES);
        Self(S::from_slice(first), S::from_slice(second))
    }
    #[inline(always)]
    fn write_to(self, values: &mut [f64]) {
        let (first, second) = values.split_at_mut(S::LANES);
        self.0.write_to(first);
        self.1.write_to(second);
    }
}
