//! The nodes of elements that stand in blocks of eight: their positions and the forces on them, near each other.

use crate::block::BLOCK;
use clubface_math::{Pack, Real, Row, Vec3};
use std::collections::HashMap;
use std::ops::Range;

/// Nodes of some elements of a mesh, N each, in blocks of eight elements.
pub struct BlockNodes<R: Real, const N: usize> {
    /// Nodes of the elements, then once more those of the copies that fill up the last block: nobody reads the forces
    /// on these.
    nodes: Vec<u32>,
    real: usize,
    /// Places in `nodes`, by block, node of the element, and lane.
    places: Vec<[[u32; BLOCK]; N]>,
    positions: Vec<Row<R>>,
    forces: Vec<Row<R>>,
    /// Number of the first element in the mesh, and how many there are.
    pub first: usize,
    /// See [`BlockNodes::first`].
    pub elements: usize,
}

impl<R: Real, const N: usize> BlockNodes<R, N> {
    /// Of some elements of a mesh, at least one, given the nodes of all.
    pub fn new(mesh: &[[u32; N]], elements: Range<usize>) -> Self {
        let count = elements.len();
        let mut places = vec![[[0; BLOCK]; N]; count.div_ceil(BLOCK)];
        let (mut nodes, mut place_of) = (Vec::new(), HashMap::new());
        let mut real = 0;
        for slot in 0..places.len() * BLOCK {
            if slot == count {
                place_of.clear();
                real = nodes.len();
            }
            for (index, &node) in mesh[elements.start + slot.min(count - 1)].iter().enumerate() {
                places[slot / BLOCK][index][slot % BLOCK] = *place_of.entry(node).or_insert_with(|| {
                    nodes.push(node);
                    nodes.len() as u32 - 1
                });
            }
        }
        if places.len() * BLOCK == count {
            real = nodes.len();
        }
        let rows = vec![Row::zero(); nodes.len()];
        let (positions, forces) = (rows.clone(), rows);
        Self { nodes, real, places, positions, forces, first: elements.start, elements: count }
    }

    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.places.len()
    }

    /// The nodes.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.real]
    }

    /// Forces on the nodes, N.
    pub fn forces(&self) -> &[Row<R>] {
        &self.forces[..self.real]
    }

    /// Takes the positions (m) of its nodes from those of all.
    pub fn load(&mut self, positions: &[Row<R>]) {
        for (local, &node) in self.positions.iter_mut().zip(&self.nodes) {
            *local = positions[node as usize];
        }
    }

    /// Forgets all forces.
    pub fn clear_forces(&mut self) {
        self.forces.fill(Row::zero());
    }

    /// Positions of the nodes of a pack of elements, from a lane of a block on.
    #[inline(always)]
    pub fn gather<P: Pack<Real = R>>(&self, block: usize, lane: usize) -> [Vec3<P>; N] {
        let mut x = [Vec3::zero(); N];
        for index in 0..N {
            // SAFETY: `new` makes every entry a place in `nodes`, as long as `positions`; a block holds eight lanes.
            x[index] = unsafe { P::gather(&self.positions, &self.places[block][index][lane..]) };
        }
        x
    }

    /// Adds forces on the nodes of a pack of elements, N.
    #[inline(always)]
    pub fn add_forces<P: Pack<Real = R>>(&mut self, block: usize, lane: usize, forces: &[Vec3<P>; N]) {
        for index in 0..N {
            // SAFETY: as in `gather`; `forces` is as long as `positions`.
            unsafe {
                P::scatter_add(&mut self.forces, &self.places[block][index][lane..], forces[index]);
            };
        }
    }

    /// Lanes of a pack from a lane of a block on that are elements, not copies.
    #[inline(always)]
    pub fn lanes<P: Pack<Real = R>>(&self, block: usize, lane: usize) -> usize {
        P::LANES.min(self.elements.saturating_sub(block * BLOCK + lane))
    }
}

/// Constants of some elements of a mesh by block, N each; the last block is filled up with copies of the last element.
pub fn constants_by_block<R: Real, const N: usize, const ALL: usize>(
    elements: Range<usize>,
    constants: impl Fn(usize) -> [R; N],
) -> Vec<[R; ALL]> {
    const { assert!(ALL == N * BLOCK) };
    let mut stored = vec![[R::zero(); ALL]; elements.len().div_ceil(BLOCK)];
    for slot in 0..stored.len() * BLOCK {
        let element = elements.start + slot.min(elements.len() - 1);
        for (index, value) in constants(element).into_iter().enumerate() {
            stored[slot / BLOCK][index * BLOCK + slot % BLOCK] = value;
        }
    }
    stored
}
