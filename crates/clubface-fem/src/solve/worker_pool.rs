//! Threads that go through the stages of a time loop together.
//!
//! A step takes about a tenth of a millisecond and has two stages of tasks. That is too short to put threads to sleep
//! in between, so workers stay awake from stage to stage. Each has a queue of its own with the same tasks every time,
//! whose data its caches keep; a worker that has waited for a while claims tasks of the others. The leader needs
//! nobody: workers for which the machine has no time just do not take part.

use crate::environment::Executor;
use std::cell::Cell;
use std::sync::atomic::{AtomicBool, AtomicPtr, AtomicU32, AtomicU64, AtomicUsize, Ordering};

/// Spins before a waiting worker goes to sleep, some 0.1 ms: the one it waits for may need its core.
const SPINS_BEFORE_SLEEP: usize = 2500;
/// Spins before a waiting worker claims tasks that others have not begun: they are held up, by other programs or by
/// their tasks. Not at once, since data that moves from core to core takes longer.
const SPINS_BEFORE_STEALING: usize = 150;
/// Stage number at which workers leave.
const SHUTDOWN: u32 = u32::MAX;
/// The half of a queue's number that counts its tasks.
const REMAINING: u64 = u32::MAX as u64;

thread_local! {
    /// The pool that this thread leads.
    static CURRENT: Cell<*const WorkerPool<'static>> = const { Cell::new(std::ptr::null()) };
}

/// Number of the stage in the upper half, tasks that nobody has claimed yet in the lower; on cache lines of its own.
#[repr(align(128))]
struct Queue(AtomicU64);

/// A stage: what to do with each task, and the tasks of each worker.
pub struct Stage<'a> {
    /// Does a task (first argument) as a worker (second).
    pub task: &'a (dyn Fn(usize, usize) + Sync),
    /// Tasks of each worker, in their order.
    pub schedule: &'a [Vec<usize>],
}

/// Workers and their queues; worker 0 is the thread that leads.
pub struct WorkerPool<'a> {
    executor: &'a dyn Executor,
    queues: Vec<Queue>,
    /// Threads that have become workers.
    present: AtomicUsize,
    stage: AtomicPtr<Stage<'static>>,
    /// Number of the current stage.
    number: AtomicU32,
    /// Tasks of the current stage that have ended.
    done: AtomicUsize,
    /// Whether a stage is under way.
    busy: AtomicBool,
}

impl WorkerPool<'_> {
    /// Workers that [`WorkerPool::with`] would have here.
    #[must_use]
    pub fn size(executor: &dyn Executor) -> usize {
        // SAFETY: as in `with`.
        unsafe { CURRENT.get().as_ref() }.map_or_else(|| executor.threads(), |pool| pool.queues.len())
    }

    /// Calls `lead` while the threads of `executor` are ready for the stages it runs. Calls within it, of this
    /// function, get the same pool.
    pub fn with<T>(executor: &dyn Executor, lead: impl FnOnce(&WorkerPool<'_>) -> T) -> T {
        // SAFETY: `Shutdown` clears the pointer before the pool is gone.
        if let Some(pool) = unsafe { CURRENT.get().as_ref() } {
            return lead(pool);
        }
        let pool = WorkerPool {
            executor,
            queues: (0..executor.threads()).map(|_| Queue(AtomicU64::new(0))).collect(),
            present: AtomicUsize::new(1),
            stage: AtomicPtr::default(),
            number: AtomicU32::new(0),
            done: AtomicUsize::new(0),
            busy: AtomicBool::new(false),
        };
        let (mut lead, mut result) = (Some(lead), None);
        executor.run(
            &mut || {
                // Also when `lead` panics, or the workers would wait for ever.
                let _shutdown = Shutdown(&pool);
                CURRENT.set(std::ptr::from_ref(&pool).cast());
                result = lead.take().map(|lead| lead(&pool));
            },
            &|| pool.work(),
        );
        result.expect("an executor calls `lead` once")
    }

    /// Number of workers, the leader included.
    #[must_use]
    pub fn workers(&self) -> usize {
        self.queues.len()
    }

    /// Does every task of a stage; for the leader, and not within a task.
    pub fn run(&self, stage: &Stage<'_>) {
        assert!(stage.schedule.len() <= self.queues.len(), "a stage for more workers");
        assert!(!self.busy.swap(true, Ordering::Relaxed), "a stage within a stage");
        let number = self.number.load(Ordering::Relaxed).wrapping_add(1) % SHUTDOWN;
        self.done.store(0, Ordering::Relaxed);
        self.stage.store(std::ptr::from_ref(stage).cast_mut().cast(), Ordering::Release);
        let mut all = 0;
        for (worker, queue) in self.queues.iter().enumerate() {
            let tasks = stage.schedule.get(worker).map_or(0, Vec::len);
            queue.0.store(u64::from(number) << 32 | tasks as u64, Ordering::Release);
            all += tasks;
        }
        // Also when a task panics: nobody may be at a task of this stage when it is gone.
        let _end = StageEnd { pool: self, all };
        self.number.store(number, Ordering::Release);
        self.claim(0, 0);
        let mut spins = 0;
        while self.done.load(Ordering::Acquire) < all {
            self.wait(0, &mut spins);
        }
    }

    /// Does the tasks of `owner` as `worker`, until there are none.
    fn claim(&self, owner: usize, worker: usize) {
        let queue = &self.queues[owner].0;
        let next = |ticket: u64| (ticket & REMAINING > 0).then(|| ticket - 1);
        while let Ok(ticket) = queue.fetch_update(Ordering::AcqRel, Ordering::Acquire, next) {
            let _done = Done(&self.done);
            // SAFETY: a stage is there until all of its tasks are done, of which this is one.
            let stage = unsafe { &*self.stage.load(Ordering::Acquire) };
            let tasks = &stage.schedule[owner];
            (stage.task)(tasks[tasks.len() - (ticket & REMAINING) as usize], worker);
        }
    }

    /// Lets some time pass; claims tasks of the others when they must have been held up.
    fn wait(&self, worker: usize, spins: &mut usize) {
        *spins += 1;
        if *spins == SPINS_BEFORE_STEALING {
            let workers = self.queues.len();
            (1..workers).for_each(|turn| self.claim((worker + turn) % workers, worker));
        } else if *spins < SPINS_BEFORE_SLEEP {
            std::hint::spin_loop();
        } else {
            self.executor.sleep();
        }
    }

    /// What every worker but the leader does from the first stage to the last.
    fn work(&self) {
        let worker = self.present.fetch_add(1, Ordering::Relaxed);
        if worker >= self.queues.len() {
            return;
        }
        let mut seen = 0;
        let mut spins = 0;
        loop {
            let number = self.number.load(Ordering::Acquire);
            if number == SHUTDOWN {
                return;
            }
            if number == seen {
                self.wait(worker, &mut spins);
            } else {
                (seen, spins) = (number, 0);
                self.claim(worker, worker);
            }
        }
    }
}

/// Counts a task when it ends, also by a panic.
struct Done<'a>(&'a AtomicUsize);

impl Drop for Done<'_> {
    fn drop(&mut self) {
        self.0.fetch_add(1, Ordering::Release);
    }
}

/// Lets the workers leave.
struct Shutdown<'a>(&'a WorkerPool<'a>);

impl Drop for Shutdown<'_> {
    fn drop(&mut self) {
        CURRENT.set(std::ptr::null());
        self.0.number.store(SHUTDOWN, Ordering::Release);
    }
}

/// Waits for those who are at a task of the stage, and lets nobody begin another.
struct StageEnd<'a> {
    pool: &'a WorkerPool<'a>,
    all: usize,
}

impl Drop for StageEnd<'_> {
    fn drop(&mut self) {
        let unclaimed = |queue: &Queue| queue.0.fetch_and(!REMAINING, Ordering::AcqRel) & REMAINING;
        let unclaimed: u64 = self.pool.queues.iter().map(unclaimed).sum();
        while self.pool.done.load(Ordering::Acquire) + (unclaimed as usize) < self.all {
            std::hint::spin_loop();
        }
        self.pool.busy.store(false, Ordering::Relaxed);
    }
}
