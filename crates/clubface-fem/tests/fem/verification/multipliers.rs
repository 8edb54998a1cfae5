//! A node pressed on a plane: springs let it sink in by the load over their stiffness, multipliers bring it back.

use crate::support::rows;
use clubface_fem::contact::{
    Contact, ContactMethod, PenaltySprings, Plane, RigidContact, TANGENTIAL_STIFFNESS,
};
use clubface_math::Vec3;

const MASS: f64 = 1e-5;
const STEP: f64 = 5e-7;
/// Into the plane and along it, N.
const LOAD: Vec3<f64> = Vec3 { x: -10.0, y: 2.0, z: 0.0 };

struct Pressed {
    at: Vec3<f64>,
    force: Vec3<f64>,
    /// Work of the load less kinetic energy and what the contact accounts for, J.
    missing: f64,
}

/// A node that rests on the plane for 3 ms under a load that rises within 0.1 ms.
fn press(method: ContactMethod, friction: f64) -> Pressed {
    let mut contact = RigidContact::new(Plane, friction, vec![0], &[MASS], &[1e-6]);
    Contact::<f64>::set_method(&mut contact, method);
    let (mut x, mut v, mut work) = (Vec3::zero(), Vec3::zero(), 0.0);
    let mut force = Vec3::zero();
    for step in 0..6000 {
        contact.assemble(&rows(&[x]), &rows(&[v]), STEP);
        force = contact.forces()[0].vec();
        let load = LOAD * (step as f64 * STEP / 1e-4).min(1.0);
        let before = v;
        v += (load + force) * (STEP / MASS);
        work += load.dot((before + v) * 0.5) * STEP;
        x += v * STEP;
    }
    let energy = contact.energy();
    let kinetic = 0.5 * MASS * v.norm_squared();
    Pressed { at: x, force, missing: work - kinetic - energy.stored - energy.friction - energy.damping }
}

#[test]
fn springs_give_way_and_multipliers_do_not() {
    let stiffness = PenaltySprings::default().stiffness * MASS / (STEP * STEP);
    let sunk = Vec3::new(LOAD.x / stiffness, LOAD.y / (stiffness * TANGENTIAL_STIFFNESS), 0.0);
    let stored = 0.5 * (LOAD.x * sunk.x + LOAD.y * sunk.y);
    let penalty = press(ContactMethod::Penalty, 1.0);
    // Along the face nothing damps the swing that the rise of the load leaves.
    assert!((penalty.at.x - sunk.x).abs() < 1e-6 * sunk.x.abs(), "{:?}", penalty.at);
    assert!((penalty.at.y - sunk.y).abs() < 0.05 * sunk.y, "{:?} {sunk:?}", penalty.at);
    let augmented = press(ContactMethod::AugmentedLagrange, 1.0);
    // After 3 ms, sixty times as long as the multiplier takes.
    assert!(augmented.at.x.abs() < 1e-4 * sunk.x.abs(), "{:?}", augmented.at);
    assert!(augmented.at.y.abs() < 0.05 * sunk.y, "{:?}", augmented.at);
    assert!((augmented.force + LOAD).norm() < 0.02 * LOAD.norm(), "{:?}", augmented.force);
    for result in [penalty, augmented] {
        // The account is kept at half steps, of a load that takes 200 of them to rise.
        assert!(result.missing.abs() < 0.01 * stored, "{} of {stored} J", result.missing);
    }
}

/// A multiplier must not be dropped where its node comes back to the surface: the load would be gone at once.
#[test]
fn a_load_that_falls_is_followed_to_its_end() {
    let mut contact = RigidContact::new(Plane, 0.0, vec![0], &[MASS], &[1e-6]);
    Contact::<f64>::set_method(&mut contact, ContactMethod::AugmentedLagrange);
    let (mut x, mut v) = (Vec3::zero(), Vec3::zero());
    for step in 0..1400 {
        let time = step as f64 * STEP;
        // Up within 0.2 ms, and down to nothing from 0.3 to 0.7 ms.
        let load = LOAD.x * (time / 2e-4).min(1.0).min((7e-4 - time) / 4e-4);
        contact.assemble(&rows(&[x]), &rows(&[v]), STEP);
        let force = contact.forces()[0].vec().x;
        if step > 200 {
            // The spring of a node in front of the surface is behind by the release time, 10 us of a fall in 400 us.
            assert!((force + load).abs() < 0.03 * LOAD.x.abs(), "{force} N against {load} N at {time} s");
        }
        v.x += (load + force) * (STEP / MASS);
        x += v * STEP;
    }
    let sunk = LOAD.x.abs() / (PenaltySprings::default().stiffness * MASS / (STEP * STEP));
    assert!(x.x.abs() < 0.1 * sunk, "{x:?} of {sunk}");
}

#[test]
fn multipliers_do_not_carry_more_than_friction_does() {
    let slid = press(ContactMethod::AugmentedLagrange, 0.1);
    assert!((slid.force.y + 0.1 * slid.force.x).abs() < 1e-9 * LOAD.x.abs(), "{:?}", slid.force);
    // Half the load along the plane is left to accelerate it.
    let accelerated = 0.5 * (LOAD.y - 0.1 * -LOAD.x) / MASS * (2.95e-3_f64).powi(2);
    assert!((slid.at.y - accelerated).abs() < 0.02 * accelerated, "{:?} {accelerated}", slid.at);
}
