//! Explicit Runge-Kutta methods: one stepper, each method a table of numbers.

use super::problem::{Attempt, Method, System};
use super::rate::{Room, rate_into};
use crate::scalar::{Computation, Scalar};

/// An explicit Runge-Kutta method of `STAGES` stages whose last stage is the derivative at the end of the step.
#[derive(Clone, Copy, Debug)]
pub struct RungeKutta<const STAGES: usize, const ERROR_ORDER: u32> {
    /// Row i weighs the earlier stages for the argument of stage i; the last row gives the new state.
    weights: [[f64; STAGES]; STAGES],
    /// Weights of the solution minus those of the embedded one.
    error: [f64; STAGES],
}

/// Dormand and Prince 5(4) (J. Comput. Appl. Math. 6, 1980, 19-26), local extrapolation.
pub const DORMAND_PRINCE: RungeKutta<7, 5> = RungeKutta {
    weights: [
        [0.0; 7],
        [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0, 0.0],
        [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0, 0.0],
        [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0, 0.0],
        [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0],
    ],
    error: [
        35.0 / 384.0 - 5179.0 / 57600.0,
        0.0,
        500.0 / 1113.0 - 7571.0 / 16695.0,
        125.0 / 192.0 - 393.0 / 640.0,
        -2187.0 / 6784.0 + 92097.0 / 339_200.0,
        11.0 / 84.0 - 187.0 / 2100.0,
        -1.0 / 40.0,
    ],
};

/// Bogacki and Shampine 3(2) (Appl. Math. Lett. 2, 1989, 321-325).
pub const BOGACKI_SHAMPINE: RungeKutta<4, 3> = RungeKutta {
    weights: [[0.0; 4], [0.5, 0.0, 0.0, 0.0], [0.0, 0.75, 0.0, 0.0], [2.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0, 0.0]],
    error: [2.0 / 9.0 - 7.0 / 24.0, 1.0 / 3.0 - 0.25, 4.0 / 9.0 - 1.0 / 3.0, -0.125],
};

/// The classical method of order 4, at fixed steps.
pub const RK4: RungeKutta<5, 0> = RungeKutta {
    weights: [
        [0.0; 5],
        [0.5, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.5, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0, 0.0],
        [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 0.0],
    ],
    error: [0.0; 5],
};

impl<P, S, const N: usize, const STAGES: usize, const ORDER: u32> Method<P, S, N>
    for RungeKutta<STAGES, ORDER>
where
    S: Scalar,
    P: System<S, N>,
{
    #[inline(always)]
    fn error_order(&self) -> u32 {
        ORDER
    }

    #[inline(always)]
    fn attempt_into(&self, problem: &P, y: &[S; N], rate: &[S; N], h: S, attempt: &mut Attempt<S, N>) {
        S::outline(Try { method: self, problem, y, rate, h, attempt });
    }
}

struct Try<'a, P, S, const N: usize, const STAGES: usize, const ORDER: u32> {
    method: &'a RungeKutta<STAGES, ORDER>,
    problem: &'a P,
    y: &'a [S; N],
    rate: &'a [S; N],
    h: S,
    attempt: &'a mut Attempt<S, N>,
}

impl<P, S, const N: usize, const STAGES: usize, const ORDER: u32> Computation
    for Try<'_, P, S, N, STAGES, ORDER>
where
    S: Scalar,
    P: System<S, N>,
{
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { method, problem, y, rate, h, attempt } = self;
        let mut stages = [const { Room::<S, N>::new() }; STAGES];
        for n in 0..N {
            stages[0].write(n, rate[n]);
        }
        attempt.y = *y;
        for i in 1..STAGES {
            let mut weights = [h; STAGES];
            for j in 0..i {
                weights[j] = h * method.weights[i][j];
            }
            // SAFETY: all stages before this one were written.
            unsafe {
                if i + 1 < STAGES {
                    add_stages(P::PASSIVE, y, &stages[..i], &weights, &mut attempt.y);
                } else {
                    add_stages(0, y, &stages[..i], &weights, &mut attempt.y);
                }
            }
            rate_into(problem, &attempt.y, &mut stages[i]);
        }
        let mut weights = [h; STAGES];
        for j in 0..STAGES {
            weights[j] = h * method.error[j];
        }
        // SAFETY: all stages were written.
        unsafe {
            add_stages(0, &[S::zero(); N], &stages, &weights, &mut attempt.error);
            attempt.rate = *stages[STAGES - 1].read();
        }
    }
}

/// Writes `start` and the weighted stages, from a component on; the others stay as they are.
///
/// # Safety
/// The stages must have been written.
#[inline(always)]
unsafe fn add_stages<S: Scalar, const N: usize>(
    first: usize,
    start: &[S; N],
    stages: &[Room<S, N>],
    weights: &[S],
    result: &mut [S; N],
) {
    for n in first..N {
        let mut sum = start[n];
        for j in 0..stages.len() {
            // SAFETY: the caller's promise.
            sum += unsafe { stages[j].read() }[n] * weights[j];
        }
        result[n] = sum;
    }
}
