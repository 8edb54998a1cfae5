//! Vectors, matrices and attitudes: identities that hold to rounding.

use clubface_math::{Mat3, Quat, Vec3};
use proptest::prelude::*;

/// A dozen roundings of numbers of order ten.
const ROUNDING: f64 = 1e-13;

fn vector() -> impl Strategy<Value = Vec3<f64>> {
    (-2.0..2.0f64, -2.0..2.0f64, -2.0..2.0f64).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn near(a: Vec3<f64>, b: Vec3<f64>, tolerance: f64) -> bool {
    (a - b).norm() <= tolerance * (1.0 + b.norm())
}

fn rows_near(a: Mat3<f64>, b: Mat3<f64>, tolerance: f64) -> bool {
    (0..3).all(|i| near(a.rows[i], b.rows[i], tolerance))
}

fn determinant(m: Mat3<f64>) -> f64 {
    m.rows[0].dot(m.rows[1].cross(m.rows[2]))
}

proptest! {
    #[test]
    fn the_vector_product_is_perpendicular_and_obeys_lagrange(a in vector(), b in vector(), c in vector()) {
        let product = a.cross(b);
        prop_assert!(product.dot(a).abs() < ROUNDING * 10.0 && product.dot(b).abs() < ROUNDING * 10.0);
        // |a x b|^2 = |a|^2 |b|^2 - (a.b)^2, a x (b x c) = b (a.c) - c (a.b).
        let lagrange = a.norm_squared() * b.norm_squared() - a.dot(b).powi(2);
        prop_assert!((product.norm_squared() - lagrange).abs() < 1e-12);
        prop_assert!(near(a.cross(b.cross(c)), b * a.dot(c) - c * a.dot(b), 1e-12));
    }

    #[test]
    fn matrices_of_products_act_as_the_products(a in vector(), b in vector(), c in vector()) {
        prop_assert!(near(Mat3::cross(a) * b, a.cross(b), ROUNDING));
        prop_assert!(near(Mat3::outer(a, b) * c, a * b.dot(c), ROUNDING));
        prop_assert!(near(Mat3::from_columns(a, b, c) * Vec3::new(0.0, 1.0, 0.0), b, 0.0));
    }

    /// Cofactors lose as many digits as the matrix is badly conditioned; the determinant is bounded from below.
    #[test]
    fn a_matrix_times_its_inverse_is_the_identity(a in vector(), b in vector(), c in vector()) {
        let matrix = Mat3::from_rows(a, b, c);
        prop_assume!(determinant(matrix).abs() > 0.1);
        prop_assert!(rows_near(matrix * matrix.inverse(), Mat3::diagonal(1.0), 1e-11));
        prop_assert!(rows_near(matrix.inverse() * matrix, Mat3::diagonal(1.0), 1e-11));
    }

    #[test]
    fn products_are_associative_and_transposed_in_reverse(a in vector(), b in vector(), c in vector()) {
        let (m, n) = (Mat3::from_rows(a, b, c), Mat3::from_rows(c, a, b));
        prop_assert!(near((m * n) * a, m * (n * a), 1e-12));
        prop_assert!(rows_near((m * n).transpose(), n.transpose() * m.transpose(), 1e-12));
    }

    /// Right-handed turns: z turns x into y, x turns y into z, y turns z into x.
    #[test]
    fn rotations_keep_lengths_and_turn_to_the_right_side(angle in -3.0..3.0f64, v in vector()) {
        let turn = angle.sin_cos();
        let (x, y, z) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
        let cases =
            [(Mat3::rotation_x(turn), y, z), (Mat3::rotation_y(turn), z, x), (Mat3::rotation_z(turn), x, y)];
        for (rotation, from, to) in cases {
            prop_assert!(near(rotation * from, from * angle.cos() + to * angle.sin(), ROUNDING));
            prop_assert!(((rotation * v).norm() - v.norm()).abs() < ROUNDING * 10.0);
            prop_assert!((determinant(rotation) - 1.0).abs() < ROUNDING);
        }
    }

    #[test]
    fn the_matrix_of_a_quaternion_is_a_rotation_whatever_its_length(w in -1.0..1.0f64, v in vector()) {
        prop_assume!(w.abs() + v.norm() > 0.1);
        let matrix = Quat { w, v }.matrix();
        prop_assert!(rows_near(matrix * matrix.transpose(), Mat3::diagonal(1.0), 1e-12));
        prop_assert!((determinant(matrix) - 1.0).abs() < 1e-12);
        let longer = Quat { w: w * 3.0, v: v * 3.0 };
        prop_assert!(rows_near(longer.matrix(), matrix, 1e-12));
        prop_assert!(near(matrix * v, v, 1e-12));
    }

    /// dA/dt = A [spin]x for a spin in body axes; the quotient of differences errs by h |spin|^2 / 2.
    #[test]
    fn the_rate_of_an_attitude_is_that_of_its_matrix(w in 0.1..1.0f64, v in vector(), spin in vector()) {
        let start = Quat { w, v };
        let rate = start.rate(spin);
        let h = 1e-6;
        let step = |h: f64| Quat { w: w + rate.w * h, v: v + rate.v * h }.matrix();
        let expected = start.matrix() * Mat3::cross(spin);
        let result = (step(h) + step(-h).scale(-1.0)).scale(0.5 / h);
        prop_assert!(rows_near(result, expected, 1e-8));
        // The length of the quaternion does not change: q . dq/dt = 0.
        prop_assert!((w * rate.w + v.dot(rate.v)).abs() < ROUNDING * 10.0);
    }
}

#[test]
fn a_turn_about_a_fixed_axis_is_the_exponential_of_its_half_angle() {
    let angle = 0.7f64;
    let turn = Quat { w: (angle / 2.0).cos(), v: Vec3::new(0.0, 0.0, (angle / 2.0).sin()) };
    assert!(rows_near(turn.matrix(), Mat3::rotation_z(angle.sin_cos()), 1e-15));
    assert!(rows_near(Quat::<f64>::identity().matrix(), Mat3::diagonal(1.0), 0.0));
}

#[test]
fn a_symmetric_matrix_takes_its_elements_in_the_order_of_an_inertia_tensor() {
    let m = Mat3::symmetric([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    // xx yy zz xy xz yz
    assert_eq!(m.rows.map(Vec3::array), [[1.0, 4.0, 5.0], [4.0, 2.0, 6.0], [5.0, 6.0, 3.0]]);
}
