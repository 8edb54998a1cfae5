//! Faces struck everywhere: points against single shots; searches, areas and expectations against closed forms.

#![allow(clippy::unwrap_used)]

use clubface_design::face_map::{
    BALL_SPEED, FINE, FaceMap, FaceStrike, Field, LAUNCHED, QUANTITIES, Scatter, evenly, grid_points,
};
use clubface_design::normal::deviate;
use clubface_design::outline::Outline;
use clubface_impact::Accuracy;
use clubface_impact::batch::Batch;
use clubface_impact::columns::Column;
use clubface_impact::flight::{self, FlightBatch, default_inputs};
use clubface_impact::launch::OUTPUTS;
use clubface_impact::registry::named;
use clubface_impact::shot::{INPUT_COUNT, INPUTS};
use core::convert::Infallible;
use core::f64::consts::PI;

fn rectangle(width: f64, height: f64) -> Outline {
    let [x, y] = [width / 2.0, height / 2.0];
    Outline::new(vec![[-x, -y], [x, -y], [x, y], [-x, y]]).unwrap()
}

/// Values of a function over a grid.
fn over(toe: &[f64], high: &[f64], function: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let (toe, high) = grid_points(toe, high);
    toe.iter().zip(&high).map(|(&toe, &high)| function(toe, high)).collect()
}

/// What computes a function at points.
fn computed(function: impl Fn(f64, f64) -> f64) -> impl Fn(&[f64], &[f64]) -> Result<Vec<f64>, Infallible> {
    move |toe, high| Ok(toe.iter().zip(high).map(|(&toe, &high)| function(toe, high)).collect())
}

#[test]
fn the_greatest_value_of_a_parabola_is_found_far_below_the_grid() {
    let parabola =
        |toe: f64, high: f64| 70.0 - 1e3 * ((toe - 0.012_34).powi(2) + 2.0 * (high + 0.005_67).powi(2));
    let (toe, high) = (evenly(-0.05, 0.05, 21), evenly(-0.025, 0.025, 11));
    let values = over(&toe, &high, parabola);
    let field = Field { toe: &toe, high: &high, values: &values };
    let Ok(best) = field.greatest(&rectangle(0.1, 0.05), computed(parabola));
    let best = best.unwrap();
    // The last neighbourhood has points 5 mm / 5 / 125 = 8 um apart.
    assert!((best.toe - 0.012_34).abs() < 5e-6 && (best.high + 0.005_67).abs() < 5e-6, "{best:?}");
    assert!((best.value - 70.0).abs() < 1e-7);
}

#[test]
fn the_greatest_value_stays_on_the_face_and_passes_over_points_without_one() {
    let slope = |toe: f64, high: f64| if high > 0.02 { f64::NAN } else { toe + 0.1 * high };
    let (toe, high) = (evenly(-0.06, 0.06, 13), evenly(-0.03, 0.03, 7));
    let values = over(&toe, &high, slope);
    let field = Field { toe: &toe, high: &high, values: &values };
    let outline = rectangle(0.1, 0.06);
    let best = field.greatest(&outline, computed(slope)).unwrap().unwrap();
    assert!((best.toe - 0.05).abs() < 1e-4 && (best.high - 0.02).abs() < 1e-4, "{best:?}");
    let nothing = vec![f64::NAN; values.len()];
    let field = Field { toe: &toe, high: &high, values: &nothing };
    assert_eq!(field.greatest(&outline, computed(slope)).unwrap(), None);
}

#[test]
fn an_area_is_that_of_a_disc_and_stays_on_the_face() {
    // Of radius 10 mm, over a grid of 1 mm and eighths of it: to 0.3 %.
    let (toe, high) = (evenly(-0.05, 0.05, 101), evenly(-0.025, 0.025, 51));
    for (centre, part) in [(0.0, 1.0), (0.05, 0.5)] {
        let cone = |toe: f64, high: f64| -(toe - centre).hypot(high);
        let values = over(&toe, &high, cone);
        let field = Field { toe: &toe, high: &high, values: &values };
        let outline = rectangle(0.1, 0.05);
        let expected = part * PI * 1e-4;
        let between = field.area_between(&outline, -0.01);
        assert!((between / expected - 1.0).abs() < 3e-3, "{between} m2 for {expected}");
        // A coarse grid is not used where the function can be computed on a finer one.
        let (coarse_toe, coarse_high) = (evenly(-0.05, 0.05, 5), evenly(-0.025, 0.025, 3));
        let values = over(&coarse_toe, &coarse_high, cone);
        let field = Field { toe: &coarse_toe, high: &coarse_high, values: &values };
        let Ok(fine) = field.area(&outline, -0.01, computed(cone));
        assert!((fine / expected - 1.0).abs() < 3e-3, "{fine} m2 for {expected}");
    }
    assert_eq!(FINE, 101);
}

#[test]
fn swings_that_miss_a_rectangle_are_those_of_the_normal_distribution() {
    // 98 % of the swings within its width, 90 % within its height.
    let [across, up] = [0.012, 0.009];
    let outline = rectangle(2.0 * across * deviate(0.99), 2.0 * up * deviate(0.95));
    let scatter = Scatter { about: [0.0, 0.0], deviations: [across, up] };
    scatter.check(&outline).unwrap();
    let Ok::<_, Infallible>(costs) = scatter.forgiveness(&outline, |toe, _| Ok(vec![vec![3.0; toe.len()]]));
    assert!((costs.missed - (1.0 - 0.98 * 0.90)).abs() < 1e-12, "{}", costs.missed);
    assert!((costs.mean[0] - 3.0).abs() < 1e-13 && costs.deviation[0] < 1e-7 && costs.loss[0].abs() < 1e-13);
}

#[test]
fn impacts_scatter_with_the_moments_of_the_normal_distribution() {
    // Over a face far larger than the spread; exact for polynomials but for what lies beyond six deviations.
    let scatter = Scatter { about: [0.003, -0.002], deviations: [0.012, 0.009] };
    let columns = |toe: &[f64], high: &[f64]| {
        let of = |function: fn(f64, f64) -> f64| {
            toe.iter().zip(high).map(|(&toe, &high)| function(toe, high)).collect::<Vec<f64>>()
        };
        Ok::<_, Infallible>(vec![
            of(|toe, _| toe),
            of(|toe, high| toe * toe + high),
            of(|toe, high| toe * high),
        ])
    };
    let Ok(costs) = scatter.forgiveness(&rectangle(0.4, 0.4), columns);
    let square: fn(f64) -> f64 = |value| value * value;
    let expected = [
        (0.003, 0.012),
        (
            square(0.012) + square(0.003) - 0.002,
            (2.0 * square(square(0.012)) + 4.0 * square(0.003 * 0.012) + square(0.009)).sqrt(),
        ),
        (-6e-6, (square(0.012 * 0.009) + square(0.012 * 0.002) + square(0.009 * 0.003)).sqrt()),
    ];
    for (place, (mean, deviation)) in expected.into_iter().enumerate() {
        assert!((costs.mean[place] - mean).abs() < 1e-9, "{} for {mean}", costs.mean[place]);
        assert!((costs.deviation[place] / deviation - 1.0).abs() < 1e-6);
    }
    assert!((costs.loss[1] - (square(0.003) - 0.002 - expected[1].0)).abs() < 1e-9);
    assert!(costs.missed < 1e-8);
}

#[test]
fn a_point_without_a_shot_is_left_out_of_the_costs() {
    let scatter = Scatter { about: [0.0, 0.0], deviations: [0.01, 0.01] };
    let half = |toe: &[f64], _: &[f64]| {
        Ok::<_, Infallible>(vec![toe.iter().map(|&toe| if toe > 0.0 { f64::NAN } else { 1.0 }).collect()])
    };
    let Ok(costs) = scatter.forgiveness(&rectangle(0.2, 0.2), half);
    assert!((costs.missed - 0.5).abs() < 1e-8 && (costs.mean[0] - 1.0).abs() < 1e-13);
}

#[test]
fn an_outline_knows_its_extent_its_area_and_what_it_holds() {
    // The lower edge of an iron, its toe, a top line that falls to the heel.
    let corners = vec![[-3.0, -2.0], [2.5, -2.0], [3.0, -1.0], [3.0, 1.0], [2.0, 2.0], [-3.0, 0.0]];
    for turn in 0..corners.len() {
        let mut turned = corners.clone();
        turned.rotate_left(turn);
        for outline in
            [turned.clone(), turned.into_iter().rev().collect()].map(|all| Outline::new(all).unwrap())
        {
            assert_eq!((outline.least(), outline.greatest()), ([-3.0, -2.0], [3.0, 2.0]));
            assert_eq!(outline.extent(-3.0), (-2.0, 0.0));
            assert_eq!(outline.extent(3.0), (-1.0, 1.0));
            assert_eq!(outline.extent(-0.5), (-2.0, 1.0));
            assert_eq!(outline.extent(2.75), (-1.5, 1.25));
            assert!((outline.area() - 18.25).abs() < 1e-13);
            assert!(outline.holds(2.0, 2.0) && outline.holds(-3.0, 0.0) && outline.holds(0.0, 0.0));
            assert!(!outline.holds(-2.5, 0.3) && !outline.holds(2.9, -1.5) && !outline.holds(3.1, 0.0));
            assert!(outline.holds_about(3.1, 0.0, 0.2));
        }
    }
    assert!(Outline::new(vec![[0.0, 0.0], [1.0, 0.0]]).is_err());
    assert!(Outline::new(vec![[0.0, 0.0], [1.0, 0.0], [f64::NAN, 1.0]]).is_err());
}

fn inputs(given: &[(&str, f64)]) -> [f64; INPUT_COUNT] {
    let usual = [
        ("speed", 46.0),
        ("club_mass", 0.2),
        ("cg_x", 0.0354),
        ("ixx", 2.5e-4),
        ("iyy", 4.7e-4),
        ("izz", 2.7e-4),
        ("bulge", 0.305),
        ("roll", 0.305),
        ("face_width", 0.11),
        ("face_height", 0.058),
        ("characteristic_time", 2.4e-4),
        ("hand", 1.0),
        ("ball_mass", 0.0459),
        ("ball_radius", 0.02134),
        ("ball_inertia", 8.2e-6),
    ];
    INPUTS.map(|input| {
        let all = given.iter().chain(&usual);
        all.into_iter().find(|(name, _)| *name == input.quantity.name).map_or(0.0, |(_, value)| *value)
    })
}

#[test]
fn every_point_of_a_map_is_a_single_shot_to_the_last_bit() {
    let inputs = inputs(&[("attack", 0.03), ("loft", 0.22), ("static_loft", 0.17), ("cg_y", 0.0035)]);
    let flight_inputs = default_inputs();
    let (model, outline) = (named("response").unwrap(), rectangle(0.09, 0.04));
    let parameters = model.info().defaults();
    let strike = FaceStrike {
        model,
        parameters: &parameters,
        accuracy: Accuracy::Fast,
        inputs: &inputs,
        flight: &flight_inputs,
    };
    let map = FaceMap::new(strike, &outline, evenly(-0.06, 0.06, 9), evenly(-0.02, 0.02, 5)).unwrap();
    let (toe, high) = grid_points(&map.toe, &map.high);
    for (row, (&toe, &high)) in toe.iter().zip(&high).enumerate() {
        let mut columns = inputs.map(Column::Constant);
        for (column, input) in columns.iter_mut().zip(&INPUTS) {
            match input.quantity.name {
                "toe" => *column = Column::Constant(toe),
                "high" => *column = Column::Constant(high),
                _ => {}
            }
        }
        let constants: Vec<Column> = parameters.iter().map(|&value| Column::Constant(value)).collect();
        let batch = Batch { model, inputs: &columns, parameters: &constants, accuracy: Accuracy::Fast };
        let mut launch = [0.0; OUTPUTS.len()];
        let _ = batch.run(0..1, launch.chunks_exact_mut(1).collect());
        let mut columns = flight_inputs.map(Column::Constant);
        for (column, input) in columns.iter_mut().zip(&flight::INPUTS) {
            if let Some(place) = OUTPUTS.iter().position(|output| output.name == input.quantity.name) {
                *column = Column::Constant(launch[place]);
            }
        }
        let mut flown = [0.0; flight::OUTPUT_COUNT];
        let _ = FlightBatch { inputs: &columns }.run(0..1, flown.chunks_exact_mut(1).collect());
        let known = OUTPUTS.iter().zip(launch).chain(flight::OUTPUTS.iter().zip(flown));
        let values: Vec<(&str, f64)> = known.map(|(output, value)| (output.name, value)).collect();
        let value = |name: &str| values.iter().find(|each| each.0 == name).unwrap().1;
        for (name, column) in QUANTITIES.iter().zip(&map.columns) {
            let expected = value(name);
            let same =
                column[row].to_bits() == expected.to_bits() || column[row].is_nan() && expected.is_nan();
            assert!(same, "{name} at {toe}, {high}: {} for {expected}", column[row]);
        }
        assert_eq!(map.inside()[row], toe.abs() < 0.05);
    }
    let launched = strike.at(&toe, &high, LAUNCHED);
    assert_eq!(launched.len(), LAUNCHED);
    assert!(launched[3].iter().zip(&map.columns[3]).all(|(a, b)| a.to_bits() == b.to_bits() || a.is_nan()));
}

#[test]
fn the_sweet_spot_of_a_flat_face_struck_squarely_is_where_the_normal_through_the_centre_of_gravity_meets_it()
{
    let flat = [("bulge", f64::INFINITY), ("roll", f64::INFINITY), ("cg_y", 0.004), ("cg_z", -0.003)];
    let (inputs, flight_inputs, outline) = (inputs(&flat), default_inputs(), rectangle(0.08, 0.04));
    let model = named("standard").unwrap();
    let parameters = model.info().defaults();
    let strike = FaceStrike {
        model,
        parameters: &parameters,
        accuracy: Accuracy::Fast,
        inputs: &inputs,
        flight: &flight_inputs,
    };
    let map = FaceMap::new(strike, &outline, evenly(-0.04, 0.04, 21), evenly(-0.02, 0.02, 11)).unwrap();
    let best = map.greatest(BALL_SPEED).unwrap();
    // The vector from the centre of gravity to the face centre is (cg_x, cg_y, cg_z).
    assert!((best.toe - 0.003).abs() < 1e-5 && (best.high + 0.004).abs() < 1e-5, "{best:?}");
    // The whole face is within half of the best, none of it above.
    assert!((map.area(0.5 * best.value) / outline.area() - 1.0).abs() < 1e-9);
    assert_eq!(map.area(1.01 * best.value), 0.0);
    let scatter = Scatter { about: [best.toe, best.high], deviations: [0.01, 0.006] };
    let costs = map.forgiveness(scatter).unwrap();
    assert!(costs.loss[BALL_SPEED] > 0.0 && costs.mean.len() == QUANTITIES.len());
    for wrong in [
        Scatter { deviations: [0.0, 0.01], ..scatter },
        Scatter { deviations: [0.01, 0.5], ..scatter },
        Scatter { about: [0.05, 0.0], ..scatter },
    ] {
        assert!(map.forgiveness(wrong).is_err());
    }
}

#[test]
fn a_face_without_a_shot_is_refused() {
    let (inputs, flight_inputs, outline) =
        (inputs(&[("loft", 2.0)]), default_inputs(), rectangle(0.08, 0.04));
    let model = named("standard").unwrap();
    let parameters = model.info().defaults();
    let strike = FaceStrike {
        model,
        parameters: &parameters,
        accuracy: Accuracy::Fast,
        inputs: &inputs,
        flight: &flight_inputs,
    };
    let places = || (evenly(-0.04, 0.04, 5), evenly(-0.02, 0.02, 5));
    let (toe, high) = places();
    assert!(FaceMap::new(strike, &outline, toe, high).unwrap_err().message.contains("no point"));
    let (toe, high) = places();
    let fewer = FaceStrike { parameters: &[], ..strike };
    assert_eq!(FaceMap::new(fewer, &outline, toe, high).unwrap_err().input, "parameters");
}
