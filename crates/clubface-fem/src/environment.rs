//! What a simulation needs from the program that runs it: a clock, and threads.
//!
//! The engine reads no clock and starts no thread by itself, so that it runs wherever Rust does, WebAssembly included.

use std::sync::Arc;

/// Threads that work on one simulation together.
pub trait Executor: Send + Sync {
    /// Number of threads, the calling one included; at least 1.
    fn threads(&self) -> usize;
    /// Calls `lead` on the calling thread. Meanwhile every other thread may call `help` once; threads that are busy
    /// elsewhere need not. Returns when all of these calls have ended, also when `lead` panics.
    fn run(&self, lead: &mut dyn FnMut(), help: &(dyn Fn() + Sync));
    /// Leaves the processor to other threads for some microseconds. A thread that has waited in vain for a while calls
    /// it.
    fn sleep(&self);
}

/// The calling thread alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct SingleThread;

impl Executor for SingleThread {
    fn threads(&self) -> usize {
        1
    }
    fn run(&self, lead: &mut dyn FnMut(), _help: &(dyn Fn() + Sync)) {
        lead();
    }
    fn sleep(&self) {}
}

/// A clock and threads for a simulation.
#[derive(Clone)]
pub struct Environment {
    /// Time since some fixed moment, s. It only serves to report how long a run took.
    pub clock: fn() -> f64,
    /// Threads. Results are the same, bit for bit, whatever their number.
    pub executor: Arc<dyn Executor>,
}

impl Environment {
    /// The calling thread alone, and no clock: the reported wall time is NaN.
    #[must_use]
    pub fn single_threaded() -> Self {
        Self { clock: || f64::NAN, executor: Arc::new(SingleThread) }
    }
}

#[cfg(feature = "threads")]
mod native {
    use super::{Environment, Executor};
    use rayon::{Scope, ThreadPool};
    use std::sync::{Arc, LazyLock};
    use std::time::{Duration, Instant};

    /// How long a thread sleeps that has waited in vain.
    const SLEEP: Duration = Duration::from_micros(20);

    /// The threads of a rayon pool; without one, of that in which it is used.
    struct RayonPool(Option<Arc<ThreadPool>>);

    impl Executor for RayonPool {
        fn threads(&self) -> usize {
            self.0.as_ref().map_or_else(rayon::current_num_threads, |pool| pool.current_num_threads())
        }
        fn run(&self, lead: &mut dyn FnMut(), help: &(dyn Fn() + Sync)) {
            let helpers = self.threads() - 1;
            match &self.0 {
                Some(pool) => pool.in_place_scope(|scope| lead_with(scope, helpers, lead, help)),
                None => rayon::in_place_scope(|scope| lead_with(scope, helpers, lead, help)),
            }
        }
        fn sleep(&self) {
            std::thread::sleep(SLEEP);
        }
    }

    fn lead_with<'a>(scope: &Scope<'a>, helpers: usize, lead: &mut dyn FnMut(), help: &'a (dyn Fn() + Sync)) {
        for _ in 0..helpers {
            scope.spawn(|_| help());
        }
        lead();
    }

    impl Environment {
        /// The clock of the operating system, and the threads of the rayon pool in which the simulation is run: that of
        /// `ThreadPool::install`, or the global one.
        #[must_use]
        pub fn native() -> Self {
            static START: LazyLock<Instant> = LazyLock::new(Instant::now);
            Self { clock: || START.elapsed().as_secs_f64(), executor: Arc::new(RayonPool(None)) }
        }

        /// The clock of the operating system, and the threads of one rayon pool, from wherever they are called.
        #[must_use]
        pub fn with_pool(pool: &Arc<ThreadPool>) -> Self {
            Self { executor: Arc::new(RayonPool(Some(Arc::clone(pool)))), ..Self::native() }
        }
    }
}
