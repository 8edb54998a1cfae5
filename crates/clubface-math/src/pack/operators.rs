//! Operators that every pack has alike.

/// Operators, elementary functions and selection of a primal type, from its few basic operations.
macro_rules! primal_operators {
    ($type:ty) => {
        impl Add<f64> for $type {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: f64) -> Self {
                self + Self::from_f64(other)
            }
        }
        impl Sub<f64> for $type {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: f64) -> Self {
                self - Self::from_f64(other)
            }
        }
        impl Mul<f64> for $type {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: f64) -> Self {
                self * Self::from_f64(other)
            }
        }
        impl Div<f64> for $type {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: f64) -> Self {
                self / Self::from_f64(other)
            }
        }
        impl AddAssign for $type {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }
        impl SubAssign for $type {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
    };
}

pub(super) use primal_operators;
