//! Everything that goes into one flight and comes out of it, as tables and as one generic function.

use super::air::{DEFAULT_HUMIDITY, DEFAULT_PRESSURE, DEFAULT_TEMPERATURE, density, viscosity};
use super::ground::{Ground, run};
use super::shot_shape::curve;
use super::trajectory::{Air, Flight, Landing, fly_to_ground};
use crate::ball::Ball;
use crate::description::Bounds;
use crate::quantity::{Quantity, known, quantities};
use clubface_math::{Scalar, Vec3};
use core::f64::consts::PI;

/// One input of a flight.
#[derive(Clone, Copy, Debug)]
pub struct FlightInput {
    /// Its name, unit, meaning and sign.
    pub quantity: &'static Quantity,
    /// "ball", "launch", "air" or "ground".
    pub group: &'static str,
    /// Value taken where none is given; the launch has none (NaN).
    pub default: f64,
    /// Allowed values.
    pub bounds: Bounds,
    /// Values that golf has, as far as a slider reaches.
    pub usual: Option<Bounds>,
}

macro_rules! inputs {
    ($($group:literal {
        $($name:ident = $default:expr, $lower:literal ..= $upper:literal $(, $least:literal ..= $most:literal)?;)+
    })+) => {
        [$($(FlightInput {
            quantity: known(stringify!($name)),
            group: $group,
            default: $default,
            bounds: Bounds::new($lower, $upper),
            usual: inputs!(@usual $($least $most)?),
        }),+),+]
    };
    (@usual) => { None };
    (@usual $least:literal $most:literal) => { Some(Bounds::new($least, $most)) };
}

const NONE: f64 = f64::NAN;

/// Number of inputs.
pub const INPUT_COUNT: usize = 20;

/// All inputs, in the order of the columns of a batch: default, allowed values, and those that golf has.
pub static INPUTS: [FlightInput; INPUT_COUNT] = inputs! {
    "ball" {
        ball_mass = 0.0459, 0.001..=1.0;
        ball_radius = 0.0213, 0.005..=0.1;
        ball_inertia = 8.336e-6, 1e-9..=1e-2;
    }
    "launch" {
        velocity_x = NONE, -150.0..=150.0;
        velocity_y = NONE, -150.0..=150.0;
        velocity_z = NONE, -150.0..=150.0;
        spin_x = NONE, -3000.0..=3000.0;
        spin_y = NONE, -3000.0..=3000.0;
        spin_z = NONE, -3000.0..=3000.0;
    }
    "air" {
        temperature = DEFAULT_TEMPERATURE, 233.15..=333.15, 263.15..=318.15;
        pressure = DEFAULT_PRESSURE, 30e3..=120e3, 65e3..=106e3;
        humidity = DEFAULT_HUMIDITY, 0.0..=1.0, 0.0..=1.0;
        wind_x = 0.0, -60.0..=60.0, -18.0..=18.0;
        wind_y = 0.0, -60.0..=60.0, -3.0..=3.0;
        wind_z = 0.0, -60.0..=60.0, -18.0..=18.0;
    }
    "ground" {
        restitution_factor = 1.0, 0.01..=1.5, 0.5..=1.5;
        ground_tilt = 12.3 * PI / 180.0, 0.0..=1.0, 0.1..=0.4;
        ground_friction = 0.40, 0.01..=2.0, 0.2..=0.6;
        rolling_friction = 0.131, 0.005..=2.0, 0.06..=0.4;
        grass_length = 23.0, 1.0..=1e9, 5.0..=100.0;
    }
};

/// Number of outputs.
pub const OUTPUT_COUNT: usize = 11;

/// All outputs, in the order of [`Flown::outputs`].
pub const OUTPUTS: [&Quantity; OUTPUT_COUNT] = quantities! {
    carry side apex landing_angle flight_time landing_speed landing_spin total total_side outside_fit curve
};

/// Default of every input; the launch, which has none, is NaN.
#[must_use]
pub fn default_inputs() -> [f64; INPUT_COUNT] {
    INPUTS.map(|input| input.default)
}

/// A ball, its launch, the air and the ground.
#[derive(Clone, Copy, Debug)]
pub struct FlightShot<S> {
    /// The ball.
    pub ball: Ball<S>,
    /// Launch velocity, m/s.
    pub velocity: Vec3<S>,
    /// Launch angular velocity, rad/s.
    pub spin: Vec3<S>,
    /// The air.
    pub air: Air<S>,
    /// The ground.
    pub ground: Ground<S>,
}

impl<S: Scalar> FlightShot<S> {
    /// From values in the order of [`INPUTS`].
    #[inline(always)]
    pub fn from_inputs(v: &[S; INPUT_COUNT]) -> Self {
        Self {
            ball: Ball { mass: v[0], radius: v[1], inertia: v[2] },
            velocity: Vec3::from_slice(v, 3),
            spin: Vec3::from_slice(v, 6),
            air: Air {
                density: density(v[9], v[10], v[11]),
                viscosity: viscosity(v[9]),
                wind: Vec3::from_slice(v, 12),
            },
            ground: Ground {
                restitution_factor: v[15],
                tilt: v[16],
                friction: v[17],
                rolling_friction: v[18],
                grass_length: v[19],
            },
        }
    }
}

/// What became of a shot.
#[derive(Clone, Copy, Debug)]
pub struct Flown<S: Scalar> {
    /// Launch velocity, m/s.
    pub velocity: Vec3<S>,
    /// Landing.
    pub landing: Landing<S>,
    /// Place of rest, m.
    pub rest: Vec3<S>,
}

impl<S: Scalar> Flown<S> {
    /// Values in the order of [`OUTPUTS`].
    #[inline(always)]
    pub fn outputs(&self) -> [S; OUTPUT_COUNT] {
        let level = |v: Vec3<S>| Vec3::new(v.x, S::zero(), v.z).norm();
        let Landing { time, position, velocity, spin, apex, outside_fit, .. } = self.landing;
        [
            level(position),
            position.z,
            apex,
            (-velocity.y).atan2(level(velocity)),
            time,
            velocity.norm(),
            spin.norm(),
            level(self.rest),
            self.rest.z,
            S::select(outside_fit, S::one(), S::zero()),
            curve(self.velocity, position),
        ]
    }
}

/// Flies a shot and lets it run out, with a tolerated error per step.
#[inline(always)]
pub fn fly<S: Scalar>(shot: &FlightShot<S>, tolerance: f64) -> Flown<S> {
    let flight = Flight::new(&shot.ball, shot.spin, &shot.air);
    let landing = fly_to_ground(&flight, shot.velocity, tolerance, f64::INFINITY, |_, _| {});
    let rest = run(&shot.ball, &shot.ground, &flight, landing.position, landing.velocity, landing.spin);
    Flown { velocity: shot.velocity, landing, rest }
}
