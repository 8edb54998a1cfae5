//! Which worker does what. Every worker has patches of its own, whose data its caches keep from step to step.

use super::Structure;
use super::gather::GatherList;
use super::worker_pool::WorkerPool;
use clubface_math::Real;

/// Rough time of the contact, ns a node.
const CONTACT_COST: usize = 8;

/// Numbers of tasks (or of chunks of nodes) in the order in which to do them, for each worker.
pub type Schedule = Vec<Vec<usize>>;

impl<R: Real> Structure<R> {
    /// Schedules of a full step, and of a substep that leaves out the subcycled patches. Tasks are the patches by their
    /// numbers, and the contact under the number after the last. A worker has the same patches in both.
    pub(super) fn schedules(&self) -> [Schedule; 2] {
        let (count, workers) = (self.patches.len(), WorkerPool::size(&*self.executor));
        let costs: Vec<usize> = self.patches.iter().map(|patch| patch.cost()).collect();
        let (subcycled, mut others): (Vec<usize>, Vec<usize>) =
            (0..count).partition(|&patch| self.subcycled[patch]);
        // The contact comes first: it is one task, however long it takes. Patches keep their order: those of a piece
        // have constants in common.
        others.insert(0, count);
        let cost = |task: usize| costs.get(task).copied().unwrap_or(CONTACT_COST * self.contact_nodes.len());
        let others = balanced(&others, cost, workers);
        let all = others.iter().zip(balanced(&subcycled, cost, workers)).map(|(a, b)| [&a[..], &b].concat());
        [all.collect(), others]
    }
}

/// Chunks of nodes by worker: each worker has those of its own patches. Chunks whose nodes are all subcycled only where
/// `subcycled` is true.
pub(super) fn chunks_of(schedule: &Schedule, chunks: &[GatherList], subcycled: bool) -> Schedule {
    let total = |tasks: &Vec<usize>| {
        let own = |&chunk: &usize| {
            tasks.contains(&chunks[chunk].owner) && (subcycled || !chunks[chunk].subcycled())
        };
        (0..chunks.len()).filter(own).collect()
    };
    schedule.iter().map(total).collect()
}

/// Tasks in the order given, in `count` runs of about the same cost.
pub fn balanced(tasks: &[usize], cost: impl Fn(usize) -> usize, count: usize) -> Schedule {
    let all: usize = tasks.iter().map(|&task| cost(task)).sum();
    let (mut start, mut sum) = (0, 0);
    (1..=count)
        .map(|worker| {
            let mut end = start;
            while end < tasks.len()
                && (worker == count || (sum + cost(tasks[end]) / 2) * count < all * worker)
            {
                sum += cost(tasks[end]);
                end += 1;
            }
            let run = tasks[start..end].to_vec();
            start = end;
            run
        })
        .collect()
}
