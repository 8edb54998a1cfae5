//! Volume that a ball shares with the face (Caldwell and McPhee, Figure 2) against integration and its limits.

use clubface_impact::models::volumetric::overlap;
use clubface_math::Dual;
use proptest::prelude::*;
use std::f64::consts::PI;

/// Volume of the part of a ball of `radius` within a sphere of `face` radius when they overlap by `depth`: discs along
/// the line of centres, by Simpson's rule on both sides of the plane where the surfaces meet (exact: a disc's area is
/// quadratic in the distance from its centre).
fn by_discs(depth: f64, face: f64, radius: f64) -> f64 {
    let centres = face + radius - depth;
    // From the centre of the face's sphere: where the ball begins, where the surfaces meet, where the sphere ends.
    let meeting = (centres * centres + face * face - radius * radius) / (2.0 * centres);
    let ball = |x: f64| PI * (radius.powi(2) - (x - centres).powi(2));
    let sphere = |x: f64| PI * (face.powi(2) - x * x);
    let simpson = |area: &dyn Fn(f64) -> f64, from: f64, to: f64| {
        (to - from) / 6.0 * (area(from) + 4.0 * area(0.5 * (from + to)) + area(to))
    };
    simpson(&ball, centres - radius, meeting) + simpson(&sphere, meeting, face)
}

proptest! {
    /// Discs lose 1e-16 (0.5 m)^2 in areas of 1e-4 m2.
    #[test]
    fn two_spheres_share_the_volume_of_their_discs(
        depth in 0.5e-3..12e-3f64, face in 0.018..0.6f64, radius in 0.018..0.025f64
    ) {
        let (volume, circle) = overlap(depth, face.recip(), radius);
        prop_assert!((volume / by_discs(depth, face, radius) - 1.0).abs() < 1e-9);
        // The circle lies on both spheres: its radius from the ball's side and from the face's.
        let centres = face + radius - depth;
        let meeting = (centres * centres + face * face - radius * radius) / (2.0 * centres);
        prop_assert!((circle / (face * face - meeting * meeting) - 1.0).abs() < 1e-9);
        prop_assert!((circle / (radius.powi(2) - (centres - meeting).powi(2)) - 1.0).abs() < 1e-9);
    }

    /// pi x^2 (3 R - x)/3 and the circle x (2 R - x).
    #[test]
    fn a_plane_cuts_a_cap_off_the_ball(depth in 1e-6..15e-3f64, radius in 0.018..0.025f64) {
        let (volume, circle) = overlap(depth, 0.0, radius);
        prop_assert!((volume / (PI * depth * depth * (3.0 * radius - depth) / 3.0) - 1.0).abs() < 1e-14);
        prop_assert!((circle / (depth * (2.0 * radius - depth)) - 1.0).abs() < 1e-14);
        // A sphere of 1e6 m is a plane to R/1e6.
        prop_assert!((overlap(depth, 1e-6, radius).0 / volume - 1.0).abs() < 1e-7);
    }

    /// Moving the ball in by dx adds a layer over the circle: dV/dx is the area of overlap seen along the line of
    /// centres.
    #[test]
    fn the_volume_grows_by_the_area_of_the_circle(depth in 1e-4..12e-3f64, curvature in 0.0..8.0f64) {
        let radius = 0.0213;
        let (volume, _) = overlap(Dual::<f64, 1>::variable(depth, 0), Dual::constant(curvature), Dual::constant(radius));
        let (_, circle) = overlap(depth, curvature, radius);
        prop_assert!((volume.tangent[0] / (PI * circle) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn without_penetration_nothing_is_shared() {
    assert_eq!(overlap(0.0, 3.0, 0.0213), (0.0, 0.0));
}
