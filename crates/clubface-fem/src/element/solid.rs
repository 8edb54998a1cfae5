//! Patches of hexahedra of one material.

use super::arrangement::shape;
use super::bulk_viscosity::BulkViscosity;
use super::field::Scratch;
use super::gauge::OutputSink;
use super::indexed::Indexed;
use super::lattice::{Lattice, DEPTH};
use super::one_point_constants::{constants, CONSTANTS, VOLUME};
use super::point::{alike, Block};
use super::solid_look::{Energies, Output};
use super::solid_step::Assemble;
use super::{parts, Aligned, Energy, Patch, StepOutput, BLOCK};
use crate::material::{Material, Shape, StateVariables, Updates};
use crate::mesh::{SolidMesh, CORNERS};
use crate::moments::{Moments, Origin};
use clubface_math::{Real, Row};
use std::sync::Arc;

/// Elements a patch: enough to hide the cost of starting on it, few enough that its nodes stay in the fast caches. It does not depend on the
/// number of threads, so neither do the sums.
pub const PATCH: usize = 864;

/// Layers a patch of a lattice has, if the lattice has as many.
const LAYERS: usize = 6;

/// How elements find their nodes.
pub(super) enum Layout<R> {
    Lattice(Lattice<R>),
    Indexed(Indexed<R>),
}

/// Some hexahedra of one material, in blocks of eight.
pub struct SolidPatch<R> {
    pub(super) material: Material<R>,
    pub(super) layout: Layout<R>,
    /// Longer than the list by a block, so that packs may overrun.
    pub(super) nodes: Vec<u32>,
    /// Largest of them.
    last: u32,
    pub(super) constants: Arc<[Block<R>]>,
    pub(super) state: StateVariables<R>,
    pub(super) updates: Updates,
    pub(super) viscosity: Option<BulkViscosity<R>>,
    volumes_valid: bool,
    /// Number of the element in every lane of the blocks.
    pub(super) numbers: Vec<Option<u32>>,
}

/// Patches of some elements of a mesh, of one material, in their undeformed shape. Where elements follow each other as in a lattice, the patches are
/// lattices, and those that differ by a rotation share their constants and follow each other.
pub fn solid_patches<R: Real>(
    mesh: &SolidMesh<R>,
    elements: std::ops::Range<usize>,
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
                if let Some(last) = patches.iter().rposition(|p| alike(&p.constants, &patch.constants)) {
                    patch.constants = Arc::clone(&patches[last].constants);
                    place = last + 1;
                }
                patches.insert(place, patch);
            }
        }
    }
    patches
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
        let (layout, mut nodes, lanes) = if let Some(shape) = shape {
            let (lattice, nodes, lanes) = Lattice::new(shape, &corners);
            (Layout::Lattice(lattice), nodes, lanes)
        } else {
            let (indexed, nodes, lanes) = Indexed::new(&corners);
            (Layout::Indexed(indexed), nodes, lanes)
        };
        nodes.extend([nodes[0]; BLOCK]);
        let blocks = lanes.len() / BLOCK;
        let mut stored = vec![Aligned([R::zero(); CONSTANTS * BLOCK]); blocks];
        for (slot, element) in lanes.iter().enumerate() {
            let Some(element) = element else { continue };
            for (which, value) in
                constants(&mesh.corners(elements[*element]), material.shear()).into_iter().enumerate()
            {
                stored[slot / BLOCK].0[which * BLOCK + slot % BLOCK] = value;
            }
        }
        let state = StateVariables::new(material, blocks);
        let last = nodes.iter().copied().max().unwrap_or(0);
        let (material, constants, updates) = (material.clone(), stored.into(), Updates::default());
        let numbers = lanes.iter().map(|lane| lane.map(|local| elements[local] as u32)).collect();
        Self {
            material,
            layout,
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
    fn check(&self, positions: &[Row<R>]) {
        assert!((self.last as usize) < positions.len(), "a patch of another mesh");
    }
}

impl<R: Real> Patch<R> for SolidPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes[..self.nodes.len() - BLOCK]
    }
    fn assemble(&mut self, positions: &[Row<R>], _velocities: &[Row<R>], dt: f64) {
        self.check(positions);
        let scratch = &mut Scratch::new();
        self.volumes_valid = R::dispatch(Assemble { patch: self, positions, dt, scratch, moving: false });
    }
    fn set_bulk_viscosity(&mut self, coefficient: f64) {
        let volumes = self.constants.iter().flat_map(|block| &block.0[VOLUME * BLOCK..]).map(|v| v.re());
        let (sum, count) = volumes.filter(|v| *v > 0.0).fold((0.0, 0.0), |(sum, n), v| (sum + v, n + 1.0));
        let size = f64::cbrt(sum / count);
        self.viscosity = Some(BulkViscosity::new(coefficient, &self.material, size, self.constants.len()));
    }
    fn claim_interior_nodes(&mut self, alone: &[bool], inverse_masses: &[R]) -> Vec<u32> {
        match &mut self.layout {
            Layout::Lattice(lattice) => lattice.claim_interior_nodes(alone, inverse_masses),
            Layout::Indexed(_) => vec![],
        }
    }
    fn load_interior(&mut self, positions: &[Row<R>], velocities: &[Row<R>]) {
        if let Layout::Lattice(Lattice { motion: Some(motion), .. }) = &mut self.layout {
            motion.load_interior(positions, velocities, &self.nodes);
        }
    }
    fn step(
        &mut self,
        positions: &[Row<R>],
        _velocities: &[Row<R>],
        dt: f64,
        scratch: &mut Scratch<R>,
        output: Option<&mut StepOutput>,
    ) {
        self.check(positions);
        self.volumes_valid = R::dispatch(Assemble { patch: self, positions, dt, scratch, moving: true });
        let step = R::from_f64(dt);
        if let Some(output) = output {
            let (energy, ratios) = R::dispatch(Energies { patch: self, positions, at_hand: true });
            let kinetic = match &mut self.layout {
                Layout::Lattice(lattice) => lattice.kinetic(scratch, step).re(),
                Layout::Indexed(_) => 0.0,
            };
            *output = StepOutput { energy, ratios, kinetic };
        }
        if let Layout::Lattice(lattice) = &mut self.layout {
            lattice.advance(scratch, step);
        }
    }
    fn volumes_valid(&self) -> bool {
        self.volumes_valid
    }
    fn interior_moments(&mut self, origin: &Origin<R>) -> Moments<R> {
        match &mut self.layout {
            Layout::Lattice(Lattice { motion: Some(motion), .. }) => motion.moments(origin),
            _ => Moments::zero(),
        }
    }
    fn store_interior(&mut self, give: &mut dyn FnMut(u32, Row<R>, Row<R>)) {
        if let Layout::Lattice(Lattice { motion: Some(motion), .. }) = &mut self.layout {
            motion.store_interior(&self.nodes, give);
        }
    }
    fn cost(&self) -> usize {
        let each = match self.material.shape {
            _ if !self.state.is_empty() => 39,
            Shape::MooneyRivlin(_) | Shape::NeoHookean(_) => 30,
            _ => 36,
        };
        self.constants.len() * BLOCK * each
    }
    fn forces(&self) -> &[Row<R>] {
        match &self.layout {
            Layout::Lattice(lattice) => lattice.forces(),
            Layout::Indexed(indexed) => indexed.forces(),
        }
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.check(positions);
        R::dispatch(Energies { patch: self, positions, at_hand: false })
    }
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>) {
        self.check(positions);
        R::singly(Output { patch: self, positions, sink });
    }
}
