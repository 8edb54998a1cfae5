//! Nodes, elements and how their forces meet: one explicit step.
//!
//! Every step has two phases: patches and contact compute forces from positions (each into an array of its own), then every node sums the forces
//! on it and moves.

use super::kinetics::Kinetics;
use super::shares::{split, Shares, PERIOD};
use crate::element::{Energy, OutputSink, Patch, Scratch};
use crate::environment::{Environment, Executor};
use crate::moments::{Moments, Nodes, Origin};
use clubface_math::{Real, Row, Vec3};
use std::sync::Arc;

/// Nodes with mass, and patches of elements between them.
pub struct Structure<R> {
    /// Positions, m; those of nodes that are away only after [`Structure::settle`].
    pub positions: Vec<Row<R>>,
    /// Velocities half a step before the positions, m/s; likewise.
    pub velocities: Vec<Row<R>>,
    /// Masses, kg.
    pub masses: Vec<R>,
    /// Number of rows that are positions; those behind are rotations of shells.
    pub translations: usize,
    pub(super) inverse_masses: Vec<R>,
    pub(super) patches: Vec<Box<dyn Patch<R>>>,
    /// Where the forces on the nodes stand: on all nodes, on those of one patch alone, and on the others; the last two without those that a
    /// patch moves by itself.
    pub(super) shares: Vec<Shares>,
    pub(super) inner: Vec<Shares>,
    pub(super) outer: Vec<Shares>,
    /// Number of forces of each patch, and of the contact.
    pub(super) lengths: Vec<usize>,
    /// Which patches rest in every second step, and whether they do in the next.
    pub(super) resting: Vec<bool>,
    pub(super) pause: bool,
    /// Nodes that a patch moves by itself. By patch the others, each in the first list it is in; in the last list those of no patch.
    adopted: Vec<bool>,
    pub(super) own: Vec<Vec<u32>>,
    /// Whether patches have nodes with them that the fields do not follow.
    pub(super) away: bool,
    /// Nodes whose moments are taken before they are away for long, from where, and by patch.
    followed: std::ops::Range<usize>,
    pub(super) origin: Origin<R>,
    pub(super) moments: Vec<Moments<R>>,
    /// Nodes of the contact.
    pub(super) touching: Vec<u32>,
    /// Memory to work in, one a thread.
    pub(super) scratches: Vec<Scratch<R>>,
    /// Threads that work on it.
    pub(super) executor: Arc<dyn Executor>,
}

impl<R: Real> Structure<R> {
    /// Nodes at rest with the given masses, and patches; `contact` names the nodes of the contact that will act on them. The threads of the
    /// environment work on them.
    pub fn new(
        positions: Vec<Row<R>>,
        masses: Vec<R>,
        mut patches: Vec<Box<dyn Patch<R>>>,
        contact: &[u32],
        environment: &Environment,
    ) -> Self {
        let count = positions.len();
        let inverse_masses: Vec<R> = masses.iter().map(|m| m.recip()).collect();
        let mut uses = vec![0_u32; count];
        for &node in patches.iter().flat_map(|p| p.nodes()).chain(contact) {
            uses[node as usize] += 1;
        }
        let mut adopted = vec![false; count];
        for patch in &mut patches {
            let nodes = patch.nodes().to_vec();
            let alone: Vec<bool> = nodes.iter().map(|&n| uses[n as usize] == 1).collect();
            let inverse: Vec<R> = nodes.iter().map(|&n| inverse_masses[n as usize]).collect();
            for place in patch.claim_interior_nodes(&alone, &inverse) {
                adopted[nodes[place as usize] as usize] = true;
            }
        }
        let mut listed = adopted.clone();
        let mut unlisted = |node: &u32| !std::mem::replace(&mut listed[*node as usize], true);
        let mut own: Vec<Vec<u32>> =
            patches.iter().map(|p| p.nodes().iter().copied().filter(&mut unlisted).collect()).collect();
        own.push((0..count as u32).filter(&mut unlisted).collect());
        let lengths = patches.iter().map(|p| p.nodes().len()).chain([contact.len()]).collect();
        let mut structure = Self {
            resting: vec![false; patches.len()],
            pause: false,
            adopted,
            own,
            away: false,
            followed: 0..0,
            origin: Origin { position: Vec3::zero(), velocity: Vec3::zero() },
            moments: Vec::new(),
            touching: contact.to_vec(),
            translations: positions.len(),
            velocities: vec![Row::zero(); positions.len()],
            positions,
            masses,
            inverse_masses,
            patches,
            shares: Vec::new(),
            inner: Vec::new(),
            outer: Vec::new(),
            lengths,
            scratches: Vec::new(),
            executor: environment.executor.clone(),
        };
        structure.share();
        structure
    }

    /// Lets some patches rest in every second step: their forces, and those of the nodes that nothing else acts on, are taken for two steps at
    /// once, as impulses (Tuckerman, Berne and Martyna, J. Chem. Phys. 97, 1992). Momentum and angular momentum stay exact. Two steps must be well
    /// below the stable step of what rests, and what it hangs on must have no vibration whose half period is as short as two steps.
    pub fn rest(&mut self, resting: Vec<bool>) {
        assert_eq!(resting.len(), self.patches.len());
        (self.resting, self.pause) = (resting, false);
        self.share();
    }

    /// Gives undeformed solid elements a linear bulk viscosity: a pressure of `coefficient` times density, speed of waves, size and rate of volume.
    pub fn damp(&mut self, coefficient: f64) {
        for patch in &mut self.patches {
            patch.set_bulk_viscosity(coefficient);
        }
    }

    /// Finds where the forces on the nodes stand.
    fn share(&mut self) {
        let lists = || self.patches.iter().map(|p| p.nodes()).chain([&self.touching[..]]);
        // Lists of the nodes that their patches do not move.
        let free = |list: &[u32]| list.iter().copied().filter(|&node| !self.adopted[node as usize]).collect();
        let free: Vec<Vec<u32>> = lists().map(free).collect();
        let rests = |list: usize| self.resting.get(list).copied().unwrap_or(false);
        let count = self.positions.len();
        let all = split(count, lists(), 0, rests, |_| false);
        let parts = split(count, free.iter().map(Vec::as_slice), self.patches.len(), rests, |node| {
            self.adopted[node]
        });
        (self.shares, self.inner, self.outer) = (all.outer, parts.inner, parts.outer);
    }

    /// Time for which the forces of a patch hold, s.
    pub(super) fn held(&self, patch: usize, dt: f64) -> f64 {
        if self.resting[patch] {
            dt * PERIOD
        } else {
            dt
        }
    }

    /// Goes on to the next step.
    pub(super) fn turn(&mut self) {
        self.pause = !self.pause && self.resting.contains(&true);
    }

    /// The patches, to build a larger structure of.
    #[must_use]
    pub fn into_patches(self) -> Vec<Box<dyn Patch<R>>> {
        self.patches
    }

    /// Whether all elements were as large as their laws bear when the last forces were made.
    pub(super) fn sound(&self) -> bool {
        self.patches.iter().all(|patch| patch.volumes_valid())
    }

    /// Tells what every element feels, those of the patches whose first node is in `nodes`, by their numbers in their mesh.
    pub fn feel(&mut self, nodes: std::ops::Range<usize>, tell: &mut OutputSink<'_>) {
        self.settle();
        for patch in self.patches.iter_mut().filter(|p| nodes.contains(&(p.nodes()[0] as usize))) {
            patch.element_output(&self.positions, tell);
        }
    }

    /// The most strained element of a patch by its number in the mesh, and the size of its strain; one whose strain is no number is the worst.
    pub fn most_strained(&mut self, patch: usize) -> (usize, f64) {
        self.settle();
        let mut worst = (0, -1.0);
        self.patches[patch].element_output(&self.positions, &mut |number, felt| {
            let size = felt.strain.as_flattened().iter().map(|e| e * e).sum::<f64>();
            let size = if size.is_nan() { f64::INFINITY } else { size };
            if size > worst.1 {
                worst = (number, size);
            }
        });
        worst
    }

    /// Energies of the elements, J, at the current positions.
    pub fn energy(&mut self) -> Energy {
        self.look().0
    }

    /// Says of which body [`Structure::kinetics`] will be asked between marches: its nodes need not be settled for that.
    pub(super) fn follow(&mut self, nodes: std::ops::Range<usize>) {
        self.settle();
        self.followed = nodes;
    }

    /// Whether the nodes of a patch, or those of none, are of the body that is followed.
    pub(super) fn follows(&self, patch: usize) -> bool {
        let nodes = self.patches.get(patch).map_or(&self.own[patch][..], |patch| patch.nodes());
        nodes.first().is_some_and(|&node| self.followed.contains(&(node as usize)))
    }

    /// Mass, mass centre, velocity and spin of some nodes, at least one.
    pub fn kinetics(&mut self, nodes: std::ops::Range<usize>) -> Kinetics<R> {
        if self.away && nodes == self.followed {
            let sum = self.moments.iter().fold(Moments::zero(), Moments::plus);
            return Kinetics::of(&sum, &self.origin);
        }
        self.settle();
        let origin = self.origin_at(nodes.start);
        let all: Vec<u32> = nodes.map(|node| node as u32).collect();
        let Self { positions, velocities, masses, .. } = self;
        Kinetics::of(&Nodes { positions, velocities, masses }.moments(&all, origin), &origin)
    }

    /// An origin of moments at a node.
    fn origin_at(&self, node: usize) -> Origin<R> {
        Origin { position: self.positions[node].vec(), velocity: self.velocities[node].vec() }
    }

    /// The same near the followed body, at a node that is never away.
    pub(super) fn origin_near(&self) -> Origin<R> {
        let here = self.followed.clone().find(|&node| !self.adopted[node]);
        self.origin_at(here.unwrap_or(0))
    }

    /// Kinetic energy, J, between two fields of velocities: with those before and after a step it is the one that central differences conserve.
    pub fn kinetic_energy(&self, before: &[Row<R>]) -> f64 {
        (0..self.masses.len()).map(|node| self.kinetic_energy_of(node, before)).sum()
    }

    /// That of one node.
    pub(super) fn kinetic_energy_of(&self, node: usize, before: &[Row<R>]) -> f64 {
        0.5 * (self.velocities[node].vec().dot(before[node].vec()) * self.masses[node]).re()
    }
}
