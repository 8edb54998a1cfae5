//! The delivered attitude: loft and face angle are what they are called, at any lie and for either hand.

use crate::shots::*;
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::shot::Shot;
use clubface_math::{Mat3, Vec3};
use proptest::prelude::*;

const ROUNDING: f64 = 1e-13;

/// `v` turned about a unit `axis` by `angle` (Rodrigues' formula).
fn turned(v: Vec3<f64>, axis: Vec3<f64>, angle: f64) -> Vec3<f64> {
    v * angle.cos() + axis.cross(v) * angle.sin() + axis * (axis.dot(v) * (1.0 - angle.cos()))
}

const X: Vec3<f64> = Vec3 { x: 1.0, y: 0.0, z: 0.0 };
const Y: Vec3<f64> = Vec3 { x: 0.0, y: 1.0, z: 0.0 };
const Z: Vec3<f64> = Vec3 { x: 0.0, y: 0.0, z: 1.0 };

fn elevation(v: Vec3<f64>) -> f64 {
    v.y.atan2(v.x.hypot(v.z))
}

fn azimuth(v: Vec3<f64>) -> f64 {
    v.z.atan2(v.x)
}

fn attitude(inputs: &Inputs) -> Mat3<f64> {
    FirstTouch::from_inputs(&inputs.0).attitude
}

fn near(a: Vec3<f64>, b: Vec3<f64>) -> bool {
    (a - b).norm() < ROUNDING
}

/// Deliveries of a club of any static loft.
fn delivery() -> impl Strategy<Value = Inputs> {
    (any_delivery(), -0.2..1.0f64, -0.5..0.5f64).prop_map(|((_, inputs), loft, lie)| {
        inputs.with(&[("static_loft", loft), ("lie", lie), ("hand", 1.0)])
    })
}

proptest! {
    #[test]
    fn dynamic_loft_and_face_angle_hold_at_any_lie(inputs in delivery()) {
        let normal = attitude(&inputs) * X;
        prop_assert!((elevation(normal) - inputs.at("loft")).abs() < ROUNDING);
        prop_assert!((azimuth(normal) - inputs.at("face")).abs() < ROUNDING);
    }

    /// Step by step as the convention says: tilt by the lie from the pose at static loft, yaw back to azimuth 0, turn
    /// about z to the dynamic loft, yaw right by the face angle.
    #[test]
    fn the_attitude_follows_the_convention_step_by_step(inputs in delivery(), v in -1.0..1.0f64) {
        let vector = Vec3::new(v, 0.3, -0.5);
        let tilted = |u: Vec3<f64>| turned(turned(u, Z, inputs.at("static_loft")), X, -inputs.at("lie"));
        let normal = tilted(X);
        let delivered = |u: Vec3<f64>| {
            // A positive turn about y takes x to -z, that is to the left.
            let square = turned(tilted(u), Y, azimuth(normal));
            let raised = turned(square, Z, inputs.at("loft") - elevation(normal));
            turned(raised, Y, -inputs.at("face"))
        };
        prop_assert!(near(attitude(&inputs) * vector, delivered(vector)));
    }

    #[test]
    fn the_attitude_is_a_rotation(inputs in delivery()) {
        let a = attitude(&inputs);
        let unity = a * a.transpose();
        for (row, unit) in unity.rows.iter().zip([X, Y, Z]) {
            prop_assert!(near(*row, unit));
        }
        prop_assert!(a.rows[0].dot(a.rows[1].cross(a.rows[2])) > 0.0);
    }

    /// Lie is the tilt about the axis to the target, so it raises the toe end of the leading edge.
    #[test]
    fn a_toe_up_lie_raises_the_toe(inputs in delivery(), lie in 0.01..0.3f64) {
        let toe_height = |lie: f64| (attitude(&inputs.with(&[("lie", lie), ("face", 0.0)])) * Z).y;
        prop_assert!(toe_height(lie) > 0.0 && toe_height(-lie) < 0.0 && toe_height(0.0).abs() < ROUNDING);
    }

    #[test]
    fn the_clubhead_moves_along_its_path_and_attack_angle(inputs in delivery()) {
        let velocity = Shot::from_inputs(&inputs.0).delivery.velocity();
        prop_assert!((velocity.norm() - inputs.at("speed")).abs() < 1e-12);
        prop_assert!((elevation(velocity) - inputs.at("attack")).abs() < ROUNDING);
        prop_assert!((azimuth(velocity) - inputs.at("path")).abs() < ROUNDING);
    }

    /// In a short time a closing face turns left, a face that gains loft turns up, a toe that rises goes up.
    #[test]
    fn rates_turn_the_face_to_the_side_they_are_named_after(inputs in delivery(), rate in 1.0..50.0f64) {
        let turn = |name: &str, v: Vec3<f64>| {
            let still = [("closure", 0.0), ("pitch_rate", 0.0), ("lie_rate", 0.0), ("face", 0.0), ("lie", 0.0)];
            let inputs = inputs.with(&still).with(&[(name, rate)]);
            let spin = Shot::from_inputs(&inputs.0).delivery.spin();
            spin.cross(attitude(&inputs) * v)
        };
        prop_assert!(turn("closure", X).z < 0.0);
        prop_assert!(turn("pitch_rate", X).y > 0.0);
        prop_assert!(turn("lie_rate", Z).y > 0.0);
    }

    /// At its static loft, square and level, the club stands as its numbers are given: Table 1 is in world axes then.
    #[test]
    fn at_static_loft_the_clubhead_stands_as_its_table_says(loft in -0.2..1.0f64) {
        let inputs = shot(Club::Driver).with(&[("static_loft", loft), ("loft", loft)]);
        let touch = FirstTouch::from_inputs(&inputs.0);
        let lever = touch.attitude * touch.lever;
        prop_assert!(near(lever, Vec3::new(inputs.at("cg_x"), inputs.at("cg_y"), inputs.at("cg_z"))));
        let inertia = touch.attitude * (touch.head.inertia * touch.attitude.transpose());
        let table = [["ixx", "ixy", "ixz"], ["ixy", "iyy", "iyz"], ["ixz", "iyz", "izz"]];
        for (row, names) in inertia.rows.iter().zip(table) {
            for (value, name) in row.array().iter().zip(names) {
                prop_assert!((value - inputs.at(name)).abs() < 1e-17 + ROUNDING * inputs.at("iyy"));
            }
        }
    }
}

/// The ball starts just touching the face at the impact point, which lies at toe and high from the face centre.
#[test]
fn the_contact_point_is_the_impact_point_of_the_face() {
    let inputs = shot(Club::Driver).with(&[("toe", 0.02), ("high", -0.01)]);
    let touch = FirstTouch::from_inputs(&inputs.0);
    let point = touch.contact - touch.lever;
    assert!((point.y + 0.01).abs() < 1e-15 && (point.z - 0.02).abs() < 1e-15);
    assert!(touch.face.nearest(point + touch.normal * 0.0213).distance - 0.0213 < 1e-15);
    // The speed of approach is that of the face point along the normal.
    let expected = touch.normal.dot(touch.club_velocity + touch.club_spin.cross(touch.contact));
    assert_eq!(touch.approach(), expected);
}
