//! Elements in any arrangement: the corners of a pack are gathered from the nodes one by one.

use super::constants::{Constants, Shapes};
use super::element::{Face, Hexahedron, Visitor, spread, sums};
use super::stress::{RUN, Run, Stress, on_bases};
use crate::block::BLOCK;
use crate::mesh::CORNERS;
use clubface_math::{Pack, Real, Row, Vec3};
use std::collections::HashMap;

/// Elements in blocks of eight, each knowing its corners.
pub struct Indexed<R: Real> {
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

    /// A pack of elements from a lane on, counted over all blocks.
    #[inline(always)]
    fn element<P: Pack<Real = R>, const SLOPES: bool>(
        &self,
        lane: usize,
        constants: &Constants<R, SLOPES>,
    ) -> Hexahedron<P> {
        let corners = &self.corners[lane / BLOCK];
        let mut x = [Vec3::zero(); CORNERS];
        for corner in 0..CORNERS {
            // SAFETY: `new` makes every entry a place in the list of nodes, as long as `positions`; a block holds
            // eight lanes.
            x[corner] = unsafe { P::gather(&self.positions, &corners[corner * BLOCK + lane % BLOCK..]) };
        }
        Hexahedron::new(constants, &side([x[0], x[1], x[2], x[3]]), &side([x[4], x[5], x[6], x[7]]))
    }

    /// Forces of all elements for the positions of their nodes; whether the laws hold for all volumes.
    #[inline(always)]
    pub fn assemble<P: Pack<Real = R>>(
        &mut self,
        positions: &[Row<R>],
        nodes: &[u32],
        shapes: &Shapes<R>,
        mut stress: Stress<P>,
    ) -> bool {
        self.load(positions, nodes);
        self.forces.fill(Row::zero());
        let mut run = Run::new();
        let mut elements = [Hexahedron::<P>::zero(); RUN];
        for (start, count) in self.runs::<P>() {
            for i in 0..count {
                let lane = start + i * P::LANES;
                let constants = Constants::<R, true>::at(shapes, lane);
                elements[i] = self.element(lane, &constants);
                stress.set(&mut run, i, lane, elements[i].gradient(&constants), constants.volume());
            }
            stress.compute(&mut run, count, start, P::LANES);
            for i in 0..count {
                let lane = start + i * P::LANES;
                let constants = Constants::<R, true>::at(shapes, lane);
                let (low, high) = elements[i].forces(&constants, &on_bases(&constants, &run.stresses[i]));
                for (bottom, face) in [(0, low), (4, high)] {
                    let (x, y, z) = (spread(face[0]), spread(face[1]), spread(face[2]));
                    for corner in 0..4 {
                        let force = Vec3::new(x[corner], y[corner], z[corner]);
                        let at = (bottom + corner) * BLOCK + lane % BLOCK;
                        let places = &self.corners[lane / BLOCK][at..];
                        // SAFETY: as in `element`; `forces` is as long as `positions`.
                        unsafe { P::scatter_add(&mut self.forces, places, force) };
                    }
                }
            }
        }
        stress.ratios.valid()
    }

    /// The first lane and the number of packs of each run.
    fn runs<P: Pack<Real = R>>(&self) -> impl Iterator<Item = (usize, usize)> + use<P, R> {
        let packs = self.corners.len() * BLOCK / P::LANES;
        (0..packs).step_by(RUN).map(move |pack| (pack * P::LANES, RUN.min(packs - pack)))
    }

    /// Shows every element to a visitor.
    #[inline(always)]
    pub fn visit<P: Pack<Real = R>, W: Visitor<P>>(
        &mut self,
        positions: &[Row<R>],
        nodes: &[u32],
        shapes: &Shapes<R>,
        visitor: &mut W,
    ) {
        self.load(positions, nodes);
        for (start, count) in self.runs::<P>() {
            for i in 0..count {
                let lane = start + i * P::LANES;
                let constants = Constants::at(shapes, lane);
                visitor.visit(lane, &constants, &self.element(lane, &constants));
            }
            visitor.end_run(P::LANES);
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
