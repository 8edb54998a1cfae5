//! How the head moves, from the momentum that club and ball keep: only the velocity of the ball relative to the head is
//! integrated.

use super::state::{ATTITUDE, BALL_SPIN, CLUB_SPIN, CORE_SPIN, VELOCITY, layered};
use crate::first_touch::{FirstTouch, Motion};
use crate::head_inertia::HeadInertia;
use clubface_math::{Computation, Mat3, Quat, Scalar, Vec3};

/// Momentum of club and ball in a frame that moves as the clubhead's CG did at first touch, axes of first touch.
#[derive(Clone, Copy, Debug)]
pub struct HeadMotion<S> {
    ball_mass: S,
    momentum: Vec3<S>,
    /// Velocity of the CG by momentum, the head's spin apart, 1/kg.
    by_momentum: Mat3<S>,
}

impl<S: Scalar> HeadMotion<S> {
    #[inline(always)]
    pub fn new(touch: &FirstTouch<S>) -> Self {
        S::outline(Start(touch))
    }

    /// Velocity of the CG in that frame in state `y`, head axes, m/s.
    #[inline(always)]
    pub fn velocity(&self, head: &HeadInertia<S>, y: &[S]) -> Vec3<S> {
        S::outline(Velocity { motion: self, head, y })
    }
}

struct Start<'a, S>(&'a FirstTouch<S>);

impl<S: Scalar> Computation for Start<'_, S> {
    type Output = HeadMotion<S>;
    #[inline(always)]
    fn run(self) -> HeadMotion<S> {
        let touch = self.0;
        let ball_mass = touch.ball.mass;
        let (carried, _) = touch.head.momenta(Vec3::zero(), touch.club_spin);
        let own = touch.head.mass + ball_mass;
        let by_momentum = match &touch.head.added {
            None => Mat3::diagonal(own.recip()),
            Some(added) => (added.linear + Mat3::diagonal(own)).inverse(),
        };
        HeadMotion { ball_mass, momentum: carried - touch.club_velocity * ball_mass, by_momentum }
    }
}

struct Velocity<'a, S> {
    motion: &'a HeadMotion<S>,
    head: &'a HeadInertia<S>,
    y: &'a [S],
}

impl<S: Scalar> Computation for Velocity<'_, S> {
    type Output = Vec3<S>;
    #[inline(always)]
    fn run(self) -> Vec3<S> {
        let Self { motion, head, y } = self;
        let turn = Quat { w: y[ATTITUDE], v: Vec3::from_slice(y, ATTITUDE + 1) }.matrix();
        let mut momentum =
            turn.transpose() * motion.momentum - Vec3::from_slice(y, VELOCITY) * motion.ball_mass;
        if let Some(added) = &head.added {
            momentum = momentum - added.coupling * Vec3::from_slice(y, CLUB_SPIN);
        }
        motion.by_momentum * momentum
    }
}

/// Motions of ball and club in face axes of first touch: velocities by momentum, ball spin from all its angular
/// momentum.
#[inline(always)]
pub fn motions<S: Scalar, const N: usize>(
    touch: &FirstTouch<S>,
    core_inertia: Option<S>,
    y: &[S; N],
) -> (Motion<S>, Motion<S>) {
    let turn = Quat { w: y[ATTITUDE], v: Vec3::from_slice(y, ATTITUDE + 1) }.matrix();
    let club_velocity = touch.club_velocity + turn * HeadMotion::new(touch).velocity(&touch.head, y);
    let relative = turn * Vec3::from_slice(y, VELOCITY);
    let mut ball_spin = Vec3::from_slice(y, BALL_SPIN);
    if let (true, Some(core)) = (layered(N), core_inertia) {
        let share = core / touch.ball.inertia;
        ball_spin += (Vec3::from_slice(y, CORE_SPIN) - ball_spin) * share;
    }
    let ball = Motion { velocity: club_velocity + relative, spin: turn * ball_spin };
    let club = Motion { velocity: club_velocity, spin: turn * Vec3::from_slice(y, CLUB_SPIN) };
    (ball, club)
}
