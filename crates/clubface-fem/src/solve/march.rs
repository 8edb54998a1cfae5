//! Many steps at a time: the threads stay together from step to step, and patches move the nodes inside them by themselves.

use super::shares::{Fields, Forces};
use super::team::{Round, Team};
use super::Structure;
use crate::contact::Contact;
use crate::element::Scratch;
use clubface_math::Real;
use std::ops::Range;

/// Things of which each task uses one.
struct Shared<T> {
    start: *mut T,
    count: usize,
}

// SAFETY: whoever takes a part promises that nobody else does.
unsafe impl<T: Send> Sync for Shared<T> {}

impl<T> Shared<T> {
    fn of(values: &mut [T]) -> Self {
        Self { start: values.as_mut_ptr(), count: values.len() }
    }
    /// # Safety
    /// Nobody else uses this part, and it is still there.
    #[allow(clippy::mut_from_ref)]
    unsafe fn part(&self, index: usize) -> &mut T {
        assert!(index < self.count);
        // SAFETY: the caller's promise.
        unsafe { &mut *self.start.add(index) }
    }
    /// # Safety
    /// Nobody writes to any part, and they are still there.
    unsafe fn all(&self) -> &[T] {
        // SAFETY: the caller's promise.
        unsafe { std::slice::from_raw_parts(self.start, self.count) }
    }
}

impl<R: Real> Structure<R> {
    /// At most `count` steps of `dt` seconds; returns their number. `watch` sees the contact after it has computed its forces in each step, and makes that step the
    /// last by returning false. The same as [`Structure::assemble`] and [`Structure::advance`] in turn, bit for bit.
    pub fn march(
        &mut self,
        contact: &mut dyn Contact<R>,
        dt: f64,
        count: usize,
        watch: &mut dyn FnMut(&dyn Contact<R>) -> bool,
    ) -> usize {
        for patch in &mut self.patches {
            patch.take_over(&self.positions, &self.velocities);
        }
        let members = rayon::current_num_threads();
        self.scratches.resize_with(members, Scratch::new);
        // The contact first: it is one task, however long it takes.
        let (patches, contact_cost) = (self.patches.len(), self.lengths[self.patches.len()]);
        let costs: Vec<usize> =
            std::iter::once(contact_cost).chain(self.lengths[..patches].iter().copied()).collect();
        let portions = [portions(&costs, members), portions(&vec![1; self.outer.len()], members)];
        let fields = Fields::new(&mut self.positions, &mut self.velocities, &self.inverse_masses);
        let mut forces = vec![Forces::none(); costs.len()];
        let (mut contacts, shared_forces) = ([contact], Shared::of(&mut forces));
        let (scratches, patches) = (Shared::of(&mut self.scratches), Shared::of(&mut self.patches));
        let (contact, outer, lengths) = (Shared::of(&mut contacts), &self.outer, &self.lengths);
        let step = R::from_f64(dt);
        // SAFETY of both rounds: each patch, the contact and each chunk of nodes is one task, each member has a scratch of its own, and the first round
        // reads the fields and writes forces, the second the other way round.
        let assemble = |task: usize, member: usize| unsafe {
            let (positions, velocities) = fields.read();
            let (place, rows) = if task == 0 {
                let contact = contact.part(0);
                contact.assemble(positions, velocities, dt);
                (patches.count, contact.forces())
            } else {
                let patch = patches.part(task - 1);
                patch.step(positions, velocities, dt, scratches.part(member));
                (task - 1, patch.forces())
            };
            *shared_forces.part(place) = Forces::new(rows, lengths[place]);
        };
        let advance = |task: usize, _: usize| unsafe {
            outer[task].advance(fields, shared_forces.all(), step);
        };
        let rounds =
            [Round { task: &assemble, shares: &portions[0] }, Round { task: &advance, shares: &portions[1] }];
        let mut done = 0;
        Team::with(&rounds, |team| {
            let mut go = true;
            while go && done < count {
                team.run(0);
                // SAFETY: between rounds.
                go = watch(*unsafe { contact.part(0) });
                team.run(1);
                done += 1;
            }
        });
        for patch in &mut self.patches {
            patch.hand_back(&mut self.positions, &mut self.velocities);
        }
        done
    }
}

/// Tasks in the order given, in portions of about the same cost.
fn portions(costs: &[usize], count: usize) -> Vec<Range<usize>> {
    let all: usize = costs.iter().sum();
    let (mut start, mut sum) = (0, 0);
    (1..=count)
        .map(|portion| {
            let mut end = start;
            while end < costs.len() && (portion == count || (sum + costs[end] / 2) * count < all * portion) {
                sum += costs[end];
                end += 1;
            }
            let tasks = start..end;
            start = end;
            tasks
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::portions;

    #[test]
    fn portions_hold_every_task_once_and_cost_about_the_same() {
        assert_eq!(portions(&[1, 4, 4, 4, 4, 1], 2), [0..3, 3..6]);
        assert_eq!(portions(&[9, 1], 3), [0..0, 0..1, 1..2]);
        assert_eq!(portions(&[], 2), [0..0, 0..0]);
    }
}
