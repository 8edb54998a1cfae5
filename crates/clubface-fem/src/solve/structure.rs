//! Nodes, the patches of elements between them, and where the forces on each node are found.
//!
//! Every step has two stages: patches and contact compute forces from positions, each into an array of its own; then
//! every node sums the forces on it and moves.

use super::gather::{GatherList, PERIOD, gather_lists};
use crate::element::{Patch, Scratch};
use crate::environment::{Environment, Executor};
use crate::moments::{Moments, Origin};
use clubface_math::{Real, Row, Vec3};
use std::ops::Range;
use std::sync::Arc;

/// Nodes with mass, and patches of elements between them.
pub struct Structure<R: Real> {
    /// Positions, m. Those of interior nodes are up to date only after [`Structure::synchronise`].
    pub positions: Vec<Row<R>>,
    /// Velocities half a step before the positions, m/s; likewise.
    pub velocities: Vec<Row<R>>,
    /// Masses, kg.
    pub masses: Vec<R>,
    /// Number of rows that are positions. The rows behind them are rotations of shells.
    pub translations: usize,
    pub(super) inverse_masses: Vec<R>,
    pub(super) patches: Vec<Box<dyn Patch<R>>>,
    /// Where to find the forces on all nodes; on those of one patch alone, by patch; and on those of several. The last
    /// two leave out interior nodes, which their patches move.
    pub(super) all_nodes: Vec<GatherList>,
    pub(super) patch_nodes: Vec<GatherList>,
    pub(super) shared_nodes: Vec<GatherList>,
    /// Number of forces of each patch, then of the contact.
    pub(super) force_counts: Vec<usize>,
    /// Which patches are subcycled, and whether the next step leaves them out.
    pub(super) subcycled: Vec<bool>,
    pub(super) skip_subcycled: bool,
    /// Which nodes are interior nodes of a patch, which moves them by itself.
    pub(super) interior: Vec<bool>,
    /// The other nodes by patch, each under the first patch that has it; at the end those of no patch.
    pub(super) boundary_nodes: Vec<Vec<u32>>,
    /// Whether the motion of interior nodes is with their patches, and the positions and velocities above are out of
    /// date for them.
    pub(super) interior_loaded: bool,
    /// Nodes whose moments every call of [`Structure::integrate`] ends with, their origin, and the moments by patch.
    pub(super) tracked: Range<usize>,
    pub(super) moment_origin: Origin<R>,
    pub(super) tracked_moments: Vec<Moments<R>>,
    /// Nodes of the contact.
    pub(super) contact_nodes: Vec<u32>,
    /// Working memory, one for each thread.
    pub(super) scratches: Vec<Scratch<R>>,
    /// Threads that work on it.
    pub(super) executor: Arc<dyn Executor>,
}

impl<R: Real> Structure<R> {
    /// Nodes at rest with the given masses, and patches between them. `contact_nodes` are those on which a contact will
    /// act. The threads of the environment do the work.
    pub fn new(
        positions: Vec<Row<R>>,
        masses: Vec<R>,
        mut patches: Vec<Box<dyn Patch<R>>>,
        contact_nodes: &[u32],
        environment: &Environment,
    ) -> Self {
        let count = positions.len();
        let inverse_masses: Vec<R> = masses.iter().map(|m| m.recip()).collect();
        let mut uses = vec![0_u32; count];
        for &node in patches.iter().flat_map(|p| p.nodes()).chain(contact_nodes) {
            uses[node as usize] += 1;
        }
        let mut interior = vec![false; count];
        for patch in &mut patches {
            let nodes = patch.nodes().to_vec();
            let alone: Vec<bool> = nodes.iter().map(|&n| uses[n as usize] == 1).collect();
            let inverse: Vec<R> = nodes.iter().map(|&n| inverse_masses[n as usize]).collect();
            for index in patch.claim_interior_nodes(&alone, &inverse) {
                interior[nodes[index as usize] as usize] = true;
            }
        }
        let mut listed = interior.clone();
        let mut unlisted = |node: &u32| !std::mem::replace(&mut listed[*node as usize], true);
        let mut boundary_nodes: Vec<Vec<u32>> =
            patches.iter().map(|p| p.nodes().iter().copied().filter(&mut unlisted).collect()).collect();
        boundary_nodes.push((0..count as u32).filter(&mut unlisted).collect());
        let force_counts = patches.iter().map(|p| p.nodes().len()).chain([contact_nodes.len()]).collect();
        let mut structure = Self {
            subcycled: vec![false; patches.len()],
            skip_subcycled: false,
            interior,
            boundary_nodes,
            interior_loaded: false,
            tracked: 0..0,
            moment_origin: Origin { position: Vec3::zero(), velocity: Vec3::zero() },
            tracked_moments: Vec::new(),
            contact_nodes: contact_nodes.to_vec(),
            translations: positions.len(),
            velocities: vec![Row::zero(); positions.len()],
            positions,
            masses,
            inverse_masses,
            patches,
            all_nodes: Vec::new(),
            patch_nodes: Vec::new(),
            shared_nodes: Vec::new(),
            force_counts,
            scratches: Vec::new(),
            executor: environment.executor.clone(),
        };
        structure.build_gather_lists();
        structure
    }

    /// Subcycles some patches: their forces are computed in every second step only and act for two steps at once, as
    /// impulses (Tuckerman, Berne and Martyna, J. Chem. Phys. 97, 1992), and nodes on which nothing else acts move only
    /// then. Momentum and angular momentum stay exact. Two steps must be well below the stable step of these patches,
    /// and their neighbours must have no vibration whose half period is as short as two steps.
    pub fn subcycle(&mut self, subcycled: Vec<bool>) {
        assert_eq!(subcycled.len(), self.patches.len());
        (self.subcycled, self.skip_subcycled) = (subcycled, false);
        self.build_gather_lists();
    }

    /// Gives undeformed solid elements a linear bulk viscosity: a pressure of `coefficient` times density, wave speed,
    /// size and the rate at which the logarithm of the volume changes.
    pub fn set_bulk_viscosity(&mut self, coefficient: f64) {
        for patch in &mut self.patches {
            patch.set_bulk_viscosity(coefficient);
        }
    }

    /// Finds where the forces on the nodes are.
    fn build_gather_lists(&mut self) {
        let lists = || self.patches.iter().map(|p| p.nodes()).chain([&self.contact_nodes[..]]);
        // A patch that moves its interior nodes itself stores forces on its other nodes alone.
        let boundary =
            |list: &[u32]| list.iter().copied().filter(|&node| !self.interior[node as usize]).collect();
        let boundary: Vec<Vec<u32>> = lists().map(boundary).collect();
        let subcycled = |list: usize| self.subcycled.get(list).copied().unwrap_or(false);
        let count = self.positions.len();
        let all = gather_lists(count, lists(), 0, subcycled, |_| false);
        let moved =
            gather_lists(count, boundary.iter().map(Vec::as_slice), self.patches.len(), subcycled, |node| {
                self.interior[node]
            });
        (self.all_nodes, self.patch_nodes, self.shared_nodes) = (all.shared, moved.single, moved.shared);
    }

    /// Time for which the forces of a patch act, s.
    pub(super) fn force_duration(&self, patch: usize, dt: f64) -> f64 {
        if self.subcycled[patch] { dt * PERIOD } else { dt }
    }

    /// The patches, to build a larger structure of.
    #[must_use]
    pub fn into_patches(self) -> Vec<Box<dyn Patch<R>>> {
        self.patches
    }

    /// Whether all elements had volumes for which their laws hold when the last forces were computed.
    pub(super) fn volumes_valid(&self) -> bool {
        self.patches.iter().all(|patch| patch.volumes_valid())
    }
}
