//! The contact law of one node: a damped penalty spring along the normal, and Coulomb friction that sticks.

use super::{ContactEnergy, Resultant};
use clubface_math::{Real, Vec3};

/// How contact springs follow from a node's mass and the time step.
#[derive(Clone, Copy, Debug)]
pub struct Springs {
    /// Stiffness over mass over the square of the time step. A node of stiffness `k` and mass `m` alone is stable up to 4.
    pub stiffness: f64,
    /// Damping over critical damping: nodes that arrive one ring after the other at full speed would ring, and the force with them.
    pub damping: f64,
    /// The time step they refer to, s; if there is none, that of the run.
    pub step: Option<f64>,
}

impl Default for Springs {
    /// About the stiffness with which the surface elements hold their nodes. A stiffer spring lets every ring of nodes that arrives ring the
    /// force (peak 5% higher at 0.25), a softer one delays the contact (reversal of the tangential force 2% later at 0.05).
    fn default() -> Self {
        Self { stiffness: 0.127, damping: 0.4, step: None }
    }
}

/// Tangential stiffness over normal stiffness.
pub const TANGENTIAL_STIFFNESS: f64 = 0.5;

/// A node below the surface of the other side.
pub struct Touch<R> {
    /// Mass that the spring moves, kg.
    pub mass: R,
    /// Share of the node in its surface, m2.
    pub area: f64,
    /// Distance from the other side, m: below zero.
    pub gap: R,
    /// Normal of the other side.
    pub normal: Vec3<R>,
    /// Velocity relative to the other side, m/s.
    pub velocity: Vec3<R>,
}

impl<R: Real> Touch<R> {
    /// Force on the node, N; adds to the sum and to the energies, and renews the force of the tangential spring.
    #[inline(always)]
    pub fn force(
        &self,
        springs: Springs,
        coefficient: R,
        friction: &mut Vec3<R>,
        dt: f64,
        sum: &mut Resultant<R>,
        energy: &mut ContactEnergy,
    ) -> Vec3<R> {
        let reference = springs.step.unwrap_or(dt);
        let stiffness = self.mass * (springs.stiffness / (reference * reference));
        let closing = -self.normal.dot(self.velocity);
        let spring = -(stiffness * self.gap);
        let damper = closing * self.mass * (2.0 * springs.damping * springs.stiffness.sqrt() / reference);
        let pressing = (spring + damper).max(R::zero());
        energy.damping += ((pressing - spring) * closing).re() * dt;
        // Stick: the spring follows the node; slip: it is let out until it carries what friction allows.
        let tangential = stiffness * TANGENTIAL_STIFFNESS;
        let trial = (*friction - self.velocity * (tangential * dt)).reject(self.normal);
        let most = coefficient * pressing;
        let size = trial.norm();
        *friction = trial;
        if size.re() > most.re() {
            *friction = trial * (most / size);
            energy.friction += (most * (size - most) / tangential).re();
        }
        energy.stored += 0.5 * (spring * spring / stiffness + friction.norm_squared() / tangential).re();
        let force = self.normal * pressing + *friction;
        sum.force += force;
        sum.normal += pressing;
        sum.area += self.area;
        force
    }
}
