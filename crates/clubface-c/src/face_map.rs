//! A face struck everywhere.

use crate::result::{ClubfaceResult, Computed, Failure, compute, text_from};
use crate::rows::or_infinite;
use clubface_design::face_map::{
    BALL_SPEED, FaceMap, FacePoint, FaceStrike, Forgiveness, QUANTITIES, Scatter, evenly,
};
use clubface_design::outline::Outline;
use clubface_impact::Accuracy;
use clubface_impact::error::all_inputs;
use clubface_impact::registry::named;
use serde::Deserialize;
use serde_json::{Map, Value, json};
use std::ffi::c_char;

/// Points along a side of a grid.
const LEAST: usize = 3;
const MOST: usize = 2001;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    model: String,
    inputs: Vec<Option<f64>>,
    parameters: Vec<f64>,
    flight: Vec<Option<f64>>,
    outline: Vec<[f64; 2]>,
    #[serde(default)]
    grid: Option<[usize; 2]>,
    #[serde(default)]
    points: Option<[Vec<f64>; 2]>,
    #[serde(default)]
    tolerance: Option<f64>,
    #[serde(default)]
    best: Vec<String>,
    #[serde(default)]
    share: Option<f64>,
    #[serde(default)]
    scatter: Option<Scattered>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Scattered {
    deviations: [f64; 2],
    #[serde(default)]
    about: [f64; 2],
}

impl Case {
    /// Places towards the toe and up the face.
    fn places(&self, outline: &Outline) -> Result<[Vec<f64>; 2], Failure> {
        match (&self.grid, &self.points) {
            (Some(counts), None) => {
                if let Some(count) = counts.iter().find(|count| !(LEAST..=MOST).contains(*count)) {
                    let message = format!("{count} points along a side; from {LEAST} to {MOST}");
                    return Err(Failure::input("grid", message));
                }
                let (least, greatest) = (outline.least(), outline.greatest());
                Ok([0, 1].map(|axis| evenly(least[axis], greatest[axis], counts[axis])))
            }
            (None, Some(points)) => {
                let rise = |places: &Vec<f64>| {
                    !places.is_empty()
                        && places.iter().all(|place| place.is_finite())
                        && places.windows(2).all(|pair| pair[0] < pair[1])
                };
                if points.iter().all(rise) {
                    return Ok(points.clone());
                }
                Err(Failure::input(
                    "points",
                    "needs finite places towards the toe and up the face, which rise",
                ))
            }
            _ => Err(Failure::input("grid", "needs either a grid or points")),
        }
    }
}

fn point_json(point: FacePoint) -> Value {
    json!({"toe": point.toe, "high": point.high, "value": point.value})
}

/// Values by the names of the quantities.
fn by_name(values: &[f64]) -> Map<String, Value> {
    QUANTITIES.iter().zip(values).map(|(name, &value)| ((*name).to_owned(), value.into())).collect()
}

fn forgiveness_json(Forgiveness { missed, mean, deviation, loss }: &Forgiveness) -> Value {
    json!({
        "missed": missed, "mean": by_name(mean), "deviation": by_name(deviation), "loss": by_name(loss),
    })
}

/// Strikes a face everywhere.
///
/// `text` is JSON: `model`, its `parameters`, `inputs` of an impact and `flight`, those of a flight, in their order (null
/// for infinite, and for what the launch replaces); the `outline`, corners of a face that bulges outwards everywhere,
/// towards the toe and up it; a `grid` of two numbers of points over the box around it, or `points`, two lists of places.
/// Perhaps `tolerance`; `best`, quantities whose greatest values are searched; `share` of the greatest ball speed from
/// which a point counts as part of the effective face; and `scatter` of impacts: two standard `deviations` and the point
/// that they are `about`, the centre unless given.
///
/// The text of the result has `quantities`, the `face_area`, values at the `centre`, and what was asked for: `best` by
/// names as `toe`, `high` and `value`, the `effective_area`, and `forgiveness` with the share of swings that `missed` the
/// face, and `mean`, `deviation` and `loss` by names. Arrays: places `toe` and `high`, the `values` by quantity, height
/// and place towards the toe, beyond the outline as well, and 1 where a point is `inside`. `threads`: 0 for one a core.
///
/// # Safety
/// `text` ends with a null byte.
#[unsafe(no_mangle)]
#[cfg_attr(not(feature = "threads"), allow(unused_variables))]
pub unsafe extern "C" fn clubface_face_map(text: *const c_char, threads: usize) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let text = unsafe { text_from(text, "text") }?;
        let case: Case =
            serde_json::from_str(text).map_err(|error| Failure::input("text", error.to_string()))?;
        #[cfg(feature = "threads")]
        {
            let pool = clubface_impact::parallel::thread_pool(threads)
                .map_err(|error| Failure::input("threads", error.to_string()))?;
            pool.install(|| mapped(&case))
        }
        #[cfg(not(feature = "threads"))]
        mapped(&case)
    })
}

fn mapped(case: &Case) -> Result<Computed, Failure> {
    let outline = Outline::new(case.outline.clone())?;
    let [toe, high] = case.places(&outline)?;
    let best = (case.best.iter())
        .map(|name| {
            let place = QUANTITIES.iter().position(|each| each == name);
            place
                .ok_or_else(|| Failure::input("best", format!("{name} is none of {}", QUANTITIES.join(", "))))
        })
        .collect::<Result<Vec<_>, _>>()?;
    if let Some(share) = case.share.filter(|&share| !(share > 0.0 && share < 1.0)) {
        return Err(Failure::input("share", format!("{share} is not allowed; between 0 and 1")));
    }
    let (inputs, flight) = (or_infinite(&case.inputs), or_infinite(&case.flight));
    let strike = FaceStrike {
        model: named(&case.model)?,
        parameters: &case.parameters,
        accuracy: Accuracy::from_tolerance(case.tolerance)?,
        inputs: all_inputs(&inputs)?,
        flight: all_inputs(&flight)?,
    };
    let map = FaceMap::new(strike, &outline, toe, high)?;
    let best: Map<String, Value> = (best.iter())
        .map(|&quantity| {
            let point = map.greatest(quantity).map_or(Value::Null, point_json);
            (QUANTITIES[quantity].to_owned(), point)
        })
        .collect();
    let effective_area = case.share.and_then(|share| Some(map.area(share * map.greatest(BALL_SPEED)?.value)));
    let forgiveness = (case.scatter.as_ref())
        .map(|&Scattered { deviations, about }| map.forgiveness(Scatter { about, deviations }))
        .transpose()?;
    let centre: Vec<f64> = strike.at(&[0.0], &[0.0], QUANTITIES.len()).concat();
    let mut computed = Computed::from_json(&json!({
        "quantities": QUANTITIES, "face_area": outline.area(), "centre": by_name(&centre), "best": best,
        "effective_area": effective_area, "forgiveness": forgiveness.as_ref().map(forgiveness_json),
    }))?;
    let shape = [map.high.len(), map.toe.len()];
    computed.add_numbers("toe", vec![shape[1]], map.toe.clone());
    computed.add_numbers("high", vec![shape[0]], map.high.clone());
    computed.add_numbers("values", vec![QUANTITIES.len(), shape[0], shape[1]], map.columns.concat());
    computed.add_numbers("inside", shape.to_vec(), map.inside().into_iter().map(f64::from).collect());
    Ok(computed)
}
