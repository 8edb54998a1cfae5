//! What a change of viewpoint changes: turning about the vertical, and the mirror.

use crate::shots::*;
use clubface_impact::{Accuracy, ModelKind};
use clubface_math::Vec3;
use proptest::prelude::*;

/// `v` turned to the right (x towards z) by `angle` about the vertical.
fn to_the_right(v: Vec3<f64>, angle: f64) -> Vec3<f64> {
    let (s, c) = angle.sin_cos();
    Vec3::new(v.x * c - v.z * s, v.y, v.x * s + v.z * c)
}

/// The same swing aimed further right. The rates of loft and lie and the spin of the ball are about world axes, so
/// their axes turn as well; a left-hander's rates are given in the mirror.
fn aimed(inputs: &Inputs, angle: f64) -> Inputs {
    let rates = Vec3::new(-inputs.at("lie_rate"), 0.0, inputs.at("pitch_rate"));
    let rates = to_the_right(rates, angle * inputs.at("hand"));
    let spin = Vec3::new(inputs.at("ball_riflespin"), 0.0, inputs.at("ball_backspin"));
    let spin = to_the_right(spin, angle);
    inputs.with(&[
        ("path", inputs.at("path") + angle),
        ("face", inputs.at("face") + angle),
        ("lie_rate", -rates.x),
        ("pitch_rate", rates.z),
        ("ball_riflespin", spin.x),
        ("ball_backspin", spin.z),
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// In face axes nothing changes but rounding. Impulses keep it (1e-11); the error control of a contact can turn it
    /// into a step of slightly other length, whose effect is bounded by the error of the steps (1e-8 at 1e-9).
    #[test]
    fn aiming_to_the_right_turns_the_launch_to_the_right(
        (club, inputs) in any_delivery(), angle in -0.8..0.8f64
    ) {
        for model in every_model() {
            let parameters = published(model, club);
            let accuracy = if model.info().lanes { Accuracy::Tolerance(1e-9) } else { Accuracy::Fast };
            let straight = hit(model, &inputs, &parameters, accuracy);
            let turned = hit(model, &aimed(&inputs, angle), &parameters, accuracy);
            let tolerance = if model.info().kind == ModelKind::Impulse { 1e-11 } else { 1e-8 };
            for (there, here) in [
                (turned.ball_velocity(), straight.ball_velocity()),
                (turned.ball_spin(), straight.ball_spin()),
                (turned.club_velocity(), straight.club_velocity()),
                (turned.club_spin(), straight.club_spin()),
            ] {
                let difference = there - to_the_right(here, angle);
                prop_assert!(difference.norm() < tolerance * (1.0 + here.norm()), "{}", model.info().name);
            }
            for name in ["launch", "backspin", "sidespin"] {
                let (a, b) = (turned.at(name), straight.at(name));
                prop_assert!((a - b).abs() < tolerance * (1.0 + b.abs()), "{} {}", model.info().name, name);
            }
            prop_assert!((turned.at("azimuth") - straight.at("azimuth") - angle).abs() < tolerance);
        }
    }

    /// Path, face and spin of the ball are in world terms and change sign in the mirror; toe, lie and the rates follow the club. Bit for
    /// bit, since the mirror image is computed as such.
    #[test]
    fn a_left_hander_hits_the_mirror_image((club, inputs) in any_delivery()) {
        let mirrored = inputs.with(&[
            ("hand", -inputs.at("hand")),
            ("path", -inputs.at("path")),
            ("face", -inputs.at("face")),
            ("ball_sidespin", -inputs.at("ball_sidespin")),
            ("ball_riflespin", -inputs.at("ball_riflespin")),
        ]);
        let reversed = ["azimuth", "sidespin", "spin_axis", "velocity_z", "spin_x", "spin_y", "club_velocity_z",
            "club_spin_x", "club_spin_y"];
        for model in every_model() {
            let parameters = published(model, club);
            let one = hit(model, &inputs, &parameters, Accuracy::Fast);
            let mut other = hit(model, &mirrored, &parameters, Accuracy::Fast);
            for name in reversed {
                // Adding 0 makes -0 and 0 the same.
                other.0[output(name)] = 0.0 - other.0[output(name)];
            }
            let zeroed = |o: Outputs| Outputs(o.0.map(|value| value + 0.0)).bits();
            prop_assert_eq!(zeroed(one), zeroed(other), "{}", model.info().name);
        }
    }

    /// Speeds alone set no direction: an impulse is linear in the speed of the club (rates of turning in step).
    #[test]
    fn an_impulse_scales_with_the_speed((club, inputs) in any_delivery(), factor in 0.5..2.0f64) {
        let moving =
            ["speed", "closure", "pitch_rate", "lie_rate", "ball_backspin", "ball_sidespin", "ball_riflespin"];
        let scaled: Vec<_> = moving.into_iter().map(|name| (name, inputs.at(name) * factor))
            .collect();
        for model in [STANDARD, ADJUSTED, SLIP, JORGENSEN] {
            let parameters = published(model, club);
            let one = hit(model, &inputs, &parameters, Accuracy::Fast);
            let other = hit(model, &inputs.with(&scaled), &parameters, Accuracy::Fast);
            prop_assert!((other.ball_velocity() - one.ball_velocity() * factor).norm() < 1e-11);
            prop_assert!((other.ball_spin() - one.ball_spin() * factor).norm() < 1e-9);
            prop_assert!((other.at("smash") - one.at("smash")).abs() < 1e-12);
        }
    }
}

/// For a symmetric head hit in the middle, square and straight, nothing goes sideways: exactly.
#[test]
fn a_symmetric_impact_stays_in_its_plane() {
    for model in every_model() {
        let parameters = published_but(model, Club::Driver, &[("dcg_z", 0.0)]);
        for loft in [0.1, 0.3, 0.6] {
            let outputs = hit(model, &simple_head(0.03).with(&[("loft", loft)]), &parameters, Accuracy::Fast);
            for name in ["velocity_z", "spin_x", "spin_y", "azimuth", "sidespin", "club_velocity_z"] {
                assert_eq!(outputs.at(name), 0.0, "{} {name}", model.info().name);
            }
        }
    }
}
