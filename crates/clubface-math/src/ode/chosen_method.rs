//! A method that is chosen at run time.

use super::problem::{Attempt, Method, StiffSystem};
use super::rosenbrock::Rosenbrock;
use super::runge_kutta::DORMAND_PRINCE;
use crate::scalar::Scalar;

/// One of two methods: everything around their steps is compiled once for both.
#[derive(Clone, Copy, Debug)]
pub enum ChosenMethod {
    /// [`Rosenbrock`]: few steps through stiff systems.
    Rosenbrock,
    /// [`DORMAND_PRINCE`]: exact to a small tolerance.
    DormandPrince,
}

impl<P, S, const N: usize> Method<P, S, N> for ChosenMethod
where
    S: Scalar,
    P: StiffSystem<S, N>,
{
    #[inline(always)]
    fn error_order(&self) -> u32 {
        match self {
            Self::Rosenbrock => Method::<P, S, N>::error_order(&Rosenbrock),
            Self::DormandPrince => Method::<P, S, N>::error_order(&DORMAND_PRINCE),
        }
    }

    #[inline(always)]
    fn attempt_into(&self, problem: &P, y: &[S; N], rate: &[S; N], h: S, attempt: &mut Attempt<S, N>) {
        match self {
            Self::Rosenbrock => Rosenbrock.attempt_into(problem, y, rate, h, attempt),
            Self::DormandPrince => DORMAND_PRINCE.attempt_into(problem, y, rate, h, attempt),
        }
    }
}
