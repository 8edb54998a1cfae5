//! Many steps at a time: the threads stay together from step to step, and patches move the nodes inside them as they go.

use super::schedule::chunks_of;
use super::shares::{Fields, Forces};
use super::together::Shared;
use super::worker_pool::{Stage, WorkerPool};
use super::Structure;
use crate::contact::Contact;
use crate::element::{Energy, Scratch, StepOutput};
use crate::moments::{Moments, Nodes};
use clubface_math::{Real, Row};

/// Rounds: the first of the two of a whole step, the first of one in which some rest, that before all steps, that after them.
const WHOLE: usize = 0;
const AWAKE: usize = 2;
const BEFORE: usize = 4;
const AFTER: usize = 5;

/// Sees the contact after it has computed its forces in a step, and the positions of all nodes but those that patches have adopted; says whether to go on.
pub type Watch<'a, R> = dyn FnMut(&dyn Contact<R>, &[Row<R>]) -> bool + 'a;

impl<R: Real> Structure<R> {
    /// At most `count` steps of `dt` seconds; returns their number. The last is one in which `watch` returns false, or elements fail. The same as
    /// [`Structure::assemble`] and [`Structure::advance`] in turn, bit for bit. Nodes inside patches are away then, until [`Structure::settle`].
    pub fn march(
        &mut self,
        contact: &mut dyn Contact<R>,
        dt: f64,
        count: usize,
        watch: &mut Watch<'_, R>,
    ) -> usize {
        self.go(contact, dt, count, watch, None)
    }

    /// Such a step, in which no patch may rest. Energies of the elements at the positions from which it goes on, J, and the smallest and largest volume
    /// ratio of each patch; the kinetic energy as of [`Structure::kinetic_energy`], J.
    pub(super) fn step_and_look(
        &mut self,
        contact: &mut dyn Contact<R>,
        dt: f64,
        watch: &mut Watch<'_, R>,
    ) -> (Energy, Vec<(f64, f64)>, f64) {
        assert!(!self.pause, "some patches rest");
        let nothing = StepOutput { energy: Energy::default(), ratios: (1.0, 1.0), kinetic: 0.0 };
        let mut seen = vec![nothing; self.patches.len()];
        let before = self.velocities.clone();
        self.go(contact, dt, 1, watch, Some(&mut seen));
        let own = self.own.iter().flatten();
        let mut kinetic: f64 = own.map(|&node| self.kinetic_energy_of(node as usize, &before)).sum();
        let mut elements = Energy::default();
        for patch in &seen {
            elements += patch.energy;
            kinetic += patch.kinetic;
        }
        (elements, seen.into_iter().map(|patch| patch.ratios).collect(), kinetic)
    }

    /// Steps; the patches tell what they see if there is room for it.
    fn go(
        &mut self,
        contact: &mut dyn Contact<R>,
        dt: f64,
        count: usize,
        watch: &mut Watch<'_, R>,
        seen: Option<&mut [StepOutput]>,
    ) -> usize {
        let workers = WorkerPool::size(&*self.executor);
        self.scratches.resize_with(workers, Scratch::new);
        let held: Vec<f64> = (0..self.patches.len()).map(|patch| self.held(patch, dt)).collect();
        let [whole, awake] = self.schedules();
        let (whole_chunks, awake_chunks) =
            (chunks_of(&whole, &self.outer, true), chunks_of(&whole, &self.outer, false));
        let followed: Vec<bool> = (0..=held.len()).map(|patch| self.follows(patch)).collect();
        let measures = followed.contains(&true);
        self.moments.clear();
        self.moments.resize(followed.len(), Moments::zero());
        let origin = self.origin_near();
        self.origin = origin;
        let (mut pause, away) = (self.pause, self.away);
        let fields = Fields::new(&mut self.positions, &mut self.velocities, &self.inverse_masses);
        let mut forces = vec![Forces::none(); held.len() + 1];
        let (mut contacts, shared_forces) = ([contact], Shared::of(&mut forces));
        let (scratches, patches) = (Shared::of(&mut self.scratches), Shared::of(&mut self.patches));
        let (contact, inner, outer) = (Shared::of(&mut contacts), &self.inner, &self.outer);
        let (moments, own, masses) = (Shared::of(&mut self.moments), &self.own, &self.masses[..]);
        let (lengths, seen) = (&self.lengths, seen.map(Shared::of));
        let step = R::from_f64(dt);
        // SAFETY of all rounds: each patch, the contact and each chunk of nodes is one task, each member has a scratch of its own, and rounds of one
        // kind read the fields and write forces, those of the other kind the other way round. Only nodes of one patch alone, which no other task
        // reads, move as soon as it has made its forces; those that a patch has adopted are its own.
        let assemble = |task: usize, member: usize| unsafe {
            let (positions, velocities) = fields.read();
            let rows = if task == patches.count {
                let contact = contact.part(0);
                contact.assemble(positions, velocities, dt);
                contact.forces()
            } else {
                let patch = patches.part(task);
                let seen = seen.as_ref().map(|seen| seen.part(task));
                patch.step(positions, velocities, held[task], scratches.part(member), seen);
                patch.forces()
            };
            *shared_forces.part(task) = Forces::new(rows, lengths[task]);
            if let Some(inner) = inner.get(task) {
                inner.advance(fields, shared_forces.base(), step, true);
            }
        };
        let advance = |task: usize, whole: bool| unsafe {
            outer[task].advance(fields, shared_forces.base(), step, whole);
        };
        let (advance_all, advance_awake) =
            (|task: usize, _: usize| advance(task, true), |task: usize, _: usize| advance(task, false));
        // Each member for its own patches, so that what they take with them is near.
        let take_over = |task: usize, _: usize| unsafe {
            let (positions, velocities) = fields.read();
            if task < patches.count {
                patches.part(task).load_interior(positions, velocities);
            }
        };
        let measure = |task: usize, _: usize| unsafe {
            if followed[task] {
                let (positions, velocities) = fields.read();
                let mut sum = Nodes { positions, velocities, masses }.moments(&own[task], origin);
                if task < patches.count {
                    sum = sum.plus(&patches.part(task).interior_moments(&origin));
                }
                *moments.part(task) = sum;
            }
        };
        let rounds = [
            Stage { task: &assemble, schedule: &whole },
            Stage { task: &advance_all, schedule: &whole_chunks },
            Stage { task: &assemble, schedule: &awake },
            Stage { task: &advance_awake, schedule: &awake_chunks },
            Stage { task: &take_over, schedule: &whole },
            Stage { task: &measure, schedule: &whole },
        ];
        let rests = self.resting.contains(&true);
        let mut done = 0;
        WorkerPool::with(&*self.executor, |pool| {
            let mut go = true;
            if !away {
                pool.run(&rounds[BEFORE]);
            }
            while go && done < count {
                let first = if pause { AWAKE } else { WHOLE };
                pool.run(&rounds[first]);
                // SAFETY: between rounds.
                go = unsafe { watch(*contact.part(0), fields.read().0) };
                let sound = (0..patches.count).all(|patch| unsafe { patches.part(patch).volumes_valid() });
                go = go && sound;
                pool.run(&rounds[first + 1]);
                pause = rests && !pause;
                done += 1;
            }
            if measures {
                pool.run(&rounds[AFTER]);
            }
        });
        (self.pause, self.away) = (pause, true);
        done
    }
}

#[cfg(test)]
mod tests {
    use crate::ball::{Ball, Piece};
    use crate::cases::against_plane;
    use crate::element::Element;
    use crate::environment::Environment;
    use crate::material::{Material, Maxwell, MooneyRivlin, Shape};

    #[test]
    fn a_step_sees_what_is_seen_between_forces_and_motion() {
        let shape = Shape::MooneyRivlin(MooneyRivlin { c10: 4e6, c01: 1e6 });
        let maxwell = vec![Maxwell { modulus: 0.3, time: 1e-4 }];
        let material = Material { shape, bulk: 5e8, maxwell, density: 1150.0 };
        let pieces = vec![Piece { name: "core".into(), radius: 0.0214, layers: 3, material }];
        let ball = Ball { pieces, cube: 6, element: Element::OnePoint, mass: None };
        let [mut one, mut other] = [(); 2].map(|()| {
            against_plane(&ball, 35.0, 0.2, 0.35, &Environment::single_threaded()).expect("the case is valid")
        });
        let dt = one.structure.stable_step(60) * 0.4;
        for impact in [&mut one, &mut other] {
            let cube = impact.parts.iter().enumerate().map(|(patch, _)| patch == 0).collect();
            impact.structure.rest(cube);
            impact.structure.march(impact.contact.as_mut(), dt, 120, &mut |_, _| true);
        }
        let (seen, ratios, kinetic) = one.structure.step_and_look(one.contact.as_mut(), dt, &mut |_, _| true);
        one.structure.settle();
        let structure = &mut other.structure;
        structure.assemble(other.contact.as_mut(), dt);
        let (expected, expected_ratios) = structure.look();
        let before = structure.velocities.clone();
        structure.advance(other.contact.as_ref(), dt);
        assert!(expected.hourglass > 0.0 && expected.viscous > 0.0);
        assert_eq!(format!("{seen:?} {ratios:?}"), format!("{expected:?} {expected_ratios:?}"));
        // Summed in another order.
        assert!((kinetic / structure.kinetic_energy(&before) - 1.0).abs() < 1e-12);
        let bits = |rows: &[clubface_math::Row<f64>]| {
            rows.iter().map(|row| row.0.map(f64::to_bits)).collect::<Vec<_>>()
        };
        assert!(bits(&one.structure.positions) == bits(&structure.positions));
    }
}
