//! Exact derivatives of launches with respect to every input and parameter, by dual numbers through the same code.

use crate::batch::{gather, split, Batch, Reject, MOST_PARAMETERS};
use crate::check::{check, check_approach, check_parameters, unseparated};
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::history::Unrecorded;
use crate::launch::OUTPUT_COUNT;
use crate::model::Accuracy;
use crate::registry::ModelKind;
use crate::shot::{INPUTS, INPUT_COUNT};
use clubface_math::lanes::{dispatch, Kernel, Lanes};
use clubface_math::{Dual, Mask, Scalar};
use core::ops::Range;
use rayon::prelude::*;

/// A launch and its derivatives.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// Outputs, in their order.
    pub values: [f64; OUTPUT_COUNT],
    /// One row an output: derivatives by the requested variables.
    pub jacobian: Vec<Vec<f64>>,
}

/// Derivatives of a launch by the chosen `variables`: indices into the inputs followed by the model's parameters.
///
/// # Errors
/// A faulty input, a club that moves away from the ball, or a contact that does not end.
pub fn sensitivity(
    model: ModelKind,
    inputs: &[f64; INPUT_COUNT],
    parameters: &[f64],
    variables: &[usize],
    accuracy: Accuracy,
) -> Result<Sensitivity, ImpactError> {
    let mut flat = vec![0.0; OUTPUT_COUNT * variables.len()];
    let values = differentiate(model, inputs, parameters, variables, accuracy, &mut flat)?;
    let width = variables.len();
    let jacobian = (0..OUTPUT_COUNT).map(|output| flat[output * width..][..width].to_vec()).collect();
    Ok(Sensitivity { values, jacobian })
}

/// [`sensitivity`] into `jacobian`, outputs by variables; returns the outputs.
fn differentiate(
    model: ModelKind,
    inputs: &[f64; INPUT_COUNT],
    parameters: &[f64],
    variables: &[usize],
    accuracy: Accuracy,
    jacobian: &mut [f64],
) -> Result<[f64; OUTPUT_COUNT], ImpactError> {
    check(inputs)?;
    check_parameters(model.info(), parameters)?;
    dispatch(Directions { model, inputs, parameters, variables, accuracy, jacobian })
}

/// Shots a task differentiates: few, since one takes some twenty times as long as its launch.
pub const CHUNK: usize = 8;

/// The launches of a batch with their derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Sensitivities<'a> {
    /// The shots.
    pub batch: Batch<'a>,
    /// Indices of the outputs wanted.
    pub outputs: &'a [usize],
    /// Indices of the variables, into the inputs followed by the model's parameters.
    pub variables: &'a [usize],
}

impl Sensitivities<'_> {
    /// Checks that the batch is complete and that what is wanted exists.
    ///
    /// # Errors
    /// What does not fit.
    pub fn validate(&self, rows: usize) -> Result<(), ImpactError> {
        self.batch.validate(rows)?;
        let count = INPUT_COUNT + self.batch.model.info().parameters.len();
        if let Some(output) = self.outputs.iter().find(|&&output| output >= OUTPUT_COUNT) {
            return Err(ImpactError::new("outputs", format!("there is no output {output}")));
        }
        let differentiable = |i: usize| i < count && (i >= INPUT_COUNT || INPUTS[i].differentiable);
        match self.variables.iter().find(|&&variable| !differentiable(variable)) {
            Some(variable) => {
                Err(ImpactError::new("variables", format!("there are no derivatives by variable {variable}")))
            }
            None => Ok(()),
        }
    }

    /// Columns of the result: for each output its value, then its derivatives.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.outputs.len() * (1 + self.variables.len())
    }

    /// Computes `rows` into `results`, one slice a column, each as long as `rows`, side by side on the current rayon pool;
    /// the result does not depend on the number of threads. Rows that cannot be computed are NaN.
    #[must_use]
    pub fn run(&self, rows: Range<usize>, results: Vec<&mut [f64]>) -> Vec<Reject> {
        let width = self.variables.len();
        let work = |(index, mut chunk): (usize, Vec<&mut [f64]>)| {
            let mut jacobian = vec![0.0; OUTPUT_COUNT * width];
            let mut rejects = Vec::new();
            for place in 0..chunk.first().map_or(0, |column| column.len()) {
                let row = rows.start + index * CHUNK + place;
                let found = self.shot(row, &mut jacobian);
                for (columns, &output) in chunk.chunks_mut(1 + width).zip(self.outputs) {
                    columns[0][place] = found.as_ref().map_or(f64::NAN, |values| values[output]);
                    for (i, column) in columns[1..].iter_mut().enumerate() {
                        column[place] = if found.is_ok() { jacobian[output * width + i] } else { f64::NAN };
                    }
                }
                rejects.extend(found.err().map(|error| Reject { row, error }));
            }
            rejects
        };
        let chunks = split(results, rows.len(), CHUNK);
        let rejects: Vec<Vec<Reject>> = chunks.into_par_iter().enumerate().map(work).collect();
        rejects.into_iter().flatten().collect()
    }

    fn shot(&self, row: usize, jacobian: &mut [f64]) -> Result<[f64; OUTPUT_COUNT], ImpactError> {
        let Batch { model, inputs, parameters, accuracy } = self.batch;
        let given: [f64; MOST_PARAMETERS] = gather(parameters, row, 1);
        let given = &given[..parameters.len()];
        differentiate(model, &gather(inputs, row, 1), given, self.variables, accuracy, jacobian)
    }
}

struct Directions<'a> {
    model: ModelKind,
    inputs: &'a [f64; INPUT_COUNT],
    parameters: &'a [f64],
    variables: &'a [usize],
    accuracy: Accuracy,
    jacobian: &'a mut [f64],
}

/// Derivatives a lane carries: with eight lanes one pass takes 8 variables.
const WIDTH: usize = 1;

impl Kernel for Directions<'_> {
    type Output = Result<[f64; OUTPUT_COUNT], ImpactError>;

    /// All lanes hold the same shot; lane l of tangent i is the derivative by variable i * lanes + l of the pass.
    #[inline(always)]
    fn run<S: Lanes>(self) -> Self::Output {
        let mut values = [f64::NAN; OUTPUT_COUNT];
        let width = self.variables.len();
        let pass = S::LANES * WIDTH;
        for start in (0..self.variables.len().max(1)).step_by(pass) {
            let chosen = &self.variables[start.min(self.variables.len())..];
            let chosen = &chosen[..chosen.len().min(pass)];
            let seed = |index: usize, value: f64| {
                let mut dual: Dual<S, WIDTH> = Dual::from_f64(value);
                for i in 0..WIDTH {
                    let hit = |lane: usize| chosen.get(i * S::LANES + lane) == Some(&index);
                    dual.tangent[i] = S::from_fn(|lane| f64::from(u8::from(hit(lane))));
                }
                dual
            };
            let mut inputs = [Dual::<S, WIDTH>::zero(); INPUT_COUNT];
            for i in 0..INPUT_COUNT {
                inputs[i] = seed(i, self.inputs[i]);
            }
            let mut parameters = [Dual::<S, WIDTH>::zero(); MOST_PARAMETERS];
            for i in 0..self.parameters.len() {
                parameters[i] = seed(INPUT_COUNT + i, self.parameters[i]);
            }
            let touch = FirstTouch::of_inputs(&inputs);
            check_approach(touch.approach().re())?;
            let parameters = &parameters[..self.parameters.len()];
            let impact = self.model.impact(&touch, parameters, self.accuracy, &mut Unrecorded);
            if !impact.separated.all() {
                return Err(unseparated());
            }
            for (output, value) in impact.launch.outputs().iter().enumerate() {
                values[output] = value.re();
                for i in 0..chosen.len() {
                    self.jacobian[output * width + start + i] =
                        value.tangent[i / S::LANES].lane(i % S::LANES);
                }
            }
        }
        Ok(values)
    }
}
