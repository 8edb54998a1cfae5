//! The golden numbers, which the command line and the studio must give as well, through the C interface.

#![allow(clippy::unwrap_used)]

mod answer;

use answer::{Answer, c, read};
use clubface::*;
use clubface_impact::flight;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::shot::INPUTS;
use serde_json::Value;
use std::ffi::c_char;
use std::fs::read_to_string;
use std::ptr::null_mut;

fn stored(name: &str) -> Value {
    let path = format!("{}/../../tests/golden/{name}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&read_to_string(path).unwrap()).unwrap()
}

/// How many numbers are stored as results, under `numbers` and `values`.
fn result_count(value: &Value, is_result: bool) -> usize {
    match value {
        Value::Array(values) => values.iter().map(|each| result_count(each, is_result)).sum(),
        Value::Object(entries) => entries
            .iter()
            .map(|(key, each)| result_count(each, is_result || key == "numbers" || key == "values"))
            .sum(),
        Value::Number(_) => usize::from(is_result),
        _ => 0,
    }
}

/// Compares the numbers of every case of a file; what is not the same fails the test, all of it named.
fn compare(file: &str, mut add_numbers: impl FnMut(&Value, &Value, &mut Comparison)) {
    let (golden, tolerance) = (stored(file), stored("tolerance"));
    let mut comparison = Comparison { tolerance, count: 0, wrong: Vec::new() };
    for case in golden["cases"].as_array().unwrap() {
        add_numbers(&golden, case, &mut comparison);
    }
    let Comparison { count, wrong, .. } = comparison;
    assert!(wrong.is_empty(), "{} numbers of {file} differ:\n{}", wrong.len(), wrong.join("\n"));
    let least = result_count(&golden, false);
    assert!(least > 0 && count >= least, "{count} numbers of {file} are compared, of {least}");
}

struct Comparison {
    tolerance: Value,
    count: usize,
    wrong: Vec<String>,
}

impl Comparison {
    /// Compares a number with the one stored, if it is; the first word of its name is the quantity.
    fn add(&mut self, case: &Value, name: &str, value: f64, expected: &Value) {
        let Some(expected) = expected.as_f64() else { return };
        let scale = self.tolerance["scales"][name.split(' ').next().unwrap()].as_f64().unwrap_or(0.0);
        let allowed = self.tolerance["relative"].as_f64().unwrap() * scale.max(expected.abs());
        self.count += 1;
        let difference = (value - expected).abs();
        if difference.is_nan() || difference > allowed {
            self.wrong.push(format!("{}: {name} is {value}, not {expected}", case["link"]));
        }
    }

    fn add_by_name(&mut self, case: &Value, stored: &Value, name: &str, value: f64) {
        self.add(case, name, value, &stored["numbers"][name]);
    }
}

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
}

/// What a function that takes a description answers.
fn answer(setup: &Value, work: impl FnOnce(*const c_char) -> *mut ClubfaceResult) -> Answer {
    let text = c(&setup.to_string());
    read(work(text.as_ptr()))
}

/// Computes a column of outputs; a rejected row fails the test.
fn computed(count: usize, work: impl FnOnce(*mut f64) -> *mut ClubfaceResult) -> Vec<f64> {
    let mut outputs = vec![0.0; count];
    assert_eq!(read(work(outputs.as_mut_ptr())).outcome, Ok(Value::Array(Vec::new())));
    outputs
}

/// Launch and flight of a shot.
fn compare_shot(golden: &Value, shot: &Value, comparison: &mut Comparison) {
    let equipment = &golden["equipment"][shot["equipment"].as_u64().unwrap() as usize];
    let parameters = numbers(&golden["parameters"][shot["parameters"].as_u64().unwrap() as usize]);
    // An infinite radius of a face is null.
    let input = |name: &str| match (&shot["delivery"][name], &equipment[name]) {
        (Value::Number(value), _) | (_, Value::Number(value)) => value.as_f64().unwrap(),
        _ => f64::INFINITY,
    };
    let inputs: Vec<f64> = INPUTS.iter().map(|each| input(each.quantity.name)).collect();
    let model = c(shot["model"].as_str().unwrap());
    // SAFETY: the arrays are as long as the interface asks.
    let launch = computed(OUTPUTS.len(), |to| unsafe {
        clubface_launches(model.as_ptr(), inputs.as_ptr(), parameters.as_ptr(), 1, 0.0, 1, to)
    });
    let mut start = flight::default_inputs();
    for (value, each) in start.iter_mut().zip(&flight::INPUTS) {
        let name = each.quantity.name;
        if let Some(place) = OUTPUTS.iter().position(|output| output.name == name) {
            *value = launch[place];
        } else if INPUTS.iter().any(|given| given.quantity.name == name) {
            *value = input(name);
        } else if let Some(given) = shot["conditions"][name].as_f64() {
            *value = given;
        }
    }
    // SAFETY: as above.
    let flown = computed(flight::OUTPUTS.len(), |to| unsafe { clubface_flights(start.as_ptr(), 1, 1, to) });
    let names = OUTPUTS.iter().chain(&flight::OUTPUTS).map(|quantity| quantity.name);
    for (name, value) in names.zip(launch.into_iter().chain(flown)) {
        comparison.add_by_name(shot, shot, name, value);
    }
}

#[test]
fn shots() {
    compare("shots", compare_shot);
}

#[test]
fn flights_in_wind_and_other_air_on_other_grounds() {
    compare("flights", compare_shot);
}

#[test]
fn maps_of_faces() {
    compare("maps", |_, case, comparison| {
        let quantity = case["link"]["map"].as_str().unwrap();
        let step = case["step"].as_u64().unwrap() as usize;
        let mut points: Vec<Vec<f64>> = Vec::new();
        for face in case["faces"].as_array().unwrap() {
            // SAFETY: the text ends with a null byte.
            let answer = answer(&face["setup"], |text| unsafe { clubface_face_map(text, 1) });
            let summary = answer.outcome.as_ref().unwrap();
            for name in ["face_area", "effective_area"] {
                comparison.add_by_name(case, face, name, summary[name].as_f64().unwrap());
            }
            for (name, point) in summary["best"].as_object().unwrap() {
                comparison.add_by_name(
                    case,
                    face,
                    &format!("{name} greatest"),
                    point["value"].as_f64().unwrap(),
                );
                for axis in ["toe", "high"] {
                    comparison.add_by_name(
                        case,
                        face,
                        &format!("{axis} {name}"),
                        point[axis].as_f64().unwrap(),
                    );
                }
            }
            let forgiveness = &summary["forgiveness"];
            comparison.add_by_name(case, face, "missed", forgiveness["missed"].as_f64().unwrap());
            for kind in ["mean", "deviation", "loss"] {
                for (name, value) in forgiveness[kind].as_object().unwrap() {
                    comparison.add_by_name(case, face, &format!("{name} {kind}"), value.as_f64().unwrap());
                }
            }
            let (_, shape, values) = answer.array("values");
            let place = summary["quantities"].as_array().unwrap().iter().position(|each| each == quantity);
            let count = shape[1] * shape[2];
            let of_quantity = &values[place.unwrap() * count..][..count];
            points.push(of_quantity.to_vec());
            for axis in ["toe", "high"] {
                for (value, expected) in
                    answer.array(axis).2.iter().step_by(step).zip(case[axis].as_array().unwrap())
                {
                    comparison.add(case, axis, *value, expected);
                }
            }
        }
        let columns = case["toe"].as_array().unwrap().len() * step - step + 1;
        for (row, values) in case["values"].as_array().unwrap().iter().enumerate() {
            for (column, expected) in values.as_array().unwrap().iter().enumerate() {
                let place = step * (row * columns + column);
                let other = points.get(1).map_or(0.0, |second| second[place]);
                comparison.add(case, quantity, points[0][place] - other, expected);
            }
        }
    });
}

#[test]
fn dispersions_of_golfers() {
    compare("dispersions", |_, case, comparison| {
        let count = case["count"].as_u64().unwrap() as u32;
        // SAFETY: the text ends with a null byte.
        let answer = answer(&case["setup"], |text| unsafe { clubface_dispersion(text, count, 0, 1) });
        let summary = answer.outcome.as_ref().unwrap();
        let mut add =
            |name: &str, value: &Value| comparison.add_by_name(case, case, name, value.as_f64().unwrap());
        for name in ["shots", "lost", "strokes"] {
            add(name, &summary[name]);
        }
        for (lie, share) in summary["lies"].as_object().unwrap() {
            add(&format!("share {lie}"), share);
        }
        for (name, each) in summary["quantities"].as_object().unwrap() {
            add(&format!("{name} mean"), &each["mean"]);
            add(&format!("{name} spread"), &each["spread"]);
            for (share, value) in
                numbers(&case["setup"]["percentiles"]).iter().zip(each["percentiles"].as_array().unwrap())
            {
                add(&format!("{name} {share}"), value);
            }
        }
        for ellipse in summary["ellipses"].as_array().unwrap() {
            let share = &ellipse["share"];
            add(&format!("carry centre {share}"), &ellipse["centre"][0]);
            add(&format!("side centre {share}"), &ellipse["centre"][1]);
            add(&format!("carry long {share}"), &ellipse["half_axes"][0]);
            add(&format!("carry short {share}"), &ellipse["half_axes"][1]);
            add(&format!("azimuth ellipse {share}"), &ellipse["angle"]);
        }
    });
}

#[cfg(feature = "fem")]
#[test]
fn the_reference_case_and_a_drive_by_finite_elements() {
    compare("elements", |_, case, comparison| {
        // SAFETY: the text ends with a null byte.
        let answer = answer(&case["setup"], |text| unsafe { clubface_fem(text, None, null_mut()) });
        let summary = answer.outcome.as_ref().unwrap();
        for (name, value) in summary.as_object().unwrap() {
            if let Some(value) = value.as_f64() {
                comparison.add_by_name(case, case, name, value);
            }
        }
        if let Some(launch) = summary["launch"].as_array() {
            for (quantity, value) in OUTPUTS.iter().zip(launch) {
                comparison.add_by_name(case, case, quantity.name, value.as_f64().unwrap_or(f64::NAN));
            }
        }
        if case["link"]["against"] == "plane" {
            let along = |axis: usize, vector: &str| {
                let pairs = numbers(&summary["axes"][axis]).into_iter().zip(numbers(&summary[vector]));
                pairs.map(|(direction, value)| direction * value).sum::<f64>()
            };
            comparison.add_by_name(case, case, "normal_velocity", along(0, "ball_velocity"));
            comparison.add_by_name(case, case, "tangential_velocity", along(1, "ball_velocity"));
            comparison.add_by_name(case, case, "backspin", along(2, "ball_spin"));
        }
    });
}
