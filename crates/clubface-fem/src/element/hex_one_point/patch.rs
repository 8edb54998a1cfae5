//! Patches of hexahedra of one material: their data.

use super::arrangement::shape;
use super::assemble::DEPTH;
use super::constants::Shapes;
use super::element::Visitor;
use super::indexed::Indexed;
use super::lattice::Lattice;
use crate::block::BLOCK;
use crate::element::bulk_viscosity::BulkViscosity;
use crate::element::patch::parts;
use crate::material::{Material, StateVariables, Updates};
use crate::mesh::{CORNERS, SolidMesh};
use clubface_math::{Pack, Real, Row};
use std::ops::Range;

/// Elements a patch: enough to hide the cost of starting on it, few enough that its nodes stay in the fast caches. It
/// does not depend on the number of threads, so neither do the sums.
pub const PATCH: usize = 864;

/// Layers a patch of a lattice has, if the lattice has as many.
const LAYERS: usize = 6;

/// How elements find their nodes.
pub(super) enum Arrangement<R: Real> {
    Lattice(Lattice<R>),
    Indexed(Indexed<R>),
}

/// Some hexahedra of one material, in blocks of eight.
pub struct SolidPatch<R: Real> {
    pub(super) material: Material<R>,
    pub(super) arrangement: Arrangement<R>,
    /// Longer than the list by a block, so that packs may overrun.
    pub(super) nodes: Vec<u32>,
    /// Largest of them.
    last: u32,
    pub(super) constants: Shapes<R>,
    pub(super) state: StateVariables<R>,
    pub(super) updates: Updates,
    pub(super) viscosity: Option<BulkViscosity<R>>,
    pub(super) volumes_valid: bool,
    /// Number of the element in every lane of the blocks.
    pub(super) numbers: Vec<Option<u32>>,
}

/// For each patch of some elements, the address of its constants. Patches with the same address share them.
#[must_use]
pub fn constant_sets(mesh: &SolidMesh<f64>, elements: Range<usize>, material: &Material<f64>) -> Vec<usize> {
    let patches = solid_patches(mesh, elements, material);
    patches.iter().map(|patch| patch.constants.address()).collect()
}

/// Patches of some elements of a mesh, of one material, in their undeformed shape. Where elements follow each other
/// as in a lattice, the patches are lattices, and those that differ by a rotation share their constants and follow
/// each other.
pub fn solid_patches<R: Real>(
    mesh: &SolidMesh<R>,
    elements: Range<usize>,
    material: &Material<R>,
) -> Vec<SolidPatch<R>> {
    let mut patches: Vec<SolidPatch<R>> = Vec::new();
    let mut start = elements.start;
    while start < elements.end {
        let [ni, nj, nk] = shape(&mesh.elements[start..elements.end]);
        let block = start;
        // Short rows would leave the packs half empty.
        if ni < 3 || ni * nj * nk < 4 * BLOCK {
            start = (start + PATCH).min(elements.end);
            patches.push(SolidPatch::new(mesh, &(block..start).collect::<Vec<_>>(), None, material));
            continue;
        }
        start += ni * nj * nk;
        for layers in parts(nk, LAYERS.min(DEPTH)) {
            for rows in parts(nj, (PATCH / (ni * layers.len())).max(1)) {
                let mut list = Vec::new();
                for k in layers.clone() {
                    for j in rows.clone() {
                        list.extend((0..ni).map(|i| block + (k * nj + j) * ni + i));
                    }
                }
                let mut patch = SolidPatch::new(mesh, &list, Some([ni, rows.len(), layers.len()]), material);
                let mut place = patches.len();
                if let Some(last) = patches.iter().rposition(|p| p.constants.alike(&patch.constants)) {
                    patch.constants = patches[last].constants.clone();
                    place = last + 1;
                }
                patches.insert(place, patch);
            }
        }
    }
    patches
}

impl<R: Real> Arrangement<R> {
    /// Shows every element to a visitor.
    ///
    /// # Safety
    /// The nodes exist.
    #[inline(always)]
    pub(super) unsafe fn visit<P: Pack<Real = R>>(
        &mut self,
        positions: &[Row<R>],
        nodes: &[u32],
        constants: &Shapes<R>,
        loaded: bool,
        visitor: &mut impl Visitor<P>,
    ) {
        match self {
            // SAFETY: the caller's promise.
            Self::Lattice(lattice) => unsafe {
                lattice.visit(positions, nodes, constants, loaded, visitor);
            },
            Self::Indexed(indexed) => indexed.visit(positions, nodes, constants, visitor),
        }
    }
}

impl<R: Real> SolidPatch<R> {
    /// From some elements of a mesh, which make a lattice of the given shape, or none.
    fn new(
        mesh: &SolidMesh<R>,
        elements: &[usize],
        shape: Option<[usize; 3]>,
        material: &Material<R>,
    ) -> Self {
        let corners: Vec<[u32; CORNERS]> = elements.iter().map(|&e| mesh.elements[e]).collect();
        let (arrangement, mut nodes, lanes) = if let Some(shape) = shape {
            let (lattice, nodes, lanes) = Lattice::new(shape, &corners);
            (Arrangement::Lattice(lattice), nodes, lanes)
        } else {
            let (indexed, nodes, lanes) = Indexed::new(&corners);
            (Arrangement::Indexed(indexed), nodes, lanes)
        };
        nodes.extend([nodes[0]; BLOCK]);
        let blocks = lanes.len() / BLOCK;
        let filled = lanes.iter().enumerate().filter_map(|(slot, &element)| Some((slot, element?)));
        let shapes: Vec<_> = filled.map(|(slot, element)| (slot, mesh.corners(elements[element]))).collect();
        let constants = Shapes::new(&shapes, blocks, material.shear());
        let state = material.state(blocks);
        let last = nodes.iter().copied().max().unwrap_or(0);
        let (material, updates) = (material.clone(), Updates::default());
        let numbers = lanes.iter().map(|lane| lane.map(|local| elements[local] as u32)).collect();
        Self {
            material,
            arrangement,
            nodes,
            last,
            constants,
            state,
            updates,
            viscosity: None,
            volumes_valid: true,
            numbers,
        }
    }

    /// The promise that every node exists, on which unchecked reads rely.
    pub(super) fn check(&self, positions: &[Row<R>]) {
        assert!((self.last as usize) < positions.len(), "a patch of another mesh");
    }
}
