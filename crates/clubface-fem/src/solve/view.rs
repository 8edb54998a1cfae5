//! A run as its watcher sees it.

use super::Impact;
use clubface_math::{Real, Vec3};

/// What a run has reached.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// Time since first touch, s.
    pub time: f64,
    /// Simulated time asked for, s; that of now where the run goes on beyond it until the ball has left.
    pub duration: f64,
    /// Steps done.
    pub steps: usize,
}

/// A node of the ball that the face touches.
#[derive(Clone, Copy, Debug)]
pub struct Touched<R> {
    /// Where it is, m.
    pub place: Vec3<R>,
    /// Force on it, N.
    pub force: Vec3<R>,
    /// Its share of the ball's undeformed surface, m2.
    pub area: f64,
}

/// A run at a motion frame.
pub struct View<'a, R> {
    /// What it has reached.
    pub progress: Progress,
    /// Mass centre of the ball, m.
    pub centre: Vec3<R>,
    pub(super) impact: &'a mut Impact<R>,
}

impl<R: Real> View<'_, R> {
    /// The face's normal, up and toe directions at first touch.
    #[must_use]
    pub fn axes(&self) -> [Vec3<f64>; 3] {
        self.impact.axes
    }

    /// The ball's nodes that the face touches.
    pub fn touches(&self) -> impl Iterator<Item = Touched<R>> + '_ {
        let Impact { contact, structure, ball_nodes, .. } = &*self.impact;
        let rows = contact.nodes().iter().zip(contact.forces()).enumerate();
        rows.filter_map(move |(index, (&node, row))| {
            let (node, force) = (node as usize, row.vec());
            // Nodes of the contact are never away.
            let touched =
                || Touched { place: structure.positions[node].vec(), force, area: contact.area(index) };
            (node < *ball_nodes && force.norm_squared().re() > 0.0).then(touched)
        })
    }

    /// All of it, every node where it is: takes as long as some steps.
    pub fn whole(&mut self) -> &mut Impact<R> {
        self.impact.structure.settle();
        self.impact
    }
}
