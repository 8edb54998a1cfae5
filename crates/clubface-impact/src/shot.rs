//! Everything that goes into one impact: club, ball and delivery, and the table of these inputs.

use crate::ball::Ball;
use crate::club::Club;
use crate::delivery::Delivery;
use crate::description::Bounds;
use crate::face_spring::CHARACTERISTIC_TIMES;
use crate::head_inertia::SPATIAL_COUNT;
use crate::quantity::{Quantity, known};
use clubface_math::Scalar;
use core::f64::consts::{FRAC_PI_2, PI};

/// One scalar input of an impact.
#[derive(Clone, Copy, Debug)]
pub struct Input {
    /// Its name, unit, meaning and sign.
    pub quantity: &'static Quantity,
    /// "delivery", "club", "ball", "parameters" or "attachment".
    pub group: &'static str,
    /// Whether launch is differentiable with respect to it.
    pub differentiable: bool,
    /// Allowed values. Club and ball must fit together besides: [`check`](crate::check::check) says what does not.
    pub bounds: Bounds,
    /// The input whose half bounds the size of this one, too.
    pub half_of: Option<&'static str>,
    /// Values that golf has, as far as a slider reaches.
    pub usual: Option<Bounds>,
}

impl Input {
    const fn new(name: &str, group: &'static str, bounds: Bounds) -> Self {
        Self { quantity: known(name), group, differentiable: true, bounds, half_of: None, usual: None }
    }

    const fn usual(self, lower: f64, upper: f64) -> Self {
        Self { usual: Some(Bounds::new(lower, upper)), ..self }
    }

    const fn half_of(self, name: &'static str) -> Self {
        Self { half_of: Some(name), ..self }
    }

    const fn constant(self) -> Self {
        Self { differentiable: false, ..self }
    }
}

/// Number of inputs that describe the delivery: the first ones.
pub const DELIVERY_COUNT: usize = 14;

/// Number of inputs of a shot with a free head: the first ones. The others are what shaft and hands add.
pub const FREE_COUNT: usize = 35;

/// Number of inputs.
pub const INPUT_COUNT: usize = FREE_COUNT + SPATIAL_COUNT;

/// Largest loft, rad: beyond it the face no longer drives the ball forwards.
pub const LARGEST_LOFT: f64 = 80.0 * PI / 180.0;
/// Highest speed of a clubhead, m/s.
pub const HIGHEST_SPEED: f64 = 150.0;
/// Largest angular velocity of a clubhead about any axis, rad/s.
pub const LARGEST_RATE: f64 = 1000.0;
/// Largest angular velocity of a ball before impact about any axis, rad/s.
pub const LARGEST_SPIN: f64 = 2000.0;
/// Largest size of any input, in SI units: far from all clubs, balls and swings, and safe from overflow.
pub const LARGEST: f64 = 1e12;
/// Least size of an input that must be above zero.
pub const SMALLEST: f64 = 1.0 / LARGEST;

const MPH: f64 = 44_704.0 / 1e5;
const DEG: f64 = PI / 180.0;
const RPM: f64 = PI / 30.0;
const POSITIVE: Bounds = Bounds::new(SMALLEST, LARGEST);
/// A radius of curvature: infinite where the face is flat.
const RADIUS: Bounds = Bounds::new(SMALLEST, f64::INFINITY);
const ANY: Bounds = Bounds::within(LARGEST);
const ANGLES: Bounds = Bounds::within(FRAC_PI_2);
const LOFTS: Bounds = Bounds::within(LARGEST_LOFT);
const RATES: Bounds = Bounds::within(LARGEST_RATE);
const SPINS: Bounds = Bounds::within(LARGEST_SPIN);
/// A face that gives, or a rigid one.
const TIMES: Bounds = Bounds::new(0.0, CHARACTERISTIC_TIMES[1]);

const fn delivery(name: &str, bounds: Bounds) -> Input {
    Input::new(name, "delivery", bounds)
}

const fn club(name: &str, bounds: Bounds) -> Input {
    Input::new(name, "club", bounds)
}

const fn ball(name: &str) -> Input {
    Input::new(name, "ball", POSITIVE)
}

/// An element of what shaft and hands add to the inertia of the head.
const fn attached(name: &str) -> Input {
    Input::new(name, "attachment", ANY)
}

/// All inputs, in the order of the columns of a batch.
pub static INPUTS: [Input; INPUT_COUNT] = [
    delivery("speed", Bounds::new(SMALLEST, HIGHEST_SPEED)).usual(20.0 * MPH, 140.0 * MPH),
    delivery("attack", ANGLES).usual(-15.0 * DEG, 15.0 * DEG),
    delivery("path", ANGLES).usual(-15.0 * DEG, 15.0 * DEG),
    delivery("loft", LOFTS).usual(-5.0 * DEG, 75.0 * DEG),
    delivery("face", ANGLES).usual(-15.0 * DEG, 15.0 * DEG),
    delivery("lie", ANGLES).usual(-15.0 * DEG, 15.0 * DEG),
    delivery("toe", ANY).half_of("face_width").usual(-0.040, 0.040),
    delivery("high", ANY).half_of("face_height").usual(-0.025, 0.025),
    delivery("closure", RATES).usual(-1000.0 * DEG, 5000.0 * DEG),
    delivery("pitch_rate", RATES).usual(-2000.0 * DEG, 2000.0 * DEG),
    delivery("lie_rate", RATES).usual(-2000.0 * DEG, 2000.0 * DEG),
    delivery("ball_backspin", SPINS).usual(-3000.0 * RPM, 3000.0 * RPM),
    delivery("ball_sidespin", SPINS).usual(-3000.0 * RPM, 3000.0 * RPM),
    delivery("ball_riflespin", SPINS).usual(-3000.0 * RPM, 3000.0 * RPM),
    club("club_mass", POSITIVE),
    club("cg_x", ANY),
    club("cg_y", ANY),
    club("cg_z", ANY),
    club("ixx", ANY),
    club("iyy", ANY),
    club("izz", ANY),
    club("ixy", ANY),
    club("ixz", ANY),
    club("iyz", ANY),
    club("static_loft", LOFTS),
    club("bulge", RADIUS),
    club("roll", RADIUS),
    club("face_width", POSITIVE).constant(),
    club("face_height", POSITIVE).constant(),
    club("characteristic_time", TIMES),
    club("hand", Bounds::within(1.0)).constant(),
    ball("ball_mass"),
    ball("ball_radius"),
    ball("ball_inertia"),
    Input::new("included_time", "parameters", TIMES).constant(),
    attached("added_mass_xx"),
    attached("added_mass_yy"),
    attached("added_mass_zz"),
    attached("added_mass_xy"),
    attached("added_mass_xz"),
    attached("added_mass_yz"),
    attached("added_coupling_xx"),
    attached("added_coupling_xy"),
    attached("added_coupling_xz"),
    attached("added_coupling_yx"),
    attached("added_coupling_yy"),
    attached("added_coupling_yz"),
    attached("added_coupling_zx"),
    attached("added_coupling_zy"),
    attached("added_coupling_zz"),
    attached("added_inertia_xx"),
    attached("added_inertia_yy"),
    attached("added_inertia_zz"),
    attached("added_inertia_xy"),
    attached("added_inertia_xz"),
    attached("added_inertia_yz"),
];

/// The inputs of a shot with a free head, given without those of what shaft and hands add.
#[must_use]
pub const fn with_free_head(given: &[f64; FREE_COUNT]) -> [f64; INPUT_COUNT] {
    let mut inputs = [0.0; INPUT_COUNT];
    let mut i = 0;
    while i < FREE_COUNT {
        inputs[i] = given[i];
        i += 1;
    }
    inputs
}

/// A club, a ball and how they meet.
#[derive(Clone, Copy, Debug)]
pub struct Shot<S> {
    /// How the club is delivered.
    pub delivery: Delivery<S>,
    /// The clubhead.
    pub club: Club<S>,
    /// The ball.
    pub ball: Ball<S>,
    /// Characteristic time of the face that the parameters of the model include, s; 0 if they are of the ball alone.
    pub included_time: S,
}

impl<S: Scalar> Shot<S> {
    /// From values in the order of [`INPUTS`].
    #[inline(always)]
    pub fn from_inputs(v: &[S; INPUT_COUNT]) -> Self {
        Self {
            delivery: Delivery {
                speed: v[0],
                attack: v[1],
                path: v[2],
                loft: v[3],
                face: v[4],
                lie: v[5],
                toe: v[6],
                high: v[7],
                closure: v[8],
                pitch_rate: v[9],
                lie_rate: v[10],
                ball_backspin: v[11],
                ball_sidespin: v[12],
                ball_riflespin: v[13],
            },
            club: Club {
                mass: v[14],
                cg_to_face: clubface_math::Vec3::new(v[15], v[16], v[17]),
                inertia: [v[18], v[19], v[20], v[21], v[22], v[23]],
                static_loft: v[24],
                bulge: v[25],
                roll: v[26],
                face_width: v[27],
                face_height: v[28],
                characteristic_time: v[29],
                hand: v[30],
                added: core::array::from_fn(|i| v[FREE_COUNT + i]),
            },
            ball: Ball { mass: v[31], radius: v[32], inertia: v[33] },
            included_time: v[34],
        }
    }
}
