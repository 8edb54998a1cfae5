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
//! greens to 0.196) and the 10 mm are as several independent programs restate it. A fairway slows the ball more.
//!
//! Ours, where Penner is silent: friction acts in three dimensions, against the sliding of the contact point, so that
//! a tilted spin axis kicks sideways and 5/7 follows from the ball's own inertia; a ball still sliding when bounces end
//! slides on under the same friction until it rolls; the air is left out of bounces and roll. And two bounds for fast
//! skimming balls, far outside the measurements and not reached by the tour averages: theta_c stays below the angle of
//! descent (else it would stop a topped ball dead), and no ball goes up faster than it came down (else the tilt would
//! throw it ever higher). Such a ball rolls at tens of m/s, where constant deceleration takes it much too far.

use super::trajectory::GRAVITY;
use crate::ball::Ball;
use clubface_math::{Mask, Scalar, Vec3};

/// Speed at which the tilt of the effective plane is given, m/s.
const TILT_SPEED: f64 = 18.6;
/// Angle of the path from the vertical at which the tilt is given, rad.
const TILT_ANGLE: f64 = 44.4 * core::f64::consts::PI / 180.0;
/// Normal speed above which the restitution is constant, m/s.
const FAST: f64 = 20.0;
/// Height a bounce must reach to count as one, m.
const LOWEST_BOUNCE: f64 = 0.01;
/// Bounces after which a ball is taken to roll; a drive makes some fifteen.
const MAX_BOUNCES: usize = 40;
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
}

/// Coefficient of rolling friction rho_g of a green on which a ball runs `distance` [m] off a Stimpmeter.
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
    let slow = (normal_speed * 0.000_903 - 0.0375) * normal_speed + 0.510;
    S::select(normal_speed.le(S::from_f64(FAST)), slow, S::from_f64(0.120))
}

/// Part of the sliding speed of the contact point that changes into rolling: 2/7 for a homogeneous ball.
#[inline(always)]
fn rolling_part<S: Scalar>(ball: &Ball<S>) -> S {
    (ball.mass * ball.radius.squared() / ball.inertia + 1.0).recip()
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
    let tilt = (ground.tilt * (velocity.norm() / TILT_SPEED) * (steepness / TILT_ANGLE)).min(descent);
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
    after.y = after.y.min(sinking);
    (after, spin + normal.cross(sliding) * turning)
}

/// Place where a ball that lands at `position` comes to rest, m.
#[inline(always)]
pub fn run<S: Scalar>(
    ball: &Ball<S>,
    ground: &Ground<S>,
    position: Vec3<S>,
    velocity: Vec3<S>,
    spin: Vec3<S>,
) -> Vec3<S> {
    let (mut place, mut velocity, mut spin) = (position, velocity, spin);
    let zero = S::zero();
    let mut bouncing = S::Mask::splat(true);
    for _ in 0..MAX_BOUNCES {
        let (after, spin_after) = bounce(ball, ground, velocity, spin);
        let high = after.y.gt(zero).and((after.y.squared() / (2.0 * GRAVITY)).ge(S::from_f64(LOWEST_BOUNCE)));
        let again = bouncing.and(high);
        let level = Vec3::new(after.x, zero, after.z);
        let hop = level * (after.y * (2.0 / GRAVITY));
        place = Vec3::select(again, place + hop, place);
        let next = Vec3::select(again, level - Vec3::new(zero, after.y, zero), level);
        velocity = Vec3::select(bouncing, next, velocity);
        spin = Vec3::select(bouncing, spin_after, spin);
        bouncing = again;
        if !bouncing.any() {
            break;
        }
    }
    place + roll(ball, ground, Vec3::new(velocity.x, zero, velocity.z), spin)
}

/// Way of a ball on the ground until it rests, m; `velocity` is level.
#[inline(always)]
pub fn roll<S: Scalar>(ball: &Ball<S>, ground: &Ground<S>, velocity: Vec3<S>, spin: Vec3<S>) -> Vec3<S> {
    let up = Vec3::new(S::zero(), S::one(), S::zero());
    let part = rolling_part(ball);
    // Sliding, in a straight line relative to the contact point, until it rolls.
    let sliding = velocity - spin.cross(up) * ball.radius;
    let rolling = velocity - sliding * part;
    let sliding_time = part * sliding.norm() / (ground.friction * GRAVITY);
    let slid = (velocity + rolling) * (sliding_time * 0.5);
    // 5/7 for a homogeneous ball.
    let deceleration = ground.rolling_friction * (-part + 1.0) * GRAVITY;
    slid + rolling * (rolling.norm() / (deceleration * 2.0))
}
