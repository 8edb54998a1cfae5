//! A model that is not one of the library's: Hunt and Crossley's contact (1975) with a quadratic spring. One file and
//! one line of a registry, as any other model, and every contract test runs over it.

use crate::shots::*;
use clubface_impact::contact::{
    ContactLaw, Indentation, RECORDED_SOLID, Recorder, SOLID, SOLID_GIVING, Sliding, run,
};
use clubface_impact::description::{Law, ModelInfo, ModelKind};
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::impact::{Accuracy, Impact};
use clubface_impact::model::{Describe, Model};
use clubface_impact::parameters;
use clubface_math::elementary::tanh_ratio;
use clubface_math::{Dual, Scalar};

parameters! {
    /// Parameters of the quadratic spring.
    QuadraticSpring {
        stiffness ["N/m2"] = 1e9 in 1e8 ..= 1e11, "stiffness k", "a drive of some half a millisecond";
        damping ["s/m"] = 6.4e-3 in 0.0 ..= 0.03, "Hunt-Crossley damping d", "as the contact-area model";
        friction ["1"] = 0.3 in 0.0 ..= 2.0, "coefficient of friction", "golf balls on steel";
        transition_speed ["m/s"] = 0.9 in 0.01 ..= 5.0, "sliding speed of nearly full friction", "as the volumetric model";
    }
}

impl Describe for QuadraticSpring<()> {
    type Over<S: Scalar> = QuadraticSpring<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "quadratic_spring",
        title: "Quadratic spring and damper",
        kind: ModelKind::Contact,
        summary: "Normal force k x^2 (1 + d xdot) with smooth Coulomb friction.",
        reference: "Hunt and Crossley (1975), exponent 2",
        laws: &[Law::Momentum, Law::AngularMomentum, Law::Energy, Law::FrictionCone],
        laws_without: None,
        face_in: None,
        lacks: &[],
        gear_effect: true,
        ball: None,
        valid: &[],
        lanes: true,
        parameters: QuadraticSpring::PARAMETERS,
    };
}

impl<S: Scalar> ContactLaw<S> for QuadraticSpring<S> {
    const FAST_TOLERANCE: f64 = 2.4e-5;

    #[inline(always)]
    fn normal_force<const K: usize>(&self, at: Indentation<S, K>) -> Dual<S, K> {
        (at.depth.squared().scale(self.stiffness) * (at.rate.scale(self.damping) + 1.0)).max(Dual::zero())
    }
    #[inline(always)]
    fn drag<const K: usize>(&self, at: Sliding<S, K>) -> Dual<S, K> {
        let slope = Dual::constant(S::from_f64(4.0) / self.transition_speed);
        tanh_ratio(slope, at.w) * at.normal_force.scale(self.friction)
    }
    #[inline(always)]
    fn area(&self, depth: S, _curvature: S, radius: S) -> S {
        depth * (radius * 2.0 - depth) * core::f64::consts::PI
    }
}

impl<S: Scalar> Model<S> for QuadraticSpring<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, accuracy: Accuracy, record: &mut R) -> Impact<S> {
        run::<S, _, R, SOLID, SOLID_GIVING, RECORDED_SOLID>(touch, *self, accuracy, record)
    }
}

/// Every model a contract is tested on.
#[test]
fn contracts_are_tested_on_models_of_other_registries() {
    let names: Vec<_> = every_model().map(|model| model.info().name).collect();
    assert!(names.contains(&"quadratic_spring") && names.contains(&"standard"), "{names:?}");
}
