//! Many shots at once: columns in, columns out, on all lanes and threads.

use crate::check::{
    check_approach, check_delivery, check_equipment, check_parameters, good_delivery, good_parameters,
    unseparated,
};
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::history::Unrecorded;
use crate::model::{Accuracy, ModelInfo};
use crate::registry::ModelKind;
use crate::shot::{DELIVERY_COUNT, INPUT_COUNT};
use clubface_math::lanes::{dispatch, Kernel, Lanes};
use clubface_math::{Mask, Scalar};
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
        let work = |(index, mut chunk): (usize, Vec<&mut [f64]>)| {
            // A pack costs more than one shot alone.
            let packs = self.model.info().lanes && chunk[0].len() > 1;
            let kernel = Chunk { batch: self, first: rows.start + index * CHUNK, outputs: &mut chunk };
            if packs {
                dispatch(kernel)
            } else {
                kernel.run::<f64>()
            }
        };
        let chunks = split(outputs, rows.len(), CHUNK);
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
        let mut checks = Checks::new(batch);
        let mut rejects = Vec::new();
        let mut pack_start = 0;
        while pack_start < rows {
            let used = S::LANES.min(rows - pack_start);
            let start = first + pack_start;
            let row = |lane: usize| start + lane.min(used - 1);
            let mut inputs: [S; INPUT_COUNT] = gather(batch.inputs, start, used);
            let mut parameters: [S; MOST_PARAMETERS] = gather(batch.parameters, start, used);
            let mut faults: [Option<ImpactError>; MOST_LANES] = [const { None }; MOST_LANES];
            let mut touch = FirstTouch::of_inputs(&inputs);
            let approach = touch.approach();
            let good = checks.good(&inputs, info, &parameters).and(approach.gt(S::zero()));
            if !good.all() {
                for lane in 0..used {
                    faults[lane] =
                        checks.row(batch, row(lane)).and_then(|()| check_approach(approach.lane(lane))).err();
                }
            }
            if !good.all() && faults.iter().any(Option::is_some) {
                // A lane that cannot be computed takes a harmless shot, so that it does not hold up its pack.
                let bad = |lane: usize| faults[lane.min(used - 1)].is_some();
                replace(&mut inputs, &HARMLESS, bad);
                replace(&mut parameters, &info.defaults(), bad);
                touch = FirstTouch::of_inputs(&inputs);
            }
            let parameters = &parameters[..info.parameters.len()];
            let impact = batch.model.impacts(&touch, parameters, batch.accuracy, &mut Unrecorded);
            let values = impact.launch.outputs();
            for (output, value) in outputs.iter_mut().zip(&values) {
                if used == S::LANES {
                    value.store(&mut output[pack_start..]);
                } else {
                    for lane in 0..used {
                        output[pack_start + lane] = value.lane(lane);
                    }
                }
            }
            if !good.and(impact.separated).all() {
                for lane in 0..used {
                    if faults[lane].is_none() && !impact.separated.lane(lane) {
                        faults[lane] = Some(unseparated());
                    }
                    if let Some(error) = faults[lane].take() {
                        rejects.push(Reject { row: row(lane), error });
                        for output in outputs.iter_mut() {
                            output[pack_start + lane] = f64::NAN;
                        }
                    }
                }
            }
            pack_start += used;
        }
        rejects
    }
}

/// Cuts columns of `rows` into chunks of `size` rows: for each chunk, its part of every column.
pub(crate) fn split(columns: Vec<&mut [f64]>, rows: usize, size: usize) -> Vec<Vec<&mut [f64]>> {
    let mut chunks: Vec<Vec<&mut [f64]>> =
        (0..rows.div_ceil(size)).map(|_| Vec::with_capacity(columns.len())).collect();
    for column in columns {
        for (chunk, part) in chunks.iter_mut().zip(column.chunks_mut(size)) {
            chunk.push(part);
        }
    }
    chunks
}

/// Values of `used` rows from `start`, one a lane; lanes beyond the last row repeat it.
#[inline(always)]
pub(crate) fn gather<S: Lanes, const N: usize>(columns: &[Column], start: usize, used: usize) -> [S; N] {
    let mut values = [S::zero(); N];
    for (value, column) in values.iter_mut().zip(columns) {
        *value = match column {
            Column::Constant(constant) => S::from_f64(*constant),
            Column::Values(column) if used == S::LANES => S::load(&column[start..]),
            Column::Values(column) => S::from_fn(|lane| column[start + lane.min(used - 1)]),
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

/// What is known of the rows of a batch: the equipment that was last found good, since it hardly ever varies, and whether
/// parameters that do not vary are good.
struct Checks {
    equipment: Option<[f64; INPUT_COUNT]>,
    parameters: Option<Result<(), ImpactError>>,
}

impl Checks {
    fn new(batch: &Batch) -> Self {
        let fixed = batch.parameters.iter().all(|column| matches!(column, Column::Constant(_)));
        Self { equipment: None, parameters: fixed.then(|| parameters_of(batch, 0)) }
    }

    /// The lanes that need no further check.
    #[inline(always)]
    fn good<S: Scalar>(&mut self, inputs: &[S; INPUT_COUNT], info: &ModelInfo, parameters: &[S]) -> S::Mask {
        let mut good = good_delivery(inputs);
        if self.equipment.is_none() {
            let mut values = [0.0; INPUT_COUNT];
            for (value, input) in values.iter_mut().zip(inputs) {
                *value = input.re();
            }
            self.equipment = check_equipment(&values).is_ok().then_some(values);
        }
        let Some(equipment) = &self.equipment else { return S::Mask::splat(false) };
        for i in DELIVERY_COUNT..INPUT_COUNT {
            let known = S::from_f64(equipment[i]);
            good = good.and(inputs[i].le(known)).and(inputs[i].ge(known));
        }
        match &self.parameters {
            Some(Ok(())) => good,
            Some(Err(_)) => S::Mask::splat(false),
            None => good.and(good_parameters(info, parameters)),
        }
    }

    fn row(&self, batch: &Batch, row: usize) -> Result<(), ImpactError> {
        let inputs = gather(batch.inputs, row, 1);
        check_equipment(&inputs)?;
        check_delivery(&inputs)?;
        self.parameters.clone().unwrap_or_else(|| parameters_of(batch, row))
    }
}

fn parameters_of(batch: &Batch, row: usize) -> Result<(), ImpactError> {
    let parameters: [f64; MOST_PARAMETERS] = gather(batch.parameters, row, 1);
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
