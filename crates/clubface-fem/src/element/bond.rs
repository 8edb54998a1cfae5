//! Nodes bonded to faces of other elements: springs between a node and the point of a face on which it lies.
//!
//! The force on a node acts at that node on both sides: its opposite is distributed to the corners of the face by the
//! weights of the point, so that momentum and angular momentum balance to rounding.

use super::output::OutputSink;
use super::patch::{Energy, Patch};
use clubface_math::{Real, Row, Vec3};
use std::collections::HashMap;

/// A node on a face of other elements.
#[derive(Clone, Debug)]
pub struct Tie<R> {
    /// The node.
    pub node: u32,
    /// Corners of a triangle of the face.
    pub face: [u32; 3],
    /// Weights of the corners at the node.
    pub weights: [f64; 3],
    /// Stiffness of the spring, N/m.
    pub stiffness: R,
}

/// Some nodes that are bonded to faces.
pub struct BondPatch<R: Real> {
    nodes: Vec<u32>,
    /// With places in `nodes` as nodes.
    ties: Vec<Tie<R>>,
    forces: Vec<Row<R>>,
}

impl<R: Real> BondPatch<R> {
    /// Of nodes that lie on their faces.
    #[must_use]
    pub fn new(ties: &[Tie<R>]) -> Self {
        let (mut nodes, mut places) = (Vec::new(), HashMap::new());
        let mut place = |node: u32| {
            *places.entry(node).or_insert_with(|| {
                nodes.push(node);
                nodes.len() as u32 - 1
            })
        };
        let local =
            |tie: &Tie<R>| Tie { node: place(tie.node), face: tie.face.map(&mut place), ..tie.clone() };
        let ties: Vec<_> = ties.iter().map(local).collect();
        Self { forces: vec![Row::zero(); nodes.len()], nodes, ties }
    }

    /// How far a node is from its point of the face, m.
    fn opening(&self, tie: &Tie<R>, positions: &[Row<R>]) -> Vec3<R> {
        let at = |local: u32| positions[self.nodes[local as usize] as usize].vec();
        let corners = tie.face.iter().zip(tie.weights);
        corners.fold(at(tie.node), |sum, (&corner, weight)| sum + at(corner) * R::from_f64(-weight))
    }
}

impl<R: Real> Patch<R> for BondPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn assemble(&mut self, positions: &[Row<R>], _velocities: &[Row<R>], _dt: f64) {
        self.forces.fill(Row::zero());
        for index in 0..self.ties.len() {
            let tie = &self.ties[index];
            let force = self.opening(tie, positions) * tie.stiffness;
            self.forces[tie.node as usize].add(-force);
            for (&corner, weight) in tie.face.iter().zip(tie.weights) {
                self.forces[corner as usize].add(force * R::from_f64(weight));
            }
        }
    }
    fn cost(&self) -> usize {
        self.ties.len() * 20
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        let energy = |tie: &Tie<R>| 0.5 * (self.opening(tie, positions).norm_squared() * tie.stiffness).re();
        (Energy { strain: self.ties.iter().map(energy).sum(), ..Energy::default() }, (1.0, 1.0))
    }
    fn element_output(&mut self, _positions: &[Row<R>], _sink: &mut OutputSink<'_>) {}
}
