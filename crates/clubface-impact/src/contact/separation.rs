//! Watches a contact for its peak force and its end.

use super::dynamics::Contact;
use super::law::ContactLaw;
use super::recorder::Recorder;
use super::state::{BALL_SPIN, CLUB_SPIN, ContactPoint, VELOCITY};
use clubface_math::ode::Observer;
use clubface_math::{Computation, Mask, Scalar, Vec3};

/// Observer of one contact.
pub struct Separation<'a, S, L, R, const N: usize> {
    contact: &'a Contact<S, L>,
    /// Sees every step.
    pub recorder: &'a mut R,
    /// Largest normal force so far, N.
    pub peak_force: S,
    /// Time of separation, s.
    pub time: S,
    /// State at the end of the step in which the bodies separated, with the velocities of the moment of separation.
    pub last: [S; N],
    /// Normal force at the start of the step, N.
    force: S,
}

/// A step is flat if its smaller end force is at least this part of the larger.
const FLAT: f64 = 0.7;

impl<'a, S: Scalar, L: ContactLaw<S>, R: Recorder<S>, const N: usize> Separation<'a, S, L, R, N> {
    /// Watches a contact that starts in state `y`.
    #[inline(always)]
    pub fn new(contact: &'a Contact<S, L>, recorder: &'a mut R, y: [S; N]) -> Self {
        Self { contact, recorder, peak_force: S::zero(), time: S::zero(), last: y, force: S::zero() }
    }

    #[inline(always)]
    fn force_at(&self, y: &[S; N]) -> (ContactPoint<S>, S) {
        S::outline(ForceAt { contact: self.contact, y })
    }
}

struct ForceAt<'a, S, L> {
    contact: &'a Contact<S, L>,
    y: &'a [S],
}

impl<S: Scalar, L: ContactLaw<S>> Computation for ForceAt<'_, S, L> {
    type Output = (ContactPoint<S>, S);
    #[inline(always)]
    fn run(self) -> (ContactPoint<S>, S) {
        let t = self.contact.touching(self.y);
        (t, self.contact.normal_force(&t))
    }
}

impl<S: Scalar, L: ContactLaw<S>, R: Recorder<S>, const N: usize> Observer<S, N>
    for Separation<'_, S, L, R, N>
{
    #[inline(always)]
    fn observe(
        &mut self,
        accepted: S::Mask,
        time: S,
        h: S,
        (y0, f0): (&[S; N], &[S; N]),
        (y1, f1): (&[S; N], &[S; N]),
    ) -> S::Mask {
        let (end, end_force) = self.force_at(y1);
        // The top of the force history is rounded: within a step that hardly changes the force, look for it between.
        let larger = self.force.max(end_force);
        let flat = accepted.and((self.force.min(end_force)).gt(larger * FLAT));
        let mut peak = larger;
        if flat.any() {
            let mut middle = *y0;
            for i in 0..N {
                middle[i] = (y0[i] + y1[i]) * 0.5 + (f0[i] - f1[i]) * (h * 0.125);
            }
            let (_, middle_force) = self.force_at(&middle);
            peak = S::select(flat, parabola_peak(self.force, middle_force, end_force), larger);
        }
        self.peak_force = S::select(accepted, self.peak_force.max(peak), self.peak_force);
        self.force = S::select(accepted, end_force, self.force);
        let separated = accepted.and(end.depth.le(S::zero()));
        if separated.any() {
            let (start, _) = self.force_at(y0);
            let fraction = hermite_root(start.depth, start.rate * h, end.depth, end.rate * h);
            self.time = S::select(separated, time + h * fraction, self.time);
            for i in 0..N {
                self.last[i] = S::select(separated, y1[i], self.last[i]);
            }
            // Beyond separation the ball flies on unchanged, but the clubhead turns on about its own axes, and a law
            // whose friction does not vanish with the normal force still pulls: both are taken back.
            let beyond = h * (-fraction + 1.0);
            let free = self.contact.motion(y1, &end, S::zero(), Vec3::zero());
            for i in 0..3 {
                let (v, b, c) = (VELOCITY + i, BALL_SPIN + i, CLUB_SPIN + i);
                for (n, excess) in [(v, f1[v] - free[v]), (b, f1[b] - free[b]), (c, f1[c])] {
                    self.last[n] = S::select(separated, y1[n] - excess * beyond, self.last[n]);
                }
            }
        }
        if R::ACTIVE {
            self.recorder.record(self.contact, time + h, y1);
        }
        separated
    }
}

/// Largest value of the parabola through three equally spaced values within their interval.
#[inline(always)]
pub(crate) fn parabola_peak<S: Scalar>(start: S, middle: S, end: S) -> S {
    let bend = (start + end - middle * 2.0) * 2.0;
    let slope = middle * 4.0 - start * 3.0 - end;
    let ends = start.max(end);
    let inside = bend.lt(S::zero()).and(slope.gt(S::zero())).and(slope.lt(bend * -2.0));
    let bend = S::select(inside, bend, S::one());
    S::select(inside, start - slope.squared() / (bend * 4.0), ends)
}

/// Fraction of a step at which the cubic through depth (positive, then not) and its rates (per step) vanishes.
#[inline(always)]
pub(crate) fn hermite_root<S: Scalar>(d0: S, r0: S, d1: S, r1: S) -> S {
    let c2 = (d1 - d0) * 3.0 - r0 * 2.0 - r1;
    let c3 = (d0 - d1) * 2.0 + r0 + r1;
    let mut x = d0 / (d0 - d1);
    // Newton from the secant: separation is nearly uniform motion, so this converges at once; the last rounds also
    // carry the derivatives.
    for _ in 0..4 {
        let value = ((c3 * x + c2) * x + r0) * x + d0;
        let slope = (c3 * x * 3.0 + c2 * 2.0) * x + r0;
        x = (x - value / slope).max(S::zero()).min(S::one());
    }
    x
}
