//! The face as a surface: nearest point, normal, curvature, limits.

use clubface_impact::face::{Face, curvature, tangents};
use clubface_math::Vec3;
use proptest::prelude::*;

/// A face point of the torus by its angles: `up` along the roll arc, `across` about the bulge axis.
fn torus(face: &Face<f64>, up: f64, across: f64) -> Vec3<f64> {
    let (bulge, roll) = (face.bulge.recip(), face.roll.recip());
    let from_axis = bulge + roll * (up.cos() - 1.0);
    Vec3::new(from_axis * across.cos() - bulge, roll * up.sin(), from_axis * across.sin())
}

/// Nearest face point by trying the eight neighbours in ever smaller steps.
fn nearest_by_search(face: &Face<f64>, p: Vec3<f64>) -> Vec3<f64> {
    let distance = |angles: (f64, f64)| (torus(face, angles.0, angles.1) - p).norm_squared();
    let mut best = (0.0, 0.0);
    let mut step = 0.1;
    while step > 1e-10 {
        let tries = (-1..=1).flat_map(|i| (-1..=1).map(move |j| (f64::from(i), f64::from(j))));
        let result = tries
            .map(|(i, j)| (best.0 + i * step, best.1 + j * step))
            .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
            .unwrap();
        if distance(result) < distance(best) {
            best = result;
        } else {
            step *= 0.5;
        }
    }
    torus(face, best.0, best.1)
}

fn curved() -> impl Strategy<Value = Face<f64>> {
    (0.15..0.6f64, 0.15..0.6f64).prop_map(|(bulge, roll)| Face { bulge: bulge.recip(), roll: roll.recip() })
}

/// Where a ball's centre may be, m.
fn place() -> impl Strategy<Value = Vec3<f64>> {
    (-0.01..0.05f64, -0.03..0.03f64, -0.05..0.05f64).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn near(a: Vec3<f64>, b: Vec3<f64>, tolerance: f64) -> bool {
    (a - b).norm() < tolerance
}

proptest! {
    /// The squared distance (1e-3 m2 or less) is flat at its minimum, so a search cannot place the point better than
    /// the root of its rounding: 1e-8 m along the face for 1e-14 m in the distance.
    #[test]
    fn the_nearest_point_is_the_nearest(face in curved(), p in place()) {
        let nearest = face.nearest(p);
        let result = nearest_by_search(&face, p);
        prop_assert!((nearest.distance.abs() - (result - p).norm()).abs() < 1e-12);
        prop_assert!(near(p - nearest.normal * nearest.distance, result, 1e-7));
        prop_assert!((nearest.normal.norm() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_distance_is_positive_in_front_and_negative_behind(face in curved(), p in place(), depth in 1e-6..5e-3f64) {
        let here = face.nearest(p);
        let on_face = p - here.normal * here.distance;
        prop_assert!((face.nearest(on_face + here.normal * depth).distance - depth).abs() < 1e-14);
        prop_assert!((face.nearest(on_face - here.normal * depth).distance + depth).abs() < 1e-14);
    }

    /// Central differences over 1e-5 m of a distance with rounding 1e-17 and third derivatives up to 1/(0.1 m)^2: 1e-8.
    #[test]
    fn the_normal_is_the_gradient_of_the_distance(face in curved(), p in place()) {
        let h = 1e-5;
        let slope = |step: Vec3<f64>| {
            (face.nearest(p + step * h).distance - face.nearest(p - step * h).distance) / (2.0 * h)
        };
        let gradient = Vec3::new(
            slope(Vec3::new(1.0, 0.0, 0.0)),
            slope(Vec3::new(0.0, 1.0, 0.0)),
            slope(Vec3::new(0.0, 0.0, 1.0)),
        );
        prop_assert!(near(gradient, face.nearest(p).normal, 1e-8));
    }

    /// The mean curvature of a surface is half the divergence of its normal; differences as above, of slopes up to
    /// 1/(0.15 m): 1e-7 1/m. Off the face it is that of the nearest face point.
    #[test]
    fn the_curvature_is_that_of_the_nearest_face_point(face in curved(), p in place()) {
        let nearest = face.nearest(p);
        let on_face = p - nearest.normal * nearest.distance;
        let h = 1e-5;
        let normal = |step: Vec3<f64>| face.nearest(on_face + step * h).normal - face.nearest(on_face - step * h).normal;
        let divergence = (normal(Vec3::new(1.0, 0.0, 0.0)).x
            + normal(Vec3::new(0.0, 1.0, 0.0)).y
            + normal(Vec3::new(0.0, 0.0, 1.0)).z)
            / (2.0 * h);
        prop_assert!((nearest.curvature - divergence / 2.0).abs() < 1e-6);
    }

    #[test]
    fn equal_bulge_and_roll_make_a_sphere(radius in 0.15..0.6f64, p in place()) {
        let face = Face { bulge: radius.recip(), roll: radius.recip() };
        let from_centre = p + Vec3::new(radius, 0.0, 0.0);
        let nearest = face.nearest(p);
        prop_assert!((nearest.distance - (from_centre.norm() - radius)).abs() < 1e-14);
        prop_assert!(near(nearest.normal, from_centre * from_centre.norm().recip(), 1e-14));
        prop_assert!((nearest.curvature * radius - 1.0).abs() < 1e-13);
    }

    /// A point 6 cm away is 1.8e-10 m from the tangent plane of a sphere of 1e7 m.
    #[test]
    fn a_plane_is_the_limit_of_large_radii(p in place()) {
        let plane = Face { bulge: curvature(f64::INFINITY), roll: curvature(f64::INFINITY) };
        let nearest = plane.nearest(p);
        prop_assert_eq!((nearest.distance, nearest.curvature), (p.x, 0.0));
        prop_assert_eq!(nearest.normal, Vec3::new(1.0, 0.0, 0.0));
        let almost = Face { bulge: curvature(1e7), roll: curvature(1e7) }.nearest(p);
        prop_assert!((almost.distance - p.x).abs() < 4e-10 && near(almost.normal, nearest.normal, 1e-8));
    }

    /// Toe and high are measured in the plane tangent at the face centre.
    #[test]
    fn an_impact_point_lies_on_the_face_at_its_offsets(face in curved(), toe in -0.05..0.05f64, high in -0.03..0.03f64) {
        let point = face.point(toe, high);
        prop_assert_eq!((point.z, point.y), (toe, high));
        prop_assert!(point.x <= 0.0 && face.nearest(point).distance.abs() < 1e-15);
        prop_assert!(near(nearest_by_search(&face, point), point, 1e-7));
    }

    /// The face frame of physics: x' outward, y' up the face, z' to the toe, right-handed.
    #[test]
    fn the_tangent_directions_point_up_and_to_the_toe(face in curved(), p in place()) {
        let normal = face.nearest(p).normal;
        let (up, toe) = tangents(normal);
        prop_assert!(up.dot(normal).abs() < 1e-15 && toe.dot(normal).abs() < 1e-15 && up.dot(toe).abs() < 1e-15);
        prop_assert!((up.norm() - 1.0).abs() < 1e-14 && near(normal.cross(up), toe, 1e-14));
        prop_assert!(up.y > 0.0 && toe.z > 0.0 && toe.y.abs() < 1e-15);
    }
}

#[test]
fn a_convex_face_falls_back_on_every_side_of_its_centre() {
    let face = Face { bulge: 1.0 / 0.305, roll: 1.0 / 0.305 };
    // Sagitta of 20 mm on 305 mm.
    let sagitta = 0.305 - (0.305f64.powi(2) - 0.02f64.powi(2)).sqrt();
    for (toe, high) in [(0.02, 0.0), (-0.02, 0.0), (0.0, 0.02), (0.0, -0.02)] {
        let point = face.point(toe, high);
        assert!((point.x + sagitta).abs() < 1e-15);
        let normal = face.nearest(point).normal;
        assert!(normal.z * toe >= 0.0 && normal.y * high >= 0.0 && normal.x < 1.0);
    }
}
