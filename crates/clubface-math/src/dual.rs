//! Dual numbers: a value with `N` derivatives, over any scalar.
//!
//! `Dual<f64, N>` carries N derivatives of one shot; over a pack, either N derivatives of several shots, or (all
//! lanes holding the same shot) N times the lanes derivatives of one.

use crate::scalar::{Computation, Scalar};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A value and its derivatives in `N` directions.
#[derive(Clone, Copy, Debug)]
pub struct Dual<S, const N: usize> {
    /// Value.
    pub value: S,
    /// Derivatives.
    pub tangent: [S; N],
}

impl<S: Scalar, const N: usize> Dual<S, N> {
    /// A number with zero derivatives.
    #[inline(always)]
    pub fn constant(value: S) -> Self {
        Self { value, tangent: [S::zero(); N] }
    }
    /// The variable of direction `index`: derivative one there, zero elsewhere.
    #[inline(always)]
    pub fn variable(value: S, index: usize) -> Self {
        let mut dual = Self::constant(value);
        dual.tangent[index] = S::one();
        dual
    }
    /// The same number with more directions, in which its derivatives are zero.
    #[inline(always)]
    pub fn widen<const M: usize>(self) -> Dual<S, M> {
        let mut wide = Dual::constant(self.value);
        wide.tangent[..N].copy_from_slice(&self.tangent);
        wide
    }
    /// Product with a number that does not depend on the variables.
    #[inline(always)]
    #[must_use]
    pub fn scale(self, factor: S) -> Self {
        self.chain(self.value * factor, factor)
    }
    /// `f(self)`, given f and its slope at the value.
    #[inline(always)]
    fn chain(self, value: S, slope: S) -> Self {
        let mut tangent = self.tangent;
        for i in 0..N {
            tangent[i] = tangent[i] * slope;
        }
        Self { value, tangent }
    }
    /// `f(self, other)`, given f and its partial slopes.
    #[inline(always)]
    fn chain2(self, other: Self, value: S, by_self: S, by_other: S) -> Self {
        let mut tangent = self.tangent;
        for i in 0..N {
            tangent[i] = tangent[i] * by_self + other.tangent[i] * by_other;
        }
        Self { value, tangent }
    }
}

impl<S: Scalar, const N: usize> Add for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let mut tangent = self.tangent;
        for i in 0..N {
            tangent[i] += other.tangent[i];
        }
        Self { value: self.value + other.value, tangent }
    }
}
impl<S: Scalar, const N: usize> Sub for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let mut tangent = self.tangent;
        for i in 0..N {
            tangent[i] -= other.tangent[i];
        }
        Self { value: self.value - other.value, tangent }
    }
}
impl<S: Scalar, const N: usize> Mul for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.chain2(other, self.value * other.value, other.value, self.value)
    }
}
impl<S: Scalar, const N: usize> Div for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let inverse = other.value.recip();
        self.chain2(other, quotient, inverse, -(quotient * inverse))
    }
}
impl<S: Scalar, const N: usize> Neg for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let mut tangent = self.tangent;
        for i in 0..N {
            tangent[i] = -tangent[i];
        }
        Self { value: -self.value, tangent }
    }
}
impl<S: Scalar, const N: usize> Add<f64> for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, tangent: self.tangent }
    }
}
impl<S: Scalar, const N: usize> Sub<f64> for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        Self { value: self.value - other, tangent: self.tangent }
    }
}
impl<S: Scalar, const N: usize> Mul<f64> for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        self.scale(S::from_f64(other))
    }
}
impl<S: Scalar, const N: usize> Div<f64> for Dual<S, N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        let mut tangent = self.tangent;
        for i in 0..N {
            tangent[i] = tangent[i] / other;
        }
        Self { value: self.value / other, tangent }
    }
}
impl<S: Scalar, const N: usize> AddAssign for Dual<S, N> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<S: Scalar, const N: usize> SubAssign for Dual<S, N> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<S: Scalar, const N: usize> Scalar for Dual<S, N> {
    type Mask = S::Mask;
    const LANES: usize = S::LANES;
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::constant(S::from_f64(value))
    }
    #[inline(always)]
    fn lane(self, index: usize) -> f64 {
        self.value.lane(index)
    }
    #[inline(always)]
    fn primal(self) -> Self {
        Self::constant(self.value.primal())
    }
    #[inline(always)]
    fn outline<C: Computation>(computation: C) -> C::Output {
        S::outline(computation)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> S::Mask {
        self.value.lt(other.value)
    }
    #[inline(always)]
    fn le(self, other: Self) -> S::Mask {
        self.value.le(other.value)
    }
    #[inline(always)]
    fn select(mask: S::Mask, a: Self, b: Self) -> Self {
        let mut tangent = a.tangent;
        for i in 0..N {
            tangent[i] = S::select(mask, a.tangent[i], b.tangent[i]);
        }
        Self { value: S::select(mask, a.value, b.value), tangent }
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        let mut tangent = term.tangent;
        for i in 0..N {
            tangent[i] =
                self.tangent[i].mul_add(factor.value, factor.tangent[i].mul_add(self.value, tangent[i]));
        }
        Self { value: self.value.mul_add(factor.value, term.value), tangent }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, (root * 2.0).recip())
    }
    #[inline(always)]
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        self.chain(self.value.ln(), self.value.recip())
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let square = x.value.squared() + self.value.squared();
        let inverse = S::select(square.gt(S::zero()), square.recip(), S::zero());
        self.chain2(x, self.value.atan2(x.value), x.value * inverse, -(self.value * inverse))
    }
}
