//! The curve of a flight and the names of shots.

use super::*;
use clubface_impact::flight::SHOT_SHAPES;
use clubface_impact::flight::shot_shape::{curve, curve_from, shot_shape};
use clubface_math::{Dual, Vec3};

/// A ball that starts along the 3-4-5 triangle's 36.87 degrees and lands 40 m right after 300 m to the target.
#[test]
fn the_curve_is_the_distance_from_the_start_line_to_the_landing() {
    let across = 0.8 * 40.0 - 0.6 * 300.0;
    let place = Vec3::new(300.0, 0.0, 40.0);
    assert_close(curve(Vec3::new(4.0, 7.0, 3.0), place), across, 1e-15);
    assert_close(curve_from(3f64.atan2(4.0), 300f64.hypot(40.0), 40.0), across, 1e-14);
    // One that goes straight up starts along the target line, and its derivatives are finite.
    let up = curve(Vec3::new(Dual::<f64, 1>::variable(0.0, 0), Dual::constant(30.0), Dual::constant(0.0)), {
        Vec3::new(Dual::constant(2.0), Dual::constant(0.0), Dual::constant(-1.5))
    });
    assert!(up.value == -1.5 && up.tangent[0].is_finite());
}

/// Turned about the vertical, start and wind alike, a flight curves as much as before, but for the errors of other steps,
/// which are sized by the components of place and velocity.
#[test]
fn a_shot_that_is_turned_as_a_whole_curves_as_much() {
    let turned = |angle: f64| {
        let mut inputs = launch(150.0, 12.0, 2600.0, 900.0);
        let turn = |x: f64, z: f64| (x * angle.cos() - z * angle.sin(), x * angle.sin() + z * angle.cos());
        (inputs[column("wind_x")], inputs[column("wind_z")]) = (3.0, -2.0);
        for [x, z] in [["velocity_x", "velocity_z"], ["spin_x", "spin_z"], ["wind_x", "wind_z"]] {
            let (x, z) = (column(x), column(z));
            (inputs[x], inputs[z]) = turn(inputs[x], inputs[z]);
        }
        value(&inputs, "curve")
    };
    let straight = turned(0.0);
    assert!(straight > 10.0);
    for angle in [0.1, -0.4, 1.2] {
        assert_close(turned(angle), straight, 1e-6);
    }
}

#[test]
fn a_flight_curves_as_its_launch_direction_carry_and_side_say() {
    let mut inputs = launch(150.0, 12.0, 2600.0, -700.0);
    let azimuth = 0.07f64;
    let level = inputs[3];
    (inputs[3], inputs[5]) = (level * azimuth.cos(), level * azimuth.sin());
    let expected = curve_from(azimuth, value(&inputs, "carry"), value(&inputs, "side"));
    assert_close(value(&inputs, "curve"), expected, 1e-12);
}

/// Every side of every limit, for either hand.
#[test]
fn shots_have_the_names_of_their_start_and_their_curve() {
    let limits = SHOT_SHAPES;
    let starts = [-1.1, 0.0, 1.1].map(|part| part * limits.straight_start);
    let shares = [
        -1.1 * limits.big_curve,
        -1.1 * limits.straight_curve,
        0.0,
        1.1 * limits.straight_curve,
        1.1 * limits.big_curve,
    ];
    for (i, start) in starts.into_iter().enumerate() {
        for (j, share) in shares.into_iter().enumerate() {
            assert_eq!(shot_shape(start, 200.0 * share, 200.0, 1.0), limits.names[i][j]);
            assert_eq!(shot_shape(start, 200.0 * share, 200.0, -1.0), limits.names[2 - i][4 - j]);
        }
    }
    assert_eq!(shot_shape(0.0, 0.0, 200.0, 1.0), "straight shot");
    assert_eq!(shot_shape(0.06, 20.0, 200.0, 1.0), "push slice");
    for (azimuth, carry) in [(f64::NAN, 100.0), (0.0, f64::NAN), (0.0, 0.0)] {
        assert_eq!(shot_shape(azimuth, 1.0, carry, 1.0), "");
    }
}
