//! Shots of a golfer, and where they go.

use crate::result::{ClubfaceResult, Computed, Failure, compute, text_from};
use crate::rows::or_infinite;
use clubface_design::dispersion::{QUANTITIES, Shots};
use clubface_design::golfer::Golfer;
use clubface_design::strokes::{Hole, LIES, StrokesTable};
use clubface_impact::Accuracy;
use clubface_impact::error::all_inputs;
use clubface_impact::registry::named;
use serde::Deserialize;
use serde_json::{Map, Value, json};
use std::ffi::c_char;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    model: String,
    inputs: Vec<Option<f64>>,
    parameters: Vec<f64>,
    flight: Vec<Option<f64>>,
    golfer: Player,
    #[serde(default)]
    hole: Option<Course>,
    #[serde(default)]
    seed: u64,
    #[serde(default)]
    tolerance: Option<f64>,
    #[serde(default)]
    percentiles: Vec<f64>,
    #[serde(default)]
    ellipses: Vec<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Course {
    length: f64,
    fairway: f64,
    rough: f64,
    green: f64,
    tables: [Table; LIES.len()],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    distance: Vec<f64>,
    strokes: Vec<f64>,
}

impl Course {
    fn hole(self) -> Result<Hole, Failure> {
        let Self { length, fairway, rough, green, tables } = self;
        let [a, b, c, d] = tables.map(|table| StrokesTable::new(table.distance, table.strokes));
        Ok(Hole { length, fairway, rough, green, tables: [a?, b?, c?, d?] })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Player {
    variables: Vec<String>,
    mean: Vec<f64>,
    covariance: Vec<Vec<f64>>,
    #[serde(default)]
    mirrored: Vec<String>,
    #[serde(default)]
    mishit_share: f64,
    #[serde(default = "one")]
    mishit_scale: f64,
}

fn one() -> f64 {
    1.0
}

/// Hits `count` shots of a golfer and sums up where they go.
///
/// `text` is JSON: `model`, its `parameters`, `inputs` of an impact and `flight`, those of a flight, in their order (null
/// for infinite, and for what a shot replaces); the `golfer` with `variables` (names of inputs of the delivery), their
/// `mean` and `covariance`, perhaps `mirrored` (variables whose deviations change their sign), `mishit_share` and
/// `mishit_scale`; perhaps a `hole` (`length`, `fairway`, `rough`, `green`, and `tables` of `distance` and `strokes` for
/// green, fairway, rough and recovery), `seed`, `tolerance`, shares for `percentiles` and `ellipses`.
///
/// The text of the result has `shots`, `lost`, `quantities` with `mean`, `spread` and `percentiles`, `ellipses`, and with
/// a hole `strokes` and `lies`; the array `landings` the places of the first `landings` shots, ahead and to the right.
/// `threads`: 0 for one a core.
///
/// # Safety
/// `text` ends with a null byte.
#[unsafe(no_mangle)]
#[cfg_attr(not(feature = "threads"), allow(unused_variables))]
pub unsafe extern "C" fn clubface_dispersion(
    text: *const c_char,
    count: u32,
    landings: usize,
    threads: usize,
) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let text = unsafe { text_from(text, "text") }?;
        let case: Case =
            serde_json::from_str(text).map_err(|error| Failure::input("text", error.to_string()))?;
        if count == 0 {
            return Err(Failure::input("count", "0; at least 1 is needed"));
        }
        for (name, shares) in [("percentiles", &case.percentiles), ("ellipses", &case.ellipses)] {
            if let Some(share) = shares.iter().find(|&&share| !(share > 0.0 && share < 1.0)) {
                return Err(Failure::input(name, format!("{share} is not allowed; shares between 0 and 1")));
            }
        }
        let Player { variables, mean, covariance, mirrored, mishit_share, mishit_scale } = case.golfer;
        let signs = variables.iter().map(|name| mirrored.contains(name)).collect();
        if covariance.iter().any(|row| row.len() != variables.len()) || mean.len() != variables.len() {
            let message =
                format!("one mean and one row of covariances for each of {} variables", variables.len());
            return Err(Failure::input("golfer", message));
        }
        let golfer = Golfer::new(mean, &covariance.concat(), signs, mishit_share, mishit_scale)?;
        let model = named(&case.model)?;
        let wanted = model.info().parameters.len();
        if case.parameters.len() != wanted {
            return Err(Failure::input(
                "parameters",
                format!("{} given, {wanted} needed", case.parameters.len()),
            ));
        }
        let hole = case.hole.map(Course::hole).transpose()?;
        let shots = Shots {
            golfer: &golfer,
            variables: Shots::places(&variables)?,
            model,
            parameters: &case.parameters,
            accuracy: Accuracy::from_tolerance(case.tolerance)?,
            inputs: *all_inputs(&or_infinite(&case.inputs))?,
            flight: *all_inputs(&or_infinite(&case.flight))?,
            hole: hole.as_ref(),
            seed: case.seed,
        };
        #[cfg(feature = "threads")]
        let pool = clubface_impact::parallel::thread_pool(threads)
            .map_err(|error| Failure::input("threads", error.to_string()))?;
        #[cfg(feature = "threads")]
        let done = pool.install(|| shots.dispersion(count, landings))?;
        #[cfg(not(feature = "threads"))]
        let done = shots.dispersion(count, landings)?;

        let tally = &done.tally;
        let mut quantities = Map::new();
        for (place, (name, _)) in QUANTITIES.iter().enumerate() {
            let percentiles: Vec<f64> =
                case.percentiles.iter().map(|&share| tally.quantile(place, share)).collect();
            let values =
                json!({"mean": tally.mean(place), "spread": tally.spread(place), "percentiles": percentiles});
            quantities.insert((*name).to_owned(), values);
        }
        let ellipses: Vec<Value> = (case.ellipses.iter())
            .map(|&share| {
                let ellipse = tally.ellipse(share);
                json!({"share": share, "centre": ellipse.centre, "half_axes": ellipse.half_axes, "angle": ellipse.angle})
            })
            .collect();
        let lies: Map<String, Value> =
            LIES.iter().zip(done.lies).map(|(name, share)| ((*name).to_owned(), share.into())).collect();
        let mut computed = Computed::from_json(&json!({
            "shots": tally.shots, "lost": tally.lost, "quantities": quantities, "ellipses": ellipses,
            "strokes": done.strokes, "lies": lies,
        }))?;
        computed.add_numbers("landings", vec![done.landings.len(), 2], done.landings.concat());
        Ok(computed)
    })
}
