//! The mass behind a face that gives, moving in the head.
//!
//! A guided mass m, part of the head's own mass properties, moves by u along the inward normal a of the impact point c,
//! against a spring k without damping. Total momentum p and angular momentum L of the head change by the ball's force
//! and torque alone, the guided mass's conjugate momentum by pi' = a.F - k u. Velocities follow from the momenta:
//!
//! u' = (pi - m (a.V0 + (c x a).W0)) / (m (1 - m (1/M + (c x a).I^-1 (c x a)))) with V0 = p/M and W0 = I^-1 L,
//! the body around the guided mass has V = V0 - m u' a / M and W = W0 - m u' I^-1 (c x a).
//!
//! After impact the guided mass goes on vibrating; V0 and W0, its mean, describe the motion of the head.

use crate::face_spring::FaceSpring;
use crate::first_touch::Motion;
use crate::head_inertia::HeadMobility;
use clubface_math::{Scalar, Vec3};

/// The guided mass in a head that is struck at some point. Vectors are fixed in the head.
#[derive(Clone, Copy, Debug)]
pub struct GuidedMass<S> {
    /// Mass and spring.
    pub spring: FaceSpring<S>,
    /// Direction a in which the face gives: the inward normal at the impact point.
    pub inward: Vec3<S>,
    /// c x a, with c from CG to impact point, m.
    arm: Vec3<S>,
    /// Change of the head's velocity for a rate of the guided mass; m a / M in a free head.
    shift: Vec3<S>,
    /// Change of the head's spin for a rate of the guided mass, 1/m; m I^-1 (c x a) in a free head.
    turn: Vec3<S>,
    /// Inverse of the guided mass as it resists a change of its rate in a head that is free, 1/kg.
    mobility: S,
}

impl<S: Scalar> GuidedMass<S> {
    /// In a head struck at a point (m, from its CG) with an outward normal.
    #[inline(always)]
    pub fn new(spring: FaceSpring<S>, head: &HeadMobility<S>, contact: Vec3<S>, normal: Vec3<S>) -> Self {
        let inward = -normal;
        let arm = contact.cross(inward);
        let (shift, turn) = head.response(inward * spring.mass, arm * spring.mass);
        let mobility = spring.inverse_mass / (-inward.dot(shift) - arm.dot(turn) + 1.0);
        Self { spring, inward, arm, shift, turn, mobility }
    }

    /// Momentum of the mass while it does not move in the head, for a motion of the head, kg m/s.
    #[inline(always)]
    pub fn carried(&self, head: Motion<S>) -> S {
        (self.inward.dot(head.velocity) + self.arm.dot(head.spin)) * self.spring.mass
    }

    /// Speed of the mass inwards (m/s), given its momentum and the mean motion of the head, p/M and I^-1 L.
    #[inline(always)]
    pub fn rate(&self, momentum: S, mean: Motion<S>) -> S {
        (momentum - self.carried(mean)) * self.mobility
    }

    /// What the motion of the body around the mass has beyond the mean one, given the mass's speed; for a depth in
    /// its place, how far that body lies from where the head as a whole would be.
    #[inline(always)]
    pub fn recoil(&self, rate: S) -> Motion<S> {
        Motion { velocity: -(self.shift * rate), spin: -(self.turn * rate) }
    }
}
