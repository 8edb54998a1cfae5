//! The size of a step from the error of the last.

use crate::scalar::{Mask, Scalar};

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

/// Largest error over the components, in units of the tolerance.
#[inline(always)]
pub(super) fn error_norm<S: Scalar, const N: usize>(
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
    // Comparisons do not see a NaN, the sum does: a step that leaves the finite numbers was much too long.
    let error = largest / (size * control.tolerance);
    let most = S::from_f64(f64::MAX);
    S::select(sum.le(most), error, most)
}

/// Share of the step that would meet the tolerance exactly.
const SAFETY: f64 = 0.9;
/// Bounds of the change from step to step.
const SHORTEN: f64 = 0.2;
const LENGTHEN: f64 = 5.0;

/// What the control of the steps needs of the last one.
pub(super) struct Last<S: Scalar> {
    accepted: S::Mask,
    /// Error of the last accepted step in units of the tolerance, to a power.
    error: S,
}

impl<S: Scalar> Last<S> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        Self { accepted: S::Mask::splat(true), error: S::one() }
    }

    /// Factor for the next step after one with this error, for an error estimate of order `order`.
    ///
    /// Error^(-1/k) for order k, and for low orders, whose steps are many and alike, proportional and integral control
    /// (K. Gustafsson, ACM TOMS 17, 1991, 533-554): about error^(-0.7/k) last^(0.4/k) after an accepted step, but no
    /// longer step right after a rejected one. Powers come from square roots alone (1/4, 1/8 and 3/8 for order 3, 3/16
    /// for order 5), since a controller needs no exact exponent and lanes have no power.
    #[inline(always)]
    pub(super) fn step_factor(&mut self, error: S, accepted: S::Mask, order: u32) -> S {
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
        S::select(accepted, smooth, alone).max(S::from_f64(SHORTEN))
    }
}
