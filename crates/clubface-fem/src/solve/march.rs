//! Many steps at a time: the threads stay together from step to step, and patches move the nodes inside them as they go.

use super::shares::{Fields, Forces};
use super::team::{Round, Team};
use super::Structure;
use crate::contact::Contact;
use crate::element::Scratch;
use crate::moments::{Moments, Nodes};
use clubface_math::{Real, Row};

/// Rough time of the contact, ns a node.
const CONTACT: usize = 8;

/// Rounds: the first of the two of a whole step, the first of one in which some rest, that before all steps, that after them.
const WHOLE: usize = 0;
const AWAKE: usize = 2;
const BEFORE: usize = 4;
const AFTER: usize = 5;

/// Sees the contact after it has computed its forces in a step, and the positions of all nodes but those that patches have adopted; says whether to go on.
pub type Watch<'a, R> = dyn FnMut(&dyn Contact<R>, &[Row<R>]) -> bool + 'a;

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
    fn base(&self) -> *const T {
        self.start
    }
    /// # Safety
    /// Nobody else uses this part, and it is still there.
    #[allow(clippy::mut_from_ref)]
    unsafe fn part(&self, index: usize) -> &mut T {
        assert!(index < self.count);
        // SAFETY: the caller's promise.
        unsafe { &mut *self.start.add(index) }
    }
}

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
        let members = rayon::current_num_threads();
        self.scratches.resize_with(members, Scratch::new);
        let held: Vec<f64> = (0..self.patches.len()).map(|patch| self.held(patch, dt)).collect();
        let [whole, awake] = self.rosters(members);
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
        let lengths = &self.lengths;
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
                patch.step(positions, velocities, held[task], scratches.part(member));
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
                patches.part(task).take_over(positions, velocities);
            }
        };
        let measure = |task: usize, _: usize| unsafe {
            if followed[task] {
                let (positions, velocities) = fields.read();
                let mut sum = Nodes { positions, velocities, masses }.moments(&own[task], origin);
                if task < patches.count {
                    sum = sum.plus(&patches.part(task).adopted_moments(&origin));
                }
                *moments.part(task) = sum;
            }
        };
        let rounds = [
            Round { task: &assemble, shares: &whole.tasks },
            Round { task: &advance_all, shares: &whole.chunks },
            Round { task: &assemble, shares: &awake.tasks },
            Round { task: &advance_awake, shares: &awake.chunks },
            Round { task: &take_over, shares: &whole.tasks },
            Round { task: &measure, shares: &whole.tasks },
        ];
        let rests = self.resting.contains(&true);
        let mut done = 0;
        Team::with(&rounds, |team| {
            let mut go = true;
            if !away {
                team.run(BEFORE);
            }
            while go && done < count {
                let first = if pause { AWAKE } else { WHOLE };
                team.run(first);
                // SAFETY: between rounds.
                go = unsafe { watch(*contact.part(0), fields.read().0) };
                let sound = (0..patches.count).all(|patch| unsafe { patches.part(patch).sound() });
                go = go && sound;
                team.run(first + 1);
                pause = rests && !pause;
                done += 1;
            }
            if measures {
                team.run(AFTER);
            }
        });
        (self.pause, self.away) = (pause, true);
        done
    }
}

/// Who does what in one kind of step, by member.
struct Roster {
    /// Patches, and the contact under the number after the last.
    tasks: Vec<Vec<usize>>,
    chunks: Vec<Vec<usize>>,
}

impl<R: Real> Structure<R> {
    /// Of a step of everything, and of one in which some rest. Each member has the same patches in both, and moves their nodes: its caches keep their data.
    fn rosters(&self, members: usize) -> [Roster; 2] {
        let count = self.patches.len();
        let costs: Vec<usize> = self.patches.iter().map(|patch| patch.cost()).collect();
        let (asleep, mut awake): (Vec<usize>, Vec<usize>) =
            (0..count).partition(|&patch| self.resting[patch]);
        // The contact first: it is one task, however long it takes. Patches in their order: those of a piece have constants in common.
        awake.insert(0, count);
        let cost = |task: usize| costs.get(task).copied().unwrap_or(CONTACT * self.touching.len());
        let awake = portions(&awake, cost, members);
        let all = awake.iter().zip(portions(&asleep, cost, members)).map(|(a, b)| [&a[..], &b].concat());
        let all: Vec<Vec<usize>> = all.collect();
        let chunks = |rested: bool| -> Vec<Vec<usize>> {
            let of = |tasks: &Vec<usize>| {
                let mine = |&chunk: &usize| {
                    tasks.contains(&self.outer[chunk].owner) && (rested || !self.outer[chunk].rest())
                };
                (0..self.outer.len()).filter(mine).collect()
            };
            all.iter().map(of).collect()
        };
        let (of_all, of_awake) = (chunks(true), chunks(false));
        [Roster { tasks: all, chunks: of_all }, Roster { tasks: awake, chunks: of_awake }]
    }
}

/// Tasks in the order given, in portions of about the same cost.
fn portions(tasks: &[usize], cost: impl Fn(usize) -> usize, count: usize) -> Vec<Vec<usize>> {
    let all: usize = tasks.iter().map(|&task| cost(task)).sum();
    let (mut start, mut sum) = (0, 0);
    (1..=count)
        .map(|portion| {
            let mut end = start;
            while end < tasks.len()
                && (portion == count || (sum + cost(tasks[end]) / 2) * count < all * portion)
            {
                sum += cost(tasks[end]);
                end += 1;
            }
            let part = tasks[start..end].to_vec();
            start = end;
            part
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::portions;

    #[test]
    fn portions_hold_every_task_once_and_cost_about_the_same() {
        let costs = [1, 4, 4, 4, 4, 1];
        assert_eq!(portions(&[0, 1, 2, 3, 4, 5], |task| costs[task], 2), [[0, 1, 2], [3, 4, 5]]);
        assert_eq!(portions(&[7, 8], |task| if task == 7 { 9 } else { 1 }, 3), [vec![], vec![7], vec![8]]);
        assert_eq!(portions(&[], |_| 1, 2), [vec![], vec![]]);
    }
}
