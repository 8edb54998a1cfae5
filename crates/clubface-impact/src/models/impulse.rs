//! The impulse-momentum equations that four models share (Caldwell and McPhee, Eqs. 1-11), eliminated to one 3 x 3
//! solve.

use crate::first_touch::{FirstTouch, Motion};
use crate::giving_face::GivingFace;
use clubface_math::{Computation, Mat3, Scalar, Vec3};

/// Coefficient of restitution of a shot: `cor + cor_slope * speed`, and never below zero, where the ball would leave
/// through the face; more where the face of the club gives more than the one that `cor` includes.
#[inline(always)]
pub fn restitution<S: Scalar>(cor: S, cor_slope: S, touch: &FirstTouch<S>) -> S {
    let approach = touch.approach();
    // In this order NaN stays.
    let of_set = S::zero().max(cor + cor_slope * approach);
    if touch.gives() {
        return GivingFace::from_touch(touch).restitution(of_set, approach);
    }
    of_set
}

/// Restitution along x' (normal), y' (up the face) and z' (to the toe): after impact the relative velocity at the
/// contact point is minus this times that before. Zero along the face is pure rolling.
#[derive(Clone, Copy, Debug)]
pub struct Restitution<S> {
    /// Normal.
    pub normal: S,
    /// Up the face.
    pub up: S,
    /// Towards the toe.
    pub toe: S,
}

/// Both motions after an instantaneous impact at one point, face axes.
///
/// `extra_mass` moves with the clubhead CG; `ball_offset` displaces the ball's CG in x'y'z' (Danaei et al., as in
/// Caldwell and McPhee section 2.1.1).
#[inline(always)]
pub fn solve<S: Scalar>(
    touch: &FirstTouch<S>,
    restitution: &Restitution<S>,
    extra_mass: S,
    ball_offset: Vec3<S>,
) -> (Motion<S>, Motion<S>) {
    S::outline(Equations { touch, restitution, extra_mass, ball_offset })
}

/// The equations, a function of their own for all models.
struct Equations<'a, S> {
    touch: &'a FirstTouch<S>,
    restitution: &'a Restitution<S>,
    extra_mass: S,
    ball_offset: Vec3<S>,
}

impl<S: Scalar> Computation for Equations<'_, S> {
    type Output = (Motion<S>, Motion<S>);
    #[inline(always)]
    fn run(self) -> (Motion<S>, Motion<S>) {
        let Self { touch, restitution, extra_mass, ball_offset } = self;
        let x = touch.normal;
        let (y, z) = touch.tangents();
        let head = touch.head.with_mass(extra_mass).mobility();
        let club_arm = touch.contact;
        let ball_arm = x * -(touch.ball.radius + ball_offset.x) - y * ball_offset.y - z * ball_offset.z;

        // Velocity of the ball relative to the face at the contact point, before and (Eqs. 5, 8-11) after.
        let before =
            touch.ball_spin.cross(ball_arm) - (touch.club_velocity + touch.club_spin.cross(club_arm));
        let after = -(x * (restitution.normal * x.dot(before))
            + y * (restitution.up * y.dot(before))
            + z * (restitution.toe * z.dot(before)));

        // Relative velocity gained per impulse on the ball at the contact point (Eqs. 1-4, 6, 7).
        let inverse_ball_inertia = touch.ball.inertia.recip();
        let ball_cross = Mat3::cross(ball_arm);
        let turning = (ball_cross * ball_cross).scale(-inverse_ball_inertia);
        let mobility = Mat3::diagonal(touch.ball.mass.recip()) + turning + head.between(club_arm, club_arm);
        let impulse = mobility.inverse() * (after - before);

        let ball = Motion {
            velocity: impulse * touch.ball.mass.recip(),
            spin: touch.ball_spin + ball_arm.cross(impulse) * inverse_ball_inertia,
        };
        let (slowed, turned) = head.response(impulse, club_arm.cross(impulse));
        let club = Motion { velocity: touch.club_velocity - slowed, spin: touch.club_spin - turned };
        (ball, club)
    }
}
