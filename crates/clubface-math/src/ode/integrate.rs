//! Integration of all lanes, each with steps of its own.

use super::problem::{Attempt, Method, System};
use super::rate::rate_of;
use super::step_size::{Control, Last, error_norm};
use crate::scalar::{Mask, Scalar};

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
        method.attempt_into(problem, &y, &rate, h, &mut attempt);
        let (accepted, factor) = if method.error_order() == 0 {
            (S::Mask::splat(true), S::one())
        } else {
            let error = error_norm(&attempt.error, &y, &attempt.y, control);
            let accepted = error.le(S::one());
            (accepted, last.step_factor(error, accepted, method.error_order()))
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
