//! Nodes, elements and how their forces meet: one explicit step.
//!
//! Every step has two phases: patches and contact compute forces from positions (each into an array of its own), then every node sums the forces on it, in an
//! order that does not depend on threads, and moves.

use crate::contact::Contact;
use crate::element::{Energy, Patch};
use clubface_math::{Pack, PackKernel, Real, Row, Scalar, Vec3};
use rayon::prelude::*;

/// Nodes a task of the second phase.
const CHUNK: usize = 512;

/// Mass, momentum and the like of some nodes.
#[derive(Clone, Copy, Debug)]
pub struct Kinetics<R> {
    /// Mass, kg.
    pub mass: R,
    /// Mass centre, m.
    pub centre: Vec3<R>,
    /// Velocity of the mass centre, m/s.
    pub velocity: Vec3<R>,
    /// Angular velocity of the rigid rotation that fits the velocities best, weighted by mass, rad/s.
    pub spin: Vec3<R>,
    /// Angular momentum about the mass centre, kg m2/s.
    pub angular_momentum: Vec3<R>,
}

/// Nodes with mass, and patches of elements between them.
pub struct Structure<R> {
    /// Positions, m.
    pub positions: Vec<Row<R>>,
    /// Velocities half a step before the positions, m/s.
    pub velocities: Vec<Row<R>>,
    /// Masses, kg.
    pub masses: Vec<R>,
    /// Number of rows that are positions; those behind are rotations of shells.
    pub translations: usize,
    pub(super) inverse_masses: Vec<R>,
    pub(super) patches: Vec<Box<dyn Patch<R>>>,
    /// Where the forces on the nodes stand, by chunk.
    shares: Vec<Shares>,
    /// Number of forces of each patch, and of the contact.
    lengths: Vec<usize>,
}

/// Where the forces on the nodes of a chunk stand. Nodes with the same number of forces follow each other, so that a CPU guesses right how
/// often to add.
struct Shares {
    /// Number of nodes with no force, one, two, ...
    counts: Vec<usize>,
    /// Nodes, counted from the first of the chunk.
    nodes: Vec<u32>,
    /// Patch of each force, and place in it, node by node in the order of the patches.
    slots: Vec<(u32, u32)>,
}

impl Shares {
    /// From the forces on each node of the chunk.
    fn new(on_node: &[Vec<(u32, u32)>]) -> Self {
        let most = on_node.iter().map(Vec::len).max().unwrap_or(0);
        let mut shares = Self { counts: vec![0; most + 1], nodes: Vec::new(), slots: Vec::new() };
        for count in 0..=most {
            for (node, slots) in on_node.iter().enumerate().filter(|(_, slots)| slots.len() == count) {
                shares.counts[count] += 1;
                shares.nodes.push(node as u32);
                shares.slots.extend(slots);
            }
        }
        shares
    }
}

impl<R: Real> Structure<R> {
    /// Nodes at rest with the given masses, and patches; `contact` names the nodes of the contact that will act on them.
    pub fn new(
        positions: Vec<Row<R>>,
        masses: Vec<R>,
        patches: Vec<Box<dyn Patch<R>>>,
        contact: &[u32],
    ) -> Self {
        let mut on_node: Vec<Vec<(u32, u32)>> = vec![Vec::new(); positions.len()];
        let lists = patches.iter().map(|p| p.nodes()).chain([contact]);
        for (patch, nodes) in lists.enumerate() {
            for (place, &node) in nodes.iter().enumerate() {
                on_node[node as usize].push((patch as u32, place as u32));
            }
        }
        let lengths = patches.iter().map(|p| p.nodes().len()).chain([contact.len()]).collect();
        let shares = on_node.chunks(CHUNK).map(Shares::new).collect();
        let inverse_masses = masses.iter().map(|m| m.recip()).collect();
        Self {
            translations: positions.len(),
            velocities: vec![Row::zero(); positions.len()],
            positions,
            masses,
            inverse_masses,
            patches,
            shares,
            lengths,
        }
    }

    /// Forces of all patches, and of the contact, at the current positions.
    pub fn assemble(&mut self, contact: &mut dyn Contact<R>, dt: f64) {
        let (positions, velocities, patches) = (&self.positions, &self.velocities, &mut self.patches);
        rayon::join(
            || contact.assemble(positions, velocities, dt),
            || patches.par_iter_mut().for_each(|patch| patch.assemble(positions, velocities, dt)),
        );
    }

    /// One step under the forces of the last [`Structure::assemble`]: velocities from half a step before the positions to half a step after,
    /// then positions.
    pub fn advance(&mut self, contact: &dyn Contact<R>, dt: f64) {
        let forces: Vec<&[Row<R>]> =
            self.patches.iter().map(|p| p.forces()).chain([contact.forces()]).collect();
        for (forces, length) in forces.iter().zip(&self.lengths) {
            assert_eq!(forces.len(), *length, "a patch has as many forces as nodes");
        }
        let (forces, step) = (&forces, R::from_f64(dt));
        self.positions
            .par_chunks_mut(CHUNK)
            .zip(self.velocities.par_chunks_mut(CHUNK))
            .zip(self.inverse_masses.par_chunks(CHUNK))
            .zip(&self.shares)
            .for_each(|(((positions, velocities), inverse_masses), shares)| {
                R::dispatch(Advance { positions, velocities, inverse_masses, shares, forces, step });
            });
    }

    /// The patches, to build a larger structure of.
    #[must_use]
    pub fn into_patches(self) -> Vec<Box<dyn Patch<R>>> {
        self.patches
    }

    /// Smallest and largest volume ratio of each patch.
    pub fn volume_ratios(&mut self) -> Vec<(f64, f64)> {
        let positions = &self.positions;
        self.patches.par_iter_mut().map(|p| p.volume_ratios(positions)).collect()
    }

    /// Energies of the elements, J, at the current positions.
    pub fn energy(&mut self) -> Energy {
        let positions = &self.positions;
        let energies: Vec<Energy> = self.patches.par_iter_mut().map(|p| p.energy(positions)).collect();
        let mut sum = Energy::default();
        for energy in energies {
            sum += energy;
        }
        sum
    }

    /// Mass, mass centre, velocity and spin of some nodes.
    pub fn kinetics(&self, nodes: std::ops::Range<usize>) -> Kinetics<R> {
        let (mut mass, mut first, mut momentum) = (R::zero(), Vec3::zero(), Vec3::zero());
        for n in nodes.clone() {
            mass += self.masses[n];
            first += self.positions[n].vec() * self.masses[n];
            momentum += self.velocities[n].vec() * self.masses[n];
        }
        let (centre, velocity) = (first * mass.recip(), momentum * mass.recip());
        let mut angular = Vec3::zero();
        let mut moments = [R::zero(); 6];
        for n in nodes {
            let m = self.masses[n];
            let r = self.positions[n].vec() - centre;
            angular += r.cross(self.velocities[n].vec() - velocity) * m;
            let (xx, yy, zz) = (r.x * r.x, r.y * r.y, r.z * r.z);
            let terms = [yy + zz, xx + zz, xx + yy, -(r.x * r.y), -(r.x * r.z), -(r.y * r.z)];
            for (moment, term) in moments.iter_mut().zip(terms) {
                *moment += term * m;
            }
        }
        let spin = clubface_math::Mat3::symmetric(moments).inverse() * angular;
        Kinetics { mass, centre, velocity, spin, angular_momentum: angular }
    }

    /// Kinetic energy, J, between two fields of velocities: with those before and after a step it is the one that central differences conserve.
    pub fn kinetic_energy(&self, before: &[Row<R>]) -> f64 {
        let pairs = self.velocities.iter().zip(before).zip(&self.masses);
        pairs.map(|((a, b), m)| 0.5 * (a.vec().dot(b.vec()) * *m).re()).sum()
    }
}

/// The second phase of a step, for a chunk of nodes.
struct Advance<'a, R> {
    positions: &'a mut [Row<R>],
    velocities: &'a mut [Row<R>],
    inverse_masses: &'a [R],
    shares: &'a Shares,
    forces: &'a [&'a [Row<R>]],
    step: R,
}

impl<R: Real> PackKernel<R> for Advance<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let Advance { positions, velocities, inverse_masses, shares, forces, step } = self;
        assert!(positions.len() == velocities.len() && positions.len() == inverse_masses.len());
        let (mut node, mut slot) = (0, 0);
        for (count, &nodes) in shares.counts.iter().enumerate() {
            for _ in 0..nodes {
                // SAFETY: `Structure::new` makes shares of nodes in their chunk, and of places within the lists of nodes of patches, to which
                // `Structure::step` has compared the forces.
                unsafe {
                    let n = *shares.nodes.get_unchecked(node) as usize;
                    debug_assert!(n < positions.len());
                    let mut sum = Row::zero();
                    for i in slot..slot + count {
                        let (patch, place) = *shares.slots.get_unchecked(i);
                        let force = forces.get_unchecked(patch as usize).get_unchecked(place as usize);
                        add(&mut sum, force, R::one());
                    }
                    let (x, v) = (positions.get_unchecked_mut(n), velocities.get_unchecked_mut(n));
                    add(v, &sum, *inverse_masses.get_unchecked(n) * step);
                    add(x, v, step);
                }
                node += 1;
                slot += count;
            }
        }
    }
}

/// `sum += s v`, all four numbers, so that one instruction does it.
#[inline(always)]
fn add<R: Scalar>(sum: &mut Row<R>, v: &Row<R>, s: R) {
    for c in 0..4 {
        sum.0[c] += v.0[c] * s;
    }
}
