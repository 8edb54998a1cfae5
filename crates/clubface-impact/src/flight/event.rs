//! Where a ball is highest and where it lands within a step of Dormand and Prince, with exact derivatives.

use clubface_math::ode::{DORMAND_PRINCE, Method, System};
use clubface_math::{Computation, Scalar};

/// Numbers of the state of a flight: position, velocity, part of the launch spin left.
pub const STATES: usize = 7;
/// Place of the height in the state.
pub const HEIGHT: usize = 1;
/// Place of the vertical velocity in the state.
pub const CLIMB: usize = 4;

/// What happens once in a flight.
#[derive(Clone, Copy, Debug)]
pub enum Event {
    /// The climb falls through zero.
    Apex,
    /// The height falls through zero.
    Landing,
}

/// A step of an integration.
#[derive(Clone, Copy, Debug)]
pub struct Step<S> {
    /// Time at its start, s.
    pub time: S,
    /// Its length, s.
    pub h: S,
    /// State and its time derivative at the start.
    pub start: ([S; STATES], [S; STATES]),
    /// State and its time derivative at the end.
    pub end: ([S; STATES], [S; STATES]),
}

impl<S: Scalar> Step<S> {
    /// A step that has not been taken.
    #[inline(always)]
    #[must_use]
    pub fn empty() -> Self {
        let none = [S::zero(); STATES];
        Self { time: S::zero(), h: S::zero(), start: (none, none), end: (none, none) }
    }

    /// Puts a new step in the lanes of the mask.
    #[inline(always)]
    pub fn replace(&mut self, mask: S::Mask, new: &Self) {
        self.time = S::select(mask, new.time, self.time);
        self.h = S::select(mask, new.h, self.h);
        for i in 0..STATES {
            self.start.0[i] = S::select(mask, new.start.0[i], self.start.0[i]);
            self.start.1[i] = S::select(mask, new.start.1[i], self.start.1[i]);
            self.end.0[i] = S::select(mask, new.end.0[i], self.end.0[i]);
            self.end.1[i] = S::select(mask, new.end.1[i], self.end.1[i]);
        }
    }

    /// Where the polynomial of degree 5 vanishes that has the height, climb and vertical acceleration of both ends, or its
    /// derivative for the climb, s after the start. Either falls through zero in this step.
    #[inline(always)]
    fn zero_of_polynomial(&self, event: Event) -> S {
        let h = self.h.primal();
        let of_end = |(y, rate): &([S; STATES], [S; STATES])| {
            let [climb, acceleration] = [rate[HEIGHT], rate[CLIMB]].map(Scalar::primal);
            (y[HEIGHT].primal(), climb * h, acceleration * h.squared())
        };
        let ((a, slope, bend), (b, slope_b, bend_b)) = (of_end(&self.start), of_end(&self.end));
        let rise = b - a - slope - bend * 0.5;
        let steepening = slope_b - slope - bend;
        let bending = bend_b - bend;
        let mut coefficients = [
            a,
            slope,
            bend * 0.5,
            rise * 10.0 - steepening * 4.0 + bending * 0.5,
            steepening * 7.0 - rise * 15.0 - bending,
            rise * 6.0 - steepening * 3.0 + bending * 0.5,
        ];
        if matches!(event, Event::Apex) {
            let [_, one, two, three, four, five] = coefficients;
            coefficients = [one, two * 2.0, three * 3.0, four * 4.0, five * 5.0, S::zero()];
        }
        // From the end of the step Newton comes down to the last zero, not to the launch.
        let mut x = S::one();
        for _ in 0..6 {
            let (mut value, mut slope) = (S::zero(), S::zero());
            for coefficient in coefficients.into_iter().rev() {
                slope = slope * x + value;
                value = value * x + coefficient;
            }
            x = (x - value / slope).min(S::one()).max(S::zero());
        }
        x * h
    }

    /// Time and state at an event of this step.
    #[inline(always)]
    pub fn at(&self, event: Event, flight: &impl System<S, STATES>) -> (S, [S; STATES]) {
        S::outline(At { step: self, event, flight })
    }
}

struct At<'a, S, P> {
    step: &'a Step<S>,
    event: Event,
    flight: &'a P,
}

impl<S: Scalar, P: System<S, STATES>> Computation for At<'_, S, P> {
    type Output = (S, [S; STATES]);
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { step, event, flight } = self;
        let (y, rate) = &step.start;
        let h = step.zero_of_polynomial(event);
        // The polynomial is good to some 1e-7 s. One correction in full arithmetic is good to rounding and carries the
        // derivatives.
        let trial = DORMAND_PRINCE.attempt(flight, y, rate, h);
        let component = match event {
            Event::Apex => CLIMB,
            Event::Landing => HEIGHT,
        };
        let correction = -(trial.y[component] / trial.rate[component]);
        let state = core::array::from_fn(|n| trial.y[n] + trial.rate[n] * correction);
        (step.time + h + correction, state)
    }
}
