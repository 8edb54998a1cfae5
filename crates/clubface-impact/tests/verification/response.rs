//! The response functions: what holds for any coefficients, and limits with known results.

use crate::rigid::Rigid;
use crate::shots::*;
use clubface_impact::Accuracy;
use proptest::prelude::*;

/// Where and when ball and head touch: with zero, at first touch.
const MOTIONS: [&str; 8] = [
    "middle_turn",
    "middle_turned",
    "middle_shift",
    "middle_pushed",
    "end_turn",
    "end_turned",
    "end_shift",
    "end_pushed",
];

/// Coefficients changed at random by up to their own size and one half, in bodies that do not move while they touch.
fn at_rest(places: &[f64], friction: f64) -> Vec<f64> {
    let info = RESPONSE.info();
    let each = info.parameters.iter().zip(places).map(|(p, place)| match p.name {
        name if MOTIONS.contains(&name) => 0.0,
        // The pressure ahead of a ball that rolls turns it as no force at first touch does.
        name if name.starts_with("rolling_") => 0.0,
        "friction" => friction,
        "time" => p.default,
        "half_slip" | "sharpness" => p.default * (0.5 + place),
        "twist_arm" => *place,
        _ => (p.default + (2.0 * place - 1.0) * (p.default.abs() + 0.5)).clamp(p.lower, p.upper),
    });
    each.collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Rounding of the solve. With bodies at rest, the angular momentum is that of the impulse at first touch but for
    /// the lever of friction, which lies on the normal: its part across the normal and the impulse must vanish.
    #[test]
    fn friction_stays_in_its_cone_and_the_impulse_goes_through_the_normal(
        (_, inputs) in any_delivery(),
        places in prop::collection::vec(0.0..=1.0f64, RESPONSE.info().parameters.len()),
        friction in 0.0..=1.0f64,
    ) {
        let parameters = at_rest(&places, friction);
        let outputs = hit(RESPONSE, &inputs, &parameters, Accuracy::Fast);
        let rigid = Rigid::new(RESPONSE, &inputs, &parameters, &outputs);
        let (impulse, normal) = (rigid.impulse(), rigid.touch.normal);
        let pressed = impulse.dot(normal);
        prop_assert!(pressed >= 0.0 && impulse.reject(normal).norm() <= friction * pressed * (1.0 + 1e-9) + 1e-15);
        let torque = rigid.spin_gained() * rigid.touch.ball.inertia;
        prop_assert!(torque.reject(normal).dot(impulse).abs() <= 1e-12 * impulse.norm());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// The laws of every model are tested with rigid faces: here with faces that give, and any coefficients.
    #[test]
    fn the_laws_hold_with_faces_that_give(
        (_, inputs) in any_delivery(),
        time in 20e-6..600e-6f64,
        places in prop::collection::vec(0.0..=1.0f64, RESPONSE.info().parameters.len()),
    ) {
        let inputs = inputs.with(&[("characteristic_time", time)]);
        let each = RESPONSE.info().parameters.iter().zip(&places);
        let parameters: Vec<f64> = each.map(|(p, place)| p.lower + (p.upper - p.lower) * place).collect();
        let outputs = hit(RESPONSE, &inputs, &parameters, Accuracy::Fast);
        let rigid = Rigid::new(RESPONSE, &inputs, &parameters, &outputs);
        prop_assert!(rigid.momentum_error() < 1e-12);
        prop_assert!(rigid.angular_momentum_error() < 1e-11);
        prop_assert!(rigid.energy_lost() > -1e-12 * rigid.energy_before());
    }
}

/// Without friction the ball leaves along the normal of a face that does not turn, and without spin.
#[test]
fn a_ball_without_friction_leaves_along_the_normal_without_spin() {
    let parameters = published_but(RESPONSE, Club::Driver, &[("friction", 0.0)]);
    let plate = simple_head(0.0).with(&[
        ("loft", 0.5),
        ("club_mass", 50.0),
        ("ixx", 1e4),
        ("iyy", 1e4),
        ("izz", 1e4),
    ]);
    let outputs = hit(RESPONSE, &plate, &parameters, Accuracy::Fast);
    assert!((outputs.at("launch") - 0.5).abs() < 1e-6, "{}", outputs.at("launch"));
    assert!(outputs.at("total_spin") < 1e-6, "{}", outputs.at("total_spin"));
}

/// Far beyond the limit of friction the ball slides throughout, and the tangential impulse is friction times the normal
/// one; far below, more friction changes little.
#[test]
fn friction_limits_the_spin_of_a_grazing_impact() {
    let spin = |loft: f64, friction: f64| {
        let parameters = published_but(RESPONSE, Club::Iron, &[("friction", friction)]);
        let inputs = simple_head(0.0).with(&[("loft", loft), ("attack", 0.0)]);
        hit(RESPONSE, &inputs, &parameters, Accuracy::Fast).at("backspin")
    };
    let (half, whole) = (spin(1.2, 0.05), spin(1.2, 0.1));
    assert!((whole / half - 2.0).abs() < 0.1, "{half} {whole}");
    let (much, more) = (spin(0.2, 0.4), spin(0.2, 0.5));
    assert!((more / much - 1.0).abs() < 0.05, "{much} {more}");
}

/// A face that gives returns energy that the ball would lose.
#[test]
fn a_longer_characteristic_time_gives_more_ball_speed() {
    let speed = |time: f64| {
        let inputs = played(Club::Driver).with(&[("characteristic_time", time)]);
        hit(RESPONSE, &inputs, &published(RESPONSE, Club::Driver), Accuracy::Fast).at("ball_speed")
    };
    let speeds = [0.0, 150e-6, 200e-6, 250e-6, 300e-6].map(speed);
    assert!(speeds.windows(2).all(|pair| pair[1] > pair[0]), "{speeds:?}");
}
