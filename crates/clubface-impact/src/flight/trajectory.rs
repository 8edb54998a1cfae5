//! From launch to the ground: position, velocity and spin under gravity and air.
//!
//! The torque of the air opposes the spin, so the spin keeps its axis and one number, the part of it that is left,
//! joins position and velocity in the state. Dormand and Prince's steps are sized by error for every ball on its
//! own; the last is shortened by Newton's method until it ends on the ground. The final Newton correction is made in
//! full arithmetic, so derivatives go through the landing event exactly.

use super::aerodynamics::{air_load, drag_coefficient, held_spin_parameter, outside_fit};
use super::event::{CLIMB, Event, HEIGHT, STATES, Step};
use crate::ball::Ball;
use clubface_math::ode::{Control, DORMAND_PRINCE, Observer, System, integrate};
use clubface_math::{Mask, Scalar, Vec3};
use core::f64::consts::PI;

/// Standard acceleration of gravity, m/s2 (ISO 80000-3).
pub const GRAVITY: f64 = 9.806_65;
/// Tolerated error of a step, relative to 1 m, 1 m/s or the launch spin plus the value itself. The carry
/// of a drive is then within 0.1 mm of the limit of small steps, and that of any shot within 1 mm.
pub const TOLERANCE: f64 = 1e-6;
/// Longest step, s.
const LONGEST_STEP: f64 = 2.0;
/// Steps after which a ball that has not come down is given up (strong rising air).
const MAX_STEPS: usize = 1000;

const SPIN: usize = 6;

/// Air that moves as one.
#[derive(Clone, Copy, Debug)]
pub struct Air<S> {
    /// Density, kg/m3.
    pub density: S,
    /// Dynamic viscosity, Pa s.
    pub viscosity: S,
    /// Wind velocity, m/s, the same at all heights.
    pub wind: Vec3<S>,
}

/// A ball in flight.
#[derive(Clone, Copy, Debug)]
pub struct Flight<S> {
    radius: S,
    wind: Vec3<S>,
    launch_spin: Vec3<S>,
    launch_spin_speed: S,
    /// 2 r rho / mu, s/m.
    reynolds_per_speed: S,
    /// 0.5 rho A / m, 1/m.
    per_mass: S,
    /// 0.5 rho A / I, 1/m3: the decay of the air is in m3/s.
    per_inertia: S,
}

impl<S: Scalar> Flight<S> {
    /// A ball launched with `spin` [rad/s] into `air`.
    #[inline(always)]
    pub fn new(ball: &Ball<S>, spin: Vec3<S>, air: &Air<S>) -> Self {
        let half_density_area = air.density * ball.radius.squared() * (0.5 * PI);
        Self {
            radius: ball.radius,
            wind: air.wind,
            launch_spin: spin,
            launch_spin_speed: spin.norm(),
            reynolds_per_speed: air.density * ball.radius * 2.0 / air.viscosity,
            per_mass: half_density_area / ball.mass,
            per_inertia: half_density_area / ball.inertia,
        }
    }

    /// Deceleration by drag in still air over the square of the speed, 1/m; `spin` and `speed` are magnitudes.
    #[inline(always)]
    pub fn drag(&self, spin: S, speed: S) -> S {
        let held = held_spin_parameter(self.radius, spin, speed);
        drag_coefficient(held, self.reynolds_per_speed * speed) * self.per_mass
    }

    /// Whether the spin parameter of a state lies outside the range of the fit.
    #[inline(always)]
    fn outside_fit(&self, y: &[S; STATES]) -> S::Mask {
        let square_speed = (Vec3::from_slice(y, 3) - self.wind).norm_squared();
        outside_fit(self.radius, self.launch_spin_speed * y[SPIN], square_speed)
    }
}

impl<S: Scalar> System<S, STATES> for Flight<S> {
    /// The place: the air is the same at all heights.
    const PASSIVE: usize = 3;

    #[inline(always)]
    fn rhs(&self, y: &[S; STATES]) -> [S; STATES] {
        let velocity = Vec3::from_slice(y, 3);
        let left = y[SPIN];
        let load = air_load(
            self.radius,
            self.reynolds_per_speed,
            velocity - self.wind,
            self.launch_spin * left,
            self.launch_spin_speed * left,
        );
        let acceleration = load.force * self.per_mass;
        [
            velocity.x,
            velocity.y,
            velocity.z,
            acceleration.x,
            acceleration.y - GRAVITY,
            acceleration.z,
            -(load.decay * self.per_inertia * left),
        ]
    }
}

/// Where and how the ball comes down.
#[derive(Clone, Copy, Debug)]
pub struct Landing<S: Scalar> {
    /// Time since launch, s.
    pub time: S,
    /// Place, m; its height is zero.
    pub position: Vec3<S>,
    /// Velocity, m/s.
    pub velocity: Vec3<S>,
    /// Angular velocity, rad/s.
    pub spin: Vec3<S>,
    /// Greatest height, m.
    pub apex: S,
    /// Balls whose spin parameter left the range of the aerodynamic fit.
    pub outside_fit: S::Mask,
    /// Balls that came down; the others are still up after all steps.
    pub landed: S::Mask,
}

/// Keeps the steps of the apex and of the landing.
struct ToGround<'a, S: Scalar, F> {
    flight: &'a Flight<S>,
    grounded: S::Mask,
    apex: Step<S>,
    landing: Step<S>,
    outside_fit: S::Mask,
    on_step: F,
}

impl<S, F> Observer<S, STATES> for ToGround<'_, S, F>
where
    S: Scalar,
    F: FnMut(S, &[S; STATES]),
{
    #[inline(always)]
    fn observe(
        &mut self,
        accepted: S::Mask,
        time: S,
        h: S,
        start: (&[S; STATES], &[S; STATES]),
        end: (&[S; STATES], &[S; STATES]),
    ) -> S::Mask {
        let zero = S::zero();
        let step = || Step { time, h, start: (*start.0, *start.1), end: (*end.0, *end.1) };
        let landing = accepted.and(end.0[HEIGHT].le(zero));
        let apex = accepted.and(start.0[CLIMB].gt(zero)).and(end.0[CLIMB].le(zero));
        if apex.any() {
            // With more than one apex the highest counts.
            let higher = start.0[HEIGHT].ge(self.apex.start.0[HEIGHT]);
            self.apex.replace(apex.and(higher), &step());
        }
        if landing.any() {
            self.landing.replace(landing, &step());
        }
        let done = landing.or(self.grounded);
        let flying = accepted.and(done.not());
        self.outside_fit = self.outside_fit.or(flying.and(self.flight.outside_fit(end.0)));
        if flying.any() {
            (self.on_step)(time + h, end.0);
        }
        done
    }
}

/// Flies a ball from the origin to the ground, with steps of at most `longest` (s); `on_step` sees the time and state
/// after every step in the air.
#[inline(always)]
pub fn fly_to_ground<S: Scalar>(
    flight: &Flight<S>,
    velocity: Vec3<S>,
    tolerance: f64,
    longest: f64,
    on_step: impl FnMut(S, &[S; STATES]),
) -> Landing<S> {
    let (zero, one) = (S::zero(), S::one());
    let launch = [zero, zero, zero, velocity.x, velocity.y, velocity.z, one];
    // A ball struck downwards, or level without lift enough, is on the ground at once.
    let climb = flight.rhs(&launch)[CLIMB];
    let level = velocity.y.le(zero).and(velocity.y.lt(zero).not());
    let grounded = velocity.y.lt(zero).or(level.and(climb.le(zero)));
    let max_steps = if longest < LONGEST_STEP { MAX_STEPS * 100 } else { MAX_STEPS };
    let longest = S::from_f64(longest.min(LONGEST_STEP));
    let control = Control {
        tolerance,
        scale: [one; STATES],
        // A small part of the flight in a vacuum, 2 v_y / g.
        first: (velocity.y * (0.1 / GRAVITY)).max(S::from_f64(1e-3)).min(longest),
        longest,
        max_steps,
    };
    let mut observer = ToGround {
        flight,
        grounded,
        apex: Step::empty(),
        landing: Step::empty(),
        outside_fit: grounded.not().and(flight.outside_fit(&launch)),
        on_step,
    };
    let outcome = integrate(&DORMAND_PRINCE, flight, launch, &control, &mut observer);
    let (_, top) = observer.apex.at(Event::Apex, flight);
    let (time, touch) = observer.landing.at(Event::Landing, flight);
    let landed_outside = grounded.not().and(flight.outside_fit(&touch));
    let state = |i: usize| S::select(grounded, launch[i], touch[i]);
    Landing {
        time: S::select(grounded, zero, time),
        position: Vec3::new(state(0), zero, state(2)),
        velocity: Vec3::new(state(3), state(CLIMB), state(5)),
        spin: flight.launch_spin * state(SPIN),
        apex: S::select(grounded, zero, top[HEIGHT]),
        outside_fit: observer.outside_fit.or(landed_outside),
        landed: outcome.finished,
    }
}
