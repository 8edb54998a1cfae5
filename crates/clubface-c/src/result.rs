//! Results of computations: an error, or text and named arrays.

#[cfg(feature = "fem")]
use clubface_fem::FemError;
use clubface_impact::ImpactError;
use clubface_impact::columns::Reject;
use clubface_impact::series::Series;
use serde::Serialize;
use serde_json::{Value, json};
use std::ffi::{CStr, CString, c_char, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Kind of the numbers of an array.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClubfaceKind {
    /// `double`.
    Float64 = 0,
    /// `float`.
    Float32 = 1,
    /// `uint32_t`.
    Uint32 = 2,
}

// Without finite elements all numbers are doubles.
#[cfg_attr(not(feature = "fem"), allow(dead_code))]
enum Values {
    Float64(Vec<f64>),
    Float32(Vec<f32>),
    Uint32(Vec<u32>),
}

struct Array {
    name: CString,
    shape: Vec<usize>,
    values: Values,
}

/// Text and arrays of a computation.
#[derive(Default)]
pub(crate) struct Computed {
    text: Value,
    arrays: Vec<Array>,
}

impl Computed {
    /// Text alone.
    pub(crate) fn from_json(value: &impl Serialize) -> Result<Self, Failure> {
        let text = serde_json::to_value(value).map_err(|error| Failure::message(error.to_string()))?;
        Ok(Self { text, arrays: Vec::new() })
    }

    /// Rows that cannot be computed: their number, the input at fault, and why.
    pub(crate) fn from_rejects(rejects: &[Reject]) -> Self {
        let row = |r: &Reject| json!({"row": r.row, "input": r.error.input, "message": r.error.message});
        Self { text: rejects.iter().map(row).collect(), arrays: Vec::new() }
    }

    fn push(&mut self, name: &str, shape: Vec<usize>, values: Values) {
        self.arrays.push(Array { name: c_text(name), shape, values });
    }

    /// Adds arrays; `prefix` comes before their names.
    pub(crate) fn add_series(&mut self, prefix: &str, all: impl IntoIterator<Item = Series>) {
        for Series { name, shape, values } in all {
            self.push(&format!("{prefix}{name}"), shape, Values::Float64(values));
        }
    }

    pub(crate) fn add_numbers(&mut self, name: &str, shape: Vec<usize>, values: Vec<f64>) {
        self.push(name, shape, Values::Float64(values));
    }

    #[cfg(feature = "fem")]
    pub(crate) fn add_singles(&mut self, name: &str, shape: Vec<usize>, values: Vec<f32>) {
        self.push(name, shape, Values::Float32(values));
    }

    #[cfg(feature = "fem")]
    pub(crate) fn add_indices(&mut self, name: &str, shape: Vec<usize>, values: Vec<u32>) {
        self.push(name, shape, Values::Uint32(values));
    }
}

/// Why something could not be computed.
pub(crate) struct Failure(Value);

impl Failure {
    /// About an input.
    pub(crate) fn input(input: &str, message: impl Into<String>) -> Self {
        Self(json!({"input": input, "message": message.into()}))
    }

    /// About no input in particular.
    pub(crate) fn message(message: impl Into<String>) -> Self {
        Self::input("", message)
    }
}

impl From<ImpactError> for Failure {
    fn from(error: ImpactError) -> Self {
        Self::input(error.input, error.message)
    }
}

#[cfg(feature = "fem")]
impl From<FemError> for Failure {
    fn from(error: FemError) -> Self {
        match error {
            FemError::Input { name, value, allowed } => {
                Self(json!({"input": name, "value": value, "message": allowed}))
            }
            other => Self::message(other.to_string()),
        }
    }
}

/// A result: an error, or text and arrays. End it with [`clubface_free`].
pub struct ClubfaceResult {
    error: Option<CString>,
    text: CString,
    arrays: Vec<Array>,
}

/// Text for C, without what comes after a null byte.
fn c_text(text: &str) -> CString {
    CString::new(text.split('\0').next().unwrap_or_default()).unwrap_or_default()
}

/// Runs a computation. A fault of the program is an error of the result, not the end of the caller's program.
pub(crate) fn compute(work: impl FnOnce() -> Result<Computed, Failure>) -> *mut ClubfaceResult {
    let done = catch_unwind(AssertUnwindSafe(work))
        .unwrap_or_else(|_| Err(Failure::message("a fault of clubface; please report it with its inputs")));
    let result = match done {
        Ok(Computed { text, arrays }) => {
            ClubfaceResult { error: None, text: c_text(&text.to_string()), arrays }
        }
        Err(Failure(error)) => ClubfaceResult {
            error: Some(c_text(&error.to_string())),
            text: CString::default(),
            arrays: Vec::new(),
        },
    };
    Box::into_raw(Box::new(result))
}

/// Text that a caller passes.
///
/// # Safety
/// `text` is null or ends with a null byte.
pub(crate) unsafe fn text_from<'a>(text: *const c_char, name: &str) -> Result<&'a str, Failure> {
    if text.is_null() {
        return Err(Failure::input(name, "null; text is needed"));
    }
    // SAFETY: the caller's promise.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str().map_err(|_| Failure::input(name, "not UTF-8"))
}

/// Returns why the computation failed, as `{"input", "message"}` and perhaps `"value"`, or null if it did not.
///
/// # Safety
/// `result` comes from this library and has not been freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_error(result: *const ClubfaceResult) -> *const c_char {
    // SAFETY: the caller's promise.
    unsafe { &*result }.error.as_ref().map_or(core::ptr::null(), |error| error.as_ptr())
}

/// Returns the text of the result; of rows, the list of those that could not be computed: `{"row", "input", "message"}`.
///
/// # Safety
/// `result` comes from this library and has not been freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_text(result: *const ClubfaceResult) -> *const c_char {
    // SAFETY: the caller's promise.
    unsafe { &*result }.text.as_ptr()
}

/// Returns the number of arrays of the result.
///
/// # Safety
/// `result` comes from this library and has not been freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_array_count(result: *const ClubfaceResult) -> usize {
    // SAFETY: the caller's promise.
    unsafe { &*result }.arrays.len()
}

/// Returns the name of an array, counted from 0; null if there are not so many.
///
/// # Safety
/// `result` comes from this library and has not been freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_array_name(result: *const ClubfaceResult, array: usize) -> *const c_char {
    // SAFETY: the caller's promise.
    unsafe { &*result }.arrays.get(array).map_or(core::ptr::null(), |each| each.name.as_ptr())
}

/// Returns the numbers of an array, and writes how many there are and of which kind; null if there is no such array.
///
/// # Safety
/// `result` comes from this library and has not been freed; `length` and `kind` may be written, or are null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_array(
    result: *const ClubfaceResult,
    array: usize,
    length: *mut usize,
    kind: *mut ClubfaceKind,
) -> *const c_void {
    // SAFETY: the caller's promise.
    let Some(each) = unsafe { &*result }.arrays.get(array) else { return core::ptr::null() };
    let (start, count, number): (*const c_void, _, _) = match &each.values {
        Values::Float64(values) => (values.as_ptr().cast(), values.len(), ClubfaceKind::Float64),
        Values::Float32(values) => (values.as_ptr().cast(), values.len(), ClubfaceKind::Float32),
        Values::Uint32(values) => (values.as_ptr().cast(), values.len(), ClubfaceKind::Uint32),
    };
    // SAFETY: the caller's promise.
    unsafe {
        if let Some(length) = length.as_mut() {
            *length = count;
        }
        if let Some(kind) = kind.as_mut() {
            *kind = number;
        }
    }
    start
}

/// Returns the size of an array along an axis, counted from 0; 0 if it has no such axis.
///
/// # Safety
/// `result` comes from this library and has not been freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_array_size(
    result: *const ClubfaceResult,
    array: usize,
    axis: usize,
) -> usize {
    // SAFETY: the caller's promise.
    unsafe { &*result }.arrays.get(array).and_then(|each| each.shape.get(axis)).copied().unwrap_or(0)
}

/// Ends a result; null is allowed.
///
/// # Safety
/// `result` comes from this library and has not been freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_free(result: *mut ClubfaceResult) {
    if !result.is_null() {
        // SAFETY: the caller's promise.
        drop(unsafe { Box::from_raw(result) });
    }
}
