//! Impulse models against closed forms and the conditions they are made of (Caldwell and McPhee, Eqs. 1-11).

use crate::rigid::Rigid;
use crate::shots::*;
use clubface_impact::{Accuracy, ImpactModel};
use clubface_math::Vec3;
use proptest::prelude::*;

/// A 3 x 3 solve of well-conditioned equations: some hundred roundings.
const ROUNDING: f64 = 1e-12;

fn impulse(model: ImpactModel, inputs: &Inputs, parameters: &[f64]) -> (Rigid, Outputs) {
    let outputs = hit(model, inputs, parameters, Accuracy::Fast);
    (Rigid::new(model, inputs, parameters, &outputs), outputs)
}

/// Penner, "The physics of golf: the optimum loft of a driver" (Am. J. Phys. 69, 2001, 563-568): for an impact through
/// the CG, along the normal v (1 + e) M/(M + m); along the face rolling, with the ball's k = I/(m R^2),
/// and here the head's own turning by a tangential force at depth a, a^2/I_zz.
#[test]
fn a_central_impact_follows_penners_closed_form() {
    for (depth, loft, cor, slope) in
        [(0.0, 0.2, 0.83, 0.0), (0.0, 0.6, 0.86, -0.0029), (0.04, 0.2, 0.7, 0.0), (0.04, 0.5, 0.86, -0.0029)]
    {
        let inputs = simple_head(depth).with(&[("loft", loft)]);
        let parameters = changed(STANDARD, STANDARD.info().defaults(), &[("cor", cor), ("cor_slope", slope)]);
        let (_, outputs) = impulse(STANDARD, &inputs, &parameters);
        let (m, big_m, radius) = (inputs.at("ball_mass"), inputs.at("club_mass"), inputs.at("ball_radius"));
        let (normal, tangential) = (inputs.at("speed") * loft.cos(), inputs.at("speed") * loft.sin());
        let e = cor + slope * normal;
        let along_normal = (1.0 + e) * normal * big_m / (big_m + m);
        let turning = radius.powi(2) / inputs.at("ball_inertia") + depth.powi(2) / inputs.at("izz");
        let impulse = tangential / (m.recip() + big_m.recip() + turning);
        // The face moves down along itself relative to its normal, and takes the ball with it.
        let (sine, cosine) = loft.sin_cos();
        let along_face = -impulse / m;
        let velocity = outputs.ball_velocity();
        let expected_x = along_normal * cosine - along_face * sine;
        let expected_y = along_normal * sine + along_face * cosine;
        assert!((velocity.x / expected_x - 1.0).abs() < ROUNDING);
        assert!((velocity.y / expected_y - 1.0).abs() < ROUNDING, "{} {expected_y}", velocity.y);
        let spin = impulse * radius / inputs.at("ball_inertia");
        assert!((outputs.at("backspin") / spin - 1.0).abs() < ROUNDING);
        assert!(velocity.z.abs() < ROUNDING && outputs.at("sidespin").abs() < 1e-10);
    }
}

/// Where the slope takes more than the restitution at rest there is none left: the ball stays at the face, and no
/// energy is made.
#[test]
fn restitution_ends_at_zero() {
    let inputs = simple_head(0.04).with(&[("speed", 60.0)]);
    for model in [STANDARD, ADJUSTED, SLIP, JORGENSEN] {
        for (cor, slope) in [(0.0, -0.02), (0.5, -0.02), (0.0, 0.0)] {
            let parameters = changed(model, model.info().defaults(), &[("cor", cor), ("cor_slope", slope)]);
            let (rigid, _) = impulse(model, &inputs, &parameters);
            let (before, after) = (rigid.relative_before(), rigid.relative_after());
            let normal = rigid.touch.normal;
            let restitution = -after.dot(normal) / before.dot(normal);
            assert!(restitution.abs() < ROUNDING, "{model:?}: {restitution}");
        }
    }
}

/// For a homogeneous ball and a head of infinite mass, rolling leaves 5/7 of the velocity along the face.
#[test]
fn a_homogeneous_ball_rolls_off_a_heavy_face_with_five_sevenths() {
    let loft = 0.4f64;
    let inputs = simple_head(0.04).with(&[
        ("loft", loft),
        ("club_mass", 1e12),
        ("ball_inertia", 0.4 * 0.0459 * 0.0213f64.powi(2)),
    ]);
    let inputs = inputs.with(&[("ixx", 1e9), ("iyy", 1e9), ("izz", 1e9)]);
    let (_, outputs) = impulse(STANDARD, &inputs, &STANDARD.info().defaults());
    let speed = inputs.at("speed") * loft.sin();
    // m/M = 5e-14.
    assert!((outputs.at("backspin") * 0.0213 / (speed * 5.0 / 7.0) - 1.0).abs() < 1e-11);
}

proptest! {
    #[test]
    fn the_standard_ball_leaves_rolling_and_with_the_restitution_asked_for(
        (_, inputs) in any_delivery(), cor in 0.0..1.0f64
    ) {
        let parameters = changed(STANDARD, STANDARD.info().defaults(), &[("cor", cor)]);
        let (rigid, _) = impulse(STANDARD, &inputs, &parameters);
        let (before, after) = (rigid.relative_before(), rigid.relative_after());
        let speed = before.norm();
        prop_assert!(after.reject(rigid.touch.normal).norm() < ROUNDING * speed);
        prop_assert!((after.dot(rigid.touch.normal) + cor * before.dot(rigid.touch.normal)).abs() < ROUNDING * speed);
    }

    /// The displaced CG moves with the ball: it is the surface that rolls.
    #[test]
    fn the_adjusted_ball_rolls_about_its_displaced_cg((club, inputs) in any_delivery()) {
        let parameters = published(ADJUSTED, club);
        let (rigid, _) = impulse(ADJUSTED, &inputs, &parameters);
        let (before, after) = (rigid.relative_before(), rigid.relative_after());
        prop_assert!(after.reject(rigid.touch.normal).norm() < ROUNDING * before.norm());
        let restitution = -after.dot(rigid.touch.normal) / before.dot(rigid.touch.normal);
        prop_assert!((restitution - 0.83).abs() < ROUNDING);
    }

    /// Caldwell and McPhee, Eqs. 10 and 11: each component of the sliding velocity is reversed by its own slip ratio.
    #[test]
    fn the_slip_model_keeps_the_slip_ratios_along_both_directions(
        (_, inputs) in any_delivery(), e_y in -1.0..1.0f64, e_z in -1.0..1.0f64
    ) {
        let parameters = changed(SLIP, SLIP.info().defaults(), &[("slip_y", e_y), ("slip_z", e_z)]);
        let (rigid, _) = impulse(SLIP, &inputs, &parameters);
        let (before, after) = (rigid.relative_before(), rigid.relative_after());
        let (up, toe) = rigid.touch.tangents();
        prop_assert!((after.dot(up) + e_y * before.dot(up)).abs() < ROUNDING * before.norm());
        prop_assert!((after.dot(toe) + e_z * before.dot(toe)).abs() < ROUNDING * before.norm());
    }

    #[test]
    fn without_slip_mass_or_displacement_three_models_are_the_standard_one((_, inputs) in any_delivery()) {
        let standard = hit(STANDARD, &inputs, &STANDARD.info().defaults(), Accuracy::Fast);
        for (model, nothing) in [
            (SLIP, vec![("slip_y", 0.0), ("slip_z", 0.0)]),
            (ADJUSTED, vec![("extra_mass", 0.0), ("dcg_x", 0.0), ("dcg_y", 0.0), ("dcg_z", 0.0)]),
        ] {
            let result = hit(model, &inputs, &changed(model, model.info().defaults(), &nothing), Accuracy::Fast);
            prop_assert_eq!(result.bits(), standard.bits());
        }
    }

    /// An impulse P at one point does the work P.(v_before + v_after)/2 of the relative velocity there. Energies of 300
    /// J are known to 1e-13 J or so.
    #[test]
    fn the_energy_lost_is_the_work_of_the_impulse((club, inputs) in any_delivery()) {
        for model in [STANDARD, ADJUSTED, SLIP] {
            let (rigid, _) = impulse(model, &inputs, &published(model, club));
            let work = rigid.impulse().dot(rigid.relative_before() + rigid.relative_after()) * 0.5;
            prop_assert!((rigid.energy_lost() + work).abs() < 1e-10, "{} {}", rigid.energy_lost(), work);
            prop_assert!(rigid.energy_lost() > 0.0);
        }
    }

    /// Rolling loses energy whatever the impact if 1 - e^2 exceeds the squared coupling of normal and sliding motion,
    /// which depends on head and impact point alone: below 0.05 for real heads, so e may go to 0.97.
    #[test]
    fn rolling_off_centre_bounds_the_restitution_that_loses_energy((_, inputs) in any_delivery(), cor in 0.0..1.0f64) {
        let parameters = changed(STANDARD, STANDARD.info().defaults(), &[("cor", cor)]);
        let (rigid, _) = impulse(STANDARD, &inputs, &parameters);
        let normal = rigid.touch.normal;
        let (up, toe) = rigid.touch.tangents();
        // Of the inverse of the mobility: c.T^-1 c / n for its normal element n, sliding block T and coupling c.
        let mass = rigid.mobility().inverse();
        let element = |a: Vec3<f64>, b: Vec3<f64>| a.dot(mass * b);
        let (n, c) = (element(normal, normal), [element(up, normal), element(toe, normal)]);
        let (yy, zz, yz) = (element(up, up), element(toe, toe), element(up, toe));
        let coupling =
            (c[0] * c[0] * zz - 2.0 * c[0] * c[1] * yz + c[1] * c[1] * yy) / ((yy * zz - yz * yz) * n);
        prop_assert!((0.0..0.05).contains(&coupling), "{}", coupling);
        if 1.0 - cor * cor > coupling {
            prop_assert!(rigid.energy_lost() > 0.0);
        }
    }

    /// Central: the normal part loses (1 - e^2)/2 of the energy of approach, the rolling part all of that of sliding.
    #[test]
    fn a_central_impact_loses_what_its_restitution_implies(loft in 0.0..0.7f64, cor in 0.0..1.0f64, depth in 0.0..0.05f64) {
        let inputs = simple_head(depth).with(&[("loft", loft)]);
        let parameters = changed(STANDARD, STANDARD.info().defaults(), &[("cor", cor)]);
        let (rigid, _) = impulse(STANDARD, &inputs, &parameters);
        let (normal, tangential) = (inputs.at("speed") * loft.cos(), inputs.at("speed") * loft.sin());
        let mass = (inputs.at("ball_mass").recip() + inputs.at("club_mass").recip()).recip();
        let turning = inputs.at("ball_radius").powi(2) / inputs.at("ball_inertia") + depth.powi(2) / inputs.at("izz");
        let sliding_mass = (mass.recip() + turning).recip();
        let expected = 0.5 * (1.0 - cor.powi(2)) * mass * normal.powi(2) + 0.5 * sliding_mass * tangential.powi(2);
        prop_assert!((rigid.energy_lost() - expected).abs() < 1e-10);
    }

    /// The impulse that gives the change of the relative velocity: an independent form of the solve.
    #[test]
    fn the_impulse_is_the_mobility_applied_backwards((club, inputs) in any_delivery()) {
        for model in [STANDARD, ADJUSTED, SLIP] {
            let (rigid, _) = impulse(model, &inputs, &published(model, club));
            let gained = rigid.mobility() * rigid.impulse();
            let difference = gained - (rigid.relative_after() - rigid.relative_before());
            prop_assert!(difference.norm() < 1e-11 * gained.norm());
        }
    }
}
