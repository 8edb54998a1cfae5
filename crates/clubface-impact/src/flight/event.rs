//! Where within a step of Dormand and Prince a component of the state vanishes, with exact derivatives.

use clubface_math::Scalar;
use clubface_math::ode::{DORMAND_PRINCE, Method, System};

/// A step of an integration.
#[derive(Clone, Copy, Debug)]
pub struct Step<S, const N: usize> {
    /// Time at its start, s.
    pub time: S,
    /// Its length, s.
    pub h: S,
    /// State and its time derivative at the start.
    pub start: ([S; N], [S; N]),
    /// State and its time derivative at the end.
    pub end: ([S; N], [S; N]),
}

impl<S: Scalar, const N: usize> Step<S, N> {
    /// A step that has not been taken.
    #[inline(always)]
    #[must_use]
    pub fn empty() -> Self {
        let none = [S::zero(); N];
        Self { time: S::zero(), h: S::zero(), start: (none, none), end: (none, none) }
    }

    /// Puts a new step in the lanes of the mask.
    #[inline(always)]
    pub fn replace(&mut self, mask: S::Mask, new: &Self) {
        self.time = S::select(mask, new.time, self.time);
        self.h = S::select(mask, new.h, self.h);
        for i in 0..N {
            self.start.0[i] = S::select(mask, new.start.0[i], self.start.0[i]);
            self.start.1[i] = S::select(mask, new.start.1[i], self.start.1[i]);
            self.end.0[i] = S::select(mask, new.end.0[i], self.end.0[i]);
            self.end.1[i] = S::select(mask, new.end.1[i], self.end.1[i]);
        }
    }

    /// Zero of component `i`, which falls through zero in this step, on the cubic that joins its ends.
    #[inline(always)]
    fn zero_of_cubic(&self, i: usize) -> S {
        let (a, b) = (self.start.0[i].primal(), self.end.0[i].primal());
        let h = self.h.primal();
        let (slope_a, slope_b) = (self.start.1[i].primal() * h, self.end.1[i].primal() * h);
        let quadratic = (b - a) * 3.0 - slope_a * 2.0 - slope_b;
        let cubic = (a - b) * 2.0 + slope_a + slope_b;
        // From the end of the step Newton comes down to the last zero, not to the launch.
        let mut x = S::one();
        for _ in 0..6 {
            let value = ((cubic * x + quadratic) * x + slope_a) * x + a;
            let slope = (cubic * x * 3.0 + quadratic * 2.0) * x + slope_a;
            x = (x - value / slope).min(S::one()).max(S::zero());
        }
        x * h
    }

    /// Time and state where component `i` vanishes, which falls through zero in this step.
    #[inline(always)]
    pub fn at_zero_of(&self, i: usize, system: &impl System<S, N>) -> (S, [S; N]) {
        let (y, rate) = &self.start;
        let mut h = self.zero_of_cubic(i);
        let mut time = self.time;
        let mut state = *y;
        // The cubic is good to a millisecond at worst, one correction to 1e-7 s and two to rounding; the last one
        // carries the derivatives.
        for _ in 0..2 {
            let trial = DORMAND_PRINCE.attempt(system, y, rate, h);
            let correction = -(trial.y[i] / trial.rate[i]);
            time = self.time + h + correction;
            for n in 0..N {
                state[n] = trial.y[n] + trial.rate[n] * correction;
            }
            h = (h + correction).primal();
        }
        (time, state)
    }
}
