//! Exact derivatives of launches with respect to every input and parameter.

use crate::batch::Batch;
use crate::columns::{Reject, gather};
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::impact::Accuracy;
use crate::impact_model::ImpactModel;
use crate::kernels::{Differentiated, MOST_PARAMETERS};
use crate::launch::OUTPUT_COUNT;
use crate::shot::{INPUT_COUNT, INPUTS};
use core::ops::Range;

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
/// A faulty input, a wrong number of parameters, a club that moves away from the ball, or a contact that does not end.
pub fn sensitivity(
    model: ImpactModel,
    inputs: &[f64; INPUT_COUNT],
    parameters: &[f64],
    variables: &[usize],
    accuracy: Accuracy,
) -> Result<Sensitivity, ImpactError> {
    model.check_count(parameters)?;
    let width = variables.len();
    let mut flat = vec![0.0; OUTPUT_COUNT * width];
    let values = model.derivatives(&Differentiated { inputs, parameters, variables, accuracy }, &mut flat)?;
    let jacobian = (0..OUTPUT_COUNT).map(|output| flat[output * width..][..width].to_vec()).collect();
    Ok(Sensitivity { values, jacobian })
}

/// Derivatives of a launch by every input and parameter; NaN by an input that is not differentiable, and by what shaft and
/// hands would add to a free head, which takes time and is hardly ever asked for.
///
/// # Errors
/// As [`sensitivity`].
pub fn sensitivity_to_all(
    model: ImpactModel,
    inputs: &[f64; INPUT_COUNT],
    parameters: &[f64],
    accuracy: Accuracy,
) -> Result<Sensitivity, ImpactError> {
    let count = INPUT_COUNT + parameters.len();
    let is_free = FirstTouch::from_inputs(inputs).head.added.is_none();
    let left_out = |i: usize| is_free && INPUTS.get(i).is_some_and(|input| input.group == "attachment");
    let variables: Vec<usize> = (0..count).filter(|&i| differentiable(model, i) && !left_out(i)).collect();
    let mut result = sensitivity(model, inputs, parameters, &variables, accuracy)?;
    for row in &mut result.jacobian {
        let mut whole = vec![f64::NAN; count];
        for (&variable, &derivative) in variables.iter().zip(&*row) {
            whole[variable] = derivative;
        }
        *row = whole;
    }
    Ok(result)
}

/// Whether there are derivatives by a variable.
fn differentiable(model: ImpactModel, variable: usize) -> bool {
    match INPUTS.get(variable) {
        Some(input) => input.differentiable,
        None => variable < INPUT_COUNT + model.info().parameters.len(),
    }
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
        if let Some(output) = self.outputs.iter().find(|&&output| output >= OUTPUT_COUNT) {
            return Err(ImpactError::new("outputs", format!("there is no output {output}")));
        }
        match self.variables.iter().find(|&&variable| !differentiable(self.batch.model, variable)) {
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

    /// Computes `rows` into `results`, one slice a column, each as long as `rows`, on the calling thread. Rows that
    /// cannot be computed are NaN and returned with reasons. Rows may be shared out among threads, [`CHUNK`] at a time.
    #[must_use]
    pub fn run(&self, rows: Range<usize>, mut results: Vec<&mut [f64]>) -> Vec<Reject> {
        let width = self.variables.len();
        let mut jacobian = vec![0.0; OUTPUT_COUNT * width];
        let mut rejects = Vec::new();
        for (place, row) in rows.enumerate() {
            let result = self.shot(row, &mut jacobian);
            for (columns, &output) in results.chunks_mut(1 + width).zip(self.outputs) {
                columns[0][place] = result.as_ref().map_or(f64::NAN, |values| values[output]);
                for (i, column) in columns[1..].iter_mut().enumerate() {
                    column[place] = if result.is_ok() { jacobian[output * width + i] } else { f64::NAN };
                }
            }
            rejects.extend(result.err().map(|error| Reject { row, error }));
        }
        rejects
    }

    fn shot(&self, row: usize, jacobian: &mut [f64]) -> Result<[f64; OUTPUT_COUNT], ImpactError> {
        let Batch { model, inputs, parameters, accuracy } = self.batch;
        let given: [f64; MOST_PARAMETERS] = gather(parameters, row, 1);
        let (inputs, parameters) = (&gather(inputs, row, 1), &given[..parameters.len()]);
        model.derivatives(
            &Differentiated { inputs, parameters, variables: self.variables, accuracy },
            jacobian,
        )
    }
}
