//! clubface in WebAssembly: arrays in, arrays out. All values SI and radians.
//!
//! Plain exports without generated glue; `clubface.js` in this crate calls them. Numbers pass through memory that
//! the caller allocates here. A function returns 0, or 1 for an error; text (an error, a description, rejected rows,
//! figures) is JSON and waits at [`text_at`] until the next call.
//!
//! Clock, progress and threads are the caller's: it exports `now` (s) and `progress` (time and duration of a
//! simulation, s; false stops it) to this module as `clubface`.

#![cfg(target_arch = "wasm32")]

mod describe;
mod shots;
mod simulation;

use serde_json::Value;
use std::cell::RefCell;

thread_local! {
    static TEXT: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Leaves a result for the caller to read.
fn answer(text: &Value) {
    TEXT.set(text.to_string());
}

/// Leaves a result or an error, and says which.
fn finish(result: Result<Value, Value>) -> u32 {
    let failed = result.is_err();
    answer(&result.unwrap_or_else(|error| error));
    u32::from(failed)
}

/// Address of the text that the last call left.
#[unsafe(no_mangle)]
pub extern "C" fn text_at() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}

/// Its length, bytes of UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    TEXT.with_borrow(String::len)
}

/// Memory for `count` numbers, to be given back by [`release`].
#[unsafe(no_mangle)]
pub extern "C" fn allocate(count: usize) -> *mut f64 {
    Box::into_raw(vec![0.0; count].into_boxed_slice()).cast()
}

/// Gives back memory.
///
/// # Safety
/// `at` and `count` are those of one call of [`allocate`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn release(at: *mut f64, count: usize) {
    // SAFETY: the caller's promise.
    drop(unsafe { Box::from_raw(core::ptr::slice_from_raw_parts_mut(at, count)) });
}
