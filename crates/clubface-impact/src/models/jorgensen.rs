//! Jorgensen's theory of spin with a compression factor (Roh and Lee, section 3.1), carried into three dimensions.

use super::impulse::{Restitution, restitution, solve};
use crate::contact::Recorder;
use crate::description::{Law, ModelInfo, ModelKind, TIMED_OUTPUTS};
use crate::first_touch::{FirstTouch, Motion};
use crate::impact::{Accuracy, Impact};
use crate::model::{Describe, Model};
use crate::parameters;
use clubface_math::{Scalar, Vec3};

parameters! {
    /// Parameters of Jorgensen's model.
    Jorgensen {
        cor ["1"] = 0.83 in 0.0 ..= 1.0, "coefficient of restitution at rest",
            "Caldwell and McPhee (2023), Eq. 5, the rule limit";
        cor_slope ["s/m"] = 0.0 in -0.02 ..= 0.0, "change of restitution per normal approach speed",
            "0 in Caldwell and McPhee (2023)";
        compression_factor ["1"] = 0.92 in 0.0 ..= 1.4,
            "fraction f of the rolling velocity that is left when the ball's compression is considered",
            "Roh and Lee: their spin of 2047 rpm implies 0.92, their Eq. 11 gives 0.9476; Jorgensen estimated 0.7";
    }
}

impl Describe for Jorgensen<()> {
    type Over<S: Scalar> = Jorgensen<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "jorgensen",
        title: "Jorgensen's compression factor",
        kind: ModelKind::Impulse,
        summary: "The standard model's normal part; rolling along the face reduced by the ball's compression. \
                  It does not keep angular momentum.",
        reference: "Roh and Lee, section 3.1, Eqs. 4-6, after Jorgensen",
        laws: &[Law::Momentum],
        laws_without: None,
        face_in: Some("cor"),
        lacks: TIMED_OUTPUTS,
        gear_effect: false,
        ball: None,
        valid: &[],
        lanes: true,
        parameters: Jorgensen::PARAMETERS,
    };
}

/// Compression factor f from the force-weighted mean radius ratio f' (Roh and Lee, Eq. 11).
#[must_use]
pub fn compression_factor(radius_ratio: f64) -> f64 {
    7.0 * radius_ratio / (5.0 * radius_ratio + 2.0)
}

impl<S: Scalar> Model<S> for Jorgensen<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, _: Accuracy, _: &mut R) -> Impact<S> {
        let x = touch.normal;
        let normal = restitution(self.cor, self.cor_slope, touch);
        let no_slip = Restitution { normal, up: S::zero(), toe: S::zero() };
        let (ball, club) = solve(touch, &no_slip, S::zero(), Vec3::zero());
        // Velocity of the ball along the face before impact, and what Roh and Lee, Eqs. 4-6 leave of it; a ball that
        // spins already would roll with two sevenths of the velocity that belongs to its spin besides.
        let sliding = -(touch.club_velocity + touch.club_spin.cross(touch.contact)).reject(x);
        let rolled = touch.ball_spin.cross(x) * touch.ball.radius;
        let rolling = sliding * S::from_f64(5.0 / 7.0) + rolled * S::from_f64(2.0 / 7.0);
        let left = rolling * self.compression_factor;
        let face_point = club.velocity + club.spin.cross(touch.contact);
        let velocity = x * x.dot(ball.velocity) + face_point.reject(x) + left;
        let spin = x.cross(left) * touch.ball.radius.recip() + x * x.dot(touch.ball_spin);
        // The club takes the momentum the ball has; its angular motion is that of the standard model.
        let momentum = velocity * touch.ball.mass;
        let (slowed, _) = touch.head_mobility().response(momentum, touch.contact.cross(momentum));
        let club = Motion { velocity: touch.club_velocity - slowed, spin: club.spin };
        Impact::certain(touch.launch(Motion { velocity, spin }, club))
    }
}
