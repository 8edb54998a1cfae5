//! The two stages of a step one by one, for callers who want to do something in between: assembly of forces, then
//! motion of the nodes.

use super::Structure;
use super::gather::{Fields, Forces};
use super::schedule::{Schedule, chunks_of};
use super::shared_slice::SharedSlice;
use super::worker_pool::{Stage, WorkerPool};
use crate::contact::Contact;
use crate::element::Energy;
use crate::environment::Executor;
use clubface_math::Real;

/// Does every task of a schedule once.
fn run(executor: &dyn Executor, schedule: &Schedule, task: &(dyn Fn(usize, usize) + Sync)) {
    WorkerPool::with(executor, |pool| pool.run(&Stage { task, schedule }));
}

// SAFETY of all that is shared: each patch, the contact and each chunk of nodes is one task, and a schedule has every
// task once.
impl<R: Real> Structure<R> {
    /// Brings positions and velocities up to date for interior nodes, whose motion their patches have kept since
    /// [`Structure::integrate`].
    pub fn synchronise(&mut self) {
        if !std::mem::take(&mut self.interior_loaded) {
            return;
        }
        let [all, _] = self.schedules();
        let fields = Fields::new(&mut self.positions, &mut self.velocities, &self.inverse_masses);
        let patches = SharedSlice::new(&mut self.patches);
        run(&*self.executor, &all, &|task, _| unsafe {
            if task < patches.count {
                // Every interior node belongs to one patch.
                patches
                    .get(task)
                    .store_interior(&mut |node, position, velocity| fields.set(node, position, velocity));
            }
        });
    }

    /// Computes the forces of the contact and of all patches whose turn it is, at the current positions.
    pub fn assemble(&mut self, contact: &mut dyn Contact<R>, dt: f64) {
        self.synchronise();
        let durations: Vec<f64> =
            (0..self.patches.len()).map(|patch| self.force_duration(patch, dt)).collect();
        let [all, without_subcycled] = self.schedules();
        let (positions, velocities) = (&self.positions, &self.velocities);
        let mut contacts = [contact];
        let (patches, contact) = (SharedSlice::new(&mut self.patches), SharedSlice::new(&mut contacts));
        let schedule = if self.skip_subcycled { &without_subcycled } else { &all };
        run(&*self.executor, schedule, &|task, _| unsafe {
            if task < patches.count {
                patches.get(task).assemble(positions, velocities, durations[task]);
            } else {
                contact.get(0).assemble(positions, velocities, dt);
            }
        });
    }

    /// Moves the nodes by one step under the forces of the last [`Structure::assemble`]: velocities from half a step
    /// before the positions to half a step after, then positions.
    pub fn advance(&mut self, contact: &dyn Contact<R>, dt: f64) {
        self.synchronise();
        let [all, _] = self.schedules();
        let chunks = chunks_of(&all, &self.all_nodes, true);
        let rows = self.patches.iter().map(|p| p.forces()).chain([contact.forces()]);
        let forces: Vec<_> =
            rows.zip(&self.force_counts).map(|(rows, &count)| Forces::new(rows, count)).collect();
        let fields = Fields::new(&mut self.positions, &mut self.velocities, &self.inverse_masses);
        let (full, lists) = (!self.skip_subcycled, &self.all_nodes);
        // The lists were made for these forces, and no node is in two of them.
        let forces = &forces;
        run(&*self.executor, &chunks, &|chunk, _| unsafe {
            lists[chunk].advance(fields, forces.as_ptr(), dt, full);
        });
        self.skip_subcycled = !self.skip_subcycled && self.subcycled.contains(&true);
    }

    /// Energies of the elements, J, at the current positions, and the smallest and largest volume ratio of each patch.
    pub fn energies(&mut self) -> (Energy, Vec<(f64, f64)>) {
        self.synchronise();
        let [all, _] = self.schedules();
        let mut result = vec![(Energy::default(), (1.0, 1.0)); self.patches.len()];
        let (positions, patches) = (&self.positions, SharedSlice::new(&mut self.patches));
        let shared = SharedSlice::new(&mut result);
        run(&*self.executor, &all, &|task, _| unsafe {
            if task < patches.count {
                *shared.get(task) = patches.get(task).energies(positions);
            }
        });
        let mut sum = Energy::default();
        for (energy, _) in &result {
            sum += *energy;
        }
        (sum, result.into_iter().map(|(_, ratios)| ratios).collect())
    }
}
