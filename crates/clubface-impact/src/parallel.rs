//! The rows of a batch side by side, and the threads that batches share.

use crate::columns::Reject;
use core::ops::Range;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::sync::{Arc, Mutex};

/// Runs `work` over `rows`, `chunk` of them at a time, side by side on the current rayon pool; `columns` are what it
/// writes, each as long as `rows`. The result does not depend on the number of threads.
pub fn in_parallel<W>(chunk: usize, rows: Range<usize>, columns: Vec<&mut [f64]>, work: W) -> Vec<Reject>
where
    W: Fn(Range<usize>, Vec<&mut [f64]>) -> Vec<Reject> + Sync,
{
    let mut chunks: Vec<Vec<&mut [f64]>> =
        (0..rows.len().div_ceil(chunk)).map(|_| Vec::with_capacity(columns.len())).collect();
    for column in columns {
        for (chunk, part) in chunks.iter_mut().zip(column.chunks_mut(chunk)) {
            chunk.push(part);
        }
    }
    let rejects: Vec<Vec<Reject>> = chunks
        .into_par_iter()
        .enumerate()
        .map(|(index, columns)| {
            let first = rows.start + index * chunk;
            work(first..rows.end.min(first + chunk), columns)
        })
        .collect();
    rejects.into_iter().flatten().collect()
}

/// A pool, and the process whose threads it has.
struct Owned {
    process: u32,
    pool: Arc<ThreadPool>,
}

static SHARED: Mutex<Option<Owned>> = Mutex::new(None);

/// A pool of `threads` threads; for 0 the pool that batches of this process share, with a thread for each core.
///
/// # Errors
/// Threads that the operating system does not give.
pub fn thread_pool(threads: usize) -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
    if threads == 0 {
        shared_pool()
    } else {
        ThreadPoolBuilder::new().num_threads(threads).build().map(Arc::new)
    }
}

/// The pool with a thread for each core. A process forked from one that has it has none of its threads, and gets its
/// own; rayon's global pool would wait for them for ever.
fn shared_pool() -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
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
