//! Contact of the ball with a face.

mod face;
mod grooves;
mod head;
mod rests;
mod rigid;
mod spring;
mod surface;

pub use face::{BallSide, FaceContact, FaceSide};
pub use grooves::Grooves;
pub use head::RigidHead;
pub use rigid::{Plane, RigidContact, RigidSurface};
pub use spring::{Held, Method, Springs, Touch, TANGENTIAL_STIFFNESS};

use clubface_impact::first_touch::Motion;
use clubface_math::{Real, Row, Vec3};

/// Energies of a contact, J.
#[derive(Clone, Copy, Debug, Default)]
pub struct ContactEnergy {
    /// Stored in the penalty springs, normal and tangential.
    pub stored: f64,
    /// Turned into heat by sliding.
    pub friction: f64,
    /// Turned into heat by the damping of nodes that arrive.
    pub damping: f64,
    /// Kinetic energy of rigid bodies.
    pub bodies: f64,
}

/// What the contact does in one step.
#[derive(Clone, Copy, Debug)]
pub struct Resultant<R> {
    /// Force on the ball, N.
    pub force: Vec3<R>,
    /// Part of it along the face normals, N.
    pub normal: R,
    /// Area of the ball's surface under pressure, m2.
    pub area: f64,
}

impl<R: Real> Default for Resultant<R> {
    fn default() -> Self {
        Self { force: Vec3::zero(), normal: R::zero(), area: 0.0 }
    }
}

/// A contact: it exerts forces on nodes, and on bodies of its own, which it moves.
pub trait Contact<R: Real>: Send {
    /// Nodes it may exert forces on.
    fn nodes(&self) -> &[u32];
    /// Share of a node in the ball's undeformed surface, m2, by its place in [`Contact::nodes`]; 0 beyond the ball's.
    fn area(&self, _index: usize) -> f64 {
        0.0
    }
    /// Keeps nodes out of the other side by another method than springs alone.
    fn keep_out(&mut self, method: Method);
    /// Computes the forces for positions (m) at a step and velocities (m/s) half a step before it; moves its bodies on by `dt` seconds.
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64);
    /// Forces on [`Contact::nodes`], N.
    fn forces(&self) -> &[Row<R>];
    /// Sum of the forces of the last step.
    fn resultant(&self) -> Resultant<R>;
    /// Energies at the last step.
    fn energy(&self) -> ContactEnergy;
    /// Signed distance of a point from the face (m, positive in front of it) and the face's unit normal, for the given positions of all nodes.
    fn nearest(&self, positions: &[Row<R>], point: Vec3<R>) -> (R, Vec3<R>);
    /// Whether the ball has reached round the edge of the face: nodes have passed it while they were pressed, and left behind what their springs had
    /// stored, or have come back below the surface, where springs hold at once.
    fn wrapped(&self) -> bool {
        false
    }
    /// Motion of a rigid head; none if the head is made of nodes.
    fn head(&self) -> Option<Motion<R>>;
}
