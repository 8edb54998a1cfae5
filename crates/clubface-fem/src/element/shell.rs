//! Patches of four-node shells of one material.
//!
//! A shell's node has a second row in the structure, for its rotation: its mass is the rotary inertia, its velocity the angular velocity, its
//! position the rotation vector summed up, which nothing reads. Stresses, or their resultants, are kept in the frame of the element and grow
//! by the strain of every step.

use super::gauge::OutputSink;
use super::layers::Layers;
use super::quadrature::Rule;
use super::quadrilateral::{Across, Quadrilateral, Resultants, CORNERS};
use super::section::{ElasticSection, Response, Section};
use super::shell_look::{Energies, Output};
use super::shell_material::ShellMaterial;
use super::{Energy, Patch, BLOCK};
use crate::material::{eight_alike, Eight, Numbers};
use crate::mesh::ShellMesh;
use clubface_math::{Pack, PackKernel, Real, Row, Vec3};
use std::collections::HashMap;

/// Most shells a patch: few enough that many threads share them, many enough that most nodes lie inside, where a patch moves them with its forces still
/// in the fast caches. As for solids, it does not depend on the number of threads.
pub const SHELL_PATCH: usize = 544;

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
    pub(super) material: ShellMaterial<R>,
    /// Rows of positions, then rows of rotations.
    nodes: Vec<u32>,
    /// Places in the first half of `nodes`, by block, corner and lane, and rows of positions.
    corners: Vec<[u32; CORNERS * BLOCK]>,
    pub(super) rows: Vec<[u32; CORNERS * BLOCK]>,
    /// How far behind its position the rotation of a node stands.
    behind: usize,
    /// Largest row of a position.
    last: u32,
    pub(super) thickness: Vec<R>,
    /// Reference areas, m2.
    pub(super) areas: Vec<R>,
    /// Points through the thickness (places from -1 to 1, weights), none for resultants alone.
    pub(super) points: Vec<(f64, f64)>,
    /// By block, number and lane.
    pub(super) state: Vec<Eight<R>>,
    pub(super) state_length: usize,
    /// Number of the first element in the mesh, and how many there are.
    pub(super) first: usize,
    pub(super) elements: usize,
    forces: Vec<Row<R>>,
}

impl<R: Real> ShellPatch<R> {
    /// From some elements of a mesh, free of stress.
    ///
    /// # Panics
    /// If rotations stand before positions.
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
        let mut rows_of = corners.clone();
        let mut thickness = Vec::with_capacity(blocks * BLOCK);
        let mut areas = Vec::with_capacity(blocks * BLOCK);
        for slot in 0..blocks * BLOCK {
            // The last block is filled up with copies of the last element, too thin to matter.
            let element = elements.start + slot.min(elements.len() - 1);
            for (corner, &node) in mesh.quads[element].iter().enumerate() {
                let (block, at) = (slot / BLOCK, corner * BLOCK + slot % BLOCK);
                rows_of[block][at] = node + rows.positions;
                corners[block][at] = *place.entry(node).or_insert_with(|| {
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
        assert!(rows.rotations >= rows.positions, "rotations stand behind positions");
        let last = rows_of.iter().flatten().copied().max().unwrap_or(0);
        Self {
            material,
            corners,
            rows: rows_of,
            behind: (rows.rotations - rows.positions) as usize,
            last,
            thickness,
            areas,
            state: eight_alike(&start).repeat(blocks),
            state_length: start.len(),
            points,
            first: elements.start,
            elements: elements.len(),
            forces: vec![Row::zero(); nodes.len()],
            nodes,
        }
    }

    /// The promise that every row exists, on which unchecked reads rely.
    fn check(&self, positions: &[Row<R>]) {
        assert!((self.last as usize) < positions.len(), "a patch of another mesh");
    }
}

impl<R: Real> Patch<R> for ShellPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64) {
        self.check(positions);
        self.check(&velocities[self.behind..]);
        self.forces.fill(Row::zero());
        R::dispatch(Assemble { patch: self, positions, velocities, dt });
    }
    fn perturbed_forces(&mut self, positions: &[Row<R>], displacements: &[Row<R>]) {
        let state = self.state.clone();
        self.assemble(positions, displacements, 1.0);
        self.state = state;
    }
    fn cost(&self) -> usize {
        self.elements * (45 + 2 * self.points.len())
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.check(positions);
        R::dispatch(Energies { patch: self, positions })
    }
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>) {
        self.check(positions);
        R::singly(Output { patch: self, positions, sink });
    }
}

/// Vectors of the corners of `LANES` elements of a block.
///
/// # Safety
/// All of the block's rows exist.
#[inline(always)]
pub(super) unsafe fn gather<P: Pack>(
    field: &[Row<P::Real>],
    rows: &[u32; CORNERS * BLOCK],
    first: usize,
) -> [Vec3<P>; CORNERS] {
    let mut x = [Vec3::zero(); CORNERS];
    for corner in 0..CORNERS {
        // SAFETY: the caller's promise.
        x[corner] = unsafe { P::gather(field, &rows[corner * BLOCK + first..]) };
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
        // SAFETY: `ShellPatch::new` makes every entry a place in the first half of `nodes`; all callers pass that many rows.
        unsafe { P::scatter_add(rows, &corners[corner * BLOCK + first..], values[corner]) };
    }
}

struct Assemble<'a, R> {
    patch: &'a mut ShellPatch<R>,
    positions: &'a [Row<R>],
    velocities: &'a [Row<R>],
    dt: f64,
}

impl<R: Real> PackKernel<R> for Assemble<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(mut self) {
        if self.patch.points.is_empty() {
            return self.with::<P>(&ElasticSection);
        }
        let points = std::mem::take(&mut self.patch.points);
        self.with::<P>(&Layers::new(&points, &self.patch.material));
        self.patch.points = points;
    }
}

impl<R: Real> Assemble<'_, R> {
    #[inline(always)]
    fn with<P: Pack<Real = R>>(&mut self, law: &impl Response<P>) {
        let patch = &mut *self.patch;
        let elastic = patch.material.elastic.splat::<P>();
        let (plate, shear) = (elastic.plate(), elastic.shear());
        let dt = P::from_f64(self.dt);
        let spins = &self.velocities[patch.behind..];
        let (forces, moments) = patch.forces.split_at_mut(patch.nodes.len() / 2);
        let states = patch.state.chunks_exact_mut(patch.state_length);
        for ((block, rows), state) in patch.rows.iter().enumerate().zip(states) {
            for first in (0..BLOCK).step_by(P::LANES) {
                // SAFETY: `assemble` has checked the rows.
                let (places, velocities, spins) = unsafe {
                    (
                        gather(self.positions, rows, first),
                        gather(self.velocities, rows, first),
                        gather(spins, rows, first),
                    )
                };
                let shape = Quadrilateral::<P>::new(&places);
                let increment = shape.increment(&velocities, &spins, dt);
                let thickness = P::load(&patch.thickness[block * BLOCK + first..]);
                let section = Section::new(elastic, plate, shear, thickness);
                let hourglass = section.hourglass(shape.area, shape.aspect());
                let mut state = Numbers::new(state, first);
                let mut across = Across::load(&state);
                section.respond_across(&increment, &hourglass, &mut across);
                across.store(&mut state);
                let [membrane, bending] = law.respond(&section, &increment, shape.area, &mut state);
                let (force, moment) = shape.forces(&Resultants { membrane, bending, across });
                scatter(forces, &patch.corners[block], first, &force);
                scatter(moments, &patch.corners[block], first, &moment);
            }
        }
    }
}
