//! Forces and torque of the air on a spinning golf ball.
//!
//! Drag and lift depend on the spin parameter S = r omega / v, and drag on the Reynolds number Re = 2 r rho v / mu
//! too: C_D = 0.156 + 0.850 S - 0.916 S^2 + 0.149 / (1 + (Re / 67,700)^16), C_L = 0.0617 + 1.256 S - 1.324 S^2, C_M =
//! 0.01 S. Both parabolas are held from their vertices on, at S = 0.46 and 0.47. The last term of C_D is the drag
//! crisis about 25 m/s: a ball that slows there drops more steeply.
//!
//! The constants are fitted (docs/flight.md has the data, and what was held out): to the carries, heights and descents
//! of the tours' averages of 2023, to flights that a TrackMan computes, and to published coefficients: P. W. Bearman
//! and J. K. Harvey (1976), the example of US patent 6,186,002 (2001), B. Lyu, J. Kensrud, L. Smith and T. Tosaya
//! (2018, doi 10.3390/proceedings2060238), B. Lyu, J. Kensrud and L. Smith (2020, doi 10.1007/s12283-020-0318-1). C_M
//! is that of S. Ferguson, W. McNally and J. McPhee (2022, doi 10.5703/1288284317493).
//!
//! Published coefficients reach from S = 0.04 to 1. Outside 0.02-1, S is held at the nearer end (and the flight says
//! so), but lift fades to zero with the spin, since it must and the fit does not know it.

use clubface_math::{Mask, Scalar, Vec3};

/// Smallest spin parameter of the fit.
pub const LOWEST_SPIN_PARAMETER: f64 = 0.02;
/// Largest spin parameter of the fit.
pub const HIGHEST_SPIN_PARAMETER: f64 = 1.0;
/// Coefficient of the spin decay torque over the spin parameter.
pub const SPIN_DECAY: f64 = 0.01;
/// Drag coefficient of a fast ball: constant, linear and quadratic in the spin parameter.
const DRAG: [f64; 3] = [0.156, 0.850, -0.916];
/// Lift coefficient: constant, linear and quadratic in the spin parameter.
const LIFT: [f64; 3] = [0.0617, 1.256, -1.324];
/// What the drag crisis adds to the drag coefficient of a slow ball.
const CRISIS_RISE: f64 = 0.149;
/// Reynolds number in the middle of the drag crisis.
const CRISIS_REYNOLDS: f64 = 67_700.0;
/// Speed below which the spin parameter is that of this speed, m/s: no force is left there, and nothing divides by 0.
const STILL: f64 = 1e-9;

/// Spin parameter r omega / v, held within the range of the fit; `spin` and `speed` are magnitudes.
#[inline(always)]
pub fn held_spin_parameter<S: Scalar>(radius: S, spin: S, speed: S) -> S {
    let (low, high) = (S::from_f64(LOWEST_SPIN_PARAMETER), S::from_f64(HIGHEST_SPIN_PARAMETER));
    (radius * spin / speed.max(S::from_f64(STILL))).max(low).min(high)
}

/// A parabola that opens downwards, held from its vertex on: no kink.
#[inline(always)]
fn held_parabola<S: Scalar>([constant, linear, quadratic]: [f64; 3], s: S) -> S {
    let s = s.min(S::from_f64(-0.5 * linear / quadratic));
    (s * quadratic + linear) * s + constant
}

/// One below the drag crisis, large above it: what divides its rise of the drag coefficient, of a Reynolds number.
#[inline(always)]
fn crisis<S: Scalar>(reynolds: S) -> S {
    (reynolds * (1.0 / CRISIS_REYNOLDS)).squared().squared().squared().squared() + 1.0
}

/// Drag coefficient at a spin parameter within the fit and a Reynolds number.
#[inline(always)]
pub fn drag_coefficient<S: Scalar>(s: S, reynolds: S) -> S {
    held_parabola(DRAG, s) + crisis(reynolds).recip() * CRISIS_RISE
}

/// Lift coefficient at a spin parameter within the fit.
#[inline(always)]
pub fn lift_coefficient<S: Scalar>(s: S) -> S {
    held_parabola(LIFT, s)
}

/// Whether the spin parameter lies outside the range of the fit; `spin` is a magnitude.
#[inline(always)]
pub fn outside_fit<S: Scalar>(radius: S, spin: S, square_speed: S) -> S::Mask {
    let (square_rim, square_speed) =
        ((radius * spin).squared(), square_speed.max(S::from_f64(STILL * STILL)));
    square_rim
        .lt(square_speed * (LOWEST_SPIN_PARAMETER * LOWEST_SPIN_PARAMETER))
        .or(square_rim.gt(square_speed * (HIGHEST_SPIN_PARAMETER * HIGHEST_SPIN_PARAMETER)))
}

/// What the air does to the ball, each in units of 0.5 rho A.
#[derive(Clone, Copy, Debug)]
pub struct AirLoad<S> {
    /// Force, m2/s2: drag against the velocity through the air, lift along spin x velocity.
    pub force: Vec3<S>,
    /// Torque against the spin per unit spin, m3/s: torque = -decay omega.
    pub decay: S,
}

/// Load on a ball of `radius` (m) moving through the air with `velocity` (m/s) and spinning with `spin` (rad/s);
/// `reynolds_per_speed` is its diameter over the kinematic viscosity, s/m.
#[inline(always)]
pub fn air_load<S: Scalar>(
    radius: S,
    reynolds_per_speed: S,
    velocity: Vec3<S>,
    spin: Vec3<S>,
    spin_speed: S,
) -> AirLoad<S> {
    let speed = velocity.norm().max(S::from_f64(STILL));
    // Speed of the surface; below the fit, where lift fades with the spin, that of its lower end.
    let rim = (radius * spin_speed).max(speed * LOWEST_SPIN_PARAMETER);
    let crisis = crisis(reynolds_per_speed * speed);
    // One division for three quotients, since it takes longer than all the rest.
    let inverse = (speed * rim * crisis).recip();
    let inverse_spin_parameter = speed.squared() * crisis * inverse;
    let held = (rim.squared() * crisis * inverse).min(S::from_f64(HIGHEST_SPIN_PARAMETER));
    let drag = (held_parabola(DRAG, held) + speed * rim * inverse * CRISIS_RISE) * speed;
    // Lift C_L v^2 along the unit vectors' product: C_L v / omega.
    let lift = lift_coefficient(held) * radius * inverse_spin_parameter;
    // C_M v^2 r / omega, which is 0.01 v r^2 but above the fit.
    let decay = held * SPIN_DECAY * speed * radius.squared() * inverse_spin_parameter;
    AirLoad { force: spin.cross(velocity) * lift - velocity * drag, decay }
}
