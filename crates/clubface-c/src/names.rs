//! Places of columns by name, and default values, for callers that read no JSON.

use crate::result::text_from;
use clubface_impact::flight;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::registry::named;
use clubface_impact::shot::INPUTS;
use std::ffi::c_char;

/// Columns that a caller lays out or takes.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClubfaceColumns {
    /// Inputs of an impact.
    Inputs = 0,
    /// Outputs of an impact.
    Outputs = 1,
    /// Inputs of a flight.
    FlightInputs = 2,
    /// Outputs of a flight.
    FlightOutputs = 3,
}

/// Names of the columns of a number of [`ClubfaceColumns`]; none for a number that is not one of them.
fn names(columns: u32) -> Vec<&'static str> {
    const INPUT: u32 = ClubfaceColumns::Inputs as u32;
    const OUTPUT: u32 = ClubfaceColumns::Outputs as u32;
    const FLIGHT_INPUT: u32 = ClubfaceColumns::FlightInputs as u32;
    const FLIGHT_OUTPUT: u32 = ClubfaceColumns::FlightOutputs as u32;
    match columns {
        INPUT => INPUTS.iter().map(|input| input.quantity.name).collect(),
        OUTPUT => OUTPUTS.iter().map(|quantity| quantity.name).collect(),
        FLIGHT_INPUT => flight::INPUTS.iter().map(|input| input.quantity.name).collect(),
        FLIGHT_OUTPUT => flight::OUTPUTS.iter().map(|quantity| quantity.name).collect(),
        _ => Vec::new(),
    }
}

/// Returns how many columns there are, of `CLUBFACE_COLUMNS_INPUTS` and so on.
#[unsafe(no_mangle)]
pub extern "C" fn clubface_count(columns: u32) -> usize {
    names(columns).len()
}

/// Returns the place of a column, counted from 0, by its name, such as "speed"; -1 if there is none of this name.
///
/// # Safety
/// `name` is null or ends with a null byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_column(columns: u32, name: *const c_char) -> isize {
    // SAFETY: the caller's promise.
    let Ok(name) = (unsafe { text_from(name, "name") }) else { return -1 };
    let place = names(columns).into_iter().position(|each| each == name);
    place.and_then(|place| isize::try_from(place).ok()).unwrap_or(-1)
}

/// Writes the default parameters of a model to `parameters`, unless it is null. Returns how many there are; -1 for a model
/// that is unknown.
///
/// # Safety
/// `model` is null or ends with a null byte; `parameters` is null or has room for as many numbers as this returns.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_default_parameters(model: *const c_char, parameters: *mut f64) -> isize {
    // SAFETY: the caller's promise.
    let Ok(name) = (unsafe { text_from(model, "model") }) else { return -1 };
    let Ok(model) = named(name) else { return -1 };
    let defaults = model.info().defaults();
    if !parameters.is_null() {
        // SAFETY: the caller's promise.
        unsafe { parameters.copy_from_nonoverlapping(defaults.as_ptr(), defaults.len()) };
    }
    isize::try_from(defaults.len()).unwrap_or(-1)
}

/// Writes the default flight inputs; what has none, the launch, is NaN.
///
/// # Safety
/// `inputs` has room for as many numbers as there are flight inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_default_flight(inputs: *mut f64) {
    if !inputs.is_null() {
        let defaults = flight::default_inputs();
        // SAFETY: the caller's promise.
        unsafe { inputs.copy_from_nonoverlapping(defaults.as_ptr(), defaults.len()) };
    }
}
