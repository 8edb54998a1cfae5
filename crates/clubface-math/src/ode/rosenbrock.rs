//! A Rosenbrock-W method: linearly implicit, and of full order whatever matrix stands for the Jacobian, so that only
//! the stiff part of a system need be linearised.

// Coefficients are quoted with all their published digits.
#![allow(clippy::excessive_precision)]

use super::problem::{Attempt, Method, StiffSystem};
use super::rate::{Room, rate_of};
use crate::scalar::{Computation, Scalar};

/// ROS34PW2: order 3(2), four stages, stiffly accurate, a W-method (J. Rang and L. Angermann, BIT 45, 2005, 761-787).
#[derive(Clone, Copy, Debug)]
pub struct Rosenbrock;

const GAMMA: f64 = 4.358_665_215_084_590_0e-1;
/// Weights of the earlier stages in the argument of each stage; the last row gives the new state.
const ALPHA: [[f64; 4]; 5] = [
    [0.0; 4],
    [8.717_330_430_169_180_1e-1, 0.0, 0.0, 0.0],
    [8.445_706_001_536_942_3e-1, -1.129_906_423_648_418_5e-1, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [2.421_238_070_609_534_6e-1, -1.223_250_583_904_514_7, 1.545_260_255_335_102, 4.358_665_215_084_590_0e-1],
];
/// Weights of the earlier stages in the term with the Jacobian.
const COUPLING: [[f64; 4]; 4] = [
    [0.0; 4],
    [-8.717_330_430_169_180_1e-1, 0.0, 0.0, 0.0],
    [-9.033_805_701_304_408_2e-1, 5.418_067_238_809_532_6e-2, 0.0, 0.0],
    [2.421_238_070_609_534_6e-1, -1.223_250_583_904_514_7, 5.452_602_553_351_021_4e-1, 0.0],
];
const EMBEDDED: [f64; 4] =
    [3.781_090_314_581_936_9e-1, -9.604_229_221_242_317_8e-2, 0.5, 2.179_332_607_542_295_0e-1];

/// Weights of the solution minus those of the embedded one.
const ERROR: [f64; 4] = [
    ALPHA[4][0] - EMBEDDED[0],
    ALPHA[4][1] - EMBEDDED[1],
    ALPHA[4][2] - EMBEDDED[2],
    ALPHA[4][3] - EMBEDDED[3],
];

/// Component `n` of a weighted sum of stages.
#[inline(always)]
fn weighted<S: Scalar, const N: usize, const J: usize>(
    n: usize,
    stages: [&[S; N]; J],
    weights: [f64; J],
) -> S {
    let mut sum = stages[0][n] * weights[0];
    for j in 1..J {
        sum += stages[j][n] * weights[j];
    }
    sum
}

/// The time derivative at state `y` plus a weighted sum of stages.
#[inline(always)]
fn rate_at<P, S, const N: usize, const J: usize>(
    problem: &P,
    y: &[S; N],
    stages: [&[S; N]; J],
    weights: [f64; J],
) -> [S; N]
where
    S: Scalar,
    P: StiffSystem<S, N>,
{
    let mut argument = Room::new();
    for n in 0..N {
        argument.write(n, y[n] + weighted(n, stages, weights));
    }
    // SAFETY: all components were written.
    rate_of(problem, unsafe { argument.read() })
}

/// The next stage, from the time derivative at its argument and the stages before it.
///
/// (I - g A) k = h f + h A w with g = gamma h: solve for k + w / gamma, so that A itself is not needed.
#[inline(always)]
fn stage<P, S, const N: usize, const J: usize>(
    problem: &P,
    solver: &P::Solver,
    slope: &[S; N],
    stages: [&[S; N]; J],
    coupling: [f64; J],
    h: S,
) -> [S; N]
where
    S: Scalar,
    P: StiffSystem<S, N>,
{
    let (mut right, mut coupled) = (Room::<S, N>::new(), Room::<S, N>::new());
    for n in 0..N {
        if J == 0 {
            right.write(n, slope[n] * h);
        } else {
            let sum = weighted(n, stages, coupling) * (1.0 / GAMMA);
            coupled.write(n, sum);
            right.write(n, sum + slope[n] * h);
        }
    }
    // SAFETY: all components were written.
    let mut stage = S::outline(Solve { problem, solver, right: unsafe { right.read() } });
    if J > 0 {
        // SAFETY: as above.
        let coupled = unsafe { coupled.read() };
        for n in 0..N {
            stage[n] -= coupled[n];
        }
    }
    stage
}

/// The linear equations of a stage, as a function of its own for all four.
struct Solve<'a, P: StiffSystem<S, N>, S: Scalar, const N: usize> {
    problem: &'a P,
    solver: &'a P::Solver,
    right: &'a [S; N],
}

impl<P: StiffSystem<S, N>, S: Scalar, const N: usize> Computation for Solve<'_, P, S, N> {
    type Output = [S; N];
    #[inline(always)]
    fn run(self) -> [S; N] {
        self.problem.solve(self.solver, self.right)
    }
}

impl<P, S, const N: usize> Method<P, S, N> for Rosenbrock
where
    S: Scalar,
    P: StiffSystem<S, N>,
{
    #[inline(always)]
    fn error_order(&self) -> u32 {
        3
    }

    #[inline(always)]
    fn attempt_into(&self, problem: &P, y: &[S; N], rate: &[S; N], h: S, attempt: &mut Attempt<S, N>) {
        S::outline(Try { problem, y, rate, h, attempt });
    }
}

struct Try<'a, P, S, const N: usize> {
    problem: &'a P,
    y: &'a [S; N],
    rate: &'a [S; N],
    h: S,
    attempt: &'a mut Attempt<S, N>,
}

impl<P, S, const N: usize> Computation for Try<'_, P, S, N>
where
    S: Scalar,
    P: StiffSystem<S, N>,
{
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { problem, y, rate, h, attempt } = self;
        let jacobian = problem.linearize(y);
        let solver = problem.factor(&jacobian, h * GAMMA);
        // Written out stage by stage, so that the zeros of the tables cost nothing.
        let first = stage(problem, &solver, rate, [], [], h);
        let slope = rate_at(problem, y, [&first], [ALPHA[1][0]]);
        let second = stage(problem, &solver, &slope, [&first], [COUPLING[1][0]], h);
        let slope = rate_at(problem, y, [&first, &second], [ALPHA[2][0], ALPHA[2][1]]);
        let third = stage(problem, &solver, &slope, [&first, &second], [COUPLING[2][0], COUPLING[2][1]], h);
        let slope = rate_at(problem, y, [&third], [ALPHA[3][2]]);
        let stages = [&first, &second, &third];
        let fourth =
            stage(problem, &solver, &slope, stages, [COUPLING[3][0], COUPLING[3][1], COUPLING[3][2]], h);
        let stages = [&first, &second, &third, &fourth];
        for n in 0..N {
            attempt.y[n] = y[n] + weighted(n, stages, ALPHA[4]);
            attempt.error[n] = weighted(n, stages, ERROR);
        }
        attempt.rate = rate_of(problem, &attempt.y);
    }
}
