//! How much more the face of a club gives than the face that the parameters of a model include.
//!
//! A face is a mass m on a spring of compliance c behind it ([`crate::face_spring`]). In a free head it moves the point
//! of contact inwards by w, beyond the mean motion of the head, which takes the whole force F:
//!
//! w'' = ((1 - s)^2 c F - w) / (m (1 - s) c), with s = m over the mass with which the head acts at the impact point.
//!
//! Parameters found with a club describe ball and face together. What its face of compliance c0 gives must not count
//! twice, and what is left is the difference of two such motions. To second order in the frequency it is
//!
//! w'' = (C F - w) / T^2, with C = (1 - s)^2 (c - c0) and T^2 = m (1 - s) (c + c0),
//!
//! the whole face for parameters of the ball alone (c0 = 0), and nothing for the face that they include. It stores the
//! energy (T^2 w'^2 + w^2) / 2C, negative where the club gives less than the parameters have it.

use crate::face_spring::{COMPLIANCE, GUIDED_MASS};
use crate::first_touch::FirstTouch;
use clubface_math::{Mask, Scalar};

/// Twice the energy of a normal impact over the square of its largest force, m/N: 13.2 kN by the ball `modern` of
/// finite elements on the rigid head of Caldwell and McPhee's driver, at 160 ft/s.
const BALL_COMPLIANCE: f64 = 5.06e-7;
/// The energy of that impact, J.
const BALL_ENERGY: f64 = 44.2;
/// A ball in Hertz's contact is the stiffer the harder it is struck: E ~ F^(5/3), E/F^2 ~ E^(-1/5).
const STIFFENING: f64 = -0.2;

/// What a face gives beyond the one that parameters include.
#[derive(Clone, Copy, Debug)]
pub struct GivingFace<S> {
    /// C, m/N: 0 for the included face.
    pub compliance: S,
    /// T^2, s2.
    pub square_time: S,
    /// (1 - s)^2 c0, m/N.
    included: S,
    /// Mass with which head and ball resist being parted at the impact point, kg.
    mass: S,
}

impl<S: Scalar> GivingFace<S> {
    /// The giving face of a shot.
    #[inline(always)]
    pub fn from_touch(touch: &FirstTouch<S>) -> Self {
        let [own, included] = [touch.characteristic_time, touch.included_time].map(Scalar::squared);
        let mobility = touch.normal_mobility();
        let free = -((mobility - touch.ball.mass.recip()) * GUIDED_MASS) + 1.0;
        let square = free.squared() * COMPLIANCE;
        let square_time = (own + included) * free * (GUIDED_MASS * COMPLIANCE);
        Self {
            compliance: square * (own - included),
            // Any time, where both are rigid and nothing moves.
            square_time: S::select(square_time.gt(S::zero()), square_time, S::one()),
            included: square * included,
            mass: mobility.recip(),
        }
    }

    /// Restitution of ball and face together at a normal approach speed in m/s, given that with the included face.
    ///
    /// A ball of compliance b takes the share s = b / (b + c) of the energy, is compressed by s times the speed, and
    /// force and its duration change by s^(1/2) and s^(-1/2): a ball that loses a part of its energy in proportion to
    /// speed^p loses 1 - e^2 ~ s^((3 + p)/2). With p = 0 it is linear and viscous, with p = 1 damped as by Hunt and
    /// Crossley; that of the ball `modern` of finite elements, 0.33 at 30 m/s, 0.40 at 49, 0.45 at 60, has p = 1/2.
    #[inline(always)]
    pub fn restitution(&self, of_set: S, speed: S) -> S {
        let energy = self.mass * speed.squared() * 0.5;
        let ball = (energy * BALL_ENERGY.recip()).powf(STIFFENING) * BALL_COMPLIANCE;
        // The ball's share of the energy, over that with the included face.
        let with_included = ball + self.included;
        let share = with_included / (with_included + self.compliance);
        let root = share.sqrt();
        let less = -(share * root * root.sqrt()) + 1.0;
        // sqrt(1 - (1 - e^2) share^(7/4)), and e to the bit where the share is one; never below zero.
        let gained = (-of_set.squared() + 1.0) * less;
        let square = of_set.squared() + gained;
        let left = square.gt(S::zero());
        let square = S::select(left, square, S::one());
        S::select(left, of_set + gained / (of_set + square.sqrt()), S::zero())
    }
}

/// Whether a face that gives less than the included one has taken no more than a quarter of the energy of the impact
/// from what the parameters hold, given the largest force. A face of 250 us holds a seventh of it; parameters of which
/// it would hold more are too stiff to include it, and what is left of them stiffens without end.
#[inline(always)]
pub fn possible<S: Scalar>(touch: &FirstTouch<S>, peak_force: S) -> S::Mask {
    if !touch.gives() {
        return S::Mask::splat(true);
    }
    let GivingFace { compliance, mass, .. } = GivingFace::from_touch(touch);
    (-(compliance * peak_force.squared())).le(mass * touch.approach().squared() * 0.25)
}

impl GivingFace<f64> {
    /// Energy that it holds, moved by `depth` (m) and moving at `rate` (m/s), J.
    #[must_use]
    pub fn energy(&self, depth: f64, rate: f64) -> f64 {
        if self.compliance == 0.0 {
            return 0.0;
        }
        0.5 * (self.square_time * rate.powi(2) + depth.powi(2)) / self.compliance
    }
}
