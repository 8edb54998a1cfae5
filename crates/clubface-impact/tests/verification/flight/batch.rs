//! Batches: the same bits as one shot alone, and an answer for every row.

use super::{INPUT_COUNT, column, drive, flown, launch, with};
use clubface_impact::batch::CHUNK;
use clubface_impact::columns::{Column, Reject};
use clubface_impact::flight::{FlightBatch, OUTPUT_COUNT, check, trajectory};
use clubface_impact::parallel::in_parallel;

/// Shots from chips to drives, in all kinds of air, some with sidespin, some struck into the ground.
fn shots(count: usize) -> Vec<[f64; INPUT_COUNT]> {
    (0..count)
        .map(|i| {
            let phase = i as f64;
            let part = |rate: f64| (phase * rate).sin() * 0.5 + 0.5;
            let mut shot = launch(
                10.0 + 180.0 * part(0.71),
                -4.0 + 60.0 * part(1.3),
                12_000.0 * part(2.1),
                3000.0 * (part(0.37) - 0.5),
            );
            shot[column("temperature")] = 260.0 + 50.0 * part(0.9);
            shot[column("wind_x")] = 30.0 * (part(1.7) - 0.5);
            shot[column("wind_z")] = 20.0 * (part(0.2) - 0.5);
            shot
        })
        .collect()
}

/// Output i of shot j at [i][j].
fn fly(inputs: &[Column<'_>], rows: usize) -> (Vec<Vec<f64>>, Vec<Reject>) {
    let batch = FlightBatch { inputs };
    batch.validate(rows).unwrap();
    let mut outputs = vec![vec![0.0; rows]; OUTPUT_COUNT];
    let columns = outputs.iter_mut().map(Vec::as_mut_slice).collect();
    let rejects = in_parallel(CHUNK, 0..rows, columns, |rows, part| batch.run(rows, part));
    (outputs, rejects)
}

fn run(shots: &[[f64; INPUT_COUNT]], threads: usize) -> (Vec<Vec<f64>>, Vec<Reject>) {
    let columns: Vec<Vec<f64>> =
        (0..INPUT_COUNT).map(|i| shots.iter().map(|shot| shot[i]).collect()).collect();
    let columns: Vec<Column<'_>> = columns.iter().map(|values| Column::Values(values)).collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| fly(&columns, shots.len()))
}

#[test]
fn a_batch_gives_the_bits_of_each_shot_alone_on_any_number_of_threads() {
    // 2501 is no multiple of lanes or chunks.
    let shots = shots(2501);
    let (outputs, rejects) = run(&shots, 1);
    assert!(rejects.is_empty());
    for (row, shot) in shots.iter().enumerate() {
        for (i, alone) in flown(shot).outputs().into_iter().enumerate() {
            assert_eq!(outputs[i][row].to_bits(), alone.to_bits(), "output {i} of shot {row}");
        }
    }
    for threads in [2, 5] {
        assert_eq!(run(&shots, threads).0, outputs);
    }
}

#[test]
fn bad_rows_are_nan_and_named_and_leave_their_neighbours_alone() {
    let mut shots = shots(30);
    let (good, _) = run(&shots, 1);
    shots[3] = with(shots[3], "humidity", 1.5);
    shots[4] = with(shots[4], "velocity_y", f64::NAN);
    shots[17] = with(shots[17], "pressure", -1.0);
    // Rising air that carries a chip away: the ball never comes down.
    shots[29] = with(launch(20.0, 45.0, 9000.0, 0.0), "wind_y", 60.0);
    let (outputs, rejects) = run(&shots, 2);
    let named: Vec<_> = rejects.iter().map(|reject| (reject.row, reject.error.input)).collect();
    assert_eq!(named, [(3, "humidity"), (4, "velocity_y"), (17, "pressure"), (29, "wind_y")]);
    for row in 0..shots.len() {
        let bad = [3, 4, 17, 29].contains(&row);
        for i in 0..OUTPUT_COUNT {
            let (now, before) = (outputs[i][row], good[i][row]);
            let expected = if bad { now.is_nan() } else { now.to_bits() == before.to_bits() };
            assert!(expected, "output {i} of shot {row}");
        }
    }
}

#[test]
fn constants_are_columns_too_parts_make_the_whole_and_an_empty_batch_is_one() {
    let shot = drive();
    let speeds: Vec<f64> = (0..3000).map(|i| 20.0 + 0.01 * f64::from(i)).collect();
    let mut columns = shot.map(Column::Constant);
    columns[column("velocity_x")] = Column::Values(&speeds);
    let (whole, _) = fly(&columns, 3000);
    assert_eq!(whole[0][1234], flown(&with(shot, "velocity_x", speeds[1234])).outputs()[0]);
    let mut part = vec![vec![0.0; 1500]; OUTPUT_COUNT];
    let slices = part.iter_mut().map(Vec::as_mut_slice).collect();
    assert!(FlightBatch { inputs: &columns }.run(700..2200, slices).is_empty());
    for i in 0..OUTPUT_COUNT {
        assert_eq!(part[i], whole[i][700..2200]);
    }
    assert_eq!(fly(&shot.map(Column::Constant), 0), (vec![vec![]; OUTPUT_COUNT], vec![]));
}

#[test]
fn misuse_of_the_call_differs_from_bad_shots() {
    let mut columns = drive().map(Column::Constant);
    let error = |inputs: &[Column<'_>]| FlightBatch { inputs }.validate(3).unwrap_err().to_string();
    assert_eq!(error(&columns[1..]), "inputs: 19 columns given, 20 needed");
    columns[column("spin_z")] = Column::Values(&[1.0, 2.0]);
    assert_eq!(error(&columns), "spin_z: the column has 2 rows, the batch 3");
}

#[test]
fn every_input_is_checked_and_named_with_its_value_and_what_is_allowed() {
    let error = |name: &str, value: f64| check(&with(drive(), name, value)).unwrap_err();
    assert_eq!(error("humidity", 1.2).to_string(), "humidity: 1.2 is not allowed; allowed is 0 to 1");
    let low = error("pressure", -5.0).to_string();
    assert_eq!(low, "pressure: -5 Pa is not allowed; allowed is 30000 to 120000 Pa");
    for input in &clubface_impact::flight::INPUTS {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(error(input.quantity.name, value).input, input.quantity.name);
        }
    }
    for name in
        ["ball_mass", "ball_radius", "ball_inertia", "temperature", "ground_friction", "rolling_friction"]
    {
        assert_eq!(error(name, 0.0).input, name);
    }
    // 83.36 g cm2 taken for 8.336e-5 kg m2: more than a hollow ball can have.
    assert_eq!(error("ball_inertia", 8.336e-5).input, "ball_inertia");
    let mut still = drive();
    still[3..6].fill(0.0);
    assert_eq!(check(&still).unwrap_err().input, "velocity_x");
    assert!(check(&clubface_impact::flight::default_inputs()).is_err(), "a launch has no default");
    assert!(check(&drive()).is_ok());
}

#[test]
fn a_track_starts_at_launch_and_ends_where_the_ball_lands() {
    let shot = launch(171.0, 10.4, 2545.0, 400.0);
    let track = trajectory(&shot).unwrap();
    let outputs = flown(&shot).outputs();
    let last = track.position[track.position.len() - 1];
    assert_eq!(track.position[0], [0.0; 3]);
    assert_eq!(last[1], 0.0);
    // The two differ by their steps: errors of 1e-7 a step.
    assert!((last[0].hypot(last[2]) - outputs[0]).abs() < 1e-3, "{last:?} {outputs:?}");
    assert!(track.time.windows(2).all(|pair| pair[1] > pair[0] && pair[1] - pair[0] < 0.020_001));
    let highest = track.position.iter().map(|p| p[1]).fold(0.0, f64::max);
    // Points 0.02 s apart miss the apex by up to g (0.01 s)^2 / 2.
    assert!(highest <= outputs[2] + 1e-4 && highest > outputs[2] - 1e-3);
}
