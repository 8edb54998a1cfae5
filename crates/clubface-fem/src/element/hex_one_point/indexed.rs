//! Elements in any arrangement: the corners of a pack are gathered from the nodes one by one.

use super::constants::{Block, Constants};
use super::element::{on_bases, Hexahedron};
use super::side::{spread, sums, Face};
use super::stress::{Run, Stress};
use super::visitor::Visitor;
use crate::block::BLOCK;
use crate::mesh::CORNERS;
use clubface_math::{Pack, Real, Row, Vec3};
use std::collections::HashMap;

/// Elements in blocks of eight, each knowing its corners.
pub struct Indexed<R> {
    /// Places in the list of nodes, by block, corner and lane.
    corners: Vec<[u32; CORNERS * BLOCK]>,
    positions: Vec<Row<R>>,
    forces: Vec<Row<R>>,
}

impl<R: Real> Indexed<R> {
    /// From elements by their corners; also the nodes, and the element in every lane of the blocks. The last block is
    /// filled up with lanes without an element.
    pub fn new(elements: &[[u32; CORNERS]]) -> (Self, Vec<u32>, Vec<Option<usize>>) {
        let mut nodes = Vec::new();
        let mut place = HashMap::new();
        let blocks = elements.len().div_ceil(BLOCK);
        let mut corners = vec![[0; CORNERS * BLOCK]; blocks];
        for (e, element) in elements.iter().enumerate() {
            for (corner, &node) in element.iter().enumerate() {
                let local = *place.entry(node).or_insert_with(|| {
                    nodes.push(node);
                    nodes.len() as u32 - 1
                });
                corners[e / BLOCK][corner * BLOCK + e % BLOCK] = local;
            }
        }
        let rows = vec![Row::zero(); nodes.len()];
        let lanes = (0..blocks * BLOCK).map(|slot| (slot < elements.len()).then_some(slot)).collect();
        (Self { corners, positions: rows.clone(), forces: rows }, nodes, lanes)
    }

    /// Takes the positions of the nodes.
    fn load(&mut self, positions: &[Row<R>], nodes: &[u32]) {
        for (local, &node) in self.positions.iter_mut().zip(nodes) {
            *local = positions[node as usize];
        }
    }

    /// Forces on the nodes.
    pub fn forces(&self) -> &[Row<R>] {
        &self.forces
    }

    /// Sides of `LANES` elements of a block, from lane `first` on.
    #[inline(always)]
    fn sides<P: Pack<Real = R>>(&self, block: usize, first: usize) -> (Face<P>, Face<P>) {
        let mut x = [Vec3::zero(); CORNERS];
        for corner in 0..CORNERS {
            // SAFETY: `new` makes every entry a place in the list of nodes, as long as `positions`; a block holds
            // eight lanes.
            x[corner] = unsafe { P::gather(&self.positions, &self.corners[block][corner * BLOCK + first..]) };
        }
        (side([x[0], x[1], x[2], x[3]]), side([x[4], x[5], x[6], x[7]]))
    }

    /// Forces of all elements for the positions of their nodes; whether the laws hold for all volumes.
    #[inline(always)]
    pub fn assemble<P: Pack<Real = R>>(
        &mut self,
        positions: &[Row<R>],
        nodes: &[u32],
        constants: &[Block<R>],
        mut stress: Stress<P>,
    ) -> bool {
        let mut run = Run::new();
        self.load(positions, nodes);
        self.forces.fill(Row::zero());
        for block in 0..self.corners.len() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let (low, high) = self.sides::<P>(block, first);
                let constants = Constants::new(&constants[block].0, first);
                let element = Hexahedron::new(&constants, &low, &high);
                run.set(0, element.gradient(&constants), constants.volume());
                stress.compute(&mut run, 1, block, first);
                let (low, high) = element.forces(&constants, &on_bases(&constants, &run.stresses[0]));
                for (bottom, face) in [(0, low), (4, high)] {
                    let (x, y, z) = (spread(face[0]), spread(face[1]), spread(face[2]));
                    for corner in 0..4 {
                        let force = Vec3::new(x[corner], y[corner], z[corner]);
                        let at = (bottom + corner) * BLOCK + first;
                        // SAFETY: as in `sides`; `forces` is as long as `positions`.
                        unsafe { P::scatter_add(&mut self.forces, &self.corners[block][at..], force) };
                    }
                }
            }
        }
        stress.ratios.valid()
    }

    /// Shows every element to `visitor`.
    #[inline(always)]
    pub fn visit<P: Pack<Real = R>, W: Visitor<P>>(
        &mut self,
        positions: &[Row<R>],
        nodes: &[u32],
        constants: &[Block<R>],
        visitor: &mut W,
    ) {
        self.load(positions, nodes);
        for block in 0..self.corners.len() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let (low, high) = self.sides::<P>(block, first);
                let constants = Constants::new(&constants[block].0, first);
                visitor.visit(block, first, &constants, &Hexahedron::new(&constants, &low, &high));
            }
        }
    }
}

#[inline(always)]
fn side<P: Pack>(c: [Vec3<P>; 4]) -> Face<P> {
    [
        sums([c[0].x, c[1].x, c[2].x, c[3].x]),
        sums([c[0].y, c[1].y, c[2].y, c[3].y]),
        sums([c[0].z, c[1].z, c[2].z, c[3].z]),
    ]
}
