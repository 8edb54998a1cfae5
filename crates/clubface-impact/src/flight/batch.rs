//! Many shots: packs of lanes, threads, progress and interruption.

use super::check::{check, never_lands};
use super::shot::{fly, FlightShot, INPUTS, INPUT_COUNT, OUTPUT_COUNT};
use super::trajectory::TOLERANCE;
use crate::error::ImpactError;
use clubface_math::{dispatch, Kernel, Lanes, Mask};
use rayon::prelude::*;
use thiserror::Error;

/// Shots one thread flies between two reports of progress: a few milliseconds, tens at worst.
const CHUNK: usize = 1024;

/// An input of a batch, in the order of [`INPUTS`].
#[derive(Clone, Copy, Debug)]
pub enum Column<'a> {
    /// The same value for all shots.
    Constant(f64),
    /// A value for each shot.
    Values(&'a [f64]),
}

impl Column<'_> {
    #[inline(always)]
    fn at(self, row: usize) -> f64 {
        match self {
            Self::Constant(value) => value,
            Self::Values(values) => values[row],
        }
    }
}

/// A shot that could not be flown; its outputs are NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Index of the shot.
    pub row: usize,
    /// What is wrong with it.
    pub error: ImpactError,
}

/// Results of a batch.
#[derive(Clone, Debug)]
pub struct Batch {
    /// Output i of shot j at `i * shots + j`.
    pub outputs: Vec<f64>,
    /// Shots without a result, by row.
    pub problems: Vec<Problem>,
}

/// A batch that was not run, or not finished.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum BatchError {
    /// Not one column an input.
    #[error("a flight has {INPUT_COUNT} inputs, but {0} columns were given")]
    Columns(usize),
    /// A column of the wrong length.
    #[error("column {name} has {found} values, but the batch has {rows} shots")]
    Length {
        /// Name of the input.
        name: &'static str,
        /// Its length.
        found: usize,
        /// Number of shots.
        rows: usize,
    },
    /// No memory for the results.
    #[error("the results of {0} shots do not fit into memory: fly them in parts")]
    Memory(usize),
    /// The threads could not be started.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// Number asked for.
        threads: usize,
        /// What the system says.
        reason: String,
    },
    /// Progress asked to stop.
    #[error("interrupted after {0} shots")]
    Interrupted(usize),
}

/// Flies `rows` shots on `threads` threads (0: one a core).
///
/// `progress` hears from the calling thread, every few milliseconds, how many shots are done; it stops the batch by
/// returning false. The results do not depend on the number of threads or on a shot's neighbours.
///
/// # Errors
/// Columns that do not fit the call, no memory, or an interruption. Shots that cannot be flown are no error: they are
/// listed with their reasons.
pub fn fly_batch(
    columns: &[Column<'_>],
    rows: usize,
    threads: usize,
    progress: &mut dyn FnMut(usize) -> bool,
) -> Result<Batch, BatchError> {
    let columns: &[Column<'_>; INPUT_COUNT] =
        columns.try_into().map_err(|_| BatchError::Columns(columns.len()))?;
    for (input, column) in INPUTS.iter().zip(columns) {
        if let Column::Values(values) = column {
            if values.len() != rows {
                return Err(BatchError::Length { name: input.name, found: values.len(), rows });
            }
        }
    }
    let mut outputs = Vec::new();
    let size = rows.checked_mul(OUTPUT_COUNT).ok_or(BatchError::Memory(rows))?;
    outputs.try_reserve_exact(size).map_err(|_| BatchError::Memory(rows))?;
    outputs.resize(size, f64::NAN);

    let threads = if threads == 0 { rayon::current_num_threads() } else { threads };
    let pool = (threads > 1 && rows > CHUNK)
        .then(|| rayon::ThreadPoolBuilder::new().num_threads(threads).build())
        .transpose()
        .map_err(|error| BatchError::Threads { threads, reason: error.to_string() })?;
    let mut problems = Vec::new();
    let mut done = 0;
    while done < rows {
        let end = rows.min(done + CHUNK * threads);
        let starts: Vec<usize> = (done..end).step_by(CHUNK).collect();
        let part = |&start: &usize| dispatch(Rows { columns, start, end: end.min(start + CHUNK) });
        let parts: Vec<Part> = match &pool {
            Some(pool) => pool.install(|| starts.par_iter().map(part).collect()),
            None => starts.iter().map(part).collect(),
        };
        for (start, part) in starts.into_iter().zip(parts) {
            for (i, values) in part.outputs.iter().enumerate() {
                let place = i * rows + start;
                outputs[place..place + values.len()].copy_from_slice(values);
            }
            problems.extend(part.problems);
        }
        done = end;
        if !progress(done) {
            return Err(BatchError::Interrupted(done));
        }
    }
    Ok(Batch { outputs, problems })
}

/// Results of consecutive shots.
struct Part {
    outputs: [Vec<f64>; OUTPUT_COUNT],
    problems: Vec<Problem>,
}

struct Rows<'a> {
    columns: &'a [Column<'a>; INPUT_COUNT],
    start: usize,
    end: usize,
}

impl Kernel for Rows<'_> {
    type Output = Part;

    #[inline(always)]
    fn run<S: Lanes>(self) -> Part {
        let count = self.end - self.start;
        let mut part =
            Part { outputs: core::array::from_fn(|_| Vec::with_capacity(count)), problems: Vec::new() };
        let mut row = self.start;
        while row < self.end {
            let used = S::LANES.min(self.end - row);
            // A lane without a good shot of its own flies a harmless one, which costs the pack nothing.
            let mut good = [false; MOST_LANES];
            let mut shots = [HARMLESS; MOST_LANES];
            for lane in 0..used {
                let shot: [f64; INPUT_COUNT] = core::array::from_fn(|i| self.columns[i].at(row + lane));
                match check(&shot) {
                    Ok(()) => {
                        good[lane] = true;
                        shots[lane] = shot;
                    }
                    Err(error) => part.problems.push(Problem { row: row + lane, error }),
                }
            }
            let inputs: [S; INPUT_COUNT] = core::array::from_fn(|i| S::from_fn(|lane| shots[lane][i]));
            let flown = fly(&FlightShot::from_inputs(&inputs), TOLERANCE);
            let outputs = flown.outputs();
            for lane in 0..used {
                let landed = flown.landing.landed.lane(lane);
                if good[lane] && !landed {
                    part.problems.push(Problem { row: row + lane, error: never_lands() });
                }
                for i in 0..OUTPUT_COUNT {
                    part.outputs[i].push(if good[lane] && landed { outputs[i].lane(lane) } else { f64::NAN });
                }
            }
            row += used;
        }
        part.problems.sort_by_key(|problem| problem.row);
        part
    }
}

/// The widest pack.
const MOST_LANES: usize = 8;

/// A ball struck down into the ground, whose flight is over at once.
const HARMLESS: [f64; INPUT_COUNT] = {
    let mut shot = [0.0; INPUT_COUNT];
    let mut i = 0;
    while i < INPUT_COUNT {
        shot[i] = INPUTS[i].default;
        i += 1;
    }
    let launch = [1.0, -1.0, 0.0, 0.0, 0.0, 0.0];
    let mut i = 0;
    while i < launch.len() {
        shot[3 + i] = launch[i];
        i += 1;
    }
    shot
};
