//! Many shots: columns in, columns out, on all lanes and threads.

use super::check::{check, good, never_lands};
use super::shot::{FlightShot, INPUT_COUNT, INPUTS, fly};
use super::trajectory::TOLERANCE;
use crate::columns::{Column, MOST_ROWS, Reject, gather};
use crate::error::ImpactError;
use clubface_math::{Mask, Numbers, RowsKernel, dispatch_rows};
use core::ops::Range;

/// Shots to fly.
#[derive(Clone, Copy, Debug)]
pub struct FlightBatch<'a> {
    /// Columns in the order of [`INPUTS`].
    pub inputs: &'a [Column<'a>],
}

impl FlightBatch<'_> {
    /// Checks that the batch is complete: number of columns and their lengths.
    ///
    /// # Errors
    /// What does not fit.
    pub fn validate(&self, rows: usize) -> Result<(), ImpactError> {
        if self.inputs.len() != INPUT_COUNT {
            let message = format!("{} columns given, {INPUT_COUNT} needed", self.inputs.len());
            return Err(ImpactError::new("inputs", message));
        }
        for (column, input) in self.inputs.iter().zip(&INPUTS) {
            if let Column::Values(values) = column
                && values.len() != rows
            {
                let message = format!("the column has {} rows, the batch {rows}", values.len());
                return Err(ImpactError::new(input.quantity.name, message));
            }
        }
        Ok(())
    }

    /// Flies `rows` into `outputs`, one slice an output, each as long as `rows`, on the calling thread. Shots that
    /// cannot be flown are NaN and returned with reasons. A shot does not depend on its neighbours, so rows may be
    /// shared out among threads: one flies a [`CHUNK`](crate::batch::CHUNK) in a few milliseconds.
    #[must_use]
    pub fn run(&self, rows: Range<usize>, mut outputs: Vec<&mut [f64]>) -> Vec<Reject> {
        dispatch_rows(rows.len(), Flights { inputs: self.inputs, rows, outputs: &mut outputs })
    }
}

struct Flights<'a, 'b, 'c> {
    inputs: &'a [Column<'a>],
    rows: Range<usize>,
    outputs: &'b mut [&'c mut [f64]],
}

impl RowsKernel for Flights<'_, '_, '_> {
    type Output = Vec<Reject>;

    #[inline(always)]
    fn run<S: Numbers>(self) -> Vec<Reject> {
        let Self { inputs: columns, rows, outputs } = self;
        let first = rows.start;
        let mut rejects = Vec::new();
        for start in (0..rows.len()).step_by(S::LANES) {
            let used = S::LANES.min(rows.len() - start);
            let mut faults: [Option<ImpactError>; MOST_ROWS] = [const { None }; MOST_ROWS];
            let inputs = read_shots::<S>(columns, first + start, used, &mut faults);
            let flown = fly(&FlightShot::from_inputs(&inputs), TOLERANCE);
            let values = flown.outputs();
            let landed = flown.landing.landed;
            if used == S::LANES && landed.all() && faults.iter().all(Option::is_none) {
                for (output, value) in outputs.iter_mut().zip(&values) {
                    value.write_to(&mut output[start..]);
                }
                continue;
            }
            for lane in 0..used {
                if faults[lane].is_none() && !landed.lane(lane) {
                    faults[lane] = Some(never_lands());
                }
                let bad = faults[lane].is_some();
                for (output, value) in outputs.iter_mut().zip(&values) {
                    output[start + lane] = if bad { f64::NAN } else { value.lane(lane) };
                }
                if let Some(error) = faults[lane].take() {
                    rejects.push(Reject { row: first + start + lane, error });
                }
            }
        }
        rejects
    }
}

/// The shots of one pack, `used` rows from `first` on. A lane without a good shot of its own takes a harmless one, which
/// costs the pack nothing, and `faults` says what is wrong.
#[inline(always)]
pub(super) fn read_shots<S: Numbers>(
    columns: &[Column],
    first: usize,
    used: usize,
    faults: &mut [Option<ImpactError>],
) -> [S; INPUT_COUNT] {
    let inputs: [S; INPUT_COUNT] = gather(columns, first, used);
    if good(&inputs).all() {
        return inputs;
    }
    let shot = |lane: usize| -> [f64; INPUT_COUNT] { core::array::from_fn(|i| columns[i].at(first + lane)) };
    for lane in 0..used {
        faults[lane] = check(&shot(lane)).err();
    }
    let mut mended = inputs;
    for i in 0..INPUT_COUNT {
        mended[i] = S::from_fn(|lane| {
            let lane = lane.min(used - 1);
            if faults[lane].is_none() { inputs[i].lane(lane) } else { HARMLESS[i] }
        });
    }
    mended
}

/// A ball struck down into the ground, whose flight is over at once.
const HARMLESS: [f64; INPUT_COUNT] = {
    let mut shot = [0.0; INPUT_COUNT];
    let mut i = 0;
    while i < INPUT_COUNT {
        shot[i] = if i >= 3 && i < 9 { 0.0 } else { INPUTS[i].default };
        i += 1;
    }
    shot[3] = 1.0;
    shot[4] = -1.0;
    shot
};
