//! Dual numbers: a value with `N` derivatives, over any scalar.
//!
//! `Dual<f64, N>` carries N derivatives of one shot; over a pack, either N derivatives of several shots, or (all
//! lanes holding the same shot) N times the lanes derivatives of one.

use crate::scalar::{Computation, Scalar, operators};
use core::ops::Neg;

/// A value and its derivatives in `N` directions: `N + 1` of the same, one after the other.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
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

operators! { [S: Scalar, const N: usize] Dual<S, N>;
    Add add Self => Self, |a, b| {
        let mut tangent = a.tangent;
        for i in 0..N {
            tangent[i] += b.tangent[i];
        }
        Self { value: a.value + b.value, tangent }
    };
    Sub sub Self => Self, |a, b| {
        let mut tangent = a.tangent;
        for i in 0..N {
            tangent[i] -= b.tangent[i];
        }
        Self { value: a.value - b.value, tangent }
    };
    Mul mul Self => Self, |a, b| a.chain2(b, a.value * b.value, b.value, a.value);
    Div div Self => Self, |a, b| {
        let (quotient, inverse) = (a.value / b.value, b.value.recip());
        a.chain2(b, quotient, inverse, -(quotient * inverse))
    };
    Add add f64 => Self, |a, b| Self { value: a.value + b, tangent: a.tangent };
    Sub sub f64 => Self, |a, b| Self { value: a.value - b, tangent: a.tangent };
    Mul mul f64 => Self, |a, b| a.scale(S::from_f64(b));
    Div div f64 => Self, |a, b| {
        let mut tangent = a.tangent;
        for i in 0..N {
            tangent[i] = tangent[i] / b;
        }
        Self { value: a.value / b, tangent }
    };
    &mut AddAssign add_assign +;
    &mut SubAssign sub_assign -;
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
    fn vanishes(self) -> bool {
        self.value.vanishes() && self.tangent.iter().all(|tangent| tangent.vanishes())
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
    fn mul_add_f64(self, factor: f64, term: Self) -> Self {
        let mut tangent = term.tangent;
        for i in 0..N {
            tangent[i] = self.tangent[i].mul_add_f64(factor, tangent[i]);
        }
        Self { value: self.value.mul_add_f64(factor, term.value), tangent }
    }
    #[inline(always)]
    fn product(self, factor: Self) -> Self {
        let mut tangent = self.tangent;
        for i in 0..N {
            tangent[i] = tangent[i].mul_add(factor.value, factor.tangent[i] * self.value);
        }
        Self { value: self.value * factor.value, tangent }
    }
    #[inline(always)]
    fn recip(self) -> Self {
        let inverse = self.value.recip();
        self.chain(inverse, -(inverse * inverse))
    }
    #[inline(always)]
    fn inverse_cube_root(self) -> Self {
        let root = self.value.inverse_cube_root();
        let square = root * root;
        self.chain(root, square * square * (-1.0 / 3.0))
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
