//! The threads that batches share: one pool for the process, and another for each that is forked from it.

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::sync::{Arc, Mutex};

/// A pool, and the process whose threads it has.
struct Owned {
    process: u32,
    pool: Arc<ThreadPool>,
}

static SHARED: Mutex<Option<Owned>> = Mutex::new(None);

/// The pool with a thread for each core. A process forked from one that has it has none of its threads, and gets its
/// own; rayon's global pool would wait for them for ever.
pub fn shared_pool() -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
    // Another thread may have held the lock when this process was forked; then nobody opens it any more.
    let Ok(mut shared) = SHARED.try_lock() else { return new_pool() };
    let process = std::process::id();
    if let Some(owned) = shared.as_ref().filter(|owned| owned.process == process) {
        return Ok(Arc::clone(&owned.pool));
    }
    let pool = new_pool()?;
    if let Some(of_parent) = shared.replace(Owned { process, pool: Arc::clone(&pool) }) {
        std::mem::forget(of_parent.pool); // to drop it would tell threads to end that are not here
    }
    Ok(pool)
}

fn new_pool() -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
    ThreadPoolBuilder::new().build().map(Arc::new)
}
