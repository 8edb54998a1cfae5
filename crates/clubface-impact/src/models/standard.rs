//! Standard impulse-momentum model: restitution along the normal, pure rolling along the face (Caldwell and McPhee,
//! section 2.1).

use super::impulse::{Restitution, restitution, solve};
use crate::contact::Recorder;
use crate::description::{Law, ModelInfo, ModelKind, TIMED_OUTPUTS};
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::model::{Describe, Model};
use crate::parameters;
use clubface_math::{Scalar, Vec3};

parameters! {
    /// Parameters of the standard model.
    Standard {
        cor ["1"] = 0.83 in 0.0 ..= 1.0, "coefficient of restitution at rest",
            "Caldwell and McPhee (2023), Eq. 5, the rule limit";
        cor_slope ["s/m"] = 0.0 in -0.02 ..= 0.0, "change of restitution per normal approach speed",
            "0 in Caldwell and McPhee (2023); Penner: cor 0.86, slope -0.0029 s/m";
    }
}

impl Describe for Standard<()> {
    type Over<S: Scalar> = Standard<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "standard",
        title: "Standard impulse-momentum",
        kind: ModelKind::Impulse,
        summary: "Instantaneous impact with restitution along the normal and pure rolling along the face.",
        reference: "Caldwell and McPhee (2023), section 2.1, Eqs. 1-9",
        laws: &[Law::Momentum, Law::AngularMomentum, Law::Energy],
        laws_without: None,
        face_in: Some("cor"),
        lacks: TIMED_OUTPUTS,
        gear_effect: true,
        ball: None,
        valid: &[],
        lanes: true,
        parameters: Standard::PARAMETERS,
    };
}

impl<S: Scalar> Model<S> for Standard<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, _: Accuracy, _: &mut R) -> Impact<S> {
        let normal = restitution(self.cor, self.cor_slope, touch);
        let rolling = Restitution { normal, up: S::zero(), toe: S::zero() };
        let (ball, club) = solve(touch, &rolling, S::zero(), Vec3::zero());
        Impact::certain(touch.launch(ball, club))
    }
}
