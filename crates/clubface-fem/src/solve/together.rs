//! What all threads do at once to all patches: forces, motion, energies.

use super::schedule::{chunks_of, Schedule};
use super::shares::{Fields, Forces};
use super::worker_pool::{Stage, WorkerPool};
use super::Structure;
use crate::contact::Contact;
use crate::element::Energy;
use crate::environment::Executor;
use clubface_math::Real;

/// Things of which each task uses one.
pub(super) struct Shared<T> {
    start: *mut T,
    pub(super) count: usize,
}

// SAFETY: whoever takes a part promises that nobody else does.
unsafe impl<T: Send> Sync for Shared<T> {}

impl<T> Shared<T> {
    pub(super) fn of(values: &mut [T]) -> Self {
        Self { start: values.as_mut_ptr(), count: values.len() }
    }
    pub(super) fn base(&self) -> *const T {
        self.start
    }
    /// # Safety
    /// Nobody else uses this part, and it is still there.
    #[allow(clippy::mut_from_ref)]
    pub(super) unsafe fn part(&self, index: usize) -> &mut T {
        assert!(index < self.count);
        // SAFETY: the caller's promise.
        unsafe { &mut *self.start.add(index) }
    }
}

/// Does every task of a schedule once.
fn run(executor: &dyn Executor, schedule: &Schedule, task: &(dyn Fn(usize, usize) + Sync)) {
    WorkerPool::with(executor, |pool| pool.run(&Stage { task, schedule }));
}

// SAFETY of all that is shared: each patch, the contact and each chunk of nodes is one task, and a schedule has every task once.
impl<R: Real> Structure<R> {
    /// Brings the fields of all nodes up to date after a march.
    pub fn settle(&mut self) {
        if !std::mem::take(&mut self.away) {
            return;
        }
        let [all, _] = self.schedules();
        let fields = Fields::new(&mut self.positions, &mut self.velocities, &self.inverse_masses);
        let patches = Shared::of(&mut self.patches);
        run(&*self.executor, &all, &|task, _| unsafe {
            if task < patches.count {
                // Every node that is away is with one patch.
                patches
                    .part(task)
                    .store_interior(&mut |node, position, velocity| fields.set(node, position, velocity));
            }
        });
    }

    /// Forces of all patches that do not rest, and of the contact, at the current positions.
    pub fn assemble(&mut self, contact: &mut dyn Contact<R>, dt: f64) {
        self.settle();
        let held: Vec<f64> = (0..self.patches.len()).map(|patch| self.held(patch, dt)).collect();
        let [all, awake] = self.schedules();
        let (positions, velocities) = (&self.positions, &self.velocities);
        let mut contacts = [contact];
        let (patches, contact) = (Shared::of(&mut self.patches), Shared::of(&mut contacts));
        run(&*self.executor, if self.pause { &awake } else { &all }, &|task, _| unsafe {
            if task < patches.count {
                patches.part(task).assemble(positions, velocities, held[task]);
            } else {
                contact.part(0).assemble(positions, velocities, dt);
            }
        });
    }

    /// One step under the forces of the last [`Structure::assemble`]: velocities from half a step before the positions to half a step after,
    /// then positions.
    pub fn advance(&mut self, contact: &dyn Contact<R>, dt: f64) {
        self.settle();
        let [all, _] = self.schedules();
        let chunks = chunks_of(&all, &self.shares, true);
        let rows = self.patches.iter().map(|p| p.forces()).chain([contact.forces()]);
        let forces: Vec<_> =
            rows.zip(&self.lengths).map(|(rows, &length)| Forces::new(rows, length)).collect();
        let fields = Fields::new(&mut self.positions, &mut self.velocities, &self.inverse_masses);
        let (step, whole, shares) = (R::from_f64(dt), !self.pause, &self.shares);
        // The shares were made for these lists, and no node is in two of them.
        let forces = &forces;
        run(&*self.executor, &chunks, &|chunk, _| unsafe {
            shares[chunk].advance(fields, forces.as_ptr(), step, whole)
        });
        self.turn();
    }

    /// Energies of the elements, J, at the current positions, and the smallest and largest volume ratio of each patch.
    pub fn look(&mut self) -> (Energy, Vec<(f64, f64)>) {
        self.settle();
        let [all, _] = self.schedules();
        let mut seen = vec![(Energy::default(), (1.0, 1.0)); self.patches.len()];
        let (positions, patches) = (&self.positions, Shared::of(&mut self.patches));
        let found = Shared::of(&mut seen);
        run(&*self.executor, &all, &|task, _| unsafe {
            if task < patches.count {
                *found.part(task) = patches.part(task).energies(positions);
            }
        });
        let mut sum = Energy::default();
        for (energy, _) in &seen {
            sum += *energy;
        }
        (sum, seen.into_iter().map(|(_, ratios)| ratios).collect())
    }
}
