//! Who does what: every member of a team has patches of its own, whose data its caches keep from step to step.

use super::shares::Shares;
use super::Structure;
use clubface_math::Real;

/// Rough time of the contact, ns a node.
const CONTACT: usize = 8;

/// Numbers of tasks, or of chunks of nodes, by member.
pub(super) type Roster = Vec<Vec<usize>>;

impl<R: Real> Structure<R> {
    /// Patches, and the contact under the number after the last: of a step of everything, and of one in which some rest. Each member has the same in both.
    pub(super) fn rosters(&self) -> [Roster; 2] {
        let (count, members) = (self.patches.len(), rayon::current_num_threads());
        let costs: Vec<usize> = self.patches.iter().map(|patch| patch.cost()).collect();
        let (asleep, mut awake): (Vec<usize>, Vec<usize>) =
            (0..count).partition(|&patch| self.resting[patch]);
        // The contact first: it is one task, however long it takes. Patches in their order: those of a piece have constants in common.
        awake.insert(0, count);
        let cost = |task: usize| costs.get(task).copied().unwrap_or(CONTACT * self.touching.len());
        let awake = portions(&awake, cost, members);
        let all = awake.iter().zip(portions(&asleep, cost, members)).map(|(a, b)| [&a[..], &b].concat());
        [all.collect(), awake]
    }
}

/// Chunks of nodes of the patches that each member has; those in which all nodes rest only if asked for.
pub(super) fn chunks_of(roster: &Roster, chunks: &[Shares], rested: bool) -> Roster {
    let of = |tasks: &Vec<usize>| {
        let mine = |&chunk: &usize| tasks.contains(&chunks[chunk].owner) && (rested || !chunks[chunk].rest());
        (0..chunks.len()).filter(mine).collect()
    };
    roster.iter().map(of).collect()
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
