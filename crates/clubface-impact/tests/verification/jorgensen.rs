//! Jorgensen's theory with the figures of Roh and Lee (sections 3.1 and 3.2).

use crate::rigid::Rigid;
use crate::shots::*;
use clubface_impact::Accuracy;
use clubface_impact::models::jorgensen::compression_factor;
use proptest::prelude::*;

/// Roh and Lee's impact: a ball of 42.8 mm and 46 g, 35 m/s, 11.5 deg; head of 210 g and 1526 g cm2.
fn p2() -> Inputs {
    simple_head(0.04).with(&[
        ("speed", 35.0),
        ("loft", 11.5f64.to_radians()),
        ("club_mass", 0.210),
        ("ixx", 1526e-7),
        ("iyy", 1526e-7),
        ("izz", 1526e-7),
        ("ball_mass", 0.046),
        ("ball_radius", 0.0214),
        ("ball_inertia", 0.4 * 0.046 * 0.0214f64.powi(2)),
    ])
}

fn spin_rpm(factor: f64) -> f64 {
    let model = JORGENSEN;
    let parameters = changed(model, model.info().defaults(), &[("compression_factor", factor)]);
    hit(model, &p2(), &parameters, Accuracy::Fast).at("backspin") / RPM
}

/// 5 f V sin(phi)/(7 R) (Eq. 6). Roh and Lee print 2047 rpm, which their f = 0.92 (two digits) gives to 0.1%.
#[test]
fn the_spin_of_p2_is_that_of_its_compression_factor() {
    let closed_form = 5.0 * 0.92 * 35.0 * 11.5f64.to_radians().sin() / (7.0 * 0.0214) / RPM;
    assert!((spin_rpm(0.92) / closed_form - 1.0).abs() < 1e-12);
    assert!((spin_rpm(0.92) - 2047.0).abs() < 2.0, "{}", spin_rpm(0.92));
}

/// Roh and Lee's ball leaves with 5.15 m/s along the face and would spin with 2298 rpm if it rolled: v/R, three digits
/// given.
#[test]
fn a_rolling_ball_spins_with_its_velocity_along_the_face_over_its_radius() {
    let left = 7.0 / 5.0 * 5.15 / (35.0 * 11.5f64.to_radians().sin());
    assert!((spin_rpm(left) - 2298.0).abs() < 1.0, "{}", spin_rpm(left));
}

/// Eq. 11, as printed to four digits.
#[test]
fn the_compression_factor_follows_from_the_mean_radius() {
    assert!((compression_factor(0.8379) - 0.9476).abs() < 1e-4);
    assert_eq!(compression_factor(1.0), 1.0);
    // Eq. 10: both ways to write the velocity left.
    let ratio = 0.8379;
    assert!((ratio / (0.4 + ratio) - 5.0 / 7.0 * compression_factor(ratio)).abs() < 1e-15);
}

proptest! {
    /// v2 = 5/7 f v1 along the face for a ball without spin, relative to the face point after impact, and spin v2/R about x' cross the sliding
    /// direction (Eqs. 4-6), whatever the impact.
    #[test]
    fn the_ball_keeps_five_sevenths_of_f_of_its_sliding_velocity((_, inputs) in any_delivery(), f in 0.3..1.4f64) {
        let model = JORGENSEN;
        let parameters = changed(model, model.info().defaults(), &[("compression_factor", f)]);
        let outputs = hit(model, &inputs, &parameters, Accuracy::Fast);
        let rigid = Rigid::new(model, &inputs, &parameters, &outputs);
        let normal = rigid.touch.normal;
        // Of a ball that spins already two sevenths of its surface's velocity come back to its centre.
        let (touch, surface) = (&rigid.touch, rigid.relative_before().reject(normal));
        let centre = surface - touch.ball_spin.cross(rigid.ball_arm);
        let left = (centre - (surface - centre) * 0.4) * (f * 5.0 / 7.0);
        let spin = normal.cross(left) * touch.ball.radius.recip() + normal * normal.dot(touch.ball_spin);
        prop_assert!((rigid.ball_spin - spin).norm() < 1e-12 * (1.0 + spin.norm()));
        prop_assert!(rigid.momentum_error() < 1e-12);
        // The normal part is that of the standard model.
        let standard = hit(STANDARD, &inputs, &STANDARD.info().defaults(), Accuracy::Fast);
        let standard = Rigid::new(STANDARD, &inputs, &[], &standard);
        let difference = (rigid.ball_velocity - standard.ball_velocity).dot(normal);
        prop_assert!(difference.abs() < 1e-11);
        // Relative to the face point, which moves after impact as in the standard model.
        let face_point = standard.club_velocity + standard.club_spin.cross(standard.touch.contact);
        prop_assert!(((rigid.ball_velocity - face_point).reject(normal) - left).norm() < 1e-11);
    }
}
