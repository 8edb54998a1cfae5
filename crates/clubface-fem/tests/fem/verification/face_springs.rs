//! A rigid head with a mass on a spring behind its face, against the free vibration of two bodies.

use crate::first_touch::touch;
use clubface_fem::contact::{RigidHead, RigidSurface};
use clubface_impact::face_spring::GUIDED_MASS;
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::head_inertia::SpatialMatrix;
use clubface_math::{Mat3, Vec3};
use std::f64::consts::TAU;

const STEP: f64 = 1e-7;

/// A head with all its numbers, struck off centre, with other values besides.
fn head(others: &[(&str, f64)]) -> FirstTouch<f64> {
    let values = [
        ("loft", 0.3),
        ("static_loft", 0.2),
        ("toe", 0.015),
        ("high", -0.008),
        ("club_mass", 0.2),
        ("cg_x", 0.03),
        ("cg_y", 0.004),
        ("ixx", 2.8e-4),
        ("iyy", 5e-4),
        ("izz", 4e-4),
        ("ixy", -0.7e-4),
        ("bulge", 0.3),
        ("roll", 0.3),
        ("characteristic_time", 250e-6),
        ("hand", 1.0),
    ];
    touch(&[&values, others].concat())
}

#[test]
fn a_head_that_was_pushed_vibrates_with_its_period_and_loses_nothing() {
    let touch = head(&[]);
    let mut head = RigidHead::new(&touch);
    let (normal, contact) = (touch.normal, touch.contact);
    let before = head.velocity(contact);
    head.apply_force(-normal * 1e6, contact);
    head.advance(STEP);
    let pushed = head.motion();
    // All of the force goes to the mass first, which moves with the surface.
    let share = 1e6 * STEP / GUIDED_MASS;
    assert!(((before - head.velocity(contact)).dot(normal) / share - 1.0).abs() < 0.01);

    let arm = contact.cross(normal);
    let softness = touch.head.mass.recip() + arm.dot(touch.head.inertia.inverse() * arm);
    let moving = GUIDED_MASS * (1.0 - GUIDED_MASS * softness);
    let period = TAU * (moving / touch.spring.stiffness).sqrt();
    let (mut crossings, mut energies) = (Vec::new(), Vec::new());
    let mut last = f64::NAN;
    for step in 0..10_000 {
        let swing =
            (head.velocity(contact) - head.motion().velocity - head.motion().spin.cross(contact)).dot(normal);
        if last < 0.0 && swing >= 0.0 {
            crossings.push((f64::from(step) - swing / (swing - last)) * STEP);
        }
        last = swing;
        head.advance(STEP);
        energies.push(head.energy());
    }
    let result = (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64;
    assert!(crossings.len() >= 3, "{crossings:?}");
    assert!((result / period - 1.0).abs() < 2e-3, "{result} {period}");
    assert_eq!(head.motion().velocity, pushed.velocity);
    let stored = energies[0] - 0.5 * touch.head.mass * pushed.velocity.norm_squared();
    let most = energies.iter().map(|energy| (energy - energies[0]).abs()).fold(0.0, f64::max);
    // The head was at rest: one that flies loses some 1e-5 of its energy, as levers leave out how far the face gave.
    assert!(most < 1e-3 * stored, "{most} of {stored}");
}

/// A mass on a mechanism that is rigidly fixed to a head is a part of the head: both move alike under a push, to second order
/// in the step, and keep the energy they had and were given.
#[test]
fn a_head_on_a_rigid_mechanism_moves_as_one_with_its_mass() {
    let free = head(&[("speed", 40.0), ("closure", 30.0), ("pitch_rate", -20.0)]);
    let (mass, place) = (0.03, Vec3::new(-0.03, 0.05, -0.04));
    let about = |mass: f64, point: Vec3<f64>| (Mat3::cross(point) * Mat3::cross(point)).scale(-mass);
    let mut attached = free;
    attached.head.added =
        Some(SpatialMatrix::new(Mat3::diagonal(mass), Mat3::cross(place).scale(-mass), about(mass, place)));
    let total = free.head.mass + mass;
    let centre = place * (mass / total);
    let mut whole = free;
    whole.head.mass = total;
    whole.head.inertia = free.head.inertia + about(mass, place) + about(total, centre).scale(-1.0);
    (whole.lever, whole.contact) = (free.lever - centre, free.contact - centre);
    whole.club_velocity = free.club_velocity + free.club_spin.cross(centre);
    let mut heads = [(RigidHead::new(&attached), Vec3::zero()), (RigidHead::new(&whole), centre)];
    let force = free.normal * -8e3 + Vec3::new(0.0, 1500.0, -900.0);
    let (mut start, mut work) = ([0.0; 2], 0.0);
    for step in 0..5_000 {
        let contact = free.contact + free.club_velocity * (f64::from(step) * STEP);
        for (i, (head, origin)) in heads.iter_mut().enumerate() {
            let point = contact - *origin;
            if i == 0 && step > 0 {
                work += head.velocity(point).dot(force) * STEP;
            }
            head.apply_force(force, point);
            head.advance(STEP);
            if step == 0 {
                start[i] = head.energy();
            }
        }
        let [one, other] = heads.each_ref().map(|(head, origin)| head.velocity(contact - *origin));
        assert!((one - other).norm() < 1e-4 * one.norm(), "step {step}: {one:?} {other:?}");
    }
    let gained = heads.each_ref().map(|(head, _)| head.energy());
    for i in 0..2 {
        let error = (gained[i] - start[i] - work).abs();
        assert!(error < 1e-3 * work.abs(), "{i}: {} and {work}", gained[i] - start[i]);
    }
}
