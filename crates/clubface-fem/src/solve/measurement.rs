//! What can be measured on a structure between steps: motion of bodies, energies, stress and strain.

use super::Structure;
use super::body_motion::BodyMotion;
use crate::element::{Energy, OutputSink};
use crate::moments::{Moments, Nodes, Origin};
use clubface_math::{Real, Row};
use std::ops::Range;

impl<R: Real> Structure<R> {
    /// Gives `sink` stress and strain of every element of the patches whose first node is in `nodes`, with its number
    /// in its mesh.
    pub fn element_output(&mut self, nodes: Range<usize>, sink: &mut OutputSink<'_>) {
        self.synchronise();
        for patch in self.patches.iter_mut().filter(|p| nodes.contains(&(p.nodes()[0] as usize))) {
            patch.element_output(&self.positions, sink);
        }
    }

    /// The most strained element of a patch: its number in its mesh, and the square of the size of its strain. A strain
    /// that is not a number counts as the largest.
    pub fn most_strained(&mut self, patch: usize) -> (usize, f64) {
        self.synchronise();
        let mut worst = (0, -1.0);
        self.patches[patch].element_output(&self.positions, &mut |number, output| {
            let size = output.strain.as_flattened().iter().map(|e| e * e).sum::<f64>();
            let size = if size.is_nan() { f64::INFINITY } else { size };
            if size > worst.1 {
                worst = (number, size);
            }
        });
        worst
    }

    /// Energies of the elements, J, at the current positions.
    pub fn energy(&mut self) -> Energy {
        self.energies().0
    }

    /// Lets every call of [`Structure::integrate`] end with the moments of these nodes, so that
    /// [`Structure::body_motion`] of them needs no synchronisation.
    pub(super) fn track_moments(&mut self, nodes: Range<usize>) {
        self.synchronise();
        self.tracked = nodes;
    }

    /// Whether the nodes of a patch belong to the tracked ones; under the number after the last, the nodes of no patch.
    pub(super) fn tracks(&self, patch: usize) -> bool {
        let nodes = self.patches.get(patch).map_or(&self.boundary_nodes[patch][..], |patch| patch.nodes());
        nodes.first().is_some_and(|&node| self.tracked.contains(&(node as usize)))
    }

    /// Mass, mass centre, velocity and spin of some nodes, at least one.
    pub fn body_motion(&mut self, nodes: Range<usize>) -> BodyMotion<R> {
        if self.interior_loaded && nodes == self.tracked {
            let sum = self.tracked_moments.iter().fold(Moments::zero(), Moments::plus);
            return BodyMotion::from_moments(&sum, &self.moment_origin);
        }
        self.synchronise();
        let origin = self.origin_at(nodes.start);
        let all: Vec<u32> = nodes.map(|node| node as u32).collect();
        let Self { positions, velocities, masses, .. } = self;
        BodyMotion::from_moments(&Nodes { positions, velocities, masses }.moments(&all, origin), &origin)
    }

    /// An origin for moments at a node.
    fn origin_at(&self, node: usize) -> Origin<R> {
        Origin { position: self.positions[node].vec(), velocity: self.velocities[node].vec() }
    }

    /// An origin for the moments of the tracked nodes: at one of them that is not an interior node.
    pub(super) fn origin_of_tracked(&self) -> Origin<R> {
        let node = self.tracked.clone().find(|&node| !self.interior[node]);
        self.origin_at(node.unwrap_or(0))
    }

    /// Kinetic energy, J, from the velocities before a step and those now, after it. This is the kinetic energy that
    /// central differences conserve together with the potential energy at the positions in between.
    pub fn kinetic_energy(&self, before: &[Row<R>]) -> f64 {
        (0..self.masses.len()).map(|node| self.kinetic_energy_of(node, before)).sum()
    }

    /// The same of one node.
    pub(super) fn kinetic_energy_of(&self, node: usize, before: &[Row<R>]) -> f64 {
        0.5 * (self.velocities[node].vec().dot(before[node].vec()) * self.masses[node]).re()
    }
}
