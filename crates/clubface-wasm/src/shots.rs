//! Batches of impacts and of flights.

use clubface_impact::batch::Batch;
use clubface_impact::columns::{Column, Reject};
use clubface_impact::error::all_inputs;
use clubface_impact::flight::{self, FlightBatch};
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::sensitivity::sensitivity_to_all;
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::{Accuracy, ImpactError, registry};
use serde_json::{Value, json};
use std::slice::{from_raw_parts, from_raw_parts_mut};

fn error(error: &ImpactError) -> Value {
    json!({"input": error.input, "message": error.message})
}

fn rejected(rejects: &[Reject]) -> Value {
    rejects
        .iter()
        .map(|r| json!({"row": r.row, "input": r.error.input, "message": r.error.message}))
        .collect()
}

/// Columns of `rows` numbers each.
fn columns(values: &[f64], rows: usize) -> Vec<Column<'_>> {
    values.chunks_exact(rows).map(Column::Values).collect()
}

/// Launches of `rows` shots by the model of this number in the description. `inputs` and `outputs` are columns in their
/// order, one after the other; `parameters` are the model's, alike for all shots. `tolerance`: relative, a step of a
/// contact; not above 0 for the fast setting. Rejected rows are NaN and left as text.
///
/// # Safety
/// The addresses hold as many numbers as given.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn launches(
    model: usize,
    inputs: *const f64,
    parameters: *const f64,
    rows: usize,
    tolerance: f64,
    outputs: *mut f64,
) -> u32 {
    let Some(&model) = registry::ALL.get(model).filter(|_| rows > 0) else {
        return crate::finish(Err(json!({"input": "model", "message": "unknown, or no shots"})));
    };
    let count = model.info().parameters.len();
    // SAFETY: the caller's promise.
    let (inputs, parameters, outputs) = unsafe {
        (
            from_raw_parts(inputs, INPUT_COUNT * rows),
            from_raw_parts(parameters, count),
            from_raw_parts_mut(outputs, OUTPUT_COUNT * rows),
        )
    };
    let inputs = columns(inputs, rows);
    let parameters: Vec<Column> = parameters.iter().copied().map(Column::Constant).collect();
    let mut run = || {
        let accuracy = Accuracy::from_tolerance((tolerance > 0.0).then_some(tolerance))?;
        let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy };
        batch.validate(rows)?;
        Ok(batch.run(0..rows, outputs.chunks_exact_mut(rows).collect()))
    };
    crate::finish(run().map(|rejects| rejected(&rejects)).map_err(|fault: ImpactError| error(&fault)))
}

/// Launch of one shot, and its derivatives: a row an output, by the inputs and then the parameters. NaN by an input
/// that is not differentiable. The rest as for [`launches`].
///
/// # Safety
/// The addresses hold as many numbers as given.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sensitivity(
    model: usize,
    inputs: *const f64,
    parameters: *const f64,
    tolerance: f64,
    outputs: *mut f64,
    jacobian: *mut f64,
) -> u32 {
    let Some(&model) = registry::ALL.get(model) else {
        return crate::finish(Err(json!({"input": "model", "message": "unknown"})));
    };
    let count = model.info().parameters.len();
    // SAFETY: the caller's promise.
    let (inputs, parameters, outputs, jacobian) = unsafe {
        (
            from_raw_parts(inputs, INPUT_COUNT),
            from_raw_parts(parameters, count),
            from_raw_parts_mut(outputs, OUTPUT_COUNT),
            from_raw_parts_mut(jacobian, OUTPUT_COUNT * (INPUT_COUNT + count)),
        )
    };
    let run = || {
        let accuracy = Accuracy::from_tolerance((tolerance > 0.0).then_some(tolerance))?;
        sensitivity_to_all(model, all_inputs(inputs)?, parameters, accuracy)
    };
    crate::finish(match run() {
        Ok(result) => {
            outputs.copy_from_slice(&result.values);
            jacobian.copy_from_slice(&result.jacobian.concat());
            Ok(json!([]))
        }
        Err(fault) => Err(error(&fault)),
    })
}

/// Flights of `rows` launches; `inputs` and `outputs` are columns in their order, one after the other.
///
/// # Safety
/// The addresses hold as many numbers as given.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn flights(inputs: *const f64, rows: usize, outputs: *mut f64) -> u32 {
    if rows == 0 {
        return crate::finish(Err(json!({"input": "inputs", "message": "no launches"})));
    }
    // SAFETY: the caller's promise.
    let (inputs, outputs) = unsafe {
        (
            from_raw_parts(inputs, flight::INPUT_COUNT * rows),
            from_raw_parts_mut(outputs, flight::OUTPUT_COUNT * rows),
        )
    };
    let inputs = columns(inputs, rows);
    let batch = FlightBatch { inputs: &inputs };
    crate::finish(match batch.validate(rows) {
        Ok(()) => Ok(rejected(&batch.run(0..rows, outputs.chunks_exact_mut(rows).collect()))),
        Err(fault) => Err(error(&fault)),
    })
}
