//! A node that bounces on the damped contact spring, against the closed form of its motion.

use crate::support::{root, rows};
use clubface_fem::contact::{Contact, PenaltySprings, Plane, RigidContact};
use clubface_math::Vec3;

const MASS: f64 = 1e-5;
/// The step to which the springs refer, s, and how many steps are taken in it, so that the bounce is smooth.
const REFERENCE: f64 = 5e-7;
const FINER: f64 = 400.0;
const SPEED: f64 = 30.0;

/// Share of its speed with which a node leaves, and how long it stays, s.
fn bounce(springs: PenaltySprings) -> [f64; 2] {
    let springs = PenaltySprings { step: Some(REFERENCE), ..springs };
    let mut contact = RigidContact::new(Plane, 0.0, vec![0], &[MASS], &[1e-6]).with_springs(springs);
    let dt = REFERENCE / FINER;
    let (mut x, mut v, mut stayed) = (Vec3::zero(), Vec3::new(-SPEED, 0.0, 0.0), 0.0);
    for _ in 0..(20.0 * FINER) as usize {
        Contact::<f64>::assemble(&mut contact, &rows(&[x]), &rows(&[v]), dt);
        let force = contact.forces()[0].vec();
        stayed += if force.x > 0.0 { dt } else { 0.0 };
        v += force * (dt / MASS);
        x += v * dt;
    }
    let lost = 0.5 * MASS * (SPEED * SPEED - v.norm_squared());
    // What the node has lost is what the contact says that it turned into heat: to the step, as all else.
    let heat = contact.energy().damping;
    assert!((heat - lost).abs() < 0.01 * lost + 1e-9, "{heat} J of {lost} J");
    [v.x / SPEED, stayed]
}

/// The same, of m x" = -(k x + min(c x', k x)) that never pulls, with k = m w^2 and c = 2 zeta m w.
fn exact(springs: PenaltySprings) -> [f64; 2] {
    let (zeta, w) = (springs.damping, springs.stiffness.sqrt() / REFERENCE);
    // While the damper would press more than the spring it presses as much: x = A sin(s t) with s = w sqrt 2, until
    // c x' = k x.
    let s = w * 2.0_f64.sqrt();
    let first = (2.0 * zeta * s / w).atan() / s;
    let (depth, speed) = (SPEED / s * (s * first).sin(), SPEED * (s * first).cos());
    // Then x = e^(-zeta w t) (a cos(d t) + b sin(d t)), until spring and damper cancel.
    let d = w * (1.0 - zeta * zeta).sqrt();
    let (a, b) = (depth, (speed + zeta * w * depth) / d);
    let x = |t: f64| (-zeta * w * t).exp() * (a * (d * t).cos() + b * (d * t).sin());
    let rate =
        |t: f64| -zeta * w * x(t) + (-zeta * w * t).exp() * d * (b * (d * t).cos() - a * (d * t).sin());
    let load = |t: f64| w * x(t) + 2.0 * zeta * rate(t);
    // It turns before it parts: between the deepest place and half a period later.
    let deepest = root(rate, 0.0, std::f64::consts::PI / d);
    let parts = root(load, deepest, deepest + std::f64::consts::PI / d);
    [-rate(parts) / SPEED, first + parts]
}

#[test]
fn a_node_leaves_a_damped_spring_as_the_closed_form_says() {
    for damping in [0.1, 0.4, 0.8] {
        let springs = PenaltySprings { damping, ..PenaltySprings::default() };
        let (result, expected) = (bounce(springs), exact(springs));
        for i in 0..2 {
            // Velocities are half a step old: of the order of w dt, 0.1%.
            assert!((result[i] / expected[i] - 1.0).abs() < 5e-3, "{damping}: {result:?} {expected:?}");
        }
    }
}

#[test]
fn a_node_without_damping_leaves_as_fast_as_it_came_after_half_a_period() {
    let springs = PenaltySprings { damping: 0.0, ..PenaltySprings::default() };
    let [share, stayed] = bounce(springs);
    let half = std::f64::consts::PI * REFERENCE / springs.stiffness.sqrt();
    assert!((share - 1.0).abs() < 2e-3 && (stayed / half - 1.0).abs() < 5e-3, "{share} {}", stayed / half);
}

#[test]
fn the_springs_that_are_used_keep_a_fifth_of_the_energy_of_a_node_that_arrives_alone() {
    // What damping is for. At four tenths of critical damping the closed form keeps 45% of the speed, at half of that
    // 61%.
    let usual = PenaltySprings::default();
    let [share, _] = exact(PenaltySprings { damping: 0.4, ..usual });
    assert!((bounce(usual)[0] / share - 1.0).abs() < 5e-3, "{} {share}", bounce(usual)[0]);
    assert!((share * share - 0.2).abs() < 0.01, "{share}");
}
