//! Patches of fully integrated hexahedra of one material: their data.

use super::element::{CONSTANTS, Hexahedron, POINTS, constants};
use crate::block::BLOCK;
use crate::element::block_nodes::{BlockNodes, constants_by_block};
use crate::element::bulk_viscosity::BulkViscosity;
use crate::material::{Material, StateVariables, Updates};
use crate::mesh::{CORNERS, SolidMesh};
use clubface_math::{Pack, Real};

/// Some fully integrated hexahedra of one material, in blocks of eight.
pub struct FullPatch<R: Real> {
    pub(super) material: Material<R>,
    pub(super) nodes: BlockNodes<R, CORNERS>,
    pub(super) constants: Vec<[R; CONSTANTS * BLOCK]>,
    /// By block and point.
    pub(super) state: StateVariables<R>,
    pub(super) updates: Updates,
    pub(super) viscosity: Option<BulkViscosity<R>>,
    pub(super) volumes_valid: bool,
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
        let nodes = BlockNodes::new(&mesh.elements, elements.clone());
        let state = material.state(nodes.blocks() * POINTS);
        Self {
            material,
            nodes,
            constants: constants_by_block(elements, |element| constants(&mesh.corners(element))),
            state,
            updates: Updates::default(),
            viscosity: None,
            volumes_valid: true,
        }
    }

    /// Elements of a block, from lane `first` on.
    #[inline(always)]
    pub(super) fn gather<P: Pack<Real = R>>(&self, block: usize, first: usize) -> Hexahedron<P> {
        Hexahedron::new(&self.nodes.gather(block, first))
    }
}
