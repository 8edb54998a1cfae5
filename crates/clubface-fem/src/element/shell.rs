//! Patches of four-node shells of one material.
//!
//! A shell's node has a second row in the structure, for its rotation: its mass is the rotary inertia, its velocity the angular velocity, its
//! position the rotation vector summed up, which nothing reads. Stresses, or their resultants, are kept in the frame of the element and grow
//! by the strain of every step.

use super::layers::Layers;
use super::quadrature::Rule;
use super::quadrilateral::{Quadrilateral, CORNERS};
use super::section::{ElasticSection, Memory, Response, Section};
use super::shell_material::ShellMaterial;
use super::{Energy, Patch, BLOCK};
use crate::mesh::ShellMesh;
use clubface_math::{Pack, PackKernel, Real, Row, Vec3};
use std::collections::HashMap;

/// Shells a patch; as for solids, it does not depend on the number of threads.
pub const SHELL_PATCH: usize = 136;

/// Where the nodes of a shell mesh stand among the rows of a structure.
#[derive(Clone, Copy, Debug)]
pub struct ShellRows {
    /// Row of the position of the mesh's first node.
    pub positions: u32,
    /// Row of the rotation of the mesh's first node.
    pub rotations: u32,
}

/// Some shells of one material, in blocks of eight.
pub struct ShellPatch<R> {
    material: ShellMaterial<R>,
    /// Rows of positions, then rows of rotations.
    nodes: Vec<u32>,
    /// Places in the first half of `nodes`, by block, corner and lane.
    corners: Vec<[u32; CORNERS * BLOCK]>,
    thickness: Vec<R>,
    /// Reference areas, m2.
    areas: Vec<R>,
    /// Points through the thickness (places from -1 to 1, weights), none for resultants alone.
    points: Vec<(f64, f64)>,
    /// By block, number and lane.
    history: Vec<R>,
    history_length: usize,
    elements: usize,
    positions: Vec<Row<R>>,
    velocities: Vec<Row<R>>,
    forces: Vec<Row<R>>,
}

impl<R: Real> ShellPatch<R> {
    /// From some elements of a mesh, free of stress.
    pub fn new(
        mesh: &ShellMesh<R>,
        elements: std::ops::Range<usize>,
        material: ShellMaterial<R>,
        rows: ShellRows,
    ) -> Self {
        let mut local = Vec::new();
        let mut place = HashMap::new();
        let blocks = elements.len().div_ceil(BLOCK);
        let mut corners = vec![[0; CORNERS * BLOCK]; blocks];
        let mut thickness = Vec::with_capacity(blocks * BLOCK);
        let mut areas = Vec::with_capacity(blocks * BLOCK);
        for slot in 0..blocks * BLOCK {
            // The last block is filled up with copies of the last element, too thin to matter.
            let element = elements.start + slot.min(elements.len() - 1);
            for (corner, &node) in mesh.quads[element].iter().enumerate() {
                corners[slot / BLOCK][corner * BLOCK + slot % BLOCK] =
                    *place.entry(node).or_insert_with(|| {
                        local.push(node);
                        local.len() as u32 - 1
                    });
            }
            let real = slot < elements.len();
            thickness.push(if real { mesh.thickness[element] } else { R::zero() });
            areas.push(R::from_f64(mesh.area(element)));
        }
        let nodes: Vec<u32> = (local.iter().map(|n| n + rows.positions))
            .chain(local.iter().map(|n| n + rows.rotations))
            .collect();
        let points = material.rule().map_or(vec![], Rule::points);
        let start = if points.is_empty() {
            vec![R::zero(); ElasticSection::LENGTH]
        } else {
            Layers::<R>::start(points.len(), material.hardening.as_ref())
        };
        let one = start.iter().flat_map(|number| [*number; BLOCK]);
        Self {
            material,
            corners,
            thickness,
            areas,
            history: one.collect::<Vec<_>>().repeat(blocks),
            history_length: start.len(),
            points,
            elements: elements.len(),
            positions: vec![Row::zero(); local.len()],
            velocities: vec![Row::zero(); nodes.len()],
            forces: vec![Row::zero(); nodes.len()],
            nodes,
        }
    }

    fn load_positions(&mut self, positions: &[Row<R>]) {
        for (local, &node) in self.positions.iter_mut().zip(&self.nodes) {
            *local = positions[node as usize];
        }
    }
}

impl<R: Real> Patch<R> for ShellPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64) {
        self.load_positions(positions);
        for (local, &node) in self.velocities.iter_mut().zip(&self.nodes) {
            *local = velocities[node as usize];
        }
        self.forces.fill(Row::zero());
        R::dispatch(Assemble { patch: self, dt });
    }
    fn probe(&mut self, positions: &[Row<R>], displacements: &[Row<R>]) {
        let history = self.history.clone();
        self.assemble(positions, displacements, 1.0);
        self.history = history;
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn look(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.load_positions(positions);
        R::dispatch(Energies { patch: self })
    }
}

/// Vectors of the corners of `LANES` elements of a block.
#[inline(always)]
fn gather<P: Pack>(
    rows: &[Row<P::Real>],
    corners: &[u32; CORNERS * BLOCK],
    first: usize,
) -> [Vec3<P>; CORNERS] {
    let mut x = [Vec3::zero(); CORNERS];
    for corner in 0..CORNERS {
        // SAFETY: `ShellPatch::new` makes every entry a place in the first half of `nodes`; all callers pass that many rows.
        x[corner] = unsafe { P::gather(rows, &corners[corner * BLOCK + first..]) };
    }
    x
}

/// Adds vectors to the corners of `LANES` elements of a block.
#[inline(always)]
fn scatter<P: Pack>(
    rows: &mut [Row<P::Real>],
    corners: &[u32; CORNERS * BLOCK],
    first: usize,
    values: &[Vec3<P>; CORNERS],
) {
    for corner in 0..CORNERS {
        // SAFETY: as in `gather`.
        unsafe { P::scatter_add(rows, &corners[corner * BLOCK + first..], values[corner]) };
    }
}

struct Assemble<'a, R> {
    patch: &'a mut ShellPatch<R>,
    dt: f64,
}

impl<R: Real> PackKernel<R> for Assemble<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let Self { patch, dt } = self;
        if patch.points.is_empty() {
            assemble::<P>(patch, &ElasticSection, dt);
        } else {
            let points = std::mem::take(&mut patch.points);
            assemble::<P>(patch, &Layers::new(&points, &patch.material), dt);
            patch.points = points;
        }
    }
}

#[inline(always)]
fn assemble<P: Pack>(patch: &mut ShellPatch<P::Real>, law: &impl Response<P>, dt: f64) {
    let elastic = patch.material.elastic.splat::<P>();
    let (plate, shear) = (elastic.plate(), elastic.shear());
    let dt = P::from_f64(dt);
    let count = patch.positions.len();
    let (velocities, spins) = patch.velocities.split_at(count);
    let (forces, moments) = patch.forces.split_at_mut(count);
    let histories = patch.history.chunks_exact_mut(patch.history_length * BLOCK);
    for ((block, corners), history) in patch.corners.iter().enumerate().zip(histories) {
        for first in (0..BLOCK).step_by(P::LANES) {
            let shape = Quadrilateral::<P>::new(&gather(&patch.positions, corners, first));
            let increment =
                shape.increment(&gather(velocities, corners, first), &gather(spins, corners, first), dt);
            let thickness = P::load(&patch.thickness[block * BLOCK + first..]);
            let section = Section::new(elastic, plate, shear, thickness);
            let hourglass = section.hourglass(shape.area, shape.aspect());
            let mut memory = Memory::new(history, first);
            let resultants = law.respond(&section, &increment, &hourglass, shape.area, &mut memory);
            let (force, moment) = shape.forces(&resultants);
            scatter(forces, corners, first, &force);
            scatter(moments, corners, first, &moment);
        }
    }
}

/// Energies, and smallest and largest ratio of areas.
type Found = (Energy, (f64, f64));

struct Energies<'a, R> {
    patch: &'a mut ShellPatch<R>,
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = Found;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Found {
        let patch = self.patch;
        if patch.points.is_empty() {
            return energies::<P>(patch, &ElasticSection);
        }
        let points = std::mem::take(&mut patch.points);
        let found = energies::<P>(patch, &Layers::new(&points, &patch.material));
        patch.points = points;
        found
    }
}

#[inline(always)]
fn energies<P: Pack>(patch: &mut ShellPatch<P::Real>, law: &impl Response<P>) -> Found {
    let elastic = patch.material.elastic.splat::<P>();
    let (plate, shear) = (elastic.plate(), elastic.shear());
    let mut energy = Energy::default();
    let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
    let histories = patch.history.chunks_exact_mut(patch.history_length * BLOCK);
    for ((block, corners), history) in patch.corners.iter().enumerate().zip(histories) {
        for first in (0..BLOCK).step_by(P::LANES) {
            let at = block * BLOCK + first;
            let shape = Quadrilateral::<P>::new(&gather(&patch.positions, corners, first));
            let section = Section::new(elastic, plate, shear, P::load(&patch.thickness[at..]));
            let hourglass = section.hourglass(shape.area, shape.aspect());
            let found = law.energy(&section, &hourglass, shape.area, &Memory::new(history, first));
            let ratio = shape.area / P::load(&patch.areas[at..]);
            for lane in 0..P::LANES.min(patch.elements.saturating_sub(at)) {
                energy.strain += found.strain.lane(lane);
                energy.hourglass += found.hourglass.lane(lane);
                energy.plastic += found.plastic.lane(lane);
                ratios.0 = ratios.0.min(ratio.lane(lane));
                ratios.1 = ratios.1.max(ratio.lane(lane));
            }
        }
    }
    (energy, ratios)
}
