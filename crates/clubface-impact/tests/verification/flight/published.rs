//! Published figures: air, coefficients, carries.

use super::{assert_close, launch, value, YARD};
use clubface_impact::flight::aerodynamics::{drag_coefficient, lift_coefficient};
use clubface_impact::flight::air::{density, pressure_at_altitude, saturation_pressure};

/// PGA Tour averages measured with TrackMan, 2023 (trackman.com/blog/golf/introducing-updated-tour-averages):
/// club, ball speed [mph], launch angle [deg], spin [rpm], height [yd], angle of descent [deg], carry [yd].
const TOUR: [(&str, [f64; 6]); 12] = [
    ("driver", [171.0, 10.4, 2545.0, 35.0, 39.0, 282.0]),
    ("3-wood", [162.0, 9.3, 3663.0, 32.0, 44.0, 249.0]),
    ("5-wood", [156.0, 9.7, 4322.0, 33.0, 48.0, 236.0]),
    ("hybrid", [149.0, 10.2, 4587.0, 31.0, 49.0, 231.0]),
    ("3-iron", [145.0, 10.3, 4404.0, 30.0, 48.0, 218.0]),
    ("4-iron", [140.0, 10.8, 4782.0, 31.0, 49.0, 209.0]),
    ("5-iron", [135.0, 11.9, 5280.0, 33.0, 50.0, 199.0]),
    ("6-iron", [130.0, 14.0, 6204.0, 32.0, 50.0, 188.0]),
    ("7-iron", [123.0, 16.1, 7124.0, 34.0, 51.0, 176.0]),
    ("8-iron", [118.0, 17.8, 8078.0, 33.0, 51.0, 164.0]),
    ("9-iron", [112.0, 20.0, 8793.0, 32.0, 52.0, 152.0]),
    ("pitching wedge", [104.0, 23.7, 9316.0, 32.0, 52.0, 142.0]),
];

/// Found minus published: carry [%], height [yd], angle of descent [deg], as the model gives them at 25 C and sea
/// level. The driver must be within 6 %. The rest is no claim of accuracy but what is so: averages of launches do not
/// make an average carry, weather and ball are unknown, the fit itself misses carries by 2.5 m, and it descends too
/// flat.
const DEVIATIONS: [[f64; 3]; 12] = [
    [3.6, -2.5, -3.1],
    [5.4, -0.2, -4.8],
    [3.9, -0.1, -6.4],
    [-0.4, 0.3, -7.5],
    [2.7, -1.3, -8.3],
    [1.4, -2.7, -8.6],
    [0.6, -3.8, -7.9],
    [-0.7, 0.0, -5.0],
    [-2.8, -1.9, -5.0],
    [-1.9, -1.2, -4.3],
    [-0.7, -0.9, -5.0],
    [-2.5, -1.3, -4.2],
];

/// Tolerance: half the last digit printed above.
#[test]
fn carries_of_the_tour_averages_from_their_published_launch() {
    for ((club, [speed, angle, spin, height, descent, carry]), deviation) in TOUR.into_iter().zip(DEVIATIONS)
    {
        let shot = launch(speed, angle, spin, 0.0);
        let found = [
            100.0 * (value(&shot, "carry") / YARD / carry - 1.0),
            value(&shot, "apex") / YARD - height,
            value(&shot, "landing_angle").to_degrees() - descent,
        ];
        println!(
            "{club:15} carry {carry} yd {:+.1} %, height {height} yd {:+.1}, descent {descent} deg {:+.1}; run {:.1} yd",
            found[0],
            found[1],
            found[2],
            (value(&shot, "total") - value(&shot, "carry")) / YARD,
        );
        assert!(club != "driver" || found[0].abs() < 6.0);
        for i in 0..3 {
            assert!((found[i] - deviation[i]).abs() < 0.051, "{club}: {found:?}, was {deviation:?}");
        }
    }
}

/// Dry air at 15 C and 101325 Pa has 1.2250 kg/m3 in the standard atmosphere (ISO 2533, ideal gas of 28.9644 g/mol);
/// CIPM's air has 28.96546 g/mol and a compressibility of 0.99959, together 0.045 % more; water boils at 100 C.
#[test]
fn air_has_its_published_density() {
    assert!((density(288.15f64, 101_325.0, 0.0) / 1.2250 - 1.000_45).abs() < 5e-5);
    assert!((saturation_pressure(293.15) - 2339.0).abs() < 2.0);
    assert!((saturation_pressure(373.15f64) / 101_325.0 - 1.0).abs() < 0.002);
    // Humid air is lighter; p x_v = h f p_sv, so at 25 C saturation takes away 0.378 * 3169 / 101325 of the density.
    let lighter = 1.0 - density(298.15, 101_325.0, 1.0) / density(298.15, 101_325.0, 0.0);
    assert!((lighter - 0.378 * 3169.0 * 1.004 / 101_325.0).abs() < 2e-4, "{lighter}");
}

/// ISO 2533 tables: 89 875 Pa at 1000 m, 70 109 Pa at 3000 m geopotential altitude.
#[test]
fn pressure_falls_with_altitude_as_in_the_standard_atmosphere() {
    assert_eq!(pressure_at_altitude(0.0), 101_325.0);
    assert!((pressure_at_altitude(1000.0) - 89_875.0).abs() < 2.0);
    assert!((pressure_at_altitude(3000.0) - 70_109.0).abs() < 2.0);
}

/// The values the fit takes at a drive (S = 0.07) and a wedge (S = 0.4), worked by hand.
#[test]
fn coefficients_are_those_of_the_fit() {
    assert_close(drag_coefficient(0.07), 0.191_362_09, 1e-9);
    assert_close(lift_coefficient(0.07), 0.128_986_9, 1e-9);
    assert_close(drag_coefficient(0.4), 0.369_736, 1e-9);
    assert_close(lift_coefficient(0.4), 0.347_8, 1e-9);
}

/// Speed above all: a launch of the wedge leaves the fit before it lands, and says so; the drive stays within.
#[test]
fn a_flight_that_leaves_the_fit_says_so() {
    assert_eq!(value(&launch(171.0, 10.4, 2545.0, 0.0), "outside_fit"), 0.0);
    assert_eq!(value(&launch(104.0, 23.7, 9316.0, 0.0), "outside_fit"), 1.0);
    assert_eq!(value(&launch(171.0, 10.4, 100.0, 0.0), "outside_fit"), 1.0);
}
