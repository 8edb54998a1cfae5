//! What every pack of plain numbers has alike.

/// Operators, from those between two packs.
macro_rules! primal_operators {
    ($generics:tt $type:ty) => {
        $crate::scalar::operators! { $generics $type;
            Add add f64 => Self, |a, b| a + Self::from_f64(b);
            Sub sub f64 => Self, |a, b| a - Self::from_f64(b);
            Mul mul f64 => Self, |a, b| a * Self::from_f64(b);
            Div div f64 => Self, |a, b| a / Self::from_f64(b);
            &mut AddAssign add_assign +;
            &mut SubAssign sub_assign -;
        }
    };
}

/// Functions of [`Scalar`](crate::Scalar), each one algorithm for all of them.
macro_rules! primal_functions {
    () => {
        #[inline(always)]
        fn primal(self) -> Self {
            self
        }
        #[inline(always)]
        fn exp(self) -> Self {
            $crate::elementary::exp(self)
        }
        #[inline(always)]
        fn inverse_cube_root(self) -> Self {
            $crate::elementary::inverse_cube_root(self)
        }
        #[inline(always)]
        fn sin_cos(self) -> (Self, Self) {
            $crate::elementary::sin_cos(self)
        }
        #[inline(always)]
        fn atan2(self, x: Self) -> Self {
            $crate::elementary::atan2(self, x)
        }
    };
}

pub(super) use {primal_functions, primal_operators};
