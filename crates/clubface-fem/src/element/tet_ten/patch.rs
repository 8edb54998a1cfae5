//! Patches of tetrahedra of one material: their data.

use super::element::{CONSTANTS, POINTS, constants};
use crate::block::BLOCK;
use crate::element::block_nodes::{BlockNodes, constants_by_block};
use crate::element::bulk_viscosity::BulkViscosity;
use crate::element::patch::parts;
use crate::material::{Material, StateVariables, Updates};
use crate::mesh::TET_NODES;
use clubface_math::{Real, Vec3};
use std::ops::Range;

/// Some tetrahedra of one material, in blocks of eight.
pub struct TetrahedronPatch<R: Real> {
    pub(super) material: Material<R>,
    pub(super) nodes: BlockNodes<R, TET_NODES>,
    pub(super) constants: Vec<[R; CONSTANTS * BLOCK]>,
    /// By block and point.
    pub(super) state: StateVariables<R>,
    pub(super) updates: Updates,
    pub(super) viscosity: Option<BulkViscosity<R>>,
    pub(super) volumes_valid: bool,
    /// What is added to the number of an element.
    pub(super) offset: usize,
}

/// Elements a patch: as much work as a patch of one-point hexahedra, give or take.
const PATCH: usize = 128;

/// Patches of some tetrahedra of one material in their undeformed shape, given the positions (m) of all nodes and the
/// nodes of all tetrahedra. Their numbers in the output begin with `offset` for the first of all.
pub fn tetrahedron_patches<R: Real>(
    positions: &[Vec3<R>],
    mesh: &[[u32; TET_NODES]],
    elements: Range<usize>,
    offset: usize,
    material: &Material<R>,
) -> Vec<TetrahedronPatch<R>> {
    let patch = |part: Range<usize>| {
        let part = elements.start + part.start..elements.start + part.end;
        let nodes = BlockNodes::new(mesh, part.clone());
        TetrahedronPatch {
            state: material.state(nodes.blocks() * POINTS),
            nodes,
            constants: constants_by_block(part, |e| constants(&mesh[e].map(|n| positions[n as usize]))),
            material: material.clone(),
            updates: Updates::default(),
            viscosity: None,
            volumes_valid: true,
            offset,
        }
    };
    parts(elements.len(), PATCH).map(patch).collect()
}
