//! An impact that is ready to run: a ball about to meet a face.

use super::Structure;
use crate::contact::Contact;
use crate::element::RATIOS;
use crate::error::FemError;
use clubface_impact::first_touch::Motion;
use clubface_math::{Real, Vec3};

/// A ball about to meet a face.
pub struct Simulation<R: Real> {
    /// Ball and, if it deforms, head.
    pub structure: Structure<R>,
    /// The contact between them.
    pub contact: Box<dyn Contact<R>>,
    /// Number of nodes of the ball. They are the first ones.
    pub ball_nodes: usize,
    /// Radius of the ball, m.
    pub radius: f64,
    /// Moment of inertia of the undeformed ball about a diameter, kg m2.
    pub inertia: R,
    /// Unit vectors at the point of first touch: the face normal, up the face, and to the toe.
    pub axes: [Vec3<f64>; 3],
    /// Velocity of the head at first touch, m/s.
    pub head_velocity: Vec3<R>,
    /// For each patch, the name of the part of the ball or head that it belongs to.
    pub parts: Vec<String>,
    /// Stable time step of the ball alone, s.
    pub ball_stable_step: f64,
    /// The clock that times its run, s.
    pub clock: fn() -> f64,
}

impl<R: Real> Simulation<R> {
    /// Checks that every element has a volume for which its law holds, given the smallest and largest volume ratio of
    /// each patch.
    ///
    /// # Errors
    /// [`FemError::ElementLost`] at the given time, us.
    pub(super) fn check_volumes(&mut self, ratios: &[(f64, f64)], microseconds: f64) -> Result<(), FemError> {
        for (patch, ratios) in ratios.iter().enumerate() {
            for ratio in [ratios.0, ratios.1] {
                if !(RATIOS.0..=RATIOS.1).contains(&ratio) {
                    let element = self.structure.most_strained(patch).0;
                    let part = self.parts[patch].clone();
                    return Err(FemError::ElementLost { element, part, ratio, microseconds });
                }
            }
        }
        Ok(())
    }

    /// The most strained element of all by its number in the mesh of its body, and the name of its part.
    pub(super) fn most_strained(&mut self) -> (usize, String) {
        let Self { structure, parts, .. } = self;
        let strained = parts.iter().enumerate().map(|(patch, part)| (structure.most_strained(patch), part));
        let worst = strained.max_by(|((_, one), _), ((_, other), _)| one.total_cmp(other));
        worst.map_or((0, String::new()), |((element, _), part)| (element, part.clone()))
    }

    /// Velocity of the ball, and its angular momentum over the inertia of the undeformed ball.
    pub(super) fn ball_motion(&mut self) -> Motion<R> {
        let body = self.structure.body_motion(0..self.ball_nodes);
        Motion { velocity: body.velocity, spin: body.angular_momentum * self.inertia.recip() }
    }

    /// Velocity and angular velocity of the head.
    pub(super) fn head_motion(&mut self) -> Motion<R> {
        self.contact.head_motion().unwrap_or_else(|| {
            let body = self.structure.body_motion(self.ball_nodes..self.structure.translations);
            Motion { velocity: body.velocity, spin: body.spin }
        })
    }
}
