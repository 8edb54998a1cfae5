//! clubface for C, and for every language that can call C: arrays and text in, arrays and text out. SI units, radians.
//!
//! # Memory
//!
//! * Every computing function returns a [`ClubfaceResult`] that belongs to the caller, who ends it with [`clubface_free`].
//!   It is never null. Pointers that are read from it are valid until then, also while other functions run.
//! * Arrays that go in, and those that take numbers out, belong to the caller. Nothing is kept of them after the call.
//! * Text is UTF-8 and ends with a null byte. Descriptions, errors and rejected rows are JSON.
//! * Functions may be called from several threads at once. A result may be read by several threads at once.
//!
//! # Versions
//!
//! [`clubface_abi`] counts changes that a compiled caller would notice. Compare it with `CLUBFACE_ABI` of the header.
//!
//! # WebAssembly
//!
//! The same crate, compiled for `wasm32-unknown-unknown` without the feature `threads`. The host provides `now` (s) and
//! `progress` (time and duration of a simulation, s; 0 stops it) in the module `clubface`, and asks for memory by
//! [`clubface_allocate`].

mod abi;
mod dispersion;
mod face_map;
mod feasibility;
#[cfg(feature = "fem")]
mod fem;
mod flights;
mod names;
mod result;
mod rows;
mod shots;
#[cfg(feature = "multibody")]
mod stepped;

pub use abi::*;
pub use dispersion::*;
pub use face_map::*;
pub use feasibility::*;
#[cfg(feature = "fem")]
pub use fem::*;
pub use flights::*;
pub use names::*;
pub use result::*;
pub use shots::*;
#[cfg(feature = "multibody")]
pub use stepped::*;

use clubface_impact::describe::Tables;
use std::ffi::c_char;

/// Returns the number of the interface of the library, to be compared with [`CLUBFACE_ABI`] of the header.
#[unsafe(no_mangle)]
pub extern "C" fn clubface_abi() -> u32 {
    CLUBFACE_ABI
}

/// Returns the version of clubface, such as "0.1.0". The text lives as long as the program.
#[unsafe(no_mangle)]
pub extern "C" fn clubface_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// Describes everything that can be computed, as text: `quantities`, `units`, `dimensions`, `models` with their
/// parameters, and `inputs`, `outputs`, `flight_inputs`, `flight_outputs` in the order of the columns, `shot_shapes`.
/// A number that is not finite, such as the default of an input that has none, is null.
#[unsafe(no_mangle)]
pub extern "C" fn clubface_describe() -> *mut ClubfaceResult {
    compute(|| Computed::from_json(&Tables::all()))
}

/// Returns `bytes` of memory, aligned for every kind of number, for hosts without an allocator of their own.
#[unsafe(no_mangle)]
pub extern "C" fn clubface_allocate(bytes: usize) -> *mut u8 {
    Box::into_raw(vec![0.0_f64; bytes.div_ceil(8)].into_boxed_slice()).cast()
}

/// Gives memory back.
///
/// # Safety
/// `memory` and `bytes` are those of one call of [`clubface_allocate`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_release(memory: *mut u8, bytes: usize) {
    let numbers = core::ptr::slice_from_raw_parts_mut(memory.cast::<f64>(), bytes.div_ceil(8));
    // SAFETY: the caller's promise.
    drop(unsafe { Box::from_raw(numbers) });
}
