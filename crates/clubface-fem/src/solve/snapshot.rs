//! A running simulation as its observer sees it.

use super::Simulation;
use clubface_math::{Real, Vec3};

/// How far a run has come.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// Time since first touch, s.
    pub time: f64,
    /// Time to simulate, s; the current time if the run goes on beyond it until the ball has left.
    pub duration: f64,
    /// Steps done.
    pub steps: usize,
}

/// The contact force on a node of the ball.
#[derive(Clone, Copy, Debug)]
pub struct NodeForce<R> {
    /// Position of the node, m.
    pub position: Vec3<R>,
    /// Force on it, N.
    pub force: Vec3<R>,
    /// Part of the ball's undeformed surface that belongs to the node, m2.
    pub area: f64,
}

/// A running simulation at the time of a motion record.
pub struct Snapshot<'a, R: Real> {
    /// How far it has come.
    pub progress: Progress,
    /// Mass centre of the ball, m.
    pub centre: Vec3<R>,
    pub(super) simulation: &'a mut Simulation<R>,
}

impl<R: Real> Snapshot<'_, R> {
    /// Unit vectors at first touch: the face normal, up the face, and to the toe.
    #[must_use]
    pub fn axes(&self) -> [Vec3<f64>; 3] {
        self.simulation.axes
    }

    /// The contact forces on the ball, node by node; only nodes with a force.
    pub fn contact_forces(&self) -> impl Iterator<Item = NodeForce<R>> + '_ {
        let Simulation { contact, structure, ball_nodes, .. } = &*self.simulation;
        let rows = contact.nodes().iter().zip(contact.forces()).enumerate();
        rows.filter_map(move |(index, (&node, row))| {
            let (node, force) = (node as usize, row.vec());
            // Nodes of the contact are never interior nodes, so that their positions are up to date.
            let node_force =
                || NodeForce { position: structure.positions[node].vec(), force, area: contact.area(index) };
            (node < *ball_nodes && force.norm_squared().re() > 0.0).then(node_force)
        })
    }

    /// The whole simulation, with the positions and velocities of all nodes up to date. This takes as long as a few
    /// steps.
    pub fn synchronised(&mut self) -> &mut Simulation<R> {
        self.simulation.structure.synchronise();
        self.simulation
    }
}
