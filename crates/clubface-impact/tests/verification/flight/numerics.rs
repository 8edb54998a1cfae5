//! Steps, the place of an event within one, lanes and derivatives.

use super::{INPUT_COUNT, assert_close, column, drive, flown, launch, with};
use clubface_impact::ball::Ball;
use clubface_impact::columns::{Column, Reject};
use clubface_impact::flight::event::{Event, HEIGHT, Step};
use clubface_impact::flight::trajectory::{Air, Flight};
use clubface_impact::flight::{
    FlightBatch, FlightSensitivities, FlightShot, INPUTS, OUTPUTS, check, fly, sensitivity,
};
use clubface_math::ode::{DORMAND_PRINCE, Method, System};
use clubface_math::{Vec3, with_lanes};

/// Chip, wedge, 7-iron, drive, drive in wind: different numbers of steps.
fn mixed() -> [[f64; INPUT_COUNT]; 5] {
    [
        launch(15.0, 40.0, 3000.0, 0.0),
        launch(104.0, 23.7, 9316.0, -300.0),
        launch(123.0, 16.1, 7124.0, 200.0),
        drive(),
        with(with(launch(171.0, 10.4, 2545.0, 500.0), "wind_x", -8.0), "wind_z", 3.0),
    ]
}

/// What is claimed of the default tolerance.
#[test]
fn the_default_tolerance_places_the_landing_to_a_millimetre() {
    for shot in mixed() {
        let fine = fly(&FlightShot::from_inputs(&shot), 1e-12).outputs();
        let fast = flown(&shot).outputs();
        assert!((fast[0] - fine[0]).abs() < 1e-3, "carry {} and {}", fast[0], fine[0]);
        assert!((fast[2] - fine[2]).abs() < 1e-3, "apex {} and {}", fast[2], fine[2]);
        assert_close(fast[4], fine[4], 1e-4);
    }
}

/// Events are placed by Newton's method to rounding: the vertical velocity of a parabola through the landing says so,
/// and so does a landing that hardly moves when the steps around it do.
#[test]
fn the_landing_does_not_depend_on_where_steps_end() {
    for shot in mixed() {
        let [a, b] =
            [1e-11, 3e-12].map(|tolerance| fly(&FlightShot::from_inputs(&shot), tolerance).outputs());
        for i in 0..OUTPUTS.len() {
            assert_close(a[i], b[i], 1e-8);
        }
    }
}

#[test]
fn every_lane_gives_the_bits_of_its_shot_alone_whatever_its_neighbours() {
    for rotation in 0..5 {
        // More than fill the widest packs, so that some are left for the last.
        let shots: Vec<_> = (0..19).map(|lane| mixed()[(lane + rotation) % 5]).collect();
        let columns: Vec<Vec<f64>> =
            (0..INPUT_COUNT).map(|i| shots.iter().map(|shot| shot[i]).collect()).collect();
        let columns: Vec<Column> = columns.iter().map(|values| Column::Values(values)).collect();
        for width in [8, 16] {
            let mut outputs = vec![vec![0.0; shots.len()]; OUTPUTS.len()];
            let slices = outputs.iter_mut().map(Vec::as_mut_slice).collect();
            let batch = FlightBatch { inputs: &columns };
            assert!(with_lanes(width, || batch.run(0..shots.len(), slices)).is_empty());
            for (lane, shot) in shots.iter().enumerate() {
                let bits: Vec<u64> = outputs.iter().map(|output| output[lane].to_bits()).collect();
                let alone = flown(shot).outputs().map(f64::to_bits);
                assert_eq!(bits, alone, "lane {lane} of {width}, shot {rotation} and on");
            }
        }
    }
}

/// Whole packs are checked at once, a fault sends them through the check of single shots: the rows refused are those that
/// it refuses, with its words, and their neighbours keep their bits.
#[test]
fn a_pack_refuses_what_a_single_check_refuses() {
    let good: Vec<_> = (0..16).map(|lane| mixed()[lane % 5]).collect();
    let mut faulty = Vec::new();
    for (place, input) in INPUTS.iter().enumerate() {
        let width = input.bounds.upper - input.bounds.lower;
        for value in [input.bounds.lower - 0.01 * width, input.bounds.upper + 0.01 * width, f64::NAN] {
            faulty.push((place, value));
        }
    }
    // A ball heavier outside than any shell.
    faulty.push((2, 1e-3));
    for (number, (place, value)) in faulty.into_iter().enumerate() {
        let (mut shots, row) = (good.clone(), number % 16);
        shots[row][place] = value;
        let columns: Vec<Vec<f64>> =
            (0..INPUT_COUNT).map(|i| shots.iter().map(|shot| shot[i]).collect()).collect();
        let columns: Vec<Column> = columns.iter().map(|values| Column::Values(values)).collect();
        let mut outputs = vec![vec![0.0; shots.len()]; OUTPUTS.len()];
        let slices = outputs.iter_mut().map(Vec::as_mut_slice).collect();
        let rejects = FlightBatch { inputs: &columns }.run(0..shots.len(), slices);
        let error = check(&shots[row]).expect_err("it is out of bounds");
        assert_eq!(rejects, [Reject { row, error }], "{} = {value}", INPUTS[place].quantity.name);
        for (lane, shot) in shots.iter().enumerate().filter(|&(lane, _)| lane != row) {
            assert_eq!(outputs[0][lane].to_bits(), flown(shot).outputs()[0].to_bits());
        }
        assert!(outputs[0][row].is_nan());
    }
}

/// Central differences of h = 1e-5 (of the range of launches, of the value elsewhere) have an error of order h^2 and,
/// from steps of 1e-12, of order 1e-12 / h; steps of the default tolerance, 1e-6, leave some 5e-6 of the derivative's
/// natural size. The shot bounces the same number of times on both sides.
#[test]
fn derivatives_are_those_of_finite_differences() {
    let mut shot = launch(150.0, 12.0, 3500.0, 300.0);
    shot[column("velocity_z")] = 2.0;
    shot[column("wind_x")] = -3.0;
    shot[column("wind_z")] = 2.0;
    let exact = sensitivity(&shot).unwrap();
    let fine = |inputs: &[f64; INPUT_COUNT]| fly(&FlightShot::from_inputs(inputs), 1e-12).outputs();
    for (j, input) in INPUTS.iter().enumerate() {
        let moving = input.group == "launch" || input.quantity.name.starts_with("wind");
        let size = shot[j].abs().max(if moving { 10.0 } else { 0.0 });
        let h = 1e-5 * size;
        let (up, down) = (
            fine(&with(shot, input.quantity.name, shot[j] + h)),
            fine(&with(shot, input.quantity.name, shot[j] - h)),
        );
        for (i, output) in OUTPUTS.iter().enumerate() {
            let difference = (up[i] - down[i]) / (2.0 * h);
            let result = exact.jacobian[i][j];
            // In units of the output's size over the input's.
            let error = (result - difference).abs() * size / exact.values[i].abs().max(1.0);
            assert!(error < 1e-5, "d {} / d {}: {result} and {difference}", output.name, input.quantity.name);
        }
    }
    assert_eq!(exact.values, flown(&shot).outputs());
}

/// A lane carries the derivatives of its own shot, so neighbours with other numbers of steps must not change a bit. One
/// shot cannot be flown: its columns are NaN, and its neighbours are as before. Eight variables take two passes.
#[test]
fn derivatives_of_many_flights_are_those_of_each_alone() {
    let mut shots: Vec<_> = (0..11).map(|row| mixed()[row % 5]).collect();
    shots[6][3] = f64::NAN;
    let columns: Vec<Vec<f64>> =
        (0..INPUT_COUNT).map(|i| shots.iter().map(|shot| shot[i]).collect()).collect();
    let columns: Vec<Column> = columns.iter().map(|values| Column::Values(values)).collect();
    let (outputs, variables) = ([0, 1, 7], [3, 4, 5, 6, 7, 8, 12, 0]);
    let batch = FlightBatch { inputs: &columns };
    let wanted = FlightSensitivities { batch, outputs: &outputs, variables: &variables };
    wanted.validate(shots.len()).unwrap();
    for width in [1, 4, 8] {
        let mut result = vec![vec![0.0; shots.len()]; wanted.columns()];
        let slices = result.iter_mut().map(Vec::as_mut_slice).collect();
        let rejects = with_lanes(width, || wanted.run(0..shots.len(), slices));
        assert_eq!(rejects.iter().map(|reject| reject.row).collect::<Vec<_>>(), [6]);
        for (row, shot) in shots.iter().enumerate() {
            let Ok(alone) = sensitivity(shot) else {
                assert!(result.iter().all(|column| column[row].is_nan()));
                continue;
            };
            for (place, &output) in outputs.iter().enumerate() {
                let first = place * (1 + variables.len());
                assert_eq!(result[first][row].to_bits(), alone.values[output].to_bits());
                for (i, &variable) in variables.iter().enumerate() {
                    let (one, other) = (result[first + 1 + i][row], alone.jacobian[output][variable]);
                    assert_eq!(one.to_bits(), other.to_bits(), "row {row}, {} by {}", output, variable);
                }
            }
        }
    }
}

/// In a vacuum, and derivatives too, everything is known: carry 2 vx vy / g, apex vy^2 / 2g. The air of the thinnest
/// pressure allowed is no vacuum, so the density is set to zero in the shot itself.
#[test]
fn derivatives_through_the_landing_are_exact_without_air() {
    use clubface_impact::flight::trajectory::GRAVITY;
    use clubface_math::Dual;
    let (vx, vy) = (50.0, 20.0);
    let mut inputs = launch(100.0, 10.0, 0.0, 0.0).map(Dual::<f64, 2>::constant);
    inputs[3] = Dual::variable(vx, 0);
    inputs[4] = Dual::variable(vy, 1);
    let mut shot = FlightShot::from_inputs(&inputs);
    shot.air.density = Dual::constant(0.0);
    let [carry, _, apex, angle, time, ..] = fly(&shot, 1e-7).outputs();
    let speed_squared = vx * vx + vy * vy;
    let expected = [
        (carry, [2.0 * vy / GRAVITY, 2.0 * vx / GRAVITY]),
        (apex, [0.0, vy / GRAVITY]),
        (angle, [-vy / speed_squared, vx / speed_squared]),
        (time, [0.0, 2.0 / GRAVITY]),
    ];
    for (result, derivatives) in expected {
        assert_close(result.tangent[0], derivatives[0], 1e-12);
        assert_close(result.tangent[1], derivatives[1], 1e-12);
    }
}

/// One Runge-Kutta step of the length found must end on the ground: to 1e-8 m in the longest step that a flight may take,
/// 2 s, where one correction leaves most.
#[test]
fn an_event_is_placed_precisely_within_steps_of_any_length() {
    let ball = Ball { mass: 0.0459, radius: 0.0213, inertia: 8.336e-6 };
    let air = Air { density: 1.18, viscosity: 1.837e-5, wind: Vec3::zero() };
    let flight = Flight::new(&ball, Vec3::new(0.0, -30.0, 250.0), &air);
    for (height, h) in [(0.5, 0.1), (2.0, 0.4), (10.0, 1.0), (20.0, 2.0)] {
        let y = [200.0, height, 1.0, 25.0, -14.0, 2.0, 0.9];
        let rate = flight.rhs(&y);
        let end = DORMAND_PRINCE.attempt(&flight, &y, &rate, h);
        assert!(end.y[HEIGHT] < 0.0);
        let step = Step { time: 0.0, h, start: (y, rate), end: (end.y, end.rate) };
        let (time, state) = step.at(Event::Landing, &flight);
        let landed = DORMAND_PRINCE.attempt(&flight, &y, &rate, time);
        assert!(landed.y[HEIGHT].abs() < 1e-8, "{:e}", landed.y[HEIGHT]);
        assert!((landed.y[0] - state[0]).abs() < 1e-8, "{:e}", landed.y[0] - state[0]);
    }
}
