//! Derivatives by dual numbers against central differences, for every input and parameter of every model.

use crate::shots::*;
use clubface_impact::launch::{OUTPUT_COUNT, OUTPUTS};
use clubface_impact::sensitivity::sensitivity;
use clubface_impact::shot::{INPUT_COUNT, INPUTS};
use clubface_impact::{Accuracy, ImpactModel};

/// Natural size of an input's change: what a difference is taken over, and a derivative multiplied by.
fn size(name: &str, unit: &str, value: f64) -> f64 {
    match (name, unit) {
        (_, "rad") => 0.1,
        (_, "rad/s") => 20.0,
        ("toe" | "high" | "cg_x" | "cg_y" | "cg_z", _) => 0.01,
        ("ixy" | "ixz" | "iyz", _) => 5e-5,
        ("dcg_x" | "dcg_y" | "dcg_z", _) => 1e-3,
        ("cor_slope", _) => 2e-3,
        ("slip_y" | "slip_z", _) => 0.1,
        ("extra_mass", _) => 0.01,
        ("area_damping", _) => 10.0,
        _ => value.abs(),
    }
}

/// Natural size of an output: what an error is measured against.
fn scale(outputs: &Outputs, index: usize) -> f64 {
    match OUTPUTS[index].unit {
        "m/s" => outputs.at("ball_speed"),
        "rad/s" => outputs.at("total_spin").max(100.0),
        "s" | "N" => outputs.0[index],
        _ => 1.0,
    }
}

/// Compares the Jacobian with differences over `h` of the size of a variable, in units of output over input.
pub fn assert_derivatives(
    model: ImpactModel,
    inputs: &Inputs,
    parameters: &[f64],
    accuracy: Accuracy,
    h: f64,
    tolerance: f64,
) {
    let info = model.info();
    let finite = |i: &usize| *i >= INPUT_COUNT || INPUTS[*i].differentiable && inputs.0[*i].is_finite();
    let variables: Vec<usize> = (0..INPUT_COUNT + parameters.len()).filter(finite).collect();
    let exact = sensitivity(model, &inputs.0, parameters, &variables, accuracy).unwrap();
    let values = Outputs(exact.values);
    let mut worst = (0.0, String::new());
    for (column, &variable) in variables.iter().enumerate() {
        let (name, unit, value) = if variable < INPUT_COUNT {
            (INPUTS[variable].quantity.name, INPUTS[variable].quantity.unit, inputs.0[variable])
        } else {
            let p = &info.parameters[variable - INPUT_COUNT];
            (p.name, p.unit, parameters[variable - INPUT_COUNT])
        };
        let size = size(name, unit, value);
        let at = |shift: f64| {
            let (mut inputs, mut parameters) = (*inputs, parameters.to_vec());
            if variable < INPUT_COUNT {
                inputs.0[variable] += shift;
            } else {
                parameters[variable - INPUT_COUNT] += shift;
            }
            hit(model, &inputs, &parameters, accuracy).0
        };
        let (below, above) = (at(-h * size), at(h * size));
        for output in 0..OUTPUT_COUNT {
            if values.0[output].is_nan() {
                assert!(exact.jacobian[output][column].is_nan() || exact.jacobian[output][column] == 0.0);
                continue;
            }
            let difference = (above[output] - below[output]) / (2.0 * h);
            let result = exact.jacobian[output][column] * size;
            let error = (result - difference).abs() / scale(&values, output);
            if !(error <= worst.0) {
                let output = OUTPUTS[output].name;
                worst = (error, format!("d {output}/d {name}: {result:e}, differences {difference:e}"));
            }
        }
    }
    assert!(worst.0 < tolerance, "{}: {:e}, {}", info.name, worst.0, worst.1);
}

/// Parameters that stand at a bound are moved inside it.
fn inside(model: ImpactModel, club: Club) -> Vec<f64> {
    published_but(model, club, &[("cor_slope", -1e-3), ("area_damping", 20.0)])
}

/// Differences over 1e-4 of the size of an input: h^2 f'''/6 is 1e-8, rounding 1e-16/1e-4 less.
#[test]
fn derivatives_of_impulse_models_equal_differences() {
    for model in impulses() {
        for (club, hand) in SIDES {
            assert_derivatives(model, &mishit(club, hand), &inside(model, club), Accuracy::Fast, 1e-4, 1e-7);
        }
    }
}

/// Steps of 1e-11 leave 1e-9 or so in an output, and their sizes change with the input: 1e-9 over 2 x 1e-3 is 5e-7; h^2
/// f'''/6 is 1e-6 at that h. The area model's friction turns round within 0.01 m/s, eighty times faster than the
/// volumetric model's: there h^2 f'''/6 was seen to fall from 3e-4 to 1e-4 with h from 1e-3 to 5e-4, and the noise of
/// the steps to take over below.
#[test]
fn derivatives_of_smooth_contacts_equal_differences() {
    for model in contacts().filter(|model| model.info().lanes) {
        let (h, tolerance) = if model == AREA { (5e-4, 3e-4) } else { (1e-3, 1e-5) };
        for (club, hand) in SIDES {
            assert_derivatives(
                model,
                &mishit(club, hand),
                &inside(model, club),
                Accuracy::Tolerance(1e-11),
                h,
                tolerance,
            );
        }
    }
}

/// The rings' fast steps follow from the state alone, so that differences over 1e-6 see no change of their number;
/// rounding of 1e-11 in the friction of the rings leaves 1e-5, or 1e-4 in spin.
#[test]
fn derivatives_of_the_rings_equal_differences() {
    for club in CLUBS {
        assert_derivatives(RINGS, &mishit(club, 1.0), &inside(RINGS, club), Accuracy::Fast, 1e-6, 1e-4);
    }
}

/// The values that come with the derivatives are those of the shot, and a choice of variables is that part of all of
/// them.
#[test]
fn a_sensitivity_holds_the_launch_and_the_columns_asked_for() {
    for model in every_model() {
        let (inputs, parameters) = (mishit(Club::Driver, 1.0), published(model, Club::Driver));
        let select = |variables: &[usize]| {
            sensitivity(model, &inputs.0, &parameters, variables, Accuracy::Fast).unwrap()
        };
        let all: Vec<usize> = (0..INPUT_COUNT).collect();
        let (some, whole) = (select(&[12, 0, 6]), select(&all));
        let shot = hit(model, &inputs, &parameters, Accuracy::Fast);
        for output in 0..OUTPUT_COUNT {
            let value = whole.values[output];
            // Duals take the same steps; only a quotient may round otherwise.
            assert!(
                value.is_nan() || (value - shot.0[output]).abs() <= 1e-12 * value.abs(),
                "{}",
                model.info().name
            );
            for (column, variable) in [12, 0, 6].into_iter().enumerate() {
                let (a, b) = (some.jacobian[output][column], whole.jacobian[output][variable]);
                assert!(a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan());
            }
        }
        assert!(select(&[]).jacobian.iter().all(Vec::is_empty));
    }
}
