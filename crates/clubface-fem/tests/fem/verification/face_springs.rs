//! A rigid head with a mass on a spring behind its face, against the free vibration of two bodies.

use crate::first_touch::touch;
use clubface_fem::contact::{RigidHead, RigidSurface};
use clubface_impact::face_spring::GUIDED_MASS;
use std::f64::consts::TAU;

#[test]
fn a_head_that_was_pushed_vibrates_with_its_period_and_loses_nothing() {
    const STEP: f64 = 1e-7;
    let touch = touch(&[
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
    ]);
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
    let softness = touch.club_mass.recip() + arm.dot(touch.inertia.inverse() * arm);
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
    let stored = energies[0] - 0.5 * touch.club_mass * pushed.velocity.norm_squared();
    let most = energies.iter().map(|energy| (energy - energies[0]).abs()).fold(0.0, f64::max);
    // The head was at rest: one that flies loses some 1e-5 of its energy, as levers leave out how far the face gave.
    assert!(most < 1e-3 * stored, "{most} of {stored}");
}
