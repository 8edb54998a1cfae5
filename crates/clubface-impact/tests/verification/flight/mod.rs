//! Flight against closed forms, symmetry, published figures and itself.

mod batch;
mod ground;
mod numerics;
mod physics;
mod published;
mod shot_shape;

use clubface_impact::flight::trajectory::TOLERANCE;
use clubface_impact::flight::{FlightShot, Flown, INPUT_COUNT, INPUTS, OUTPUTS, default_inputs, fly};
use core::f64::consts::PI;

const MPH: f64 = 0.447_04;
const YARD: f64 = 0.9144;
const RPM: f64 = PI / 30.0;

/// Place of an input in the columns.
fn column(name: &str) -> usize {
    INPUTS.iter().position(|input| input.quantity.name == name).unwrap()
}

/// Place of an output.
fn output(name: &str) -> usize {
    OUTPUTS.iter().position(|output| output.name == name).unwrap()
}

/// Inputs with one changed.
fn with(mut inputs: [f64; INPUT_COUNT], name: &str, value: f64) -> [f64; INPUT_COUNT] {
    inputs[column(name)] = value;
    inputs
}

/// A launch at the target: ball speed in mph, launch angle in deg, backspin and sidespin in rpm; default air.
fn launch(speed: f64, angle: f64, backspin: f64, sidespin: f64) -> [f64; INPUT_COUNT] {
    let (speed, angle) = (speed * MPH, angle.to_radians());
    let mut inputs = default_inputs();
    let values = [speed * angle.cos(), speed * angle.sin(), 0.0, 0.0, -sidespin * RPM, backspin * RPM];
    inputs[3..9].copy_from_slice(&values);
    inputs
}

/// The published average drive.
fn drive() -> [f64; INPUT_COUNT] {
    launch(171.0, 10.4, 2545.0, 0.0)
}

fn flown(inputs: &[f64; INPUT_COUNT]) -> Flown<f64> {
    fly(&FlightShot::from_inputs(inputs), TOLERANCE)
}

fn value(inputs: &[f64; INPUT_COUNT], name: &str) -> f64 {
    flown(inputs).outputs()[output(name)]
}

#[track_caller]
fn assert_close(result: f64, expected: f64, tolerance: f64) {
    let error = (result - expected).abs();
    assert!(error <= tolerance * expected.abs().max(1.0), "{result} is not {expected} (error {error:e})");
}
