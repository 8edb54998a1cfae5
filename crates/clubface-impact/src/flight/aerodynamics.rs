//! Forces and torque of the air on a spinning golf ball.
//!
//! S. Ferguson, W. McNally and J. McPhee (2022, doi 10.5703/1288284317493) fitted the coefficients of drag, lift and
//! spin decay to 1040 measured flights as functions of the spin parameter S = r omega / v alone:
//! C_D = 0.1304 + 0.9287 S - 0.8259 S^2, C_L = 0.0504 + 1.2031 S - 1.1490 S^2, C_M = 0.01 S. There is no Reynolds
//! number in them. They hold for S in 0.02-0.75; outside, S is held at the nearer end (and the flight says so), but
//! lift fades to zero with the spin, since it must and the fit does not know it.

use clubface_math::{Mask, Scalar, Vec3};

/// Smallest spin parameter of the fit.
pub const LOWEST_SPIN_PARAMETER: f64 = 0.02;
/// Largest spin parameter of the fit.
pub const HIGHEST_SPIN_PARAMETER: f64 = 0.75;
/// Coefficient of the spin decay torque over the spin parameter.
pub const SPIN_DECAY: f64 = 0.01;
/// Speed below which the spin parameter is that of this speed, m/s: no force is left there, and nothing divides by 0.
const STILL: f64 = 1e-9;

/// Spin parameter r omega / v, held within the range of the fit.
#[inline(always)]
pub fn held_spin_parameter<S: Scalar>(radius: S, spin: S, speed: S) -> S {
    let (low, high) = (S::from_f64(LOWEST_SPIN_PARAMETER), S::from_f64(HIGHEST_SPIN_PARAMETER));
    spin_parameter(radius, spin, speed).max(low).min(high)
}

/// Drag coefficient at a spin parameter within the fit.
#[inline(always)]
pub fn drag_coefficient<S: Scalar>(s: S) -> S {
    (s * -0.8259 + 0.9287) * s + 0.1304
}

/// Lift coefficient at a spin parameter within the fit.
#[inline(always)]
pub fn lift_coefficient<S: Scalar>(s: S) -> S {
    (s * -1.1490 + 1.2031) * s + 0.0504
}

/// Spin parameter r omega / v; `spin` and `speed` are magnitudes.
#[inline(always)]
pub fn spin_parameter<S: Scalar>(radius: S, spin: S, speed: S) -> S {
    radius * spin / speed.max(S::from_f64(STILL))
}

/// Whether a spin parameter lies outside the range of the fit.
#[inline(always)]
pub fn outside_fit<S: Scalar>(s: S) -> S::Mask {
    s.lt(S::from_f64(LOWEST_SPIN_PARAMETER)).or(s.gt(S::from_f64(HIGHEST_SPIN_PARAMETER)))
}

/// What the air does to the ball, each in units of 0.5 rho A.
#[derive(Clone, Copy, Debug)]
pub struct AirLoad<S> {
    /// Force, m2/s2: drag against the velocity through the air, lift along spin x velocity.
    pub force: Vec3<S>,
    /// Torque against the spin per unit spin, m3/s: torque = -decay omega.
    pub decay: S,
}

/// Load on a ball of `radius` [m] moving through the air with `velocity` [m/s] and spinning with `spin` [rad/s].
#[inline(always)]
pub fn air_load<S: Scalar>(radius: S, velocity: Vec3<S>, spin: Vec3<S>, spin_speed: S) -> AirLoad<S> {
    let speed = velocity.norm().max(S::from_f64(STILL));
    let held = held_spin_parameter(radius, spin_speed, speed);
    let drag = drag_coefficient(held) * speed;
    // Lift C_L v^2 along the unit vectors' product; below the fit, 1 / omega becomes that of its lower end.
    let slowest = speed * LOWEST_SPIN_PARAMETER / radius;
    let inverse_spin = spin_speed.max(slowest).recip();
    let lift = lift_coefficient(held) * speed * inverse_spin;
    // C_M v^2 r / omega, which is 0.01 v r^2 but above the fit.
    let decay = held * SPIN_DECAY * speed.squared() * radius * inverse_spin;
    AirLoad { force: spin.cross(velocity) * lift - velocity * drag, decay }
}
