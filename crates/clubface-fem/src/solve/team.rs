//! Threads that go through the rounds of a time loop together.
//!
//! A step is about a tenth of a millisecond in two rounds of tasks, too short to put threads to sleep in between: the members of a team stay
//! awake from round to round. Each has a queue of its own, the same tasks every time, whose data its caches keep; whoever has
//! waited for a while takes from the others. The leader needs nobody: members that the machine has no time for just do not take part.

use std::sync::atomic::{AtomicU32, AtomicU64, AtomicUsize, Ordering};
use std::time::Duration;

/// Tries before a waiting thread goes to sleep, some 0.1 ms: whom it waits for may need its core.
const PATIENCE: usize = 2500;
/// How long it sleeps at a time.
const NAP: Duration = Duration::from_micros(20);
/// Tries before a waiting thread does what others have not begun: they are held up, by other programs or by their tasks. Not at once, since what
/// moves from core to core takes longer.
const LENIENCE: usize = 150;
/// The round after the last.
const OVER: u32 = u32::MAX;

/// Round in the upper half, place of the next task in the lower, on cache lines of its own.
#[derive(Debug)]
#[repr(align(128))]
struct Queue(AtomicU64);

/// A round of tasks: what to do with each, and the tasks of each member, in their order.
pub struct Round<'a> {
    /// Does a task, for the member of that number.
    pub task: &'a (dyn Fn(usize, usize) + Sync),
    /// Tasks of each member.
    pub shares: &'a [Vec<usize>],
}

/// The members' meeting place.
pub struct Team<'a> {
    rounds: &'a [Round<'a>],
    queues: Vec<Queue>,
    round: AtomicU32,
    done: AtomicUsize,
}

impl<'a> Team<'a> {
    /// Runs `lead` with the threads of the current pool ready to take part in the rounds it calls for.
    pub fn with<T>(rounds: &'a [Round<'a>], lead: impl FnOnce(&Self) -> T) -> T {
        let members = rounds.iter().map(|round| round.shares.len()).max().unwrap_or(1);
        let queues = (0..members).map(|_| Queue(AtomicU64::new(0))).collect();
        let team = Self { rounds, queues, round: AtomicU32::new(0), done: AtomicUsize::new(0) };
        rayon::in_place_scope(|scope| {
            // Also when `lead` panics, or the members would wait for ever.
            let _end = End(&team);
            for member in 1..members {
                let team = &team;
                scope.spawn(move |_| team.help(member));
            }
            lead(&team)
        })
    }

    /// Does every task of a round; to be called by the leader.
    pub fn run(&self, which: usize) {
        let rounds = self.rounds.len();
        // The next number that stands for this round.
        let last = self.round.load(Ordering::Relaxed) as usize;
        let number = (last / rounds + 1) * rounds + which;
        let shares = self.rounds[which].shares;
        self.done.store(0, Ordering::Relaxed);
        for queue in &self.queues {
            queue.0.store((number as u64) << 32, Ordering::Release);
        }
        self.round.store(number as u32, Ordering::Release);
        self.take(0, 0);
        let all: usize = shares.iter().map(Vec::len).sum();
        let mut tries = 0;
        while self.done.load(Ordering::Acquire) < all {
            self.wait(0, &mut tries);
        }
    }

    /// Does the tasks of `owner` as `member`, until there are none.
    fn take(&self, owner: usize, member: usize) {
        loop {
            let ticket = self.queues[owner].0.fetch_add(1, Ordering::AcqRel);
            let (number, place) = ((ticket >> 32) as usize, (ticket & u64::from(u32::MAX)) as usize);
            let round = &self.rounds[number % self.rounds.len()];
            let Some(&task) = round.shares[owner].get(place).filter(|_| number > 0) else { break };
            let _done = Done(&self.done);
            (round.task)(task, member);
        }
    }

    /// Lets some time pass; takes from the others when they must have been held up.
    fn wait(&self, member: usize, tries: &mut usize) {
        *tries += 1;
        if *tries == LENIENCE {
            let members = self.queues.len();
            (1..members).for_each(|turn| self.take((member + turn) % members, member));
        } else if *tries < PATIENCE {
            std::hint::spin_loop();
        } else {
            std::thread::sleep(NAP);
        }
    }

    fn help(&self, member: usize) {
        let mut seen = 0;
        let mut tries = 0;
        loop {
            let round = self.round.load(Ordering::Acquire);
            if round == OVER {
                return;
            }
            if round == seen {
                self.wait(member, &mut tries);
            } else {
                (seen, tries) = (round, 0);
                self.take(member, member);
            }
        }
    }
}

/// Counts a task when it has ended, by whatever way.
struct Done<'a>(&'a AtomicUsize);

impl Drop for Done<'_> {
    fn drop(&mut self) {
        self.0.fetch_add(1, Ordering::Release);
    }
}

/// Sends the members home.
struct End<'a, 'b>(&'b Team<'a>);

impl Drop for End<'_, '_> {
    fn drop(&mut self) {
        self.0.round.store(OVER, Ordering::Release);
    }
}
