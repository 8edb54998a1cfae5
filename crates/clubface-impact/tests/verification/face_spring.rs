//! The mass behind a face that gives, against its momenta and energy written out.

use crate::shots::*;
use clubface_impact::face_spring::{COMPLIANCE, FaceSpring, GUIDED_MASS};
use clubface_impact::first_touch::{FirstTouch, Motion};
use clubface_impact::guided_mass::GuidedMass;
use clubface_math::Vec3;

fn touch(club: Club, characteristic_time: f64) -> FirstTouch<f64> {
    FirstTouch::from_inputs(&mishit(club, 1.0).with(&[("characteristic_time", characteristic_time)]).0)
}

fn guided(touch: &FirstTouch<f64>) -> GuidedMass<f64> {
    GuidedMass::new(touch.spring, &touch.head_mobility(), touch.contact, touch.normal)
}

/// A motion of the body around the mass, and a speed of the mass in it inwards.
const AROUND: Motion<f64> =
    Motion { velocity: Vec3 { x: 30.0, y: -4.0, z: 7.0 }, spin: Vec3 { x: 12.0, y: -35.0, z: 20.0 } };
const RATE: f64 = 9.0;

#[test]
fn velocities_follow_from_momenta_and_energy_is_half_of_both() {
    for club in CLUBS {
        let touch = touch(club, 250e-6);
        let (guided, inward, arm) = (guided(&touch), -touch.normal, touch.contact.cross(-touch.normal));
        let of_mass = |v: Vec3<f64>| v * GUIDED_MASS;
        let momentum = AROUND.velocity * touch.head.mass + of_mass(inward * RATE);
        let angular = touch.head.inertia * AROUND.spin + of_mass(arm * RATE);
        let at_contact = inward.dot(AROUND.velocity + AROUND.spin.cross(touch.contact));
        let inwards = GUIDED_MASS * (at_contact + RATE);
        let mean = Motion {
            velocity: momentum * touch.head.mass.recip(),
            spin: touch.head.inertia.inverse() * angular,
        };
        let rate = guided.rate(inwards, mean);
        assert!((rate - RATE).abs() < 1e-12 * RATE, "{rate}");
        let recoil = guided.recoil(rate);
        for (result, wanted) in
            [(mean.velocity + recoil.velocity, AROUND.velocity), (mean.spin + recoil.spin, AROUND.spin)]
        {
            assert!((result - wanted).norm() < 1e-12 * wanted.norm(), "{result:?} {wanted:?}");
        }
        // Kinetic energy, by the speeds of its parts: the mass moves with the body and in it.
        let body = 0.5
            * (touch.head.mass * AROUND.velocity.norm_squared()
                + AROUND.spin.dot(touch.head.inertia * AROUND.spin));
        let energy = body + GUIDED_MASS * RATE * at_contact + 0.5 * GUIDED_MASS * RATE * RATE;
        let halves = 0.5 * (momentum.dot(AROUND.velocity) + angular.dot(AROUND.spin) + inwards * RATE);
        assert!((energy - halves).abs() < 1e-12 * energy, "{energy} {halves}");
    }
}

/// So a rigid face gives the same bits as if there were no mass behind it.
#[test]
fn the_mass_behind_a_rigid_face_is_locked() {
    let guided = guided(&touch(Club::Driver, 0.0));
    for momentum in [0.0, 3.0, -1e9] {
        assert_eq!(guided.rate(momentum, AROUND), 0.0);
    }
    let recoil = guided.recoil(guided.rate(5.0, AROUND));
    assert_eq!(
        (AROUND.velocity + recoil.velocity, AROUND.spin + recoil.spin),
        (AROUND.velocity, AROUND.spin)
    );
    assert_eq!(guided.carried(AROUND), 0.0);
}

#[test]
fn compliance_grows_with_the_square_of_the_characteristic_time() {
    for time in [20e-6, 250e-6, 600e-6] {
        let spring = FaceSpring::new(time);
        assert!((spring.stiffness * COMPLIANCE * time * time - 1.0).abs() < 1e-14);
    }
}
