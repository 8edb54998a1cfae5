//! Flights: batches, derivatives, trajectories.

use crate::result::{ClubfaceResult, Computed, compute};
use crate::rows::{check_rows, columns, numbers, numbers_out, run_rows};
use clubface_impact::batch::CHUNK;
use clubface_impact::error::all_inputs;
use clubface_impact::flight::shot_shape::shot_shape;
use clubface_impact::flight::{self, FlightBatch, INPUT_COUNT, OUTPUT_COUNT};

/// Computes flights of `rows` launches. `inputs` are the columns of the flight inputs of the description, one after the
/// other, `rows` numbers each; `outputs` takes the flight outputs. Rows that cannot be flown are NaN, and named in the
/// text. `threads`: 0 for one a core.
///
/// # Safety
/// The arrays hold as many numbers as stated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_flights(
    inputs: *const f64,
    rows: usize,
    threads: usize,
    outputs: *mut f64,
) -> *mut ClubfaceResult {
    compute(|| {
        check_rows(rows)?;
        // SAFETY: the caller's promise.
        let (inputs, outputs) = unsafe {
            (
                numbers(inputs, INPUT_COUNT * rows, "inputs")?,
                numbers_out(outputs, OUTPUT_COUNT * rows, "outputs")?,
            )
        };
        let inputs = columns(inputs, rows);
        let batch = FlightBatch { inputs: &inputs };
        batch.validate(rows)?;
        let rejects = run_rows(threads, CHUNK, rows, outputs, |rows, out| batch.run(rows, out))?;
        Ok(Computed::from_rejects(&rejects))
    })
}

/// Computes one flight and all its derivatives: in `jacobian` a row an output, by the inputs.
///
/// # Safety
/// The arrays hold as many numbers as stated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_flight_sensitivity(
    inputs: *const f64,
    outputs: *mut f64,
    jacobian: *mut f64,
) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let (inputs, outputs, jacobian) = unsafe {
            (
                numbers(inputs, INPUT_COUNT, "inputs")?,
                numbers_out(outputs, OUTPUT_COUNT, "outputs")?,
                numbers_out(jacobian, OUTPUT_COUNT * INPUT_COUNT, "jacobian")?,
            )
        };
        let result = flight::sensitivity(all_inputs(inputs)?)?;
        outputs.copy_from_slice(&result.values);
        jacobian.copy_from_slice(result.jacobian.as_flattened());
        Ok(Computed::default())
    })
}

/// Computes the path of one flight: arrays `time`, `position`, `velocity` and `spin` over its points, world axes. The
/// last point is the landing.
///
/// # Safety
/// `inputs` holds as many numbers as there are flight inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_trajectory(inputs: *const f64) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let inputs = unsafe { numbers(inputs, INPUT_COUNT, "inputs") }?;
        let mut computed = Computed::default();
        computed.add_series("", flight::trajectory(all_inputs(inputs)?)?.series());
        Ok(computed)
    })
}

/// Returns the pressure of the standard atmosphere at an altitude above the sea, Pa; the altitude in m.
#[unsafe(no_mangle)]
pub extern "C" fn clubface_pressure_at_altitude(altitude: f64) -> f64 {
    flight::air::pressure_at_altitude(altitude)
}

/// Returns the density of moist air, kg/m3: temperature in K, pressure in Pa, humidity relative to saturation, 0 to 1.
#[unsafe(no_mangle)]
pub extern "C" fn clubface_air_density(temperature: f64, pressure: f64, humidity: f64) -> f64 {
    flight::air::density(temperature, pressure, humidity)
}

/// Names `rows` shots by their shape, as the text of the result: a list of names such as "pull hook", empty for a shot that
/// does not fly. `azimuth` (rad) and `curve` and `carry` (m) are columns of launches and flights; `hand` is 1 for a
/// right-handed player, -1 for a left-handed one. The limits between the names stand in the description.
///
/// # Safety
/// The arrays hold `rows` numbers each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_shot_shapes(
    azimuth: *const f64,
    curve: *const f64,
    carry: *const f64,
    rows: usize,
    hand: f64,
) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let (azimuth, curve, carry) = unsafe {
            (
                numbers(azimuth, rows, "azimuth")?,
                numbers(curve, rows, "curve")?,
                numbers(carry, rows, "carry")?,
            )
        };
        let names: Vec<&str> =
            (0..rows).map(|row| shot_shape(azimuth[row], curve[row], carry[row], hand)).collect();
        Computed::from_json(&names)
    })
}
