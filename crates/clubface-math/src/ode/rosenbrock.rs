//! A Rosenbrock-W method: linearly implicit, and of full order whatever matrix stands for the Jacobian, so that only
//! the stiff part of a system need be linearised.

// Coefficients are quoted with all their published digits.
#![allow(clippy::excessive_precision)]

use super::{rate_of, Attempt, Method, StiffSystem};
use crate::scalar::Scalar;

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

impl<P, S, const N: usize> Method<P, S, N> for Rosenbrock
where
    S: Scalar,
    P: StiffSystem<S, N>,
{
    const ERROR_ORDER: u32 = 3;

    #[inline(always)]
    fn attempt(&self, problem: &P, y: &[S; N], rate: &[S; N], h: S) -> Attempt<S, N> {
        let jacobian = problem.linearize(y);
        let solver = problem.factor(&jacobian, h * GAMMA);
        let mut stages = [[S::zero(); N]; 4];
        let mut slope = *rate;
        let mut end = *y;
        let mut coupling = [S::zero(); N];
        let mut right = [S::zero(); N];
        for i in 0..5 {
            if i > 0 {
                for n in 0..N {
                    let mut sum = y[n];
                    for j in 0..i {
                        sum += stages[j][n] * ALPHA[i][j];
                    }
                    end[n] = sum;
                }
                slope = rate_of(problem, &end);
            }
            if i == 4 {
                break;
            }
            // (I - g A) k = h f + h A w with g = gamma h: solve for k + w / gamma, so that A itself is not needed.
            for n in 0..N {
                let mut sum = S::zero();
                for j in 0..i {
                    sum += stages[j][n] * (COUPLING[i][j] / GAMMA);
                }
                coupling[n] = sum;
                right[n] = sum + slope[n] * h;
            }
            let solution = problem.solve(&solver, &right);
            for n in 0..N {
                stages[i][n] = solution[n] - coupling[n];
            }
        }
        let mut error = [S::zero(); N];
        for n in 0..N {
            for j in 0..4 {
                error[n] += stages[j][n] * (ALPHA[4][j] - EMBEDDED[j]);
            }
        }
        Attempt { y: end, error, rate: slope }
    }
}
