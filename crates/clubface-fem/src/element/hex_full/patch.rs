//! Patches of fully integrated hexahedra of one material: their data.

use super::element::{CONSTANTS, Hexahedron, POINTS, constants};
use crate::block::BLOCK;
use crate::element::bulk_viscosity::BulkViscosity;
use crate::material::{Material, StateVariables, Updates};
use crate::mesh::{CORNERS, SolidMesh};
use clubface_math::{Pack, Real, Row, Vec3};
use std::collections::HashMap;

/// Some fully integrated hexahedra of one material, in blocks of eight.
pub struct FullPatch<R: Real> {
    pub(super) material: Material<R>,
    /// Nodes of the elements, then once more those of the copies that fill up the last block: nobody reads the forces
    /// on these.
    pub(super) nodes: Vec<u32>,
    pub(super) real_nodes: usize,
    /// Places in `nodes`, by block, corner and lane.
    pub(super) corners: Vec<[u32; CORNERS * BLOCK]>,
    pub(super) constants: Vec<[R; CONSTANTS * BLOCK]>,
    /// By block and point.
    pub(super) state: StateVariables<R>,
    pub(super) updates: Updates,
    pub(super) viscosity: Option<BulkViscosity<R>>,
    pub(super) volumes_valid: bool,
    /// Number of the first element in the mesh, and how many there are.
    pub(super) first: usize,
    pub(super) elements: usize,
    positions: Vec<Row<R>>,
    pub(super) forces: Vec<Row<R>>,
}

/// Elements a patch: as much work as a patch of one-point elements, give or take.
const PATCH: usize = 96;

/// Patches of some fully integrated elements of a mesh, of one material, in their undeformed shape.
pub fn full_patches<R: Real>(
    mesh: &SolidMesh<R>,
    elements: std::ops::Range<usize>,
    material: &Material<R>,
) -> Vec<FullPatch<R>> {
    let end = elements.end;
    elements
        .step_by(PATCH)
        .map(|start| FullPatch::new(mesh, start..(start + PATCH).min(end), material.clone()))
        .collect()
}

impl<R: Real> FullPatch<R> {
    /// From some elements of a mesh, in their undeformed shape.
    fn new(mesh: &SolidMesh<R>, elements: std::ops::Range<usize>, material: Material<R>) -> Self {
        let blocks = elements.len().div_ceil(BLOCK);
        let mut corners = vec![[0; CORNERS * BLOCK]; blocks];
        let mut stored = vec![[R::zero(); CONSTANTS * BLOCK]; blocks];
        let (mut nodes, mut place) = (Vec::new(), HashMap::new());
        let mut real_nodes = 0;
        for slot in 0..blocks * BLOCK {
            if slot == elements.len() {
                place.clear();
                real_nodes = nodes.len();
            }
            let element = elements.start + slot.min(elements.len() - 1);
            let (block, lane) = (slot / BLOCK, slot % BLOCK);
            for (corner, &node) in mesh.elements[element].iter().enumerate() {
                let local = *place.entry(node).or_insert_with(|| {
                    nodes.push(node);
                    nodes.len() as u32 - 1
                });
                corners[block][corner * BLOCK + lane] = local;
            }
            for (index, value) in constants(&mesh.corners(element)).into_iter().enumerate() {
                stored[block][index * BLOCK + lane] = value;
            }
        }
        if blocks * BLOCK == elements.len() {
            real_nodes = nodes.len();
        }
        let state = material.state(blocks * POINTS);
        let rows = vec![Row::zero(); nodes.len()];
        Self {
            material,
            real_nodes,
            corners,
            constants: stored,
            state,
            updates: Updates::default(),
            viscosity: None,
            volumes_valid: true,
            first: elements.start,
            elements: elements.len(),
            positions: rows.clone(),
            forces: rows,
            nodes,
        }
    }

    pub(super) fn load(&mut self, positions: &[Row<R>]) {
        for (local, &node) in self.positions.iter_mut().zip(&self.nodes) {
            *local = positions[node as usize];
        }
    }

    /// Elements of a block, from lane `first` on.
    #[inline(always)]
    pub(super) fn gather<P: Pack<Real = R>>(&self, block: usize, first: usize) -> Hexahedron<P> {
        let mut x = [Vec3::zero(); CORNERS];
        for corner in 0..CORNERS {
            // SAFETY: `new` makes every entry a place in `nodes`, as long as `positions`; a block holds eight lanes.
            x[corner] = unsafe { P::gather(&self.positions, &self.corners[block][corner * BLOCK + first..]) };
        }
        Hexahedron::new(&x)
    }
}
