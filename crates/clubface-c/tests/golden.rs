//! The golden shots, which the command line and the studio must give as well, through the C interface.

#![allow(clippy::unwrap_used)]

use clubface::*;
use clubface_impact::flight;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::shot::INPUTS;
use serde_json::Value;
use std::ffi::CString;
use std::fs::read_to_string;

/// Relative difference: the last bits of logarithms and powers, which come from the machine's library.
const SAME: f64 = 1e-12;
/// What is a difference of large numbers, as are components of vectors, is compared on their scale [SI].
const SCALES: [(&str, f64); 9] = [
    ("side", 100.0),
    ("total_side", 100.0),
    ("curve", 100.0),
    ("launch", 1.0),
    ("azimuth", 1.0),
    ("landing_angle", 1.0),
    ("backspin", 100.0),
    ("sidespin", 100.0),
    ("spin_axis", 1.0),
];

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
}

/// Computes a column of outputs; a result that names an error or a rejected row fails the test.
fn computed(count: usize, work: impl FnOnce(*mut f64) -> *mut ClubfaceResult) -> Vec<f64> {
    let mut outputs = vec![0.0; count];
    let result = work(outputs.as_mut_ptr());
    // SAFETY: the result is read once, and freed once.
    unsafe {
        assert!(clubface_error(result).is_null());
        clubface_free(result);
    }
    outputs
}

#[test]
fn golden_shots_are_computed_alike() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/shots.json");
    let golden: Value = serde_json::from_str(&read_to_string(path).unwrap()).unwrap();
    let shots = golden["shots"].as_array().unwrap();
    let mut compared = 0;
    for shot in shots {
        let equipment = &golden["equipment"][shot["equipment"].as_u64().unwrap() as usize];
        let parameters = numbers(&golden["parameters"][shot["parameters"].as_u64().unwrap() as usize]);
        // An infinite radius of a face is null.
        let input = |name: &str| match (&shot["delivery"][name], &equipment[name]) {
            (Value::Number(value), _) | (_, Value::Number(value)) => value.as_f64().unwrap(),
            _ => f64::INFINITY,
        };
        let inputs: Vec<f64> = INPUTS.iter().map(|each| input(each.quantity.name)).collect();
        let model = CString::new(shot["link"]["model"].as_str().unwrap()).unwrap();
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
            }
        }
        // SAFETY: as above.
        let flown =
            computed(flight::OUTPUTS.len(), |to| unsafe { clubface_flights(start.as_ptr(), 1, 1, to) });
        let names = OUTPUTS.iter().chain(&flight::OUTPUTS).map(|quantity| quantity.name);
        for (name, value) in names.zip(launch.into_iter().chain(flown)) {
            let Some(expected) = shot["numbers"][name].as_f64() else { continue };
            let component = ["_x", "_y", "_z"].iter().any(|axis| name.ends_with(axis));
            let scale = SCALES.iter().find(|each| each.0 == name).map_or(0.0, |each| each.1);
            let scale = if component { 100.0 } else { scale };
            let allowed = SAME * scale.max(expected.abs());
            assert!((value - expected).abs() <= allowed, "{}: {name} {value}, not {expected}", shot["link"]);
            compared += 1;
        }
    }
    assert!(compared > 25 * shots.len());
}
