//! Patches of fully integrated hexahedra of one material.

use super::bulk_viscosity::BulkViscosity;
use super::full::{constants, reference_volume, Forces, Hexahedron, Point, CONSTANTS, POINTS};
use super::full_look::{Energies, Output};
use super::gauge::OutputSink;
use super::point::Ratios;
use super::{Energy, Patch, BLOCK};
use crate::material::{InelasticLaw, Kinematics, Material, StateVariables, Updates, UseInelastic};
use crate::mesh::{SolidMesh, CORNERS};
use clubface_math::{Pack, PackKernel, Real, Row, Vec3};
use std::collections::HashMap;

/// Some fully integrated hexahedra of one material, in blocks of eight.
pub struct FullPatch<R> {
    pub(super) material: Material<R>,
    /// Nodes of the elements, then once more those of the copies that fill up the last block: nobody reads the forces on these.
    nodes: Vec<u32>,
    real_nodes: usize,
    /// Places in `nodes`, by block, corner and lane.
    pub(super) corners: Vec<[u32; CORNERS * BLOCK]>,
    pub(super) constants: Vec<[R; CONSTANTS * BLOCK]>,
    /// By block and point.
    pub(super) state: StateVariables<R>,
    pub(super) updates: Updates,
    pub(super) viscosity: Option<BulkViscosity<R>>,
    volumes_valid: bool,
    /// Number of the first element in the mesh, and how many there are.
    pub(super) first: usize,
    pub(super) elements: usize,
    positions: Vec<Row<R>>,
    forces: Vec<Row<R>>,
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
            for (which, value) in constants(&mesh.corners(element)).into_iter().enumerate() {
                stored[block][which * BLOCK + lane] = value;
            }
        }
        if blocks * BLOCK == elements.len() {
            real_nodes = nodes.len();
        }
        let state = StateVariables::new(&material, blocks * POINTS);
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

    fn load(&mut self, positions: &[Row<R>]) {
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

impl<R: Real> Patch<R> for FullPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes[..self.real_nodes]
    }
    fn assemble(&mut self, positions: &[Row<R>], _velocities: &[Row<R>], dt: f64) {
        self.load(positions);
        self.forces.fill(Row::zero());
        self.volumes_valid = R::dispatch(Assemble { patch: self, dt });
    }
    fn volumes_valid(&self) -> bool {
        self.volumes_valid
    }
    fn set_bulk_viscosity(&mut self, coefficient: f64) {
        let volume = |at: usize| reference_volume(&self.constants[at / BLOCK], at % BLOCK);
        let size = f64::cbrt((0..self.elements).map(volume).sum::<f64>() / self.elements as f64);
        self.viscosity = Some(BulkViscosity::new(coefficient, &self.material, size, self.corners.len()));
    }
    fn cost(&self) -> usize {
        self.elements * 230
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces[..self.real_nodes]
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.load(positions);
        R::dispatch(Energies { patch: self })
    }
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>) {
        self.load(positions);
        R::singly(Output { patch: self, sink });
    }
}

struct Assemble<'a, R> {
    patch: &'a mut FullPatch<R>,
    dt: f64,
}

impl<R: Real> PackKernel<R> for Assemble<'_, R> {
    type Output = bool;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> bool {
        let material = self.patch.material.clone();
        material.with_inelastic::<P, _>(self.patch.updates.next(self.dt), self)
    }
}

impl<R: Real, P: Pack<Real = R>> UseInelastic<P> for Assemble<'_, R> {
    type Output = bool;
    #[inline(always)]
    fn with<M: InelasticLaw<P>>(self, law: M) -> bool {
        let mut ratios = Ratios::new();
        let patch = self.patch;
        let bulk = P::splat(patch.material.bulk);
        for block in 0..patch.corners.len() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let element = patch.gather::<P>(block, first);
                let mut forces = Forces::zero();
                let mut volume = P::zero();
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    let f = element.gradient(point, &constants);
                    let at = Kinematics::new(f);
                    let stress = law.advance(&at, &mut patch.state.of(block * POINTS + point, first));
                    forces.add_stress(point, &constants, &at.first_piola(&f, &stress, P::zero()));
                    volume += constants.volume;
                }
                let ratio = element.volume() / volume;
                ratios = ratios.and(ratio);
                let mut pressure = bulk * (ratio - 1.0);
                if let Some(viscosity) = &mut patch.viscosity {
                    pressure += viscosity.pressure(block, first, ratio, self.dt);
                }
                forces.add_pressure(&element, pressure);
                let forces = forces.corners();
                for corner in 0..CORNERS {
                    let places = &patch.corners[block][corner * BLOCK + first..];
                    // SAFETY: as in `gather`; `forces` is as long as `positions`.
                    unsafe { P::scatter_add(&mut patch.forces, places, forces[corner]) };
                }
            }
        }
        ratios.valid()
    }
}
