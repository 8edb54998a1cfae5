//! Variable-slip impulse-momentum model: Cross and Dewhurst's tangential restitution in 3D (Caldwell and McPhee,
//! section 2.1.2).

use super::impulse::{Restitution, restitution, solve};
use crate::contact::Recorder;
use crate::description::{Law, ModelInfo, ModelKind, TIMED_OUTPUTS};
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::model::{Describe, Model};
use crate::parameters;
use clubface_math::{Scalar, Vec3};

parameters! {
    /// Parameters of the variable-slip model.
    Slip {
        cor ["1"] = 0.83 in 0.0 ..= 1.0, "coefficient of restitution at rest",
            "Caldwell and McPhee (2023), Eq. 5, the rule limit";
        cor_slope ["s/m"] = 0.0 in -0.02 ..= 0.0, "change of restitution per normal approach speed",
            "0 in Caldwell and McPhee (2023)";
        slip_y ["1"] = -0.0103 in -1.0 ..= 1.0, "slip ratio e_y up the face (Eq. 10); 0 is rolling",
            "Caldwell and McPhee (2023), Table 7, driver";
        slip_z ["1"] = -0.0150 in -1.0 ..= 1.0, "slip ratio e_z towards the toe (Eq. 11); 0 is rolling",
            "Caldwell and McPhee (2023), Table 7, driver";
    }
}

impl Describe for Slip<()> {
    type Over<S: Scalar> = Slip<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "slip",
        title: "Variable-slip impulse-momentum",
        kind: ModelKind::Impulse,
        summary: "The standard model with a prescribed fraction of the sliding velocity reversed instead of rolling.",
        reference: "Caldwell and McPhee (2023), section 2.1.2, Eqs. 10-11, after Cross and Dewhurst; parameters of Table 7",
        laws: &[Law::Momentum, Law::AngularMomentum, Law::Energy],
        laws_without: None,
        face_in: Some("cor"),
        lacks: TIMED_OUTPUTS,
        gear_effect: true,
        ball: None,
        valid: &[],
        lanes: true,
        parameters: Slip::PARAMETERS,
    };
}

impl<S: Scalar> Model<S> for Slip<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, _: Accuracy, _: &mut R) -> Impact<S> {
        let normal = restitution(self.cor, self.cor_slope, touch);
        let sliding = Restitution { normal, up: self.slip_y, toe: self.slip_z };
        let (ball, club) = solve(touch, &sliding, S::zero(), Vec3::zero());
        Impact::certain(touch.launch(ball, club))
    }
}
