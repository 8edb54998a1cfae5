//! Elementary functions against values computed to 90 digits (mpmath) and, over their ranges, against the standard
//! library, whose functions are within one unit in the last place.

// The tables show every number as it was computed.
#![allow(clippy::approx_constant)]

use clubface_math::elementary::tanh_ratio;
use clubface_math::{Dual, Scalar};
use proptest::prelude::*;

/// Distance in units in the last place of the true value.
fn ulps(result: f64, truth: f64) -> f64 {
    let unit = truth.abs().next_up() - truth.abs();
    (result - truth).abs() / unit
}

/// Rounding of the reduced argument, of the polynomial and of the result may each add up: 2 units.
const FUNCTION_ULPS: f64 = 2.0;

#[test]
fn sine_and_cosine_hold_at_the_borders_of_quadrants() {
    // (x, sin x, cos x): multiples of pi/4 and pi/2 rounded to double, their neighbours, whole numbers near
    // multiples of pi (22, 355, 11), and the far end of the range.
    let table = [
        (1.5707963267948966, 1.0, 6.123233995736766e-17),
        (1.5707963267948963, 1.0, 2.83276944882399e-16),
        (0.7853981633974483, 0.7071067811865475, 0.7071067811865476),
        (0.7853981633974484, 0.7071067811865476, 0.7071067811865475),
        (2.356194490192345, 0.7071067811865476, -0.7071067811865475),
        (3.141592653589793, 1.2246467991473532e-16, -1.0),
        (-1.5707963267948966, -1.0, 6.123233995736766e-17),
        (4.71238898038469, -1.0, -1.8369701987210297e-16),
        (6.283185307179586, -2.4492935982947064e-16, 1.0),
        (1e-300, 1e-300, 1.0),
        (1.0, 0.8414709848078965, 0.5403023058681398),
        (-2.5, -0.5984721441039565, -0.8011436155469337),
        (22.0, -0.008851309290403876, -0.9999608263946371),
        (355.0, -3.014435335948845e-05, -0.999999999545659),
        (11.0, -0.9999902065507035, 0.004425697988050785),
        (81397.09485818475, -1.0, -4.8386943745794146e-14),
        (99999.0, 0.860248280789742, -0.5098753724179009),
    ];
    for (x, sine, cosine) in table {
        let (s, c) = Scalar::sin_cos(x);
        assert!(ulps(s, sine) <= FUNCTION_ULPS, "sin({x}): {s} for {sine}");
        assert!(ulps(c, cosine) <= FUNCTION_ULPS, "cos({x}): {c} for {cosine}");
    }
    assert_eq!(Scalar::sin_cos(0.0), (0.0, 1.0));
}

#[test]
fn the_exponential_holds_across_its_range_and_is_held_at_its_ends() {
    let table = [
        (0.0, 1.0),
        (1.0, 2.718281828459045),
        (-1.0, 0.36787944117144233),
        // Where the whole part of x / ln 2 changes.
        (0.34657359027997264, 1.414213562373095),
        (0.3465735902799727, 1.4142135623730951),
        (-0.34657359027997264, 0.7071067811865476),
        (1e-17, 1.0),
        (-1e-09, 0.999999999),
        (10.5, 36315.502674246636),
        (-36.7, 1.1518409493076097e-16),
        (-100.25, 2.897198083210148e-44),
        (300.3, 2.6220013776845454e+130),
        (699.9, 9.177151136957067e+303),
        (-699.9, 1.0896627777796162e-304),
    ];
    for (x, truth) in table {
        assert!(ulps(Scalar::exp(x), truth) <= FUNCTION_ULPS, "exp({x}): {} for {truth}", Scalar::exp(x));
    }
    for (beyond, end) in [(1e9, 700.0), (f64::INFINITY, 700.0), (-1e9, -700.0), (f64::NEG_INFINITY, -700.0)] {
        assert_eq!(Scalar::exp(beyond), Scalar::exp(end));
    }
}

#[test]
fn the_angle_of_a_point_holds_in_every_octant_and_on_every_axis() {
    let table = [
        (1.0, 1.0, 0.7853981633974483),
        // Where the rational approximation switches its argument.
        (0.66, 1.0, 0.583373006993856),
        (0.6600000000000001, 1.0, 0.5833730069938561),
        (1.0, 0.66, 0.9874233198010407),
        (-1.0, 1.0, -0.7853981633974483),
        (1.0, -1.0, 2.356194490192345),
        (-1.0, -1.0, -2.356194490192345),
        (-0.1, -2.0, -3.0916342578678506),
        (1e-10, 1.0, 1e-10),
        (3.0, 1e-12, 1.5707963267945633),
        (1e-20, -1.0, std::f64::consts::PI),
        (0.3, -0.2, 2.1587989303424644),
        (5.0, 7.0, 0.6202494859828215),
        (-123.0, 4.5, -1.5342272708813551),
    ];
    for (y, x, truth) in table {
        let result = Scalar::atan2(y, x);
        assert!(ulps(result, truth) <= FUNCTION_ULPS, "atan2({y}, {x}): {result} for {truth}");
    }
    for (y, x) in [(0.0, 1.0), (1.0, 0.0), (-1.0, 0.0), (0.0, -1.0)] {
        assert_eq!(Scalar::atan2(y, x), f64::atan2(y, x), "atan2({y}, {x})");
    }
    assert_eq!(Scalar::atan2(0.0, 0.0), 0.0);
}

/// The series that is used at rest leaves out a term below 4e-15, the quotient loses about `1/z` of the last place to
/// cancellation (z = 0.01 at the switch): 1e-14 relative, and as much across the switch.
#[test]
fn the_friction_factor_is_smooth_through_rest_and_across_its_switch() {
    let table = [
        (4.0, 0.0, 4.0),
        (4.0, 1e-30, 4.0),
        (4.0, 1e-06, 3.999978666803199),
        (4.0, 0.000624999, 3.98671980616193),
        (4.0, 0.000625001, 3.9867197638345355),
        (4.0, 0.01, 3.7994896225522488),
        (4.0, 1.0, 0.999329299739067),
        (100.0, 9.99999e-07, 99.66799495563859),
        (100.0, 1.000001e-06, 99.66799429427304),
        (4.27, 400.0, 0.05),
        (100.0, 900.0, 0.03333333333333333),
    ];
    for (c, w, truth) in table {
        let result: f64 = tanh_ratio(c, w);
        assert!((result / truth - 1.0).abs() < 1e-14, "c {c}, w {w}: {result} for {truth}");
    }
}

/// d/dw of tanh(c sqrt w)/sqrt w = (c sqrt w sech^2(c sqrt w) - tanh(c sqrt w))/(2 w^1.5); -c^3/3 at rest. The slope
/// of the first term the series leaves out, 6 (21844/6081075) z^5, is 6.5e-12 of it at the switch.
#[test]
fn the_slope_of_the_friction_factor_is_exact_down_to_rest() {
    let at_rest = tanh_ratio(Dual::<f64, 1>::constant(4.0), Dual::variable(0.0, 0));
    assert!((at_rest.tangent[0] / (-64.0 / 3.0) - 1.0).abs() < 1e-15);
    for z in [0.0099, 0.0101, 0.05, 0.5, 3.0, 40.0f64] {
        let c = 4.0f64;
        let w = z / (c * c);
        let x = z.sqrt();
        let truth = (x / x.cosh().powi(2) - x.tanh()) / (2.0 * w.powf(1.5));
        let result = tanh_ratio(Dual::<f64, 1>::constant(c), Dual::variable(w, 0)).tangent[0];
        assert!((result / truth - 1.0).abs() < 1e-11, "z {z}: {result} for {truth}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn sine_and_cosine_agree_with_the_standard_library(near in -100.0..100.0f64, far in -1e5..1e5f64) {
        for x in [near, far] {
            let (sine, cosine) = Scalar::sin_cos(x);
            prop_assert!(ulps(sine, x.sin()) <= FUNCTION_ULPS, "{} {}", sine, x.sin());
            prop_assert!(ulps(cosine, x.cos()) <= FUNCTION_ULPS, "{} {}", cosine, x.cos());
        }
    }

    #[test]
    fn the_exponential_agrees_with_the_standard_library(x in -700.0..700.0f64) {
        prop_assert!(ulps(Scalar::exp(x), x.exp()) <= FUNCTION_ULPS, "{} {}", Scalar::exp(x), x.exp());
    }

    /// A quarter, half or whole turn is added with one more rounding: 2 units.
    #[test]
    fn the_angle_agrees_with_the_standard_library(y in -3.0..3.0f64, x in -3.0..3.0f64) {
        let truth = f64::atan2(y, x);
        prop_assert!(ulps(Scalar::atan2(y, x), truth) <= FUNCTION_ULPS, "{} {}", Scalar::atan2(y, x), truth);
    }

    /// exp(p ln x): an error of half a unit in p ln x <= 37 costs up to 37 units of the result.
    #[test]
    fn powers_agree_with_the_standard_library(x in 1e-4..1e4f64, power in -4.0..4.0f64) {
        let truth = f64::powf(x, power);
        prop_assert!((Scalar::powf(x, power) / truth - 1.0).abs() < 1e-14);
    }
}
