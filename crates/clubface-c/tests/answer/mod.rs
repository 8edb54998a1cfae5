//! What the functions of the C interface answer, read as a caller reads it.

use clubface::*;
use serde_json::Value;
use std::ffi::{CStr, CString, c_char};

/// A result read whole: the error or the text, and arrays with their shapes.
pub struct Answer {
    pub outcome: Result<Value, Value>,
    pub arrays: Vec<(String, Vec<usize>, Vec<f64>)>,
}

impl Answer {
    pub fn array(&self, name: &str) -> &(String, Vec<usize>, Vec<f64>) {
        self.arrays.iter().find(|each| each.0 == name).unwrap_or_else(|| panic!("no array {name}"))
    }
}

unsafe fn text(at: *const c_char) -> String {
    unsafe { CStr::from_ptr(at) }.to_str().unwrap().to_owned()
}

pub fn read(result: *mut ClubfaceResult) -> Answer {
    unsafe {
        let error = clubface_error(result);
        let outcome = if error.is_null() {
            Ok(serde_json::from_str(&text(clubface_text(result))).unwrap())
        } else {
            Err(serde_json::from_str(&text(error)).unwrap())
        };
        let mut arrays = Vec::new();
        for i in 0..clubface_array_count(result) {
            let (mut length, mut kind) = (0, ClubfaceKind::Float64);
            let start = clubface_array(result, i, &raw mut length, &raw mut kind);
            let values = match kind {
                ClubfaceKind::Float64 => std::slice::from_raw_parts(start.cast::<f64>(), length).to_vec(),
                ClubfaceKind::Float32 => std::slice::from_raw_parts(start.cast::<f32>(), length)
                    .iter()
                    .map(|&v| v.into())
                    .collect(),
                ClubfaceKind::Uint32 => std::slice::from_raw_parts(start.cast::<u32>(), length)
                    .iter()
                    .map(|&v| v.into())
                    .collect(),
            };
            let shape =
                (0..).map(|axis| clubface_array_size(result, i, axis)).take_while(|&n| n > 0).collect();
            arrays.push((text(clubface_array_name(result, i)), shape, values));
        }
        assert!(clubface_array_name(result, arrays.len()).is_null());
        clubface_free(result);
        Answer { outcome, arrays }
    }
}

pub fn c(text: &str) -> CString {
    CString::new(text).unwrap()
}
