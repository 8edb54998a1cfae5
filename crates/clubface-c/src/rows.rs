//! Rows of batches: columns as callers lay them out, and threads that share the rows.

use crate::result::Failure;
use clubface_impact::columns::{Column, Reject};
use core::ops::Range;
use std::slice::{from_raw_parts, from_raw_parts_mut};

/// Numbers that a caller passes.
///
/// # Safety
/// `values` is null or holds `count` numbers.
pub(crate) unsafe fn numbers<'a>(values: *const f64, count: usize, name: &str) -> Result<&'a [f64], Failure> {
    match count {
        0 => Ok(&[]),
        _ if values.is_null() => Err(Failure::input(name, format!("null; {count} numbers are needed"))),
        // SAFETY: the caller's promise.
        _ => Ok(unsafe { from_raw_parts(values, count) }),
    }
}

/// Numbers that a caller takes.
///
/// # Safety
/// `values` is null, or holds `count` numbers that nobody else reads or writes.
pub(crate) unsafe fn numbers_out<'a>(
    values: *mut f64,
    count: usize,
    name: &str,
) -> Result<&'a mut [f64], Failure> {
    if values.is_null() {
        return Err(Failure::input(name, format!("null; room for {count} numbers is needed")));
    }
    // SAFETY: the caller's promise.
    Ok(unsafe { from_raw_parts_mut(values, count) })
}

/// Numbers of JSON, which has no infinite ones: null stands for them.
pub(crate) fn or_infinite(values: &[Option<f64>]) -> Vec<f64> {
    values.iter().map(|value| value.unwrap_or(f64::INFINITY)).collect()
}

/// Columns of `rows` numbers each.
pub(crate) fn columns(values: &[f64], rows: usize) -> Vec<Column<'_>> {
    values.chunks_exact(rows).map(Column::Values).collect()
}

/// The same number for all rows, for each number.
pub(crate) fn constants(values: &[f64]) -> Vec<Column<'static>> {
    values.iter().copied().map(Column::Constant).collect()
}

/// Checks that there are rows.
pub(crate) fn check_rows(rows: usize) -> Result<(), Failure> {
    if rows > 0 { Ok(()) } else { Err(Failure::input("rows", "0; at least 1 is needed")) }
}

/// Runs `work` over all rows, `chunk` of them at a time, on `threads` threads (0: one a core), into columns.
#[cfg_attr(not(feature = "threads"), allow(unused_variables))]
pub(crate) fn run_rows(
    threads: usize,
    chunk: usize,
    rows: usize,
    outputs: &mut [f64],
    work: impl Fn(Range<usize>, Vec<&mut [f64]>) -> Vec<Reject> + Sync + Send,
) -> Result<Vec<Reject>, Failure> {
    let columns: Vec<&mut [f64]> = outputs.chunks_exact_mut(rows).collect();
    #[cfg(feature = "threads")]
    if rows > chunk && threads != 1 {
        use clubface_impact::parallel::{in_parallel, thread_pool};
        let pool = thread_pool(threads).map_err(|e| Failure::input("threads", e.to_string()))?;
        return Ok(pool.install(|| in_parallel(chunk, 0..rows, columns, &work)));
    }
    Ok(work(0..rows, columns))
}
