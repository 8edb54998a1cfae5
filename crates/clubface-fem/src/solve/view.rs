//! A run as its watcher sees it.

use super::Impact;
use clubface_math::{Real, Vec3};

/// What a run has reached.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// Time since first touch, s.
    pub time: f64,
    /// Simulated time asked for, s.
    pub duration: f64,
    /// Steps done.
    pub steps: usize,
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

    /// Places (m) of the ball's nodes that the face touches, and forces (N) on them.
    pub fn touches(&self) -> impl Iterator<Item = (Vec3<R>, Vec3<R>)> + '_ {
        let Impact { contact, structure, ball_nodes, .. } = &*self.impact;
        let nodes = contact.nodes().iter().map(|&node| node as usize).zip(contact.forces());
        let of_ball = nodes.filter(|(node, row)| node < ball_nodes && row.vec().norm_squared().re() > 0.0);
        // Nodes of the contact are never away.
        of_ball.map(|(node, row)| (structure.positions[node].vec(), row.vec()))
    }

    /// All of it, every node where it is: takes as long as some steps.
    pub fn whole(&mut self) -> &mut Impact<R> {
        self.impact.structure.settle();
        self.impact
    }
}
