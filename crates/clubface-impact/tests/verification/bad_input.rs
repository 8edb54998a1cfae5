//! Every fault names the input, its value and what is allowed.

use crate::shots::*;
use clubface_impact::Accuracy;
use clubface_impact::check::{check, check_parameters, unseparated};
use clubface_impact::fault::shown;
use clubface_impact::sensitivity::sensitivity;
use clubface_impact::shot::{INPUT_COUNT, INPUTS};
use proptest::prelude::*;

/// The fault that a driver's shot with these values has.
fn fault(values: &[(&str, f64)]) -> (String, String) {
    let error = check(&played(Club::Driver).with(values).0).unwrap_err();
    (error.input.to_owned(), error.message)
}

fn assert_fault(values: &[(&str, f64)], input: &str, message: &str) {
    assert_eq!(fault(values), (input.to_owned(), message.to_owned()));
}

#[test]
fn good_shots_pass() {
    for club in CLUBS {
        assert_eq!(check(&played(club).0), Ok(()));
        assert_eq!(check(&shot(club).with(&[("hand", -1.0)]).0), Ok(()));
    }
}

#[test]
fn a_number_that_is_not_finite_is_named_whatever_it_is() {
    for input in INPUTS {
        let values = [(f64::NAN, "NaN"), (f64::INFINITY, "inf"), (f64::NEG_INFINITY, "-inf")];
        for (value, text) in values {
            let flat =
                (input.quantity.name == "bulge" || input.quantity.name == "roll") && value == f64::INFINITY;
            if flat {
                assert_eq!(check(&played(Club::Driver).with(&[(input.quantity.name, value)]).0), Ok(()));
            } else {
                assert_fault(
                    &[(input.quantity.name, value)],
                    input.quantity.name,
                    &format!("{text} must be a finite number"),
                );
            }
        }
    }
}

/// Beyond these sizes arithmetic overflows, and no club or ball is there.
#[test]
fn sizes_of_no_club_or_ball_are_refused() {
    for name in ["cg_x", "ixy", "club_mass", "ball_radius", "roll"] {
        assert_fault(&[(name, 2e12)], name, "2e12 must be within +-1e12; is the unit right?");
    }
    for name in ["club_mass", "ball_mass", "ball_inertia", "bulge"] {
        assert_fault(&[(name, 5e-13)], name, "5e-13 must be at least 1e-12; is the unit right?");
    }
}

#[test]
fn a_face_gives_as_faces_do_and_less_than_the_head_weighs() {
    for time in [0.0, 20e-6, 600e-6] {
        assert_eq!(check(&played(Club::Driver).with(&[("characteristic_time", time)]).0), Ok(()));
    }
    for (time, text) in [(-1e-6, "-1e-6"), (1.9e-5, "1.9e-5"), (6.1e-4, "0.00061")] {
        let allowed = format!("{text} s must be 0 (a rigid face) or from 20e-6 to 600e-6 s");
        assert_fault(&[("characteristic_time", time)], "characteristic_time", &allowed);
    }
    let (input, message) = fault(&[("characteristic_time", 2.5e-4), ("club_mass", 0.0125)]);
    assert_eq!(input, "characteristic_time");
    assert!(message.contains("in a corner of this one the head acts like"), "{message}");
}

#[test]
fn a_face_must_reach_the_corners_of_its_outline() {
    for (name, value) in [("bulge", 0.05), ("roll", 0.02)] {
        let (input, message) = fault(&[(name, value)]);
        assert_eq!(input, "bulge");
        for text in [&format!("{value} m"), "0.105 m x 0.055 m", "larger radii or a smaller outline"] {
            assert!(message.contains(text), "{message}");
        }
    }
    assert_eq!(check(&played(Club::Driver).with(&[("bulge", 0.06), ("roll", 0.15)]).0), Ok(()));
}

#[test]
fn masses_and_sizes_must_be_positive() {
    for (unit, names) in [
        ("m/s", &["speed"][..]),
        ("kg", &["club_mass", "ball_mass"]),
        ("m", &["bulge", "roll", "face_width", "face_height", "ball_radius"]),
        ("kg m2", &["ball_inertia"]),
    ] {
        for name in names {
            assert_fault(&[(name, 0.0)], name, &format!("0 must be above 0 {unit}"));
            assert_fault(&[(name, -0.25)], name, &format!("-0.25 must be above 0 {unit}"));
        }
    }
}

#[test]
fn a_loft_of_95_degrees_is_refused() {
    for (degrees, text) in [(95.0f64, "95"), (-95.0, "-95"), (80.1, "80.1")] {
        let value = degrees.to_radians();
        assert_fault(&[("loft", value)], "loft", &format!("{text} deg dynamic loft must be within +-80 deg"));
        let message = format!("{text} deg must be within +-80 deg");
        assert_fault(&[("static_loft", value)], "static_loft", &message);
    }
    assert_eq!(check(&played(Club::Driver).with(&[("loft", 79.9f64.to_radians())]).0), Ok(()));
}

#[test]
fn angles_beyond_a_right_angle_are_refused() {
    for name in ["attack", "path", "face", "lie"] {
        assert_fault(&[(name, 100f64.to_radians())], name, "100 deg must be within +-90 deg");
        assert_fault(&[(name, -100f64.to_radians())], name, "-100 deg must be within +-90 deg");
    }
}

/// 240 mph in m/s is no golf swing, and 2400 deg/s is 42 rad/s: the likely fault is a unit.
#[test]
fn speeds_and_rates_in_a_wrong_unit_are_asked_about() {
    assert_fault(&[("speed", 240.0)], "speed", "240 must be at most 150 m/s; is the unit right?");
    for name in ["closure", "pitch_rate", "lie_rate"] {
        assert_fault(&[(name, 2400.0)], name, "2400 must be within +-1000 rad/s; is the unit right?");
        assert_fault(&[(name, -2400.0)], name, "-2400 must be within +-1000 rad/s; is the unit right?");
    }
}

#[test]
fn an_impact_outside_the_face_outline_is_refused() {
    let toe = "impact at 60.0 mm is outside the face outline; allowed: +-52.5 mm";
    assert_fault(&[("toe", 0.060)], "toe", toe);
    let high = "impact at -30.0 mm is outside the face outline; allowed: +-27.5 mm";
    assert_fault(&[("high", -0.030)], "high", high);
    assert_eq!(check(&played(Club::Driver).with(&[("toe", 0.0525), ("high", 0.0275)]).0), Ok(()));
}

#[test]
fn a_hand_is_right_or_left() {
    assert_fault(&[("hand", 0.0)], "hand", "0 must be 1 (right-handed) or -1 (left-handed)");
    assert_fault(&[("hand", 2.0)], "hand", "2 must be 1 (right-handed) or -1 (left-handed)");
}

#[test]
fn an_inertia_must_be_that_of_a_body() {
    for (name, value) in [("ixx", -1e-4), ("iyy", 0.0), ("ixy", 1e-3), ("iyz", -6e-4), ("izz", -1e-5)] {
        let (input, message) = fault(&[(name, value)]);
        assert_eq!(input, "ixx");
        let text = format!("{value:.4e}");
        assert!(message.contains(&text) && message.contains("not positive definite"), "{message}");
    }
    // 2843 + 4085 < 9000 g cm2.
    let (input, message) = fault(&[("iyy", 9000e-7)]);
    assert_eq!(input, "ixx");
    assert!(message.contains("yy 9.0000e-4") && message.contains("triangle inequality"), "{message}");
}

#[test]
fn the_moments_of_a_flat_plate_add_up_and_no_body_is_flatter() {
    let plate = |iyy| [("ixx", 1e-4), ("izz", 2e-4), ("iyy", iyy), ("ixy", 0.0), ("ixz", 0.0), ("iyz", 0.0)];
    // 1e-4 + 2e-4 rounds to the number above 3e-4.
    assert_eq!(check(&played(Club::Driver).with(&plate(1e-4 + 2e-4)).0), Ok(()));
    assert_eq!(fault(&plate(3.000_001e-4)).0, "ixx");
}

#[test]
fn a_ball_cannot_have_more_inertia_than_its_mass_at_its_surface() {
    let (input, message) = fault(&[("ball_inertia", 2e-5)]);
    assert_eq!(input, "ball_inertia");
    assert!(message.starts_with("2e-5 kg m2 must not exceed 2/3 m R^2"), "{message}");
}

/// One end of each parameter of each model beyond its bound.
#[test]
fn parameters_outside_their_bounds_are_named_with_the_bounds() {
    for model in every_model() {
        let info = model.info();
        for (i, p) in info.parameters.iter().enumerate() {
            let width = p.upper - p.lower;
            for value in [p.lower - 0.1 * width, p.upper + 0.1 * width, f64::NAN] {
                let mut parameters = info.defaults();
                parameters[i] = value;
                let error = check_parameters(info, &parameters).unwrap_err();
                assert_eq!(error.input, p.name);
                let allowed = format!("{} to {} {}", p.lower, p.upper, p.unit);
                assert_eq!(
                    error.message,
                    format!("parameter of {} is {}; allowed: {allowed}", info.name, shown(value))
                );
            }
            for value in [p.lower, p.upper] {
                let mut parameters = info.defaults();
                parameters[i] = value;
                assert_eq!(check_parameters(info, &parameters), Ok(()));
            }
        }
    }
}

#[test]
fn a_receding_face_is_reported_with_its_speed() {
    let receding = played(Club::Driver).with(&[("attack", -1.2), ("loft", 0.9)]);
    // Head and face centre do not turn: v cos(loft - attack) along the normal, and the driver's face centre is level.
    let approach = receding.at("speed") * (2.1f64).cos();
    for model in every_model() {
        let error = try_hit(model, &receding, &model.info().defaults(), Accuracy::Fast).unwrap_err();
        assert_eq!(error.input, "speed");
        let expected = format!("approach speed {approach:.3} m/s along the face normal); allowed: above 0");
        assert!(error.message.contains(&expected), "{error}");
    }
}

/// The same faults reach whoever asks for a history or for derivatives.
#[test]
fn histories_and_derivatives_check_their_input_as_batches_do() {
    let model = VOLUMETRIC;
    let good = played(Club::Driver);
    let parameters = published(model, Club::Driver);
    let wrong = changed(model, parameters.clone(), &[("friction", 3.0)]);
    let cases = [
        (good.with(&[("toe", 0.2)]), &parameters, "toe"),
        (good.with(&[("attack", -1.2), ("loft", 0.9)]), &parameters, "speed"),
        (good, &wrong, "friction"),
    ];
    for (inputs, parameters, name) in cases {
        let from_history = model.history(&inputs.0, parameters, Accuracy::Fast).unwrap_err();
        let from_derivatives = sensitivity(model, &inputs.0, parameters, &[0], Accuracy::Fast).unwrap_err();
        let from_batch = try_hit(model, &inputs, parameters, Accuracy::Fast).unwrap_err();
        assert_eq!(from_history.input, name);
        assert_eq!((&from_derivatives, &from_batch), (&from_history, &from_history));
        assert!(from_batch.to_string().starts_with(&format!("{name}: ")));
    }
}

#[test]
fn a_contact_that_does_not_end_says_what_to_try() {
    let error = unseparated();
    assert_eq!(error.input, "model");
    assert!(error.message.contains("did not separate") && error.message.contains("accuracy"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Whatever numbers come in: a named fault or finite outputs, never a panic, and never a number from nowhere.
    #[test]
    fn any_numbers_give_a_launch_or_a_named_fault(
        changes in prop::collection::vec((0..INPUT_COUNT, any::<f64>()), 1..4)
    ) {
        let mut inputs = played(Club::Driver);
        for (index, value) in changes {
            inputs.0[index] = value;
        }
        match try_hit(STANDARD, &inputs, &[0.83, 0.0], Accuracy::Fast) {
            Ok(outputs) => {
                prop_assert_eq!(check(&inputs.0), Ok(()));
                let timeless = ["contact_time", "peak_force"].map(output);
                for (i, value) in outputs.0.iter().enumerate().filter(|(i, _)| !timeless.contains(i)) {
                    prop_assert!(value.is_finite(), "{} of {:?}", clubface_impact::launch::OUTPUTS[i].name, inputs);
                }
            }
            Err(error) => {
                prop_assert!(INPUTS.iter().any(|input| input.quantity.name == error.input), "{}", error);
                let says = ["must", "allowed", "positive definite", "principal moment"];
                prop_assert!(says.iter().any(|text| error.message.contains(text)), "{}", error);
            }
        }
    }
}
