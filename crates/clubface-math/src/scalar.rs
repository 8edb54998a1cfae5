//! The number type physics is generic over.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Result of a comparison: one truth value a lane.
pub trait Mask: Copy + Debug {
    /// Number of truth values.
    const LANES: usize;
    /// True if any lane is true.
    fn any(self) -> bool;
    /// True if every lane is true.
    fn all(self) -> bool;
    /// Lane-wise and.
    #[must_use]
    fn and(self, other: Self) -> Self;
    /// Lane-wise or.
    #[must_use]
    fn or(self, other: Self) -> Self;
    /// Lane-wise not.
    #[must_use]
    fn not(self) -> Self;
    /// The same truth value in every lane.
    fn splat(value: bool) -> Self;
    /// Truth value of one lane.
    fn lane(self, index: usize) -> bool;
}

impl Mask for bool {
    const LANES: usize = 1;
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self & other
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self | other
    }
    #[inline(always)]
    fn not(self) -> Self {
        !self
    }
    #[inline(always)]
    fn splat(value: bool) -> Self {
        value
    }
    #[inline(always)]
    fn lane(self, _index: usize) -> bool {
        self
    }
}

/// A computation for [`Scalar::outline`]: a closure whose inlining can be demanded.
pub trait Computation {
    /// What it returns.
    type Output;
    /// Runs it; implement with `#[inline(always)]`, since CPU features reach only what is inlined.
    fn run(self) -> Self::Output;
}

/// A real number, a pack of real numbers, or either with derivatives.
///
/// The rounding of every operation is that of IEEE `f64` in every lane (no fused multiply-add), and the elementary
/// functions are one algorithm for all types, so a pack gives bit for bit what its lanes would give alone.
pub trait Scalar:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + Send
    + 'static
{
    /// Comparison result.
    type Mask: Mask;
    /// Number of independent values.
    const LANES: usize;

    /// A constant, equal in every lane, without derivatives.
    fn from_f64(value: f64) -> Self;
    /// Value of one lane, without derivatives.
    fn lane(self, index: usize) -> f64;
    /// The same value without derivatives.
    #[must_use]
    fn primal(self) -> Self;
    /// Lane-wise `self < other`, by value.
    fn lt(self, other: Self) -> Self::Mask;
    /// Lane-wise `self <= other`, by value.
    fn le(self, other: Self) -> Self::Mask;
    /// `a` where the mask is true, else `b`; both have been computed.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Exponential; the argument is clamped to +-700.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm.
    #[must_use]
    fn ln(self) -> Self;
    /// `self^(-1/3)` for a number between 0.3 and 2.5.
    #[must_use]
    fn inverse_cube_root(self) -> Self;
    /// Sine and cosine of an angle in radians (accurate for |x| below 1e5).
    fn sin_cos(self) -> (Self, Self);
    /// Angle of the point (x, self) in (-pi, pi], 0 for the origin.
    #[must_use]
    fn atan2(self, x: Self) -> Self;

    /// Runs a computation as a function of its own, compiled with the CPU features of this type: keeps large kernels
    /// from being copied into every caller.
    fn outline<C: Computation>(computation: C) -> C::Output;

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::from_f64(0.0)
    }
    /// One.
    #[inline(always)]
    fn one() -> Self {
        Self::from_f64(1.0)
    }
    /// Value of the first lane, without derivatives: for branches that all lanes take alike.
    #[inline(always)]
    fn re(self) -> f64 {
        self.lane(0)
    }
    /// Whether it is zero in every lane and does not depend on any variable.
    #[inline(always)]
    fn vanishes(self) -> bool {
        self.le(Self::zero()).and(self.ge(Self::zero())).all()
    }
    /// Lane-wise `self > other`, by value.
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// Lane-wise `self >= other`, by value.
    #[inline(always)]
    fn ge(self, other: Self) -> Self::Mask {
        other.le(self)
    }
    /// Larger of two numbers (`other` where either is NaN).
    #[inline(always)]
    #[must_use]
    fn max(self, other: Self) -> Self {
        Self::select(self.gt(other), self, other)
    }
    /// Smaller of two numbers (`other` where either is NaN).
    #[inline(always)]
    #[must_use]
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    /// Absolute value.
    #[inline(always)]
    #[must_use]
    fn abs(self) -> Self {
        Self::select(self.lt(Self::zero()), -self, self)
    }
    /// `self * factor + term`, fused where the CPU can: bits may differ between packs of different widths.
    #[inline(always)]
    #[must_use]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
    /// The same with a factor that depends on no variable.
    #[inline(always)]
    #[must_use]
    fn mul_add_f64(self, factor: f64, term: Self) -> Self {
        self.mul_add(Self::from_f64(factor), term)
    }
    /// `self * factor`, its derivatives fused where the CPU can: their bits may differ between packs of different
    /// widths.
    #[inline(always)]
    #[must_use]
    fn product(self, factor: Self) -> Self {
        self * factor
    }
    /// Square.
    #[inline(always)]
    #[must_use]
    fn squared(self) -> Self {
        self * self
    }
    /// Reciprocal.
    #[inline(always)]
    #[must_use]
    fn recip(self) -> Self {
        Self::one() / self
    }
    /// `self^power` for `self > 0`.
    #[inline(always)]
    #[must_use]
    fn powf(self, power: f64) -> Self {
        (self.ln() * power).exp()
    }
    /// Square root whose derivative at zero is zero: for lengths that may vanish.
    #[inline(always)]
    #[must_use]
    fn safe_sqrt(self) -> Self {
        let zero = Self::zero();
        Self::select(self.gt(zero), self.sqrt(), zero)
    }
    /// `self^1.5` for `self > 0`, else zero with zero derivative.
    #[inline(always)]
    #[must_use]
    fn pow_three_halves(self) -> Self {
        let zero = Self::zero();
        Self::select(self.gt(zero), self * self.sqrt(), zero)
    }
}

/// Operators of a type, each always inlined: `Trait method Right => Result, |left, right| value;`, or of those that
/// change their left side `&mut Trait method operator;`.
macro_rules! operators {
    (@one [$($generics:tt)*] $type:ty, $trait:ident $method:ident $right:ty, $result:ty, $a:ident $b:ident $value:expr) => {
        impl<$($generics)*> core::ops::$trait<$right> for $type {
            type Output = $result;
            #[inline(always)]
            fn $method(self, $b: $right) -> $result {
                let $a = self;
                $value
            }
        }
    };
    (@assigning [$($generics:tt)*] $type:ty, $trait:ident $method:ident $operator:tt) => {
        impl<$($generics)*> core::ops::$trait for $type {
            #[inline(always)]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    };
    ($generics:tt $type:ty; $(
        $trait:ident $method:ident $right:ty => $result:ty, |$a:ident, $b:ident| $value:expr;
    )* $(&mut $assigning:ident $assign:ident $operator:tt;)*) => {
        $($crate::scalar::operators! { @one $generics $type, $trait $method $right, $result, $a $b $value })*
        $($crate::scalar::operators! { @assigning $generics $type, $assigning $assign $operator })*
    };
}
pub(crate) use operators;
