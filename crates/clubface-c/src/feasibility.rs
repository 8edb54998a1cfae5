//! Which heads can be built.

use crate::result::{ClubfaceResult, Computed, Failure, compute, text_from};
use crate::rows::{check_rows, numbers, numbers_out};
use clubface_design::feasibility::{
    Envelope, MASS_PROPERTIES, MassProperties, ROUNDING, Shape, Volume, pseudo_inertia,
};
use serde::Deserialize;
use serde_json::{Value, json};
use std::ffi::c_char;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Space {
    shape: String,
    centre: [f64; 3],
    size: [f64; 3],
    head: MassProperties,
    free: f64,
}

/// Computes for `rows` heads whether mass in a space can be distributed so.
///
/// `text` is JSON: the space by `shape` ("box" or "ellipsoid"), `centre` seen from the face centre and `size` (face to back,
/// sole to crown, heel to toe; m); and the `head` that is made lighter evenly by its `free` mass (kg), which is placed anew,
/// as its mass properties: mass, `cg_x`, `cg_y`, `cg_z`, `ixx`, `iyy`, `izz`, `ixy`, `ixz`, `iyz`. `values` are columns of
/// the same ten numbers, `rows` each. `least` takes the smallest margin of each head: below 0 no body has these numbers.
///
/// The text of the result has `margins`, those of the first head, each its `name`, `value` and `reason`, what is wrong where
/// it is below 0; and `rounding`, by which a margin may be below 0.
///
/// # Safety
/// `text` ends with a null byte; the arrays hold as many numbers as stated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_buildable(
    text: *const c_char,
    values: *const f64,
    rows: usize,
    least: *mut f64,
) -> *mut ClubfaceResult {
    compute(|| {
        check_rows(rows)?;
        // SAFETY: the caller's promise.
        let (text, values, least) = unsafe {
            (
                text_from(text, "text")?,
                numbers(values, MASS_PROPERTIES * rows, "values")?,
                numbers_out(least, rows, "least")?,
            )
        };
        let space: Space =
            serde_json::from_str(text).map_err(|error| Failure::input("text", error.to_string()))?;
        let volume = Volume::new(Shape::named(&space.shape)?, space.centre, space.size)?;
        let envelope = Envelope::lightened(volume, &space.head, space.free)?;
        let moments = |row: usize| pseudo_inertia(&core::array::from_fn(|i| values[i * rows + row]));
        for (row, least) in least.iter_mut().enumerate() {
            *least = envelope.least(&moments(row));
        }
        let margins: Vec<Value> = (envelope.margins(&moments(0)).iter())
            .map(|each| json!({"name": each.name, "value": each.value, "reason": each.reason}))
            .collect();
        Computed::from_json(&json!({"margins": margins, "rounding": ROUNDING}))
    })
}
