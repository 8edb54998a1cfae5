//! Patches of hexahedra of one material.

use super::one_point::{constants, Hexahedron, CONSTANTS};
use super::{Energy, Patch, BLOCK};
use crate::material::{add_branches, history_length, Decay, Isochoric, Kinematics, Material, UseLaw, MAX_TERMS};
use crate::mesh::{SolidMesh, CORNERS};
use clubface_math::{Pack, PackKernel, Real, Row, Vec3};
use std::collections::HashMap;

/// Elements a patch: enough to hide the cost of starting on it, few enough that its nodes stay in the first-level cache. It does not depend on the
/// number of threads, so neither do the sums.
pub const PATCH: usize = 288;

/// Some hexahedra of one material, in blocks of eight.
pub struct SolidPatch<R> {
    material: Material<R>,
    nodes: Vec<u32>,
    /// Places in `nodes`, by block, corner and lane.
    corners: Vec<[u32; CORNERS * BLOCK]>,
    constants: Vec<R>,
    history: Vec<R>,
    history_length: usize,
    elements: usize,
    positions: Vec<Row<R>>,
    forces: Vec<Row<R>>,
}

impl<R: Real> SolidPatch<R> {
    /// From some elements of a mesh, in their undeformed shape.
    pub fn new(mesh: &SolidMesh, elements: std::ops::Range<usize>, material: Material<R>) -> Self {
        let mut nodes = Vec::new();
        let mut place = HashMap::new();
        let blocks = elements.len().div_ceil(BLOCK);
        let mut corners = vec![[0; CORNERS * BLOCK]; blocks];
        let mut stored = vec![R::zero(); blocks * CONSTANTS * BLOCK];
        for slot in 0..blocks * BLOCK {
            // The last block is filled up with copies of the last element, of no volume: they exert no force.
            let element = elements.start + slot.min(elements.len() - 1);
            let (block, lane) = (slot / BLOCK, slot % BLOCK);
            for (corner, &node) in mesh.elements[element].iter().enumerate() {
                let local = *place.entry(node).or_insert_with(|| {
                    nodes.push(node);
                    nodes.len() as u32 - 1
                });
                corners[block][corner * BLOCK + lane] = local;
            }
            let mut c = constants(&mesh.corners(element));
            if slot >= elements.len() {
                c[CONSTANTS - 1] = 0.0;
            }
            for (which, value) in c.into_iter().enumerate() {
                stored[(block * CONSTANTS + which) * BLOCK + lane] = R::from_f64(value);
            }
        }
        let terms = material.maxwell.len();
        assert!(terms <= MAX_TERMS, "at most {MAX_TERMS} viscoelastic terms");
        let history_length = history_length(terms);
        let mut history = vec![R::zero(); blocks * history_length * BLOCK];
        if terms > 0 {
            // The undeformed C̄ is the identity; its driving stress has no deviator.
            for block in history.chunks_exact_mut(history_length * BLOCK) {
                block[6 * BLOCK..9 * BLOCK].fill(R::one());
            }
        }
        let rows = vec![Row::zero(); nodes.len()];
        Self {
            material,
            corners,
            constants: stored,
            history,
            history_length,
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
}

impl<R: Real> Patch<R> for SolidPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn assemble(&mut self, positions: &[Row<R>], _velocities: &[Row<R>], dt: f64) {
        self.load(positions);
        self.forces.fill(Row::zero());
        R::dispatch(Assemble { patch: self, dt });
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn energy(&mut self, positions: &[Row<R>]) -> Energy {
        self.load(positions);
        R::dispatch(Energies { patch: self }).0
    }
    fn volume_ratios(&mut self, positions: &[Row<R>]) -> (f64, f64) {
        self.load(positions);
        R::dispatch(Energies { patch: self }).1
    }
}

/// Corner positions of `LANES` elements of a block.
#[inline(always)]
fn gather<P: Pack>(
    positions: &[Row<P::Real>],
    corners: &[u32; CORNERS * BLOCK],
    first: usize,
) -> [Vec3<P>; CORNERS] {
    let mut x = [Vec3::zero(); CORNERS];
    for corner in 0..CORNERS {
        // SAFETY: `SolidPatch::new` makes every entry a place in `nodes`, as long as `positions`; a block holds eight lanes.
        x[corner] = unsafe { P::gather(positions, &corners[corner * BLOCK + first..]) };
    }
    x
}

struct Assemble<'a, R> {
    patch: &'a mut SolidPatch<R>,
    dt: f64,
}

impl<R: Real> PackKernel<R> for Assemble<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let material = self.patch.material.clone();
        material.with_law::<P, _>(self);
    }
}

impl<R: Real, P: Pack<Real = R>> UseLaw<P> for Assemble<'_, R> {
    type Output = ();
    #[inline(always)]
    fn with<L: Isochoric<P>>(self, law: L) {
        let patch = self.patch;
        let bulk = P::splat(patch.material.bulk);
        let shear = P::splat(patch.material.shear());
        let mut decays = [Decay { whole: P::zero(), half: P::zero() }; MAX_TERMS];
        let terms = patch.material.maxwell.len();
        for (decay, term) in decays.iter_mut().zip(&patch.material.maxwell) {
            let step = term.decay(self.dt);
            *decay = Decay { whole: P::splat(step.whole), half: P::splat(step.half) };
        }
        for (block, corners) in patch.corners.iter().enumerate() {
            let constants = &patch.constants[block * CONSTANTS * BLOCK..(block + 1) * CONSTANTS * BLOCK];
            for first in (0..BLOCK).step_by(P::LANES) {
                let x = gather::<P>(&patch.positions, corners, first);
                let element = Hexahedron::<P>::new(constants, first, &x);
                let at = Kinematics::new(element.gradient());
                let mut stress = law.stress(&at.c);
                if terms > 0 {
                    let mut history = [P::zero(); 13 + 6 * MAX_TERMS];
                    let stored = &mut patch.history[block * patch.history_length * BLOCK..];
                    for i in 0..patch.history_length {
                        history[i] = P::load(&stored[i * BLOCK + first..]);
                    }
                    stress =
                        add_branches(&at, stress, &decays[..terms], &mut history[..patch.history_length]);
                    for i in 0..patch.history_length {
                        history[i].store(&mut stored[i * BLOCK + first..]);
                    }
                }
                let piola = at.first_piola(&stress, bulk * (at.volume - 1.0));
                let forces = element.forces(&piola, shear);
                for corner in 0..CORNERS {
                    // SAFETY: as in `gather`; `forces` is as long as `positions`.
                    unsafe {
                        P::scatter_add(
                            &mut patch.forces,
                            &corners[corner * BLOCK + first..],
                            forces[corner],
                        );
                    }
                }
            }
        }
    }
}

struct Energies<'a, R> {
    patch: &'a SolidPatch<R>,
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Self::Output {
        self.patch.material.with_law::<P, _>(Energies { patch: self.patch })
    }
}

impl<R: Real, P: Pack<Real = R>> UseLaw<P> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn with<L: Isochoric<P>>(self, law: L) -> Self::Output {
        let patch = self.patch;
        let bulk = P::splat(patch.material.bulk);
        let shear = P::splat(patch.material.shear());
        let mut energy = Energy::default();
        let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
        for (block, corners) in patch.corners.iter().enumerate() {
            let constants = &patch.constants[block * CONSTANTS * BLOCK..(block + 1) * CONSTANTS * BLOCK];
            for first in (0..BLOCK).step_by(P::LANES) {
                let x = gather::<P>(&patch.positions, corners, first);
                let element = Hexahedron::<P>::new(constants, first, &x);
                let at = Kinematics::new(element.gradient());
                let strain = element.strain_energy(law, bulk, &at);
                let hourglass = element.hourglass_energy(shear);
                let viscous = if patch.history_length > 0 {
                    let at = (block * patch.history_length + 12) * BLOCK + first;
                    P::load(&patch.history[at..]) * element.volume
                } else {
                    P::zero()
                };
                for lane in 0..P::LANES.min(patch.elements.saturating_sub(block * BLOCK + first)) {
                    energy.strain += strain.lane(lane);
                    energy.hourglass += hourglass.lane(lane);
                    energy.viscous += viscous.lane(lane);
                    ratios.0 = ratios.0.min(at.volume.lane(lane));
                    ratios.1 = ratios.1.max(at.volume.lane(lane));
                }
            }
        }
        (energy, ratios)
    }
}
