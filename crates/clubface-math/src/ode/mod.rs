//! Runge-Kutta and Rosenbrock steppers in which every lane has its own step.
//!
//! A pack of shots advances together, but each lane accepts, rejects and sizes its own steps and is frozen once it
//! has finished, so its result does not depend on its neighbours, bit for bit. Step sizes carry no derivatives.

mod rosenbrock;
mod runge_kutta;

pub use rosenbrock::Rosenbrock;
pub use runge_kutta::{RungeKutta, BOGACKI_SHAMPINE, DORMAND_PRINCE, RK4};

use crate::scalar::{Computation, Mask, Scalar};
use core::mem::MaybeUninit;

/// An autonomous system of ordinary differential equations.
pub trait System<S: Scalar, const N: usize> {
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
    const ERROR_ORDER: u32;
    /// Tries a step of `h` seconds from state `y` with time derivative `rate`, and writes all of `attempt`.
    fn attempt_into(&self, problem: &P, y: &[S; N], rate: &[S; N], h: S, attempt: &mut Attempt<S, N>);

    /// A step tried.
    #[inline(always)]
    fn attempt(&self, problem: &P, y: &[S; N], rate: &[S; N], h: S) -> Attempt<S, N> {
        let mut attempt = Attempt { y: *y, error: *y, rate: *rate };
        self.attempt_into(problem, y, rate, h, &mut attempt);
        attempt
    }
}

/// Sees every accepted step and says which lanes are done.
pub trait Observer<S: Scalar, const N: usize> {
    /// Called after a step; `accepted` are the lanes that took it. Returns the lanes that need no more.
    fn observe(
        &mut self,
        accepted: S::Mask,
        time: S,
        h: S,
        start: (&[S; N], &[S; N]),
        end: (&[S; N], &[S; N]),
    ) -> S::Mask;
}

/// How steps are sized.
#[derive(Clone, Copy, Debug)]
pub struct Control<S, const N: usize> {
    /// Tolerated error of a step, relative to `scale + |y|`.
    pub tolerance: f64,
    /// Natural size of each state component.
    pub scale: [S; N],
    /// First step, s.
    pub first: S,
    /// Longest step, s.
    pub longest: S,
    /// Steps, rejected ones included, after which lanes that have not finished are given up.
    pub max_steps: usize,
}

/// How an integration ended.
#[derive(Clone, Copy, Debug)]
pub struct Outcome<M> {
    /// Lanes that finished (the others ran out of steps or met a number that is not finite).
    pub finished: M,
    /// Steps taken by the pack, rejected ones included.
    pub steps: usize,
}

/// Integrates from `y` until the observer has finished every lane.
#[inline(always)]
pub fn integrate<P, M, O, S, const N: usize>(
    method: &M,
    problem: &P,
    mut y: [S; N],
    control: &Control<S, N>,
    observer: &mut O,
) -> Outcome<S::Mask>
where
    S: Scalar,
    P: System<S, N>,
    M: Method<P, S, N>,
    O: Observer<S, N>,
{
    let mut rate = rate_of(problem, &y);
    let mut time = S::zero();
    let mut h = control.first.primal();
    let mut finished = S::Mask::splat(false);
    let mut last = Last::none();
    let mut attempt = Attempt { y, error: y, rate };
    let mut steps = 0;
    while steps < control.max_steps {
        steps += 1;
        S::outline(Try { method, problem, y: &y, rate: &rate, h, attempt: &mut attempt });
        let (accepted, factor) = if M::ERROR_ORDER == 0 {
            (S::Mask::splat(true), S::one())
        } else {
            let error = error_norm(&attempt.error, &y, &attempt.y, control);
            // A NaN error compares false: the step is rejected and shortened until the lane is given up.
            let accepted = error.le(S::one());
            (accepted, last.step_factor(error, accepted, M::ERROR_ORDER))
        };
        let accepted = accepted.and(finished.not());
        if accepted.any() {
            let done = observer.observe(accepted, time, h, (&y, &rate), (&attempt.y, &attempt.rate));
            finished = finished.or(done.and(accepted));
            for i in 0..N {
                y[i] = S::select(accepted, attempt.y[i], y[i]);
                rate[i] = S::select(accepted, attempt.rate[i], rate[i]);
            }
            time = S::select(accepted, time + h, time);
        }
        if finished.all() {
            break;
        }
        h = (h * factor).min(control.longest.primal());
    }
    Outcome { finished, steps }
}

/// The time derivative, as a function of its own: every stage of every method calls the one copy.
#[inline(always)]
fn rate_of<P: System<S, N>, S: Scalar, const N: usize>(problem: &P, y: &[S; N]) -> [S; N] {
    S::outline(Rate { problem, y })
}

/// Room for a state that is written as a whole: an array that need not be filled first.
struct Room<S, const N: usize>([MaybeUninit<S>; N]);

impl<S: Copy, const N: usize> Room<S, N> {
    #[inline(always)]
    fn new() -> Self {
        Self([const { MaybeUninit::uninit() }; N])
    }
    #[inline(always)]
    fn write(&mut self, n: usize, value: S) {
        self.0[n].write(value);
    }
    /// What was written.
    ///
    /// # Safety
    /// All of it must have been written.
    #[inline(always)]
    unsafe fn read(&self) -> &[S; N] {
        // SAFETY: an array of written elements has the layout of the array of their values.
        unsafe { &*self.0.as_ptr().cast() }
    }
}

struct Rate<'a, P, S, const N: usize> {
    problem: &'a P,
    y: &'a [S; N],
}

impl<P: System<S, N>, S: Scalar, const N: usize> Computation for Rate<'_, P, S, N> {
    type Output = [S; N];
    #[inline(always)]
    fn run(self) -> [S; N] {
        self.problem.rhs(self.y)
    }
}

struct Try<'a, M, P, S, const N: usize> {
    method: &'a M,
    problem: &'a P,
    y: &'a [S; N],
    rate: &'a [S; N],
    h: S,
    attempt: &'a mut Attempt<S, N>,
}

impl<M: Method<P, S, N>, P, S: Scalar, const N: usize> Computation for Try<'_, M, P, S, N> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        self.method.attempt_into(self.problem, self.y, self.rate, self.h, self.attempt);
    }
}

/// Largest error over the components, in units of the tolerance.
#[inline(always)]
fn error_norm<S: Scalar, const N: usize>(
    error: &[S; N],
    before: &[S; N],
    after: &[S; N],
    control: &Control<S, N>,
) -> S {
    // The largest of the fractions error / size, found by products: a division takes as long as all the rest.
    let (mut largest, mut size, mut sum) = (S::zero(), S::one(), S::zero());
    for i in 0..N {
        let error = error[i].primal().abs();
        let here = control.scale[i].primal() + before[i].primal().abs().max(after[i].primal().abs());
        let larger = (largest * here).lt(error * size);
        largest = S::select(larger, error, largest);
        size = S::select(larger, here, size);
        sum += error;
    }
    // Comparisons do not see a NaN, the sum does.
    let error = largest / (size * control.tolerance);
    S::select(sum.le(S::from_f64(f64::MAX)), error, sum)
}

/// Share of the step that would meet the tolerance exactly.
const SAFETY: f64 = 0.9;
/// Bounds of the change from step to step.
const SHORTEN: f64 = 0.2;
const LENGTHEN: f64 = 5.0;

/// What the control of the steps remembers of the last one.
struct Last<S: Scalar> {
    accepted: S::Mask,
    /// Error of the last accepted step in units of the tolerance, to a power.
    error: S,
}

impl<S: Scalar> Last<S> {
    #[inline(always)]
    fn none() -> Self {
        Self { accepted: S::Mask::splat(true), error: S::one() }
    }

    /// Factor for the next step after one with this error, for an error estimate of order `order`.
    ///
    /// Error^(-1/k) for order k, and for low orders, whose steps are many and alike, proportional and integral control (K.
    /// Gustafsson, ACM TOMS 17, 1991, 533-554): about error^(-0.7/k) last^(0.4/k) after an accepted step, but no longer
    /// step right after a rejected one. Powers come from square roots alone (1/4, 1/8 and 3/8 for order 3, 3/16 for
    /// order 5), since a controller needs no exact exponent and lanes have no power.
    #[inline(always)]
    fn step_factor(&mut self, error: S, accepted: S::Mask, order: u32) -> S {
        let fourth = error.max(S::from_f64(1e-4)).sqrt().sqrt();
        let eighth = fourth.sqrt();
        if order > 3 {
            let factor = S::from_f64(SAFETY) / (eighth * eighth.sqrt());
            return factor.min(S::from_f64(LENGTHEN)).max(S::from_f64(SHORTEN));
        }
        let longest = S::select(self.accepted, S::from_f64(LENGTHEN), S::one());
        let smooth = (self.error * SAFETY / fourth).min(longest);
        let alone = S::from_f64(SAFETY) / (fourth * eighth);
        self.error = S::select(accepted, eighth, self.error);
        self.accepted = accepted;
        // `max` returns its argument for a NaN error, here and above: shorten.
        S::select(accepted, smooth, alone).max(S::from_f64(SHORTEN))
    }
}
