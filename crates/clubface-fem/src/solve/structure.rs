//! Nodes, elements and how their forces meet: one explicit step.
//!
//! Every step has two phases: patches and contact compute forces from positions (each into an array of its own), then every node sums the forces on it, in an
//! order that does not depend on threads, and moves.

use crate::contact::Contact;
use crate::element::{Energy, Patch};
use clubface_math::{Real, Row, Scalar, Vec3};
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
    inverse_masses: Vec<R>,
    patches: Vec<Box<dyn Patch<R>>>,
    /// Where the forces on node `n` stand: `slots[first[n]..first[n + 1]]`, each a patch and a place in it.
    first: Vec<u32>,
    slots: Vec<(u32, u32)>,
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
        let mut first = vec![0];
        let mut slots = Vec::new();
        for list in on_node {
            slots.extend(list);
            first.push(slots.len() as u32);
        }
        let inverse_masses = masses.iter().map(|m| m.recip()).collect();
        Self {
            translations: positions.len(),
            velocities: vec![Row::zero(); positions.len()],
            positions,
            masses,
            inverse_masses,
            patches,
            first,
            slots,
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
        let (first, slots) = (&self.first, &self.slots);
        let (forces, step) = (&forces, R::from_f64(dt));
        self.positions
            .par_chunks_mut(CHUNK)
            .zip(self.velocities.par_chunks_mut(CHUNK))
            .zip(self.inverse_masses.par_chunks(CHUNK))
            .enumerate()
            .for_each(|(chunk, ((x, v), inverse))| {
                for i in 0..x.len() {
                    let node = chunk * CHUNK + i;
                    let mut sum = Row::zero();
                    for &(patch, place) in &slots[first[node] as usize..first[node + 1] as usize] {
                        add(&mut sum, &forces[patch as usize][place as usize], R::one());
                    }
                    add(&mut v[i], &sum, inverse[i] * step);
                    let velocity = v[i];
                    add(&mut x[i], &velocity, step);
                }
            });
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

    /// Bound of the stable step, s: two over the highest frequency of the structure as it stands, by power iteration on the forces.
    pub fn stable_step(&mut self, iterations: usize) -> f64 {
        let rest = self.positions.clone();
        let mut frequency = 0.0_f64;
        // A deterministic start with a part along every mode.
        let mut seed = 1_u64;
        let mut direction: Vec<[f64; 3]> = rest
            .iter()
            .map(|_| {
                [0; 3].map(|_: i32| {
                    seed =
                        seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    (seed >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
                })
            })
            .collect();
        let size = 1e-8;
        for _ in 0..iterations {
            let norm = length(&direction, &self.masses);
            for d in direction.iter_mut().flatten() {
                *d /= norm;
            }
            let largest = direction.iter().flat_map(|d| d.iter()).fold(0.0_f64, |m, c| m.max(c.abs()));
            let scale = size / largest;
            for (x, (r, d)) in self.positions.iter_mut().zip(rest.iter().zip(&direction)) {
                for c in 0..3 {
                    x.0[c] = r.0[c] + d[c] * scale;
                }
            }
            let (positions, velocities) = (&self.positions, &self.velocities);
            self.patches.par_iter_mut().for_each(|patch| patch.assemble(positions, velocities, 0.0));
            for (node, d) in direction.iter_mut().enumerate() {
                let mut sum = Row::<R>::zero();
                for &(patch, place) in &self.slots[self.first[node] as usize..self.first[node + 1] as usize] {
                    if let Some(patch) = self.patches.get(patch as usize) {
                        add(&mut sum, &patch.forces()[place as usize], R::one());
                    }
                }
                for c in 0..3 {
                    d[c] = -(sum.0[c] * self.inverse_masses[node]).re() / scale;
                }
            }
            frequency = frequency.max(length(&direction, &self.masses).sqrt());
        }
        self.positions = rest;
        2.0 / frequency
    }
}

/// `sum += s v`, all four numbers, so that one instruction does it.
#[inline(always)]
fn add<R: Scalar>(sum: &mut Row<R>, v: &Row<R>, s: R) {
    for c in 0..4 {
        sum.0[c] += v.0[c] * s;
    }
}

/// Length of a field of velocities, weighted by mass.
fn length<R: Real>(field: &[[f64; 3]], masses: &[R]) -> f64 {
    field.iter().zip(masses).map(|(d, m)| d.iter().map(|c| c * c).sum::<f64>() * m.re()).sum::<f64>().sqrt()
}
