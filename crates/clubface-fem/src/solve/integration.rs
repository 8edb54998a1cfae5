//! Many steps at a time: workers stay together from step to step, and patches move their interior nodes as they compute
//! the forces.

use super::Structure;
use super::gather::{Fields, Forces};
use super::schedule::chunks_of;
use super::shared_slice::SharedSlice;
use super::worker_pool::{Stage, WorkerPool};
use crate::contact::Contact;
use crate::element::{Energy, Scratch, StepOutput};
use crate::moments::{Moments, Nodes};
use clubface_math::{Real, Row};

/// Stages by their numbers: the first of the two of a full step, the first of the two of a step without subcycled
/// patches, the one before all steps, and the one after them.
const FULL: usize = 0;
const WITHOUT_SUBCYCLED: usize = 2;
const LOAD: usize = 4;
const MEASURE: usize = 5;

/// Called in every step after all forces have been computed, with the contact and the positions of all nodes but
/// interior ones; returns whether to go on.
pub type StepObserver<'a, R> = dyn FnMut(&dyn Contact<R>, &[Row<R>]) -> bool + 'a;

impl<R: Real> Structure<R> {
    /// Takes at most `count` steps of `dt` seconds, and returns their number. The last step is the one in which
    /// `observer` returns false, or in which the volume of an element leaves the range of its law. The result equals
    /// that of [`Structure::assemble`] and [`Structure::advance`] in turn, bit for bit. Afterwards the motion of
    /// interior nodes is with their patches, until [`Structure::synchronise`].
    ///
    /// # Backends
    /// **A GPU, or any other backend, plugs in here.** All time integration of a run goes through this method, some 50
    /// steps a call. A backend takes over [`Structure::positions`], [`Structure::velocities`], masses and patches with
    /// their state variables at the first call and keeps them; per step it needs the contact's forces and calls the
    /// observer; [`Structure::synchronise`] brings positions and velocities back. Nothing outside reads interior nodes
    /// or state variables in between.
    pub fn integrate(
        &mut self,
        contact: &mut dyn Contact<R>,
        dt: f64,
        count: usize,
        observer: &mut StepObserver<'_, R>,
    ) -> usize {
        self.take_steps(contact, dt, count, observer, None)
    }

    /// Takes one full step. Returns the energies of the elements (J) at the positions from which it starts, the
    /// smallest and largest volume ratio of each patch, and the kinetic energy as in [`Structure::kinetic_energy`], J.
    pub fn step_with_energies(
        &mut self,
        contact: &mut dyn Contact<R>,
        dt: f64,
        observer: &mut StepObserver<'_, R>,
    ) -> (Energy, Vec<(f64, f64)>, f64) {
        assert!(!self.skip_subcycled, "a step without the subcycled patches has no energies of all elements");
        let nothing = StepOutput { energy: Energy::default(), ratios: (1.0, 1.0), kinetic: 0.0 };
        let mut outputs = vec![nothing; self.patches.len()];
        let before = self.velocities.clone();
        self.take_steps(contact, dt, 1, observer, Some(&mut outputs));
        let nodes = self.boundary_nodes.iter().flatten();
        let mut kinetic: f64 = nodes.map(|&node| self.kinetic_energy_of(node as usize, &before)).sum();
        let mut elements = Energy::default();
        for patch in &outputs {
            elements += patch.energy;
            kinetic += patch.kinetic;
        }
        (elements, outputs.into_iter().map(|patch| patch.ratios).collect(), kinetic)
    }

    /// Takes steps; the patches fill `outputs` if there are any.
    fn take_steps(
        &mut self,
        contact: &mut dyn Contact<R>,
        dt: f64,
        count: usize,
        observer: &mut StepObserver<'_, R>,
        outputs: Option<&mut [StepOutput]>,
    ) -> usize {
        let workers = WorkerPool::size(&*self.executor);
        self.scratches.resize_with(workers, Scratch::new);
        let durations: Vec<f64> =
            (0..self.patches.len()).map(|patch| self.force_duration(patch, dt)).collect();
        let [all, without_subcycled] = self.schedules();
        let (all_chunks, fast_chunks) =
            (chunks_of(&all, &self.shared_nodes, true), chunks_of(&all, &self.shared_nodes, false));
        let tracked: Vec<bool> = (0..=durations.len()).map(|patch| self.tracks(patch)).collect();
        let measures = tracked.contains(&true);
        self.tracked_moments.clear();
        self.tracked_moments.resize(tracked.len(), Moments::zero());
        let origin = self.origin_of_tracked();
        self.moment_origin = origin;
        let (mut skip_subcycled, loaded) = (self.skip_subcycled, self.interior_loaded);
        let fields = Fields::new(&mut self.positions, &mut self.velocities, &self.inverse_masses);
        let mut forces = vec![Forces::none(); durations.len() + 1];
        let (mut contacts, shared_forces) = ([contact], SharedSlice::new(&mut forces));
        let (scratches, patches) =
            (SharedSlice::new(&mut self.scratches), SharedSlice::new(&mut self.patches));
        let contact = SharedSlice::new(&mut contacts);
        let (patch_nodes, shared_nodes) = (&self.patch_nodes, &self.shared_nodes);
        let moments = SharedSlice::new(&mut self.tracked_moments);
        let (boundary_nodes, masses) = (&self.boundary_nodes, &self.masses[..]);
        let (force_counts, outputs) = (&self.force_counts, outputs.map(SharedSlice::new));
        // SAFETY of all stages: each patch, the contact and each chunk of nodes is one task, and each worker has a
        // scratch memory of its own. Stages of one kind read the fields and write forces, those of the other kind the
        // other way round. Only nodes of one patch alone, which no other task reads, move as soon as the patch has
        // computed its forces; interior nodes belong to their patch anyway.
        let assemble = |task: usize, worker: usize| unsafe {
            let (positions, velocities) = fields.read();
            let rows = if task == patches.count {
                let contact = contact.get(0);
                contact.assemble(positions, velocities, dt);
                contact.forces()
            } else {
                let patch = patches.get(task);
                let output = outputs.as_ref().map(|outputs| outputs.get(task));
                patch.step(positions, velocities, durations[task], scratches.get(worker), output);
                patch.forces()
            };
            *shared_forces.get(task) = Forces::new(rows, force_counts[task]);
            if let Some(nodes) = patch_nodes.get(task) {
                nodes.advance(fields, shared_forces.as_ptr(), dt, true);
            }
        };
        let advance = |chunk: usize, full: bool| unsafe {
            shared_nodes[chunk].advance(fields, shared_forces.as_ptr(), dt, full);
        };
        let advance_all = |chunk: usize, _: usize| advance(chunk, true);
        let advance_fast = |chunk: usize, _: usize| advance(chunk, false);
        // Each worker for its own patches, so that the data which they load is near.
        let load = |task: usize, _: usize| unsafe {
            let (positions, velocities) = fields.read();
            if task < patches.count {
                patches.get(task).load_interior(positions, velocities);
            }
        };
        let measure = |task: usize, _: usize| unsafe {
            if tracked[task] {
                let (positions, velocities) = fields.read();
                let nodes = Nodes { positions, velocities, masses };
                let mut sum = nodes.moments(&boundary_nodes[task], origin);
                if task < patches.count {
                    sum = sum.plus(&patches.get(task).interior_moments(&origin));
                }
                *moments.get(task) = sum;
            }
        };
        let stages = [
            Stage { task: &assemble, schedule: &all },
            Stage { task: &advance_all, schedule: &all_chunks },
            Stage { task: &assemble, schedule: &without_subcycled },
            Stage { task: &advance_fast, schedule: &fast_chunks },
            Stage { task: &load, schedule: &all },
            Stage { task: &measure, schedule: &all },
        ];
        let subcycles = self.subcycled.contains(&true);
        let mut done = 0;
        WorkerPool::with(&*self.executor, |pool| {
            let mut go_on = true;
            if !loaded {
                pool.run(&stages[LOAD]);
            }
            while go_on && done < count {
                let first = if skip_subcycled { WITHOUT_SUBCYCLED } else { FULL };
                pool.run(&stages[first]);
                // SAFETY: no stage is under way.
                go_on = unsafe { observer(*contact.get(0), fields.read().0) };
                let valid = (0..patches.count).all(|patch| unsafe { patches.get(patch).volumes_valid() });
                go_on = go_on && valid;
                pool.run(&stages[first + 1]);
                skip_subcycled = subcycles && !skip_subcycled;
                done += 1;
            }
            if measures {
                pool.run(&stages[MEASURE]);
            }
        });
        (self.skip_subcycled, self.interior_loaded) = (skip_subcycled, true);
        done
    }
}
