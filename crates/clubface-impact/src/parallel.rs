//! The rows of a batch side by side on the threads of the caller.

use crate::columns::Reject;
use core::ops::Range;
use rayon::prelude::*;

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
