//! Impacts: batches, derivatives, histories.

use crate::result::{ClubfaceResult, Computed, Failure, compute, text_from};
use crate::rows::{check_rows, columns, constants, numbers, numbers_out, run_rows};
use clubface_impact::batch::{Batch, CHUNK};
use clubface_impact::error::all_inputs;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::registry::named;
use clubface_impact::sensitivity::{CHUNK as DIFFERENTIATED, Sensitivities, sensitivity_to_all};
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::{Accuracy, ImpactModel};
use std::ffi::c_char;

/// A model by its name.
///
/// # Safety
/// `model` is null or ends with a null byte.
pub(crate) unsafe fn model_from(model: *const c_char) -> Result<ImpactModel, Failure> {
    // SAFETY: the caller's promise.
    Ok(named(unsafe { text_from(model, "model") }?)?)
}

fn accuracy(tolerance: f64) -> Result<Accuracy, Failure> {
    Ok(Accuracy::from_tolerance(Some(tolerance))?)
}

/// Computes launches of `rows` shots by a model.
///
/// `inputs` are the columns of the description, one after the other, `rows` numbers each; `outputs` takes as many columns
/// as the description has outputs. `parameters` are the model's, alike for all shots. `tolerance` is relative, of a step
/// of a contact; 0 is the fast setting. `threads`: 0 for one a core. Rows that cannot be computed are NaN, and named in
/// the text.
///
/// # Safety
/// The arrays hold as many numbers as stated; `model` ends with a null byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_launches(
    model: *const c_char,
    inputs: *const f64,
    parameters: *const f64,
    rows: usize,
    tolerance: f64,
    threads: usize,
    outputs: *mut f64,
) -> *mut ClubfaceResult {
    compute(|| {
        check_rows(rows)?;
        // SAFETY: the caller's promise.
        let (model, inputs, outputs) = unsafe {
            (
                model_from(model)?,
                numbers(inputs, INPUT_COUNT * rows, "inputs")?,
                numbers_out(outputs, OUTPUT_COUNT * rows, "outputs")?,
            )
        };
        // SAFETY: the caller's promise.
        let parameters = unsafe { numbers(parameters, model.info().parameters.len(), "parameters") }?;
        let (inputs, parameters) = (columns(inputs, rows), constants(parameters));
        let accuracy = accuracy(tolerance)?;
        let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy };
        batch.validate(rows)?;
        let rejects = run_rows(threads, CHUNK, rows, outputs, |rows, out| batch.run(rows, out))?;
        Ok(Computed::from_rejects(&rejects))
    })
}

/// Computes one launch and all its derivatives: in `jacobian` a row an output, by the inputs and then the parameters. It
/// is NaN by an input that is not differentiable, and by the group "attachment" where all of it is zero. The rest as for
/// [`clubface_launches`].
///
/// # Safety
/// The arrays hold as many numbers as stated; `model` ends with a null byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_sensitivity(
    model: *const c_char,
    inputs: *const f64,
    parameters: *const f64,
    tolerance: f64,
    outputs: *mut f64,
    jacobian: *mut f64,
) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let model = unsafe { model_from(model) }?;
        let count = model.info().parameters.len();
        // SAFETY: the caller's promise.
        let (inputs, parameters, outputs, jacobian) = unsafe {
            (
                numbers(inputs, INPUT_COUNT, "inputs")?,
                numbers(parameters, count, "parameters")?,
                numbers_out(outputs, OUTPUT_COUNT, "outputs")?,
                numbers_out(jacobian, OUTPUT_COUNT * (INPUT_COUNT + count), "jacobian")?,
            )
        };
        let result = sensitivity_to_all(model, all_inputs(inputs)?, parameters, accuracy(tolerance)?)?;
        outputs.copy_from_slice(&result.values);
        jacobian.copy_from_slice(&result.jacobian.concat());
        Ok(Computed::default())
    })
}

/// Computes chosen outputs of `rows` shots and their derivatives by chosen variables.
///
/// `outputs` are `output_count` indices into the outputs, `variables` are `variable_count` indices into the inputs
/// followed by the parameters. `values` takes columns: for each output, its values and then its derivatives by each
/// variable. The rest as for [`clubface_launches`].
///
/// # Safety
/// The arrays hold as many numbers as stated; `model` ends with a null byte.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments)]
pub unsafe extern "C" fn clubface_sensitivities(
    model: *const c_char,
    inputs: *const f64,
    parameters: *const f64,
    rows: usize,
    outputs: *const usize,
    output_count: usize,
    variables: *const usize,
    variable_count: usize,
    tolerance: f64,
    threads: usize,
    values: *mut f64,
) -> *mut ClubfaceResult {
    compute(|| {
        check_rows(rows)?;
        if outputs.is_null() || variables.is_null() {
            return Err(Failure::input("outputs and variables", "null; indices are needed"));
        }
        // SAFETY: the caller's promise.
        let (model, outputs, variables, inputs) = unsafe {
            (
                model_from(model)?,
                std::slice::from_raw_parts(outputs, output_count),
                std::slice::from_raw_parts(variables, variable_count),
                numbers(inputs, INPUT_COUNT * rows, "inputs")?,
            )
        };
        // SAFETY: the caller's promise.
        let (parameters, values) = unsafe {
            (
                numbers(parameters, model.info().parameters.len(), "parameters")?,
                numbers_out(values, output_count * (1 + variable_count) * rows, "values")?,
            )
        };
        let (inputs, parameters) = (columns(inputs, rows), constants(parameters));
        let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy: accuracy(tolerance)? };
        let wanted = Sensitivities { batch, outputs, variables };
        wanted.validate(rows)?;
        let rejects = run_rows(threads, DIFFERENTIATED, rows, values, |rows, out| wanted.run(rows, out))?;
        Ok(Computed::from_rejects(&rejects))
    })
}

/// Computes the history of one shot by a contact model: arrays over the steps (`time`, `normal_force`, `force_y`,
/// `penetration`, `ball_spin`, ...), world axes, and its outputs as `launch`. The rest as for [`clubface_launches`].
///
/// # Safety
/// The arrays hold as many numbers as stated; `model` ends with a null byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_history(
    model: *const c_char,
    inputs: *const f64,
    parameters: *const f64,
    tolerance: f64,
) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let (model, inputs) = unsafe { (model_from(model)?, numbers(inputs, INPUT_COUNT, "inputs")?) };
        // SAFETY: the caller's promise.
        let parameters = unsafe { numbers(parameters, model.info().parameters.len(), "parameters") }?;
        let (history, launch) = model.history(all_inputs(inputs)?, parameters, accuracy(tolerance)?)?;
        let mut computed = Computed::default();
        computed.add_series("", history.series());
        computed.add_numbers("launch", vec![OUTPUT_COUNT], launch.to_vec());
        Ok(computed)
    })
}
