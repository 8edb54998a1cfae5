//! Many shots at once: columns in, columns out, on all lanes and threads.

use crate::check::{check_approach, check_delivery, check_equipment, check_parameters, unseparated};
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::history::Unrecorded;
use crate::launch::OUTPUT_COUNT;
use crate::model::Accuracy;
use crate::registry::ModelKind;
use crate::shot::{DELIVERY_COUNT, INPUT_COUNT};
use clubface_math::lanes::{dispatch, Kernel, Lanes};
use clubface_math::Mask;
use core::ops::Range;
use rayon::prelude::*;

/// One input of a batch: the same for all shots, or one value a shot.
#[derive(Clone, Copy, Debug)]
pub enum Column<'a> {
    /// The same for all shots.
    Constant(f64),
    /// One value a shot.
    Values(&'a [f64]),
}

impl Column<'_> {
    /// Value for one shot.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, row: usize) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Values(values) => values[row],
        }
    }
}

/// Largest number of parameters a model may have.
pub const MOST_PARAMETERS: usize = 16;

/// Shots to compute.
#[derive(Clone, Copy, Debug)]
pub struct Batch<'a> {
    /// The model.
    pub model: ModelKind,
    /// Columns in the order of [`INPUTS`](crate::shot::INPUTS).
    pub inputs: &'a [Column<'a>],
    /// Columns in the order of the model's parameters.
    pub parameters: &'a [Column<'a>],
    /// Accuracy of contact models.
    pub accuracy: Accuracy,
}

/// A shot that could not be computed; its outputs are NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct Reject {
    /// Row of the batch, from 0.
    pub row: usize,
    /// What is wrong.
    pub error: ImpactError,
}

/// Shots a task takes: whole packs of any width, and few enough that even rings, at some 0.3 ms a shot, let a caller look
/// at signals within 0.1 s.
pub const CHUNK: usize = 64;

impl Batch<'_> {
    /// Checks that the batch is complete: columns, parameters, lengths.
    ///
    /// # Errors
    /// What does not fit.
    pub fn validate(&self, rows: usize) -> Result<(), ImpactError> {
        let info = self.model.info();
        let wanted =
            [("inputs", INPUT_COUNT, self.inputs), ("parameters", info.parameters.len(), self.parameters)];
        for (name, count, columns) in wanted {
            if columns.len() != count {
                return Err(ImpactError::new(
                    name,
                    format!("{} columns given, {count} needed", columns.len()),
                ));
            }
            for column in columns {
                if let Column::Values(values) = column {
                    if values.len() != rows {
                        let message = format!("a column has {} rows, the batch {rows}", values.len());
                        return Err(ImpactError::new(name, message));
                    }
                }
            }
        }
        Ok(())
    }

    /// Computes `rows` into `outputs`, one slice an output, each as long as `rows`. Chunks run side by side on the
    /// current rayon pool; the result does not depend on their number.
    #[must_use]
    pub fn run(&self, rows: Range<usize>, outputs: Vec<&mut [f64]>) -> Vec<Reject> {
        let mut chunks: Vec<Vec<&mut [f64]>> =
            (0..rows.len().div_ceil(CHUNK)).map(|_| Vec::with_capacity(OUTPUT_COUNT)).collect();
        for output in outputs {
            for (chunk, part) in chunks.iter_mut().zip(output.chunks_mut(CHUNK)) {
                chunk.push(part);
            }
        }
        let work = |(index, mut chunk): (usize, Vec<&mut [f64]>)| {
            let kernel = Chunk { batch: self, first: rows.start + index * CHUNK, outputs: &mut chunk };
            if self.model.info().lanes {
                dispatch(kernel)
            } else {
                kernel.run::<f64>()
            }
        };
        let rejects: Vec<Vec<Reject>> = chunks.into_par_iter().enumerate().map(work).collect();
        rejects.into_iter().flatten().collect()
    }
}

struct Chunk<'a, 'b, 'c> {
    batch: &'a Batch<'a>,
    first: usize,
    outputs: &'b mut [&'c mut [f64]],
}

impl Kernel for Chunk<'_, '_, '_> {
    type Output = Vec<Reject>;

    #[inline(always)]
    fn run<S: Lanes>(self) -> Vec<Reject> {
        let Self { batch, first, outputs } = self;
        let info = batch.model.info();
        let rows = outputs[0].len();
        let checks = Checks::new(batch);
        let mut rejects = Vec::new();
        let mut pack_start = 0;
        while pack_start < rows {
            let used = S::LANES.min(rows - pack_start);
            // Lanes beyond the last shot repeat it.
            let row = |lane: usize| first + pack_start + lane.min(used - 1);
            let mut inputs: [S; INPUT_COUNT] = gather(batch.inputs, row);
            let mut parameters: [S; MOST_PARAMETERS] = gather(batch.parameters, row);
            let mut faults: [Option<ImpactError>; MOST_LANES] = [const { None }; MOST_LANES];
            for lane in 0..used {
                faults[lane] = checks.row(batch, row(lane)).err();
            }
            let mut touch = FirstTouch::of_inputs(&inputs);
            let approach = touch.approach();
            for lane in 0..used {
                if faults[lane].is_none() {
                    faults[lane] = check_approach(approach.lane(lane)).err();
                }
            }
            if faults.iter().any(Option::is_some) {
                // A lane that cannot be computed takes a harmless shot, so that it does not hold up its pack.
                let bad = |lane: usize| faults[lane.min(used - 1)].is_some();
                replace(&mut inputs, &HARMLESS, bad);
                replace(&mut parameters, &info.defaults(), bad);
                touch = FirstTouch::of_inputs(&inputs);
            }
            let parameters = &parameters[..info.parameters.len()];
            let impact = batch.model.impact(&touch, parameters, batch.accuracy, &mut Unrecorded);
            let values = impact.launch.outputs();
            for lane in 0..used {
                if faults[lane].is_none() && !impact.separated.lane(lane) {
                    faults[lane] = Some(unseparated());
                }
                let bad = faults[lane].is_some();
                for (output, value) in outputs.iter_mut().zip(&values) {
                    output[pack_start + lane] = if bad { f64::NAN } else { value.lane(lane) };
                }
                if let Some(error) = faults[lane].take() {
                    rejects.push(Reject { row: row(lane), error });
                }
            }
            pack_start += used;
        }
        rejects
    }
}

/// Values of one row a lane.
#[inline(always)]
fn gather<S: Lanes, const N: usize>(columns: &[Column], row: impl Fn(usize) -> usize) -> [S; N] {
    let mut values = [S::zero(); N];
    for (value, column) in values.iter_mut().zip(columns) {
        *value = match column {
            Column::Constant(constant) => S::from_f64(*constant),
            Column::Values(column) => S::from_fn(|lane| column[row(lane)]),
        };
    }
    values
}

/// Puts `other` in the place of the values of some lanes.
fn replace<S: Lanes, const N: usize>(values: &mut [S; N], other: &[f64], lane_is: impl Fn(usize) -> bool) {
    for (value, &other) in values.iter_mut().zip(other) {
        *value = S::from_fn(|lane| if lane_is(lane) { other } else { value.lane(lane) });
    }
}

/// What is known of all rows of a batch: equipment and parameters that do not vary are checked once.
struct Checks {
    equipment: Option<Result<(), ImpactError>>,
    parameters: Option<Result<(), ImpactError>>,
}

impl Checks {
    fn new(batch: &Batch) -> Self {
        let fixed = |columns: &[Column]| columns.iter().all(|column| matches!(column, Column::Constant(_)));
        Self {
            equipment: fixed(&batch.inputs[DELIVERY_COUNT..])
                .then(|| check_equipment(&gather(batch.inputs, |_| 0))),
            parameters: fixed(batch.parameters).then(|| parameters_of(batch, 0)),
        }
    }

    fn row(&self, batch: &Batch, row: usize) -> Result<(), ImpactError> {
        let inputs = gather(batch.inputs, |_| row);
        self.equipment.clone().unwrap_or_else(|| check_equipment(&inputs))?;
        check_delivery(&inputs)?;
        self.parameters.clone().unwrap_or_else(|| parameters_of(batch, row))
    }
}

fn parameters_of(batch: &Batch, row: usize) -> Result<(), ImpactError> {
    let parameters: [f64; MOST_PARAMETERS] = gather(batch.parameters, |_| row);
    let info = batch.model.info();
    check_parameters(info, &parameters[..info.parameters.len()])
}

/// The widest pack.
const MOST_LANES: usize = 8;

/// A plain central impact, in the order of [`INPUTS`](crate::shot::INPUTS).
#[rustfmt::skip]
const HARMLESS: [f64; INPUT_COUNT] = [
    40.0, 0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.2, 0.04, 0.0, 0.0, 3e-4, 5e-4, 4e-4, 0.0, 0.0, 0.0, 0.2, 0.3, 0.3, 0.1, 0.05, 1.0,
    0.0459, 0.0213, 8.336e-6,
];
