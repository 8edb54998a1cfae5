//! A body thrown at a rigid plane, and what it does there.

use crate::support::step;
use clubface_fem::contact::{Contact, PenaltySprings, Plane, RigidContact};
use clubface_fem::solve::Structure;
use clubface_math::{Row, Vec3};
use std::collections::VecDeque;

/// What a ball did on a plane through the origin with normal +x.
pub struct Bounce {
    /// Largest mean normal force over a fiftieth of the run, N, and its time, s.
    pub peak: (f64, f64),
    /// Time of contact, s.
    pub contact: f64,
    /// Velocity after, m/s.
    pub velocity: Vec3<f64>,
    /// Angular momentum about the mass centre after, kg m2/s.
    pub angular_momentum: Vec3<f64>,
    /// Largest and smallest force along -y, N, and the time at which it turned, s.
    pub tangential: (f64, f64),
    pub reversal: f64,
    /// Largest error of the balance of energy over the energy at first.
    pub imbalance: f64,
    /// Steps taken.
    pub steps: usize,
}

/// Throws a body at a plane: `surface` its outer nodes with their areas (m2), friction, velocity (m/s), duration (s),
/// contact springs.
pub fn bounce(
    body: &mut Structure<f64>,
    surface: &[u32],
    areas: &[f64],
    friction: f64,
    velocity: Vec3<f64>,
    duration: f64,
    springs: PenaltySprings,
) -> Bounce {
    let mut contact =
        RigidContact::new(Plane, friction, surface.to_vec(), &body.masses, areas).with_springs(springs);
    // Bodies are shorter while they are pressed, and their stable step with them.
    let dt = body.stable_step(60) * 0.7;
    body.velocities.fill(Row::from_vec(velocity));
    let mass: f64 = body.masses.iter().sum();
    let start = 0.5 * mass * velocity.norm_squared();
    let mut bounce = Bounce {
        peak: (0.0, 0.0),
        contact: 0.0,
        velocity,
        angular_momentum: Vec3::zero(),
        tangential: (0.0, 0.0),
        reversal: 0.0,
        imbalance: 0.0,
        steps: (duration / dt) as usize,
    };
    let (mut last, mut window) = (0.0, VecDeque::new());
    for n in 0..bounce.steps {
        let time = n as f64 * dt;
        let measure = n % 50 == 25;
        let (before, stored) =
            if measure { (body.velocities.clone(), body.energy().total()) } else { (vec![], 0.0) };
        step(body, &mut contact, dt);
        let force = contact.resultant();
        window.push_back((force.normal, time));
        if time > window[0].1 + duration / 50.0 {
            window.pop_front();
        }
        let mean = window.iter().map(|(force, _)| force).sum::<f64>() / window.len() as f64;
        if mean > bounce.peak.0 {
            bounce.peak = (mean, time - duration / 100.0);
        }
        if force.normal > 0.0 {
            bounce.contact = time;
        }
        let along = -force.force.y;
        if last > 0.0 && along <= 0.0 && bounce.reversal == 0.0 && time > 0.2 * bounce.contact {
            bounce.reversal = time;
        }
        last = along;
        bounce.tangential = (bounce.tangential.0.max(along), bounce.tangential.1.min(along));
        if measure {
            let kinetic: f64 = body
                .velocities
                .iter()
                .zip(&before)
                .zip(&body.masses)
                .map(|((a, b), m)| 0.5 * m * a.vec().dot(b.vec()))
                .sum();
            let energy = contact.energy();
            let sum = kinetic + stored + energy.stored + energy.friction;
            bounce.imbalance = bounce.imbalance.max((sum / start - 1.0).abs());
        }
    }
    let mut angular = Vec3::zero();
    let kinetics = body.body_motion(0..body.positions.len());
    for ((x, v), m) in body.positions.iter().zip(&body.velocities).zip(&body.masses) {
        angular += (x.vec() - kinetics.centre).cross(v.vec() - kinetics.velocity) * *m;
    }
    Bounce { velocity: kinetics.velocity, angular_momentum: angular, ..bounce }
}
