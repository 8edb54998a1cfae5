//! Two-layer ball with a volumetric normal force (Caldwell and McPhee, section 2.2.1, Eqs. 12-13), after McNally,
//! Gonthier and Brown.

use crate::contact::{
    ContactLaw, Core, Indentation, LAYERED, LAYERED_GIVING, RECORDED_LAYERED, Recorder, Sliding, run,
};
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

parameters! {
    /// Parameters of the volumetric model.
    Volumetric {
        stiffness ["N/m3"] = 6.25e9 in 1e8 ..= 1e11, "volumetric stiffness k_V",
            "Caldwell and McPhee (2023), Table 8, driver";
        damping ["s/m"] = 6.42e-3 in 0.0 ..= 0.03, "Hunt-Crossley damping d_V",
            "Caldwell and McPhee (2023), Table 8, driver";
        friction ["1"] = 0.372 in 0.0 ..= 2.0, "coefficient of friction mu",
            "Caldwell and McPhee (2023), Table 8, driver";
        layer_stiffness ["N m/rad"] = 13.5 in 0.0 ..= 200.0, "rotary stiffness between cover and core k_ball",
            "Caldwell and McPhee (2023), Table 8, driver";
        layer_damping ["N m s/rad"] = 2.53e-3 in 0.0 ..= 0.1, "rotary damping between cover and core c_ball",
            "Caldwell and McPhee (2023), Table 8, driver";
        cover_thickness ["m"] = 1.26e-3 in 0.3e-3 ..= 8e-3, "thickness of the cover t_cover",
            "Caldwell and McPhee (2023), Table 8, driver";
        transition_speed ["m/s"] = 0.936 in 0.01 ..= 5.0, "transition speed of friction v_tr",
            "Caldwell and McPhee (2023), Table 8, driver";
    }
}

impl Describe for Volumetric<()> {
    type Over<S: Scalar> = Volumetric<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "volumetric",
        title: "Two-layer ball, volumetric contact",
        kind: ModelKind::Contact,
        summary: "Normal force from the overlap volume, smooth Coulomb friction, a cover that twists on its core.",
        reference: "Caldwell and McPhee (2023), section 2.2.1, Eqs. 12-13; parameters of Table 8",
        laws: &[Law::Momentum, Law::AngularMomentum, Law::Energy, Law::FrictionCone],
        laws_without: None,
        face_in: Some("damping"),
        lacks: &[],
        gear_effect: true,
        ball: None,
        valid: &[],
        lanes: true,
        parameters: Volumetric::PARAMETERS,
    };
}

/// Volume, m3, that a ball of `radius` shares with a sphere of `curvature` (0: a half space) it enters by `depth`,
/// and the squared radius of the circle in which the surfaces meet, m2.
///
/// Two spherical caps; written in the curvature so that the half space is no special case.
#[inline(always)]
pub fn overlap<S: Scalar>(depth: S, curvature: S, radius: S) -> (S, S) {
    // Distance of the centres times the curvature.
    let centres = curvature * (radius - depth) + 1.0;
    let ball_cap = depth * (-(curvature * depth) + 2.0) / (centres * 2.0);
    let face_cap = depth * (radius * 2.0 - depth) / (centres * 2.0);
    let circle = ball_cap * (radius * 2.0 - ball_cap);
    // Cap heights h: pi h^2 (3 r - h) / 3 each; the face's cap height is curvature * face_cap.
    let face_part = curvature * face_cap.squared() * (-(curvature.squared() * face_cap) + 3.0);
    let ball_part = ball_cap.squared() * (radius * 3.0 - ball_cap);
    ((ball_part + face_part) * (PI / 3.0), circle)
}

impl<S: Scalar> ContactLaw<S> for Volumetric<S> {
    const FAST_TOLERANCE: f64 = 7.5e-5;

    #[inline(always)]
    fn normal_force<const K: usize>(&self, at: Indentation<S, K>) -> Dual<S, K> {
        let (volume, _) = overlap(at.depth, at.curvature, Dual::constant(at.radius));
        // Caldwell and McPhee, Eq. 12; never adhesive.
        (volume.scale(self.stiffness) * (at.rate.scale(self.damping) + 1.0)).max(Dual::zero())
    }
    #[inline(always)]
    fn drag<const K: usize>(&self, at: Sliding<S, K>) -> Dual<S, K> {
        // Caldwell and McPhee, Eq. 13.
        let slope = Dual::constant(S::from_f64(4.0) / self.transition_speed);
        tanh_ratio(slope, at.w) * at.normal_force.scale(self.friction)
    }
    #[inline(always)]
    fn area(&self, depth: S, curvature: S, radius: S) -> S {
        overlap(depth, curvature, radius).1 * PI
    }
    #[inline(always)]
    fn core(&self, inertia: S, radius: S) -> Option<Core<S>> {
        // Equal densities: inertias go with the fifth power of the radius.
        let ratio = (radius - self.cover_thickness) / radius;
        let fifth = ratio.squared().squared() * ratio;
        Some(Core { inertia: inertia * fifth, stiffness: self.layer_stiffness, damping: self.layer_damping })
    }
}

impl<S: Scalar> Model<S> for Volumetric<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, accuracy: Accuracy, record: &mut R) -> Impact<S> {
        run::<S, _, R, LAYERED, LAYERED_GIVING, RECORDED_LAYERED>(touch, *self, accuracy, record)
    }

    #[cfg(feature = "multibody")]
    fn stepped(&self, touch: &FirstTouch<S>) -> Option<Box<dyn SteppedContact<S>>> {
        Some(stepped::<S, _, LAYERED_GIVING>(touch, *self))
    }
}
