//! Systems of ordinary differential equations, and methods that step through them.

use crate::scalar::Scalar;

/// An autonomous system of ordinary differential equations.
pub trait System<S: Scalar, const N: usize> {
    /// How many components, the first ones, the time derivative does not depend on, such as places in air that is the
    /// same everywhere.
    const PASSIVE: usize = 0;
    /// Time derivative of the state, per second.
    fn rhs(&self, y: &[S; N]) -> [S; N];
}

/// A system whose stiff part is known: an approximation `A` of its Jacobian that is cheap to invert.
pub trait StiffSystem<S: Scalar, const N: usize>: System<S, N> {
    /// `A` at one state.
    type Jacobian;
    /// What solving with `I - g A` needs.
    type Solver;
    /// `A` at state `y`.
    fn linearize(&self, y: &[S; N]) -> Self::Jacobian;
    /// Prepares to solve with `I - g A`, `g` in seconds.
    fn factor(&self, jacobian: &Self::Jacobian, g: S) -> Self::Solver;
    /// `(I - g A)^-1 b`.
    fn solve(&self, solver: &Self::Solver, b: &[S; N]) -> [S; N];
}

/// One attempted step.
#[derive(Clone, Copy, Debug)]
pub struct Attempt<S, const N: usize> {
    /// State at its end.
    pub y: [S; N],
    /// Estimated error of that state.
    pub error: [S; N],
    /// Time derivative at its end.
    pub rate: [S; N],
}

/// A one-step method for problem `P`.
pub trait Method<P, S: Scalar, const N: usize> {
    /// Order of the error estimate, which sizes the steps; 0 for fixed steps.
    fn error_order(&self) -> u32;
    /// Tries a step of `h` seconds from state `y` with time derivative `rate`, and writes all of `attempt`: a function of
    /// its own, however many places call it.
    fn attempt_into(&self, problem: &P, y: &[S; N], rate: &[S; N], h: S, attempt: &mut Attempt<S, N>);

    /// A step tried.
    #[inline(always)]
    fn attempt(&self, problem: &P, y: &[S; N], rate: &[S; N], h: S) -> Attempt<S, N> {
        let mut attempt = Attempt { y: *y, error: *y, rate: *rate };
        self.attempt_into(problem, y, rate, h, &mut attempt);
        attempt
    }
}
