//! Everything that goes into one flight and comes out of it, as tables and as one generic function.

use super::air::{density, viscosity, DEFAULT_HUMIDITY, DEFAULT_PRESSURE, DEFAULT_TEMPERATURE};
use super::ground::{run, Ground};
use super::trajectory::{fly_to_ground, Air, Flight, Landing};
use crate::ball::Ball;
use clubface_math::{Scalar, Vec3};
use core::f64::consts::PI;

/// Allowed values of an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest allowed value.
    pub lower: f64,
    /// Largest allowed value.
    pub upper: f64,
}

/// One input of a flight.
#[derive(Clone, Copy, Debug)]
pub struct FlightInput {
    /// Name, as in the Python API.
    pub name: &'static str,
    /// "ball", "launch", "air" or "ground".
    pub group: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// What it is and where its default comes from.
    pub meaning: &'static str,
    /// What positive means; empty for a magnitude.
    pub sign: &'static str,
    /// Value taken where none is given; the launch has none (NaN).
    pub default: f64,
    /// Allowed values.
    pub bounds: Bounds,
}

/// One output of a flight.
#[derive(Clone, Copy, Debug)]
pub struct FlightOutput {
    /// Name, as in the Python API.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// What positive means; empty for a magnitude.
    pub sign: &'static str,
}

macro_rules! inputs {
    ($($group:literal $name:ident [$unit:literal] = $default:expr, $lower:literal ..= $upper:literal, $meaning:literal, $sign:literal;)+) => {
        [$(FlightInput {
            name: stringify!($name),
            group: $group,
            unit: $unit,
            meaning: $meaning,
            sign: $sign,
            default: $default,
            bounds: Bounds { lower: $lower, upper: $upper },
        }),+]
    };
}

macro_rules! outputs {
    ($($name:ident [$unit:literal], $meaning:literal, $sign:literal;)+) => {
        [$(FlightOutput { name: stringify!($name), unit: $unit, meaning: $meaning, sign: $sign }),+]
    };
}

const NONE: f64 = f64::NAN;

/// Number of inputs.
pub const INPUT_COUNT: usize = 20;

/// All inputs, in the order of the columns of a batch.
pub const INPUTS: [FlightInput; INPUT_COUNT] = inputs! {
    "ball" ball_mass ["kg"] = 0.0459, 0.001..=1.0, "mass of the ball", "";
    "ball" ball_radius ["m"] = 0.0213, 0.005..=0.1, "radius of the ball", "";
    "ball" ball_inertia ["kg m2"] = 8.336e-6, 1e-9..=1e-2, "moment of inertia of the ball about any diameter", "";
    "launch" velocity_x ["m/s"] = NONE, -150.0..=150.0, "launch velocity along the target line", "to the target";
    "launch" velocity_y ["m/s"] = NONE, -150.0..=150.0, "vertical launch velocity", "up";
    "launch" velocity_z ["m/s"] = NONE, -150.0..=150.0, "launch velocity across the target line", "right";
    "launch" spin_x ["rad/s"] = NONE, -3000.0..=3000.0, "angular velocity about the target line", "right-handed";
    "launch" spin_y ["rad/s"] = NONE, -3000.0..=3000.0, "angular velocity about the vertical: minus sidespin", "curves left";
    "launch" spin_z ["rad/s"] = NONE, -3000.0..=3000.0, "angular velocity about the horizontal to the right", "backspin of a ball flying to the target";
    "air" temperature ["K"] = DEFAULT_TEMPERATURE, 233.15..=333.15, "air temperature (default: that of normalised carries, 77 F)", "";
    "air" pressure ["Pa"] = DEFAULT_PRESSURE, 30e3..=120e3, "air pressure at the course (default: standard sea level)", "";
    "air" humidity ["1"] = DEFAULT_HUMIDITY, 0.0..=1.0, "relative humidity over liquid water, 0 to 1", "";
    "air" wind_x ["m/s"] = 0.0, -60.0..=60.0, "wind velocity along the target line, the same at all heights", "tailwind";
    "air" wind_y ["m/s"] = 0.0, -60.0..=60.0, "vertical wind velocity", "rising";
    "air" wind_z ["m/s"] = 0.0, -60.0..=60.0, "wind velocity across the target line", "blows to the right";
    "ground" restitution_factor ["1"] = 1.0, 0.01..=1.5, "factor on Penner's coefficient of restitution of ball and turf", "firmer";
    "ground" ground_tilt ["rad"] = 12.3 * PI / 180.0, 0.0..=1.0, "tilt of the effective plane of a bounce at 18.6 m/s, 44.4 deg (Penner, on greens: 15.4 deg)", "softer";
    "ground" ground_friction ["1"] = 0.40, 0.01..=2.0, "sliding friction of ball and turf (Penner: 0.40)", "";
    "ground" rolling_friction ["1"] = 0.131, 0.005..=2.0, "rolling friction rho_g of a fairway, assumed that of Penner's average green, on which a ball runs 6 ft off a Stimpmeter", "";
    "ground" grass_length ["m"] = 23.0, 1.0..=1e9, "way over which grass alone slows a rolling ball to 1/e of its speed", "";
};

/// Number of outputs.
pub const OUTPUT_COUNT: usize = 10;

/// All outputs, in the order of [`Flown::outputs`].
pub const OUTPUTS: [FlightOutput; OUTPUT_COUNT] = outputs! {
    carry ["m"], "straight level distance from the start to where the ball comes down to its height", "";
    side ["m"], "distance of the landing from the target line", "right";
    apex ["m"], "greatest height above the start", "up";
    landing_angle ["rad"], "angle of descent below the horizontal at landing", "down";
    flight_time ["s"], "time from launch to landing", "";
    landing_speed ["m/s"], "speed at landing, relative to the ground", "";
    landing_spin ["rad/s"], "magnitude of the angular velocity at landing", "";
    total ["m"], "straight distance from the start to rest, after bounces and roll", "";
    total_side ["m"], "distance of the place of rest from the target line", "right";
    outside_fit ["1"], "1 if the spin parameter left 0.02-1, the range of the aerodynamic fit, else 0", "";
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
            velocity: Vec3::of(v, 3),
            spin: Vec3::of(v, 6),
            air: Air {
                density: density(v[9], v[10], v[11]),
                viscosity: viscosity(v[9]),
                wind: Vec3::of(v, 12),
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
        ]
    }
}

/// Flies a shot and lets it run out, with a tolerated error per step.
#[inline(always)]
pub fn fly<S: Scalar>(shot: &FlightShot<S>, tolerance: f64) -> Flown<S> {
    let flight = Flight::new(&shot.ball, shot.spin, &shot.air);
    let landing = fly_to_ground(&flight, shot.velocity, tolerance, f64::INFINITY, |_, _| {});
    let rest = run(&shot.ball, &shot.ground, &flight, landing.position, landing.velocity, landing.spin);
    Flown { landing, rest }
}
