//! Adjusted impulse-momentum model of Danaei et al.: extra clubhead mass and a displaced ball CG (Caldwell and McPhee,
//! section 2.1.1).

use super::impulse::{Restitution, restitution, solve};
use crate::contact::Recorder;
use crate::description::{Law, ModelInfo, ModelKind, TIMED_OUTPUTS};
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::model::{Describe, Model};
use crate::parameters;
use clubface_math::{Scalar, Vec3};

parameters! {
    /// Parameters of the adjusted model.
    Adjusted {
        cor ["1"] = 0.83 in 0.0 ..= 1.0, "coefficient of restitution at rest",
            "Caldwell and McPhee (2023), Eq. 5, the rule limit";
        cor_slope ["s/m"] = 0.0 in -0.02 ..= 0.0, "change of restitution per normal approach speed",
            "0 in Caldwell and McPhee (2023)";
        extra_mass ["kg"] = 2.54e-3 in -0.05 ..= 0.1, "mass added at the clubhead CG",
            "Caldwell and McPhee (2023), Table 6, driver";
        dcg_x ["m"] = 0.0 in -0.005 ..= 0.005, "displacement of the ball CG along x' (outward)",
            "Caldwell and McPhee (2023), Table 6, driver";
        dcg_y ["m"] = -0.482e-3 in -0.005 ..= 0.005, "displacement of the ball CG along y' (up the face)",
            "Caldwell and McPhee (2023), Table 6, driver";
        dcg_z ["m"] = -0.068e-3 in -0.005 ..= 0.005, "displacement of the ball CG along z' (to the toe)",
            "Caldwell and McPhee (2023), Table 6, driver";
    }
}

impl Describe for Adjusted<()> {
    type Over<S: Scalar> = Adjusted<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "adjusted",
        title: "Adjusted impulse-momentum",
        kind: ModelKind::Impulse,
        summary: "The standard model with a little mass added to the clubhead and the ball's CG displaced.",
        reference: "Caldwell and McPhee (2023), section 2.1.1, after Danaei et al.; parameters of Table 6",
        laws: &[Law::Momentum, Law::AngularMomentum, Law::Energy],
        laws_without: None,
        face_in: Some("cor"),
        lacks: TIMED_OUTPUTS,
        gear_effect: true,
        ball: None,
        valid: &[],
        lanes: true,
        parameters: Adjusted::PARAMETERS,
    };
}

impl<S: Scalar> Model<S> for Adjusted<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, _: Accuracy, _: &mut R) -> Impact<S> {
        let normal = restitution(self.cor, self.cor_slope, touch);
        let rolling = Restitution { normal, up: S::zero(), toe: S::zero() };
        let offset = Vec3::new(self.dcg_x, self.dcg_y, self.dcg_z);
        let (ball, club) = solve(touch, &rolling, self.extra_mass, offset);
        Impact::certain(touch.launch(ball, club))
    }
}
