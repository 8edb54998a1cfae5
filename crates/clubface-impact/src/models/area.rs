//! Contact-area model of Arakawa (Caldwell and McPhee, section 2.2.3, Eqs. 17-21, letters as in the original work).

use super::hertz;
use crate::contact::{ContactLaw, Indentation, RECORDED_SOLID, Recorder, SOLID, SOLID_GIVING, Sliding, run};
#[cfg(feature = "multibody")]
use crate::contact::{SteppedContact, stepped};
use crate::description::{Law, ModelInfo, ModelKind};
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::model::{Describe, Model};
use crate::parameters;
use clubface_math::elementary::tanh_ratio;
use clubface_math::{Dual, Scalar};
use core::f64::consts::PI;

/// Sliding speed at which friction has nearly its full size, m/s.
const SLIDING_SPEED: f64 = 0.01;

parameters! {
    /// Parameters of the contact-area model.
    Area {
        shear_modulus ["Pa"] = 5.40e7 in 1e6 ..= 1e10, "effective shear modulus G",
            "Caldwell and McPhee (2023), Table 10, driver, corrected by 1/100 (as printed a drive lasts 82 us)";
        poisson ["1"] = 0.398 in 0.0 ..= 0.499, "effective Poisson's ratio",
            "Caldwell and McPhee (2023), Table 10, driver";
        damping ["s/m"] = 6.35e-3 in 0.0 ..= 0.03, "Hunt-Crossley damping d",
            "Caldwell and McPhee (2023), Table 10, driver";
        friction ["1"] = 0.0486 in 0.0 ..= 2.0, "coefficient of friction mu (the published lambda)",
            "Caldwell and McPhee (2023), Table 10, driver";
        area_damping ["N s/m2"] = 0.0 in 0.0 ..= 1e6, "contact-area coefficient eta",
            "0: the printed 1.32e5 gives 20 kN at first touch";
    }
}

impl Describe for Area<()> {
    type Over<S: Scalar> = Area<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "area",
        title: "Contact area",
        kind: ModelKind::Contact,
        summary: "Hertz contact with friction from the normal force and the rate of the contact area.",
        reference: "Caldwell and McPhee (2023), section 2.2.3, Eqs. 14-21, after Arakawa et al.; parameters of Table 10",
        laws: &[Law::Momentum, Law::AngularMomentum],
        laws_without: Some(("area_damping", &[Law::Energy, Law::FrictionCone])),
        face_in: Some("damping"),
        lacks: &[],
        gear_effect: true,
        ball: None,
        valid: &[],
        lanes: true,
        parameters: Area::PARAMETERS,
    };
}

impl<S: Scalar> ContactLaw<S> for Area<S> {
    const FAST_TOLERANCE: f64 = 2.4e-5;

    #[inline(always)]
    fn normal_force<const K: usize>(&self, at: Indentation<S, K>) -> Dual<S, K> {
        let equivalent = hertz::equivalent_radius(Dual::constant(at.radius), at.curvature);
        let stiffness = hertz::stiffness(self.shear_modulus, self.poisson, equivalent);
        hertz::force(stiffness, self.damping, at.depth, at.rate)
    }
    #[inline(always)]
    fn drag<const K: usize>(&self, at: Sliding<S, K>) -> Dual<S, K> {
        // Caldwell and McPhee, Eqs. 17 and 20 with the letters put right: mu F_N + mu eta dA/dt, dA/dt = pi R xdot.
        let growth = at.rate.scale(at.radius * PI);
        let slope = Dual::constant(S::from_f64(1.0 / SLIDING_SPEED));
        tanh_ratio(slope, at.w) * (at.normal_force + growth.scale(self.area_damping)).scale(self.friction)
    }
    #[inline(always)]
    fn area(&self, depth: S, _curvature: S, radius: S) -> S {
        // Caldwell and McPhee, Eqs. 18-19, with the ball's radius.
        radius * depth * PI
    }
}

impl<S: Scalar> Model<S> for Area<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, accuracy: Accuracy, record: &mut R) -> Impact<S> {
        run::<S, _, R, SOLID, SOLID_GIVING, RECORDED_SOLID>(touch, *self, accuracy, record)
    }

    #[cfg(feature = "multibody")]
    fn stepped(&self, touch: &FirstTouch<S>) -> Option<Box<dyn SteppedContact<S>>> {
        Some(stepped::<S, _, SOLID_GIVING>(touch, *self))
    }
}
