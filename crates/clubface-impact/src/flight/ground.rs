//! Bounces and roll on level turf.
//!
//! After A. R. Penner (The run of a golf ball, Can. J. Phys. 80, 2002, 931-940): the ball dents the turf and bounces
//! as from a rigid plane tilted back towards it by theta_c = 15.4 deg (v / 18.6 m/s) (theta / 44.4 deg), theta being
//! the angle of its path from the vertical; with a restitution e = 0.510 - 0.0375 v + 0.000903 v^2 of the speed v
//! normal to that plane (0.120 above 20 m/s); sliding all through the impact if the friction is below
//! mu_c = 2 (v_t + r omega) / (7 (1 + e) v), else leaving it in rolling. When a bounce would not reach 10 mm the ball
//! rolls, slowed by 5/7 rho_g g. The two laws come from Haake's measurements on greens around 18.6 m/s and 44.4 deg.
//!
//! The paper itself was not at hand: constants and equations, the friction 0.40, rho_g = 0.131 (0.065 on the fastest
//! greens to 0.196 on the slowest) and the 10 mm are as several independent programs restate it. The default ground is
//! a fairway, on which a slow ball rolls like on Penner's average green (assumed), and firmer: its tilt of 12.3 deg
//! lies between that of runs that a TrackMan computes today (13.3 deg) and that of published runs of drives.
//!
//! Ours, where Penner is silent: friction acts in three dimensions, against the sliding of the contact point, so that
//! a tilted spin axis kicks sideways and 5/7 follows from the ball's own inertia; a ball still sliding when bounces
//! end slides on under the same friction until it rolls. Three bounds make shallow landings run as far as a TrackMan
//! has them, from 4 deg of descent on: theta_c stays below the angle of descent (else it would stop a topped ball
//! dead), so that (theta_c^-8 + descent^-8)^(-1/8) stands in its place; no ball goes up faster than e(0) = 0.510 times
//! its fall, the most that any bounce returns (else the tilt would throw it ever higher); and grass, which a
//! Stimpmeter on a green does not notice, slows a rolling ball in proportion to the square of its speed, to 1/e in 23
//! m on a fairway.
//!
//! A low ball runs at tens of m/s, so that the drag of still air slows bounces and roll: a hop of time T multiplies the
//! level speed v by 1 / (1 + c v T), c being the deceleration over v^2, and is v T ln(1 + c v T) / (c v T) long; a roll
//! against the constant deceleration a is shorter by the same function of c v^2 / a, grass and air together in c. Lift,
//! worth a few per cent of the run of a low drive, and wind, weak near the ground, are left out.
//!
//! So that the place of rest never jumps: bounces give way to rolling not at 10 mm but between 5 and 15 mm, where the
//! ball rests at the mean of the two, as it does on turf whose grass is as long; and the restitution is constant from
//! the lowest point of its parabola on, 0.1207 at 20.8 m/s, instead of falling to 0.120 at 20 m/s at once.

use super::trajectory::{Flight, GRAVITY};
use crate::ball::Ball;
use clubface_math::{Mask, Scalar, Vec3};

/// Speed at which the tilt of the effective plane is given, m/s.
const TILT_SPEED: f64 = 18.6;
/// Angle of the path from the vertical at which the tilt is given, rad.
const TILT_ANGLE: f64 = 44.4 * core::f64::consts::PI / 180.0;
/// Penner's coefficient of restitution of a slow ball.
const SLOW_RESTITUTION: f64 = 0.510;
/// Normal speed above which the restitution is constant, m/s: the lowest point of its parabola.
const FAST: f64 = 0.0375 / (2.0 * 0.000_903);
/// Heights of a bounce between which it gives way to rolling, m; in the middle Penner's 10 mm.
const LOWEST_BOUNCE: [f64; 2] = [0.005, 0.015];
/// Bounces after which a ball is taken to roll; a drive makes some thirty.
const MAX_BOUNCES: usize = 60;
/// Length or speed that stands for zero in a denominator.
const TINY: f64 = 1e-12;

/// Level turf.
#[derive(Clone, Copy, Debug)]
pub struct Ground<S> {
    /// Factor on Penner's coefficient of restitution: above 1 is firmer.
    pub restitution_factor: S,
    /// Tilt of the effective plane at 18.6 m/s and 44.4 deg, rad: smaller is firmer.
    pub tilt: S,
    /// Coefficient of sliding friction.
    pub friction: S,
    /// Coefficient of rolling friction rho_g.
    pub rolling_friction: S,
    /// Way over which grass alone slows a rolling ball to 1/e of its speed, m.
    pub grass_length: S,
}

/// Coefficient of rolling friction rho_g of a green on which a ball runs `distance` (m) off a Stimpmeter.
///
/// The ball leaves it at 1.83 m/s (6.00 ft/s) and rolls v^2 / (2 (5/7) rho_g g).
#[must_use]
pub fn rolling_friction_of_stimp(distance: f64) -> f64 {
    let speed: f64 = 1.83;
    0.7 * speed.powi(2) / (GRAVITY * distance)
}

/// Penner's coefficient of restitution at a normal speed, m/s.
#[inline(always)]
pub fn restitution<S: Scalar>(normal_speed: S) -> S {
    let speed = normal_speed.min(S::from_f64(FAST));
    (speed * 0.000_903 - 0.0375) * speed + SLOW_RESTITUTION
}

/// Part of the sliding speed of the contact point that changes into rolling: 2/7 for a homogeneous ball.
#[inline(always)]
fn rolling_part<S: Scalar>(ball: &Ball<S>) -> S {
    (ball.mass * ball.radius.squared() / ball.inertia + 1.0).recip()
}

/// The lesser of two angles, without a kink: (a^-8 + b^-8)^(-1/8).
#[inline(always)]
fn bounded<S: Scalar>(a: S, b: S) -> S {
    let eighth = |x: S| x.squared().squared().squared();
    a * b / (eighth(a) + eighth(b)).max(S::from_f64(TINY.powi(8))).powf(0.125)
}

/// Velocity [m/s] and spin [rad/s] after a bounce.
#[inline(always)]
pub fn bounce<S: Scalar>(
    ball: &Ball<S>,
    ground: &Ground<S>,
    velocity: Vec3<S>,
    spin: Vec3<S>,
) -> (Vec3<S>, Vec3<S>) {
    let zero = S::zero();
    let level_speed = Vec3::new(velocity.x, zero, velocity.z).norm();
    let sinking = -velocity.y;
    let steepness = level_speed.atan2(sinking);
    let descent = sinking.atan2(level_speed);
    let dent = ground.tilt * (velocity.norm() / TILT_SPEED) * (steepness / TILT_ANGLE);
    let tilt = bounded(dent, descent);
    let (sine, cosine) = tilt.sin_cos();
    let back = sine / level_speed.max(S::from_f64(TINY));
    let normal = Vec3::new(-(velocity.x * back), cosine, -(velocity.z * back));

    let normal_speed = -velocity.dot(normal);
    let gain = ground.restitution_factor * restitution(normal_speed) + 1.0;
    // Velocity of the contact point along the plane; friction opposes it, at most until it vanishes.
    let sliding = velocity + normal * normal_speed - spin.cross(normal) * ball.radius;
    let sliding_speed = sliding.norm();
    let limit = ground.friction * gain * normal_speed / sliding_speed.max(S::from_f64(TINY));
    let part = limit.min(rolling_part(ball));
    let turning = ball.mass * ball.radius / ball.inertia * part;
    let mut after = velocity + normal * (gain * normal_speed) - sliding * part;
    after.y = after.y.min(sinking * ground.restitution_factor * SLOW_RESTITUTION);
    (after, spin + normal.cross(sliding) * turning)
}

/// Part of a bounce of a height, m, that leaves the ground: from 0 to 1, with a derivative that does not jump.
#[inline(always)]
fn lifted<S: Scalar>(height: S) -> S {
    let [low, high] = LOWEST_BOUNCE;
    let x = ((height - low) / (high - low)).max(S::zero()).min(S::one());
    x.squared() * (x * -2.0 + 3.0)
}

/// ln(1 + x) / x, the part of its way that drag leaves to a ball; one where there is no drag.
#[inline(always)]
fn left_by_drag<S: Scalar>(x: S) -> S {
    // Below it the series is exact to rounding, and the quotient is not.
    let small = S::from_f64(1e-5);
    let divisor = x.max(small);
    let series = (x * (1.0 / 3.0) - 0.5) * x + 1.0;
    S::select(x.lt(small), series, (divisor + 1.0).ln() / divisor)
}

/// Place where a ball that lands at `position` comes to rest, m; `flight` gives the drag.
#[inline(always)]
pub fn run<S: Scalar>(
    ball: &Ball<S>,
    ground: &Ground<S>,
    flight: &Flight<S>,
    position: Vec3<S>,
    velocity: Vec3<S>,
    spin: Vec3<S>,
) -> Vec3<S> {
    let (zero, one) = (S::zero(), S::one());
    let (mut place, mut velocity, mut spin) = (position, velocity, spin);
    // The mean over where the ball begins to roll, and the part of it that still bounces.
    let (mut rest, mut bouncing) = (Vec3::zero(), one);
    for count in 1..=MAX_BOUNCES {
        let (after, spin_after) = bounce(ball, ground, velocity, spin);
        let rising = after.y.max(zero);
        let level = Vec3::new(after.x, zero, after.z);
        let part = if count < MAX_BOUNCES { lifted(rising.squared() / (2.0 * GRAVITY)) } else { zero };
        let rolls = bouncing.gt(zero).and(part.lt(one));
        if rolls.any() {
            let end =
                rest + (place + roll(ball, ground, flight, level, spin_after)) * (bouncing * (-part + 1.0));
            rest = Vec3::select(rolls, end, rest);
        }
        bouncing = bouncing * part;
        let again = bouncing.gt(zero);
        if !again.any() {
            break;
        }
        let (speed, time) = (level.norm(), rising * (2.0 / GRAVITY));
        let slowing = flight.drag(spin_after.norm(), speed) * speed * time;
        place = Vec3::select(again, place + level * (time * left_by_drag(slowing)), place);
        let landing = level * (slowing + 1.0).recip() - Vec3::new(zero, rising, zero);
        velocity = Vec3::select(again, landing, velocity);
        spin = Vec3::select(again, spin_after, spin);
    }
    rest
}

/// Way of a ball on the ground until it rests, m; `velocity` is level.
#[inline(always)]
pub fn roll<S: Scalar>(
    ball: &Ball<S>,
    ground: &Ground<S>,
    flight: &Flight<S>,
    velocity: Vec3<S>,
    spin: Vec3<S>,
) -> Vec3<S> {
    let up = Vec3::new(S::zero(), S::one(), S::zero());
    let part = rolling_part(ball);
    // Sliding, in a straight line relative to the contact point, until it rolls.
    let sliding = velocity - spin.cross(up) * ball.radius;
    let rolling = velocity - sliding * part;
    let sliding_time = part * sliding.norm() / (ground.friction * GRAVITY);
    let slid = (velocity + rolling) * (sliding_time * 0.5);
    // 5/7 for a homogeneous ball.
    let deceleration = ground.rolling_friction * (-part + 1.0) * GRAVITY;
    let speed = rolling.norm();
    let drag = flight.drag(speed / ball.radius, speed) + ground.grass_length.recip();
    let drag = drag * speed.squared() / deceleration;
    slid + rolling * (speed / (deceleration * 2.0) * left_by_drag(drag))
}
