//! Patches of four-node shells of one material.
//!
//! A shell's node has a second row in the structure, for its rotation: its mass is the rotary inertia, its velocity the angular velocity, its
//! position the rotation vector summed up, which nothing reads. Stress resultants are kept in the frame of the element and grow by
//! the strain of every step.

use super::quadrilateral::{Quadrilateral, Resultants, CORNERS, HOURGLASS};
use super::section::{Isotropic, Section};
use super::{Energy, Patch, BLOCK};
use crate::error::FemError;
use crate::mesh::ShellMesh;
use clubface_math::{Pack, PackKernel, Real, Row, Vec3};
use std::collections::HashMap;

/// Shells a patch; as for solids, it does not depend on the number of threads.
pub const SHELL_PATCH: usize = 136;

/// Numbers an element remembers: resultants.
const HISTORY: usize = 8 + HOURGLASS;

/// What shells are made of.
#[derive(Clone, Debug)]
pub struct ShellMaterial<R> {
    /// Elastic constants.
    pub elastic: Isotropic<R>,
    /// Density, kg/m3.
    pub density: R,
}

impl<R: Real> ShellMaterial<R> {
    /// Checks the constants of the part called `name`.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first constant that is not allowed.
    pub fn check(&self, name: &str) -> Result<(), FemError> {
        let (young, poisson, density) =
            (self.elastic.young.re(), self.elastic.poisson.re(), self.density.re());
        if !(young > 0.0 && young.is_finite()) {
            let name = format!("{name}.youngs");
            return Err(FemError::input(name, format!("{young} Pa"), "it must be above zero"));
        }
        if !(poisson > -1.0 && poisson < 0.5) {
            let name = format!("{name}.poisson");
            return Err(FemError::input(name, poisson, "above -1 and below 0.5 is allowed"));
        }
        if !(density > 0.0 && density < 3e4) {
            let name = format!("{name}.density");
            return Err(FemError::input(
                name,
                format!("{density} kg/m3"),
                "above 0, below 30000 kg/m3 is allowed",
            ));
        }
        Ok(())
    }
}

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
    history: Vec<R>,
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
        Self {
            material,
            corners,
            thickness,
            areas,
            history: vec![R::zero(); blocks * HISTORY * BLOCK],
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
    fn energy(&mut self, positions: &[Row<R>]) -> Energy {
        self.load_positions(positions);
        R::dispatch(Energies { patch: self }).0
    }
    fn volume_ratios(&mut self, positions: &[Row<R>]) -> (f64, f64) {
        self.load_positions(positions);
        R::dispatch(Energies { patch: self }).1
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

impl<P: Pack> Resultants<P> {
    #[inline(always)]
    fn load(history: &[P::Real], first: usize) -> Self {
        let mut v = [P::zero(); HISTORY];
        for i in 0..HISTORY {
            v[i] = P::load(&history[i * BLOCK + first..]);
        }
        Self {
            membrane: [v[0], v[1], v[2]],
            bending: [v[3], v[4], v[5]],
            shear: [v[6], v[7]],
            hourglass: [v[8], v[9], v[10], v[11], v[12], v[13]],
        }
    }
    #[inline(always)]
    fn store(&self, history: &mut [P::Real], first: usize) {
        for i in 0..3 {
            self.membrane[i].store(&mut history[i * BLOCK + first..]);
            self.bending[i].store(&mut history[(3 + i) * BLOCK + first..]);
        }
        for i in 0..2 {
            self.shear[i].store(&mut history[(6 + i) * BLOCK + first..]);
        }
        for i in 0..HOURGLASS {
            self.hourglass[i].store(&mut history[(8 + i) * BLOCK + first..]);
        }
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
        let patch = self.patch;
        let elastic = patch.material.elastic.splat::<P>();
        let (plate, shear) = (elastic.plate(), elastic.shear());
        let dt = P::from_f64(self.dt);
        let count = patch.positions.len();
        let (velocities, spins) = patch.velocities.split_at(count);
        let (forces, moments) = patch.forces.split_at_mut(count);
        for (block, corners) in patch.corners.iter().enumerate() {
            let history = &mut patch.history[block * HISTORY * BLOCK..(block + 1) * HISTORY * BLOCK];
            for first in (0..BLOCK).step_by(P::LANES) {
                let shape = Quadrilateral::<P>::new(&gather(&patch.positions, corners, first));
                let increment =
                    shape.increment(&gather(velocities, corners, first), &gather(spins, corners, first), dt);
                let thickness = P::load(&patch.thickness[block * BLOCK + first..]);
                let section = Section::new(elastic, plate, shear, thickness);
                let mut resultants = Resultants::load(history, first);
                section.respond(&increment, &section.hourglass(shape.aspect()), &mut resultants);
                resultants.store(history, first);
                let (force, moment) = shape.forces(&resultants);
                scatter(forces, corners, first, &force);
                scatter(moments, corners, first, &moment);
            }
        }
    }
}

struct Energies<'a, R> {
    patch: &'a ShellPatch<R>,
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Self::Output {
        let patch = self.patch;
        let elastic = patch.material.elastic.splat::<P>();
        let (plate, shear) = (elastic.plate(), elastic.shear());
        let mut energy = Energy::default();
        let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
        for (block, corners) in patch.corners.iter().enumerate() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = block * BLOCK + first;
                let shape = Quadrilateral::<P>::new(&gather(&patch.positions, corners, first));
                let section = Section::new(elastic, plate, shear, P::load(&patch.thickness[at..]));
                let resultants = Resultants::load(&patch.history[block * HISTORY * BLOCK..], first);
                let hourglass = section.hourglass(shape.aspect());
                let (strain, stabilising) = section.energy(&resultants, shape.area, &hourglass);
                let ratio = shape.area / P::load(&patch.areas[at..]);
                for lane in 0..P::LANES.min(patch.elements.saturating_sub(at)) {
                    energy.strain += strain.lane(lane);
                    energy.hourglass += stabilising.lane(lane);
                    ratios.0 = ratios.0.min(ratio.lane(lane));
                    ratios.1 = ratios.1.max(ratio.lane(lane));
                }
            }
        }
        (energy, ratios)
    }
}
