//! Elements in rows, columns and layers: neighbours share what they read and write.
//!
//! Positions and forces stand component by component in the order of the lattice, so that the corners of consecutive
//! elements are consecutive numbers. Where rows do not fill whole packs, the last node of one makes an element with
//! the first of the next, which exists only to keep the packs full: it has no volume. Each element pack goes up
//! through the layers and carries the side it shares with the next one along.

use super::arrangement::order;
use super::assemble::{DEPTH, assemble};
use super::constants::{Constants, Shapes};
use super::element::{Hexahedron, Visitor};
use super::interior::{Advance, Interior, Kinetic};
use super::places::{Places, gather_face};
use super::stress::{RUN, Stress};

use crate::block::BLOCK;
use crate::element::field::{Layout, Scratch};
use crate::mesh::CORNERS;
use clubface_math::{Pack, Real, Row};

/// A lattice of elements.
pub struct Lattice<R: Real> {
    /// Elements along the three directions.
    shape: [usize; 3],
    layout: Layout,
    /// Forces by node, with room for a pack to overrun.
    rows: Vec<Row<R>>,
    /// The nodes inside, if the lattice moves them itself.
    pub interior: Option<Interior<R>>,
}

impl<R: Real> Lattice<R> {
    /// From the elements of a lattice by their corners; also the nodes, and the element in every lane of the blocks.
    pub fn new(shape: [usize; 3], elements: &[[u32; CORNERS]]) -> (Self, Vec<u32>, Vec<Option<usize>>) {
        let [ni, nj, nk] = shape;
        assert!(nk <= DEPTH);
        let (nodes, lanes) = order(shape, elements);
        let row = ni + 1;
        // The last pack reads as far as the corner after the next row, and one that begins in the last row but one
        // overruns by less than a block.
        let last = Places::new(shape).at(lanes.len() / nk - 1);
        let stride = (last + row + 2).max(row * nj + BLOCK).next_multiple_of(BLOCK);
        let layout = Layout { row, plane: row * (nj + 1), planes: nk + 1, stride };
        let rows = vec![Row::zero(); nodes.len() + BLOCK];
        (Self { shape, layout, rows, interior: None }, nodes, lanes)
    }

    /// Takes charge of the nodes inside, if nothing else acts on them; returns their places.
    pub fn claim_interior_nodes(&mut self, alone: &[bool], inverse_masses: &[R]) -> Vec<u32> {
        self.interior = Interior::new(self.layout, alone, inverse_masses);
        self.interior.as_ref().map_or(vec![], Interior::inside)
    }

    /// Forces on the nodes.
    pub fn forces(&self) -> &[Row<R>] {
        &self.rows[..self.rows.len() - BLOCK]
    }

    /// Forces of all elements for the positions of their nodes, a list longer than it need be by a block. If the
    /// lattice is `moving` its interior nodes, the forces on these stay in the scratch for [`Lattice::advance`], and
    /// only those on the others are written. Returns whether the laws hold for all volumes.
    ///
    /// # Safety
    /// The nodes exist.
    #[inline(always)]
    pub unsafe fn assemble<P: Pack<Real = R>>(
        &mut self,
        scratch: &mut Scratch<R>,
        positions: &[Row<R>],
        nodes: &[u32],
        constants: &Shapes<R>,
        stress: Stress<P>,
        moving: bool,
    ) -> bool {
        let Self { shape, layout, rows, interior } = self;
        let mut forces = scratch.forces.field(*layout);
        let mut interior = interior.as_mut().filter(|_| moving);
        // SAFETY of these: the caller's promise.
        let mut field = if let Some(interior) = &mut interior {
            unsafe { interior.load_boundary::<P>(positions, nodes) }
        } else {
            let mut field = scratch.positions.field(*layout);
            for k in 0..layout.planes {
                unsafe { field.load::<P>(k, positions, nodes) };
            }
            field
        };
        let valid = unsafe {
            if P::Real::PARTS > 1 && constants.vary() {
                assemble::<P, true>(*shape, &mut field, &mut forces, constants, stress)
            } else {
                assemble::<P, false>(*shape, &mut field, &mut forces, constants, stress)
            }
        };
        if let Some(interior) = interior {
            interior.store_boundary::<P>(&mut forces, rows);
        } else {
            for k in 0..layout.planes {
                forces.store::<P>(k, &mut rows[k * layout.plane..]);
            }
        }
        valid
    }

    /// Moves the interior nodes on by a step, s.
    pub fn advance(&mut self, scratch: &mut Scratch<R>, step: f64) {
        let forces = scratch.forces.field(self.layout);
        if let Some(interior) = &mut self.interior {
            R::dispatch(Advance { interior, forces, step });
        }
    }

    /// Kinetic energy of the interior nodes between their velocities before and after such a step, J.
    pub fn kinetic(&mut self, scratch: &mut Scratch<R>, step: f64) -> R {
        let forces = scratch.forces.field(self.layout);
        let kinetic = |interior| R::dispatch(Kinetic { interior, forces, step });
        self.interior.as_mut().map_or(R::zero(), kinetic)
    }

    /// Shows every element to `visitor`, at the positions that [`Lattice::assemble`] has loaded if it may.
    ///
    /// # Safety
    /// As for [`Lattice::assemble`].
    #[inline(always)]
    pub unsafe fn visit<P: Pack<Real = R>, W: Visitor<P>>(
        &mut self,
        positions: &[Row<R>],
        nodes: &[u32],
        shapes: &Shapes<R>,
        loaded: bool,
        visitor: &mut W,
    ) {
        let nk = self.shape[2];
        let places = Places::new(self.shape);
        let mut scratch = Scratch::new();
        let mut field = if let Some(interior) = self.interior.as_mut().filter(|_| loaded) {
            interior.positions()
        } else {
            let mut field = scratch.positions.field(self.layout);
            for k in 0..self.layout.planes {
                // SAFETY: the caller's promise.
                unsafe { field.load::<P>(k, positions, nodes) };
            }
            field
        };
        for (column, blocks) in shapes.blocks().chunks_exact(nk).enumerate() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = places.quads::<P>(column * BLOCK + first);
                for (k, block) in blocks.iter().enumerate() {
                    // SAFETY: `at` is within the columns.
                    let (low, high) = unsafe {
                        (gather_face::<P>(&mut field, k, &at), gather_face::<P>(&mut field, k + 1, &at))
                    };
                    let constants = Constants::new(shapes, column * nk + k, block, first);
                    let lane = (column * nk + k) * BLOCK + first;
                    visitor.visit(lane, &constants, &Hexahedron::new(&constants, &low, &high));
                    if (k + 1).is_multiple_of(RUN) || k + 1 == nk {
                        visitor.end_run(BLOCK);
                    }
                }
            }
        }
    }
}
