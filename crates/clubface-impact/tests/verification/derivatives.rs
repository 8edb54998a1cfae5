//! Derivatives by dual numbers against central differences, for every input and parameter of every model.

use crate::shots::*;
use clubface_impact::launch::{OUTPUTS, OUTPUT_COUNT};
use clubface_impact::sensitivity::sensitivity;
use clubface_impact::shot::{INPUTS, INPUT_COUNT};
use clubface_impact::{Accuracy, ImpactModel, ModelKind};

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

/// Largest error of the Jacobian, in units of output over input, and where.
fn worst(
    model: ImpactModel,
    inputs: &Inputs,
    parameters: &[f64],
    accuracy: Accuracy,
    h: f64,
) -> (f64, String) {
    let info = model.info();
    let finite = |i: &usize| *i >= INPUT_COUNT || INPUTS[*i].differentiable && inputs.0[*i].is_finite();
    let variables: Vec<usize> = (0..INPUT_COUNT + parameters.len()).filter(finite).collect();
    let exact = sensitivity(model, &inputs.0, parameters, &variables, accuracy).unwrap();
    let values = Outputs(exact.values);
    let mut worst = (0.0, String::new());
    for (column, &variable) in variables.iter().enumerate() {
        let (name, unit, value) = if variable < INPUT_COUNT {
            (INPUTS[variable].name, INPUTS[variable].unit, inputs.0[variable])
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
            let found = exact.jacobian[output][column] * size;
            let error = (found - difference).abs() / scale(&values, output);
            if !(error <= worst.0) {
                worst = (
                    error,
                    format!("d {}/d {name}: {found:e}, differences {difference:e}", OUTPUTS[output].name),
                );
            }
        }
    }
    println!("{}: {:.1e} ({})", info.name, worst.0, worst.1);
    worst
}

/// Off-centre and with every value away from zero, so that no derivative vanishes by symmetry. Parameters that stand at
/// a bound are moved inside it.
fn general(club: Club, hand: f64) -> Inputs {
    played(club).with(&[
        ("path", 0.05),
        ("face", -0.03),
        ("lie", 0.06),
        ("toe", 0.012),
        ("high", -0.007),
        ("closure", 40.0),
        ("pitch_rate", 12.0),
        ("lie_rate", -8.0),
        ("hand", hand),
    ])
}

fn inside(model: ImpactModel, club: Club) -> Vec<f64> {
    let moved = [("cor_slope", -1e-3), ("area_damping", 20.0)];
    let known: Vec<_> = moved.into_iter().filter(|(name, _)| parameter(model, name).is_some()).collect();
    changed(model, published(model, club), &known)
}

/// Differences over 1e-4 of the size of an input: h^2 f'''/6 is 1e-8, rounding 1e-16/1e-4 less.
#[test]
fn derivatives_of_impulse_models_equal_differences() {
    for model in every_model().filter(|model| model.info().kind == ModelKind::Impulse) {
        for (club, hand) in [(Club::Driver, 1.0), (Club::Iron, 1.0), (Club::Driver, -1.0)] {
            let (error, place) =
                worst(model, &general(club, hand), &inside(model, club), Accuracy::Fast, 1e-4);
            assert!(error < 1e-7, "{} {club:?}: {error:e} {place}", model.info().name);
        }
    }
}

/// Steps of 1e-11 leave 1e-9 or so in an output, and their sizes change with the input: 1e-9 over 2 x 1e-3 is 5e-7; h^2
/// f'''/6 is 1e-6 at that h. The area model's friction turns round within 0.01 m/s, eighty times faster than the
/// volumetric model's: there h^2 f'''/6 was seen to fall from 3e-4 to 1e-4 with h from 1e-3 to 5e-4, and the noise of
/// the steps to take over below.
#[test]
fn derivatives_of_smooth_contacts_equal_differences() {
    let smooth = |model: &ImpactModel| model.info().kind == ModelKind::Contact && model.info().lanes;
    for model in every_model().filter(smooth) {
        let (h, tolerance) = if model == AREA { (5e-4, 3e-4) } else { (1e-3, 1e-5) };
        for (club, hand) in [(Club::Driver, 1.0), (Club::Iron, 1.0), (Club::Driver, -1.0)] {
            let accuracy = Accuracy::Tolerance(1e-11);
            let (error, place) = worst(model, &general(club, hand), &inside(model, club), accuracy, h);
            assert!(error < tolerance, "{} {club:?}: {error:e} {place}", model.info().name);
        }
    }
}

/// The rings' fast steps follow from the state alone, so that differences over 1e-6 see no change of their number;
/// rounding of 1e-11 in the friction of the rings leaves 1e-5, or 1e-4 in spin.
#[test]
fn derivatives_of_the_rings_equal_differences() {
    for club in CLUBS {
        let model = RINGS;
        let (error, place) = worst(model, &general(club, 1.0), &inside(model, club), Accuracy::Fast, 1e-6);
        assert!(error < 1e-4, "{club:?}: {error:e} {place}");
    }
}

/// The values beside the derivatives are those of the shot, and a choice of variables is that part of all of them.
#[test]
fn a_sensitivity_holds_the_launch_and_the_columns_asked_for() {
    for model in every_model() {
        let (inputs, parameters) = (general(Club::Driver, 1.0), published(model, Club::Driver));
        let of = |variables: &[usize]| {
            sensitivity(model, &inputs.0, &parameters, variables, Accuracy::Fast).unwrap()
        };
        let all: Vec<usize> = (0..INPUT_COUNT).collect();
        let (some, whole) = (of(&[12, 0, 6]), of(&all));
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
        assert!(of(&[]).jacobian.iter().all(Vec::is_empty));
    }
}
