//! Friction of a rigid sphere: sticking on the springs of the contact, and rolling at last.

use crate::support::{SPRING, rows};
use clubface_fem::contact::{Contact, RigidContact, RigidSurface, TANGENTIAL_STIFFNESS};
use clubface_impact::first_touch::Motion;
use clubface_math::Vec3;

const RADIUS: f64 = 0.02;
const MASS: f64 = 0.045;
const INERTIA: f64 = 0.4 * MASS * RADIUS * RADIUS;
/// Stiffness of the contact, N/m.
const STIFFNESS: f64 = 1e6;
/// Fine enough for an error of 1e-4 in half a swing of 670 us.
const STEP: f64 = 1e-6;

/// A homogeneous sphere above the plane x = 0, under a steady acceleration towards it (m/s2).
struct Sphere {
    height: f64,
    velocity: Vec3<f64>,
    spin: Vec3<f64>,
    pressed: f64,
    force: Vec3<f64>,
}

impl RigidSurface<f64> for Sphere {
    fn nearest(&self, _point: Vec3<f64>) -> (f64, Vec3<f64>) {
        (self.height - RADIUS, Vec3::new(-1.0, 0.0, 0.0))
    }
    fn velocity(&self, _point: Vec3<f64>) -> Vec3<f64> {
        self.velocity + self.spin.cross(Vec3::new(-RADIUS, 0.0, 0.0))
    }
    fn apply_force(&mut self, force: Vec3<f64>, _point: Vec3<f64>) {
        self.force += force;
    }
    fn advance(&mut self, dt: f64) {
        self.velocity += self.force * (dt / MASS) + Vec3::new(-self.pressed * dt, 0.0, 0.0);
        self.spin += Vec3::new(-RADIUS, 0.0, 0.0).cross(self.force) * (dt / INERTIA);
        self.force = Vec3::zero();
        self.height += self.velocity.x * dt;
    }
    fn energy(&self) -> f64 {
        0.0
    }
    fn motion(&self) -> Motion<f64> {
        Motion { velocity: self.velocity, spin: self.spin }
    }
}

/// Velocities along the plane, one a step, of a sphere that comes with `velocity` and presses on one node at rest.
fn meet(friction: f64, velocity: Vec3<f64>, pressed: f64, steps: usize) -> (Vec<f64>, Motion<f64>) {
    let sphere = Sphere { height: RADIUS, velocity, spin: Vec3::zero(), pressed, force: Vec3::zero() };
    let mass = STIFFNESS * STEP * STEP / SPRING.stiffness;
    let mut contact = RigidContact::new(sphere, friction, vec![0], &[mass], &[0.0]).with_springs(SPRING);
    let node = rows(&[Vec3::zero()]);
    let mut along = vec![];
    for _ in 0..steps {
        contact.assemble(&node, &node, STEP);
        along.push(contact.surface.velocity.y);
    }
    (along, contact.surface.motion())
}

#[test]
fn sticking_swings_on_the_tangential_spring() {
    // Half a swing across the face, w = sqrt(k/m); along it the point of contact swings with w sqrt(7/2 of the ratio of
    // the stiffnesses).
    let (fall, along) = (5.0, 1.0);
    let (_, after) = meet(100.0, Vec3::new(-fall, along, 0.0), 0.0, 1000);
    let swing = (std::f64::consts::PI * (3.5 * TANGENTIAL_STIFFNESS).sqrt()).cos();
    let expected = along * (1.0 - 2.0 / 7.0 * (1.0 - swing));
    // The end of contact falls between steps.
    assert!((after.velocity.x / fall - 1.0).abs() < 5e-3, "{after:?}");
    assert!((after.velocity.y / expected - 1.0).abs() < 5e-3, "{after:?} {expected}");
}

#[test]
fn a_pressed_sphere_ends_up_rolling_with_five_sevenths() {
    // It slides for 2 v / (7 mu g), then sticks; what swings on in the tangential spring averages out.
    let (friction, along, pressed) = (0.3, 7.0, 1000.0);
    let slides = (2.0 * along / (7.0 * friction * pressed) / STEP) as usize;
    let (velocities, _) = meet(friction, Vec3::new(0.0, along, 0.0), pressed, 3 * slides);
    let end = &velocities[2 * slides..];
    let mean = end.iter().sum::<f64>() / end.len() as f64;
    assert!((mean / along - 5.0 / 7.0).abs() < 2e-3, "{}", mean / along);
}
