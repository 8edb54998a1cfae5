//! Threads that go through the rounds of a time loop together.
//!
//! A step is about a tenth of a millisecond in two rounds of tasks, too short to put threads to sleep in between: the members of a team stay
//! awake from round to round. Each has a queue of its own, the same tasks every time, whose data its caches keep; whoever has
//! waited for a while takes from the others. The leader needs nobody: members that the machine has no time for just do not take part.

use std::cell::Cell;
use std::sync::atomic::{AtomicBool, AtomicPtr, AtomicU32, AtomicU64, AtomicUsize, Ordering};
use std::time::Duration;

/// Tries before a waiting thread goes to sleep, some 0.1 ms: whom it waits for may need its core.
const PATIENCE: usize = 2500;
/// How long it sleeps at a time.
const NAP: Duration = Duration::from_micros(20);
/// Tries before a waiting thread does what others have not begun: they are held up, by other programs or by their tasks. Not at once, since what
/// moves from core to core takes longer.
const LENIENCE: usize = 150;
/// The number after that of the last round.
const OVER: u32 = u32::MAX;

thread_local! {
    /// The team that this thread leads.
    static LED: Cell<*const Team> = const { Cell::new(std::ptr::null()) };
}

/// Number of the round in the upper half, tasks that nobody has taken yet in the lower, on cache lines of its own.
#[repr(align(128))]
struct Queue(AtomicU64);

/// The lower half.
const LEFT: u64 = u32::MAX as u64;

/// A round of tasks: what to do with each, and the tasks of each member, in their order.
pub struct Round<'a> {
    /// Does a task, for the member of that number.
    pub task: &'a (dyn Fn(usize, usize) + Sync),
    /// Tasks of each member.
    pub shares: &'a [Vec<usize>],
}

/// The members' meeting place.
pub struct Team {
    queues: Vec<Queue>,
    /// The round that is on.
    current: AtomicPtr<Round<'static>>,
    number: AtomicU32,
    done: AtomicUsize,
    busy: AtomicBool,
}

impl Team {
    /// Runs `lead` with the threads of the current pool ready to take part in the rounds it calls for. Within it the same team is at hand.
    pub fn with<T>(lead: impl FnOnce(&Self) -> T) -> T {
        // SAFETY: `End` forgets the team before it is gone.
        if let Some(team) = unsafe { LED.get().as_ref() } {
            return lead(team);
        }
        let members = rayon::current_num_threads();
        let team = Self {
            queues: (0..members).map(|_| Queue(AtomicU64::new(0))).collect(),
            current: AtomicPtr::default(),
            number: AtomicU32::new(0),
            done: AtomicUsize::new(0),
            busy: AtomicBool::new(false),
        };
        rayon::in_place_scope(|scope| {
            // Also when `lead` panics, or the members would wait for ever.
            let _end = End(&team);
            for member in 1..members {
                let team = &team;
                scope.spawn(move |_| team.help(member));
            }
            LED.set(&team);
            lead(&team)
        })
    }

    /// Does every task of a round; to be called by the leader, and by no task.
    pub fn run(&self, round: &Round<'_>) {
        assert!(round.shares.len() <= self.queues.len(), "a round for a larger team");
        assert!(!self.busy.swap(true, Ordering::Relaxed), "a round within a round");
        let number = self.number.load(Ordering::Relaxed).wrapping_add(1) % OVER;
        self.done.store(0, Ordering::Relaxed);
        self.current.store(std::ptr::from_ref(round).cast_mut().cast(), Ordering::Release);
        let mut all = 0;
        for (member, queue) in self.queues.iter().enumerate() {
            let tasks = round.shares.get(member).map_or(0, Vec::len);
            queue.0.store(u64::from(number) << 32 | tasks as u64, Ordering::Release);
            all += tasks;
        }
        // Whatever happens, nobody is at a task of this round when it is gone.
        let _rest = Rest { team: self, all };
        self.number.store(number, Ordering::Release);
        self.take(0, 0);
        let mut tries = 0;
        while self.done.load(Ordering::Acquire) < all {
            self.wait(0, &mut tries);
        }
    }

    /// Does the tasks of `owner` as `member`, until there are none.
    fn take(&self, owner: usize, member: usize) {
        let queue = &self.queues[owner].0;
        let next = |ticket: u64| (ticket & LEFT > 0).then(|| ticket - 1);
        while let Ok(ticket) = queue.fetch_update(Ordering::AcqRel, Ordering::Acquire, next) {
            let _done = Done(&self.done);
            // SAFETY: a round is there until all of its tasks are done, of which this is one.
            let round = unsafe { &*self.current.load(Ordering::Acquire) };
            let tasks = &round.shares[owner];
            (round.task)(tasks[tasks.len() - (ticket & LEFT) as usize], member);
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
            let number = self.number.load(Ordering::Acquire);
            if number == OVER {
                return;
            }
            if number == seen {
                self.wait(member, &mut tries);
            } else {
                (seen, tries) = (number, 0);
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
struct End<'a>(&'a Team);

impl Drop for End<'_> {
    fn drop(&mut self) {
        LED.set(std::ptr::null());
        self.0.number.store(OVER, Ordering::Release);
    }
}

/// Waits for those who are at a task of the round, and lets nobody begin another.
struct Rest<'a> {
    team: &'a Team,
    all: usize,
}

impl Drop for Rest<'_> {
    fn drop(&mut self) {
        let left = |queue: &Queue| queue.0.fetch_and(!LEFT, Ordering::AcqRel) & LEFT;
        let left: u64 = self.team.queues.iter().map(left).sum();
        while self.team.done.load(Ordering::Acquire) + (left as usize) < self.all {
            std::hint::spin_loop();
        }
        self.team.busy.store(false, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::{Round, Team, LED};
    use std::panic::{catch_unwind, AssertUnwindSafe};
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::{Duration, Instant};

    /// With a team of three.
    fn three<T: Send>(lead: impl FnOnce() -> T + Send) -> T {
        rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("threads").install(lead)
    }

    #[test]
    fn every_task_of_a_round_is_done_once_before_the_next() {
        three(|| {
            Team::with(|team| {
                for turn in 0..2000 {
                    // Rounds of all sizes, each gone when the next begins.
                    let shares = [(0..turn % 5).collect(), vec![], (5..5 + turn % 7).collect::<Vec<_>>()];
                    let counts: Vec<AtomicUsize> = (0..12).map(|_| AtomicUsize::new(0)).collect();
                    let task = |task: usize, _: usize| {
                        counts[task].fetch_add(1, Ordering::Relaxed);
                    };
                    team.run(&Round { task: &task, shares: &shares });
                    for (task, count) in counts.iter().enumerate() {
                        let expected = usize::from(task < turn % 5 || (5..5 + turn % 7).contains(&task));
                        assert_eq!(count.load(Ordering::Relaxed), expected, "task {task} of round {turn}");
                    }
                }
            });
        });
    }

    #[test]
    fn a_team_is_at_hand_within_and_gone_afterwards() {
        three(|| {
            Team::with(|outer| Team::with(|inner| assert!(std::ptr::eq(outer, inner))));
            assert!(LED.get().is_null());
            assert!(catch_unwind(|| Team::with(|_| panic!("planted"))).is_err());
            assert!(LED.get().is_null(), "whatever has happened");
        });
    }

    #[test]
    fn no_task_is_left_when_another_panics() {
        three(|| {
            Team::with(|team| {
                let [begun, ended] = [AtomicUsize::new(0), AtomicUsize::new(0)];
                let task = |task: usize, _: usize| {
                    if task == 0 {
                        // Another member is at its task, unless the machine has no time for any.
                        let start = Instant::now();
                        while begun.load(Ordering::Relaxed) == 0 && start.elapsed() < Duration::from_secs(5) {
                            std::hint::spin_loop();
                        }
                        panic!("planted");
                    }
                    begun.fetch_add(1, Ordering::Relaxed);
                    std::thread::sleep(Duration::from_millis(200));
                    ended.fetch_add(1, Ordering::Relaxed);
                };
                let round = Round { task: &task, shares: &[vec![0, 1], vec![2, 3], vec![4, 5]] };
                assert!(catch_unwind(AssertUnwindSafe(|| team.run(&round))).is_err());
                assert_eq!(begun.load(Ordering::Relaxed), ended.load(Ordering::Relaxed));
            });
        });
    }

    #[test]
    fn no_round_begins_within_a_round() {
        three(|| {
            Team::with(|team| {
                let empty = Round { task: &|_, _| (), shares: &[vec![0]] };
                let task = |_, _| {
                    assert!(catch_unwind(AssertUnwindSafe(|| team.run(&empty))).is_err());
                };
                team.run(&Round { task: &task, shares: &[vec![0]] });
                team.run(&empty);
            });
        });
    }
}
