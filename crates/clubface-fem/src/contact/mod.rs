//! Contact of the ball with a face, rigid or deformable.

mod deformable;
mod grooves;
mod penalty;
mod rigid;
mod rigid_head;
mod search_interval;
mod surface;

pub use deformable::{BallSide, DeformableContact, FaceSide};
pub use grooves::Grooves;
pub use penalty::{
    ContactMethod, NodeState, PenaltyContact, PenaltySprings, Penetration, TANGENTIAL_STIFFNESS,
};
pub use rigid::{Plane, RigidContact, RigidSurface};
pub use rigid_head::RigidHead;
pub use search_interval::SearchIntervals;
pub use surface::{Beyond, Normals, Projection, Surface};

use clubface_impact::first_touch::Motion;
use clubface_math::{Real, Row, Vec3};

/// Energies of a contact, J.
#[derive(Clone, Copy, Debug, Default)]
pub struct ContactEnergy {
    /// Stored in the penalty springs, normal and tangential.
    pub stored: f64,
    /// Turned into heat by sliding.
    pub friction: f64,
    /// Turned into heat by the damping of nodes that arrive at the face.
    pub damping: f64,
    /// Energy of rigid bodies: kinetic, and that of the spring behind a face.
    pub bodies: f64,
}

/// Sum of the contact forces in one step.
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

/// A contact. It exerts forces on nodes, and on rigid bodies of its own, which it moves.
pub trait Contact<R: Real>: Send {
    /// Nodes on which it may exert forces.
    fn nodes(&self) -> &[u32];
    /// Part of the ball's undeformed surface that belongs to a node, m2, by its index in [`Contact::nodes`]; 0 for
    /// other nodes.
    fn area(&self, _index: usize) -> f64 {
        0.0
    }
    /// Chooses the method that keeps nodes out of the other side, if the contact has any.
    fn set_method(&mut self, _method: ContactMethod) {}
    /// Computes the forces for positions (m) at a step and velocities (m/s) half a step before it; moves its bodies on
    /// by `dt` seconds.
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64);
    /// Forces on [`Contact::nodes`], N.
    fn forces(&self) -> &[Row<R>];
    /// Sum of the forces of the last step.
    fn resultant(&self) -> Resultant<R> {
        Resultant::default()
    }
    /// Energies at the last step.
    fn energy(&self) -> ContactEnergy {
        ContactEnergy::default()
    }
    /// Signed distance of a point from the face (m, positive in front of it) and the face's unit normal, for the given
    /// positions of all nodes.
    fn nearest(&self, positions: &[Row<R>], point: Vec3<R>) -> (R, Vec3<R>);
    /// Whether the ball has reached round the edge of the face: nodes under load have passed the edge and lost the
    /// energy of their springs, or have come back below the surface, where their springs act at once.
    fn passed_edge(&self) -> bool {
        false
    }
    /// Motion of a rigid head; none if the head is made of nodes.
    fn head_motion(&self) -> Option<Motion<R>> {
        None
    }
}
