//! Exact derivatives of many flights: a lane holds a shot, and carries its derivatives by a few variables at a time.

use super::batch::{FlightBatch, read_shots};
use super::check::never_lands;
use super::shot::{FlightShot, INPUT_COUNT, OUTPUT_COUNT, fly};
use super::trajectory::TOLERANCE;
use crate::columns::{MOST_LANES, Reject};
use crate::error::ImpactError;
use clubface_math::{Dual, Kernel, Lanes, Mask, dispatch};
use core::ops::Range;

/// Derivatives of a pass: those by a launch, velocity and spin, take one.
const WIDTH: usize = 6;

/// Shots a task differentiates: few, since one takes some ten times as long as its flight.
pub const CHUNK: usize = 64;

/// Flights with their derivatives.
#[derive(Clone, Copy, Debug)]
pub struct FlightSensitivities<'a> {
    /// The shots.
    pub batch: FlightBatch<'a>,
    /// Indices of the outputs wanted.
    pub outputs: &'a [usize],
    /// Indices of the variables, into the inputs.
    pub variables: &'a [usize],
}

impl FlightSensitivities<'_> {
    /// Checks that the batch is complete and that what is wanted exists.
    ///
    /// # Errors
    /// What does not fit.
    pub fn validate(&self, rows: usize) -> Result<(), ImpactError> {
        self.batch.validate(rows)?;
        for (what, wanted, count) in
            [("outputs", self.outputs, OUTPUT_COUNT), ("variables", self.variables, INPUT_COUNT)]
        {
            if let Some(index) = wanted.iter().find(|&&index| index >= count) {
                return Err(ImpactError::new(what, format!("there is no number {index} of {count}")));
            }
        }
        Ok(())
    }

    /// Columns of the result: for each output its value, then its derivatives.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.outputs.len() * (1 + self.variables.len())
    }

    /// Computes `rows` into `results`, one slice a column, each as long as `rows`, on the calling thread. Rows that
    /// cannot be flown are NaN and returned with reasons. Rows may be shared out among threads, [`CHUNK`] at a time.
    ///
    /// They go through the landing exactly; where one has a kink, it has the derivative of the side the shot is on.
    #[must_use]
    pub fn run(&self, rows: Range<usize>, mut results: Vec<&mut [f64]>) -> Vec<Reject> {
        dispatch(Derivatives { wanted: *self, rows, results: &mut results })
    }
}

struct Derivatives<'a, 'b, 'c> {
    wanted: FlightSensitivities<'a>,
    rows: Range<usize>,
    results: &'b mut [&'c mut [f64]],
}

impl Kernel for Derivatives<'_, '_, '_> {
    type Output = Vec<Reject>;

    #[inline(always)]
    fn run<S: Lanes>(self) -> Vec<Reject> {
        let Self { wanted: FlightSensitivities { batch, outputs, variables }, rows, results } = self;
        let stride = 1 + variables.len();
        let mut rejects = Vec::new();
        for start in (0..rows.len()).step_by(S::LANES) {
            let used = S::LANES.min(rows.len() - start);
            let first = rows.start + start;
            let mut faults: [Option<ImpactError>; MOST_LANES] = [const { None }; MOST_LANES];
            let shots = read_shots::<S>(batch.inputs, first, used, &mut faults);
            for begin in (0..variables.len().max(1)).step_by(WIDTH) {
                let chosen = &variables[begin..variables.len().min(begin + WIDTH)];
                let mut inputs: [Dual<S, WIDTH>; INPUT_COUNT] =
                    core::array::from_fn(|i| Dual::constant(shots[i]));
                for (direction, &variable) in chosen.iter().enumerate() {
                    inputs[variable].tangent[direction] = S::from_f64(1.0);
                }
                let flown = fly(&FlightShot::from_inputs(&inputs), TOLERANCE);
                let values = flown.outputs();
                for lane in 0..used {
                    if faults[lane].is_none() && !flown.landing.landed.lane(lane) {
                        faults[lane] = Some(never_lands());
                    }
                    for (columns, &output) in results.chunks_mut(stride).zip(outputs) {
                        columns[0][start + lane] = values[output].value.lane(lane);
                        for direction in 0..chosen.len() {
                            columns[1 + begin + direction][start + lane] =
                                values[output].tangent[direction].lane(lane);
                        }
                    }
                }
            }
            for lane in 0..used {
                if let Some(error) = faults[lane].take() {
                    for column in results.iter_mut() {
                        column[start + lane] = f64::NAN;
                    }
                    rejects.push(Reject { row: first + lane, error });
                }
            }
        }
        rejects
    }
}
