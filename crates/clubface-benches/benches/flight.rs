//! Time of a flight next to its result: one shot, shots in a batch on one core, all derivatives.

use clubface_impact::columns::Column;
use clubface_impact::flight::{
    FlightBatch, FlightShot, INPUT_COUNT, OUTPUT_COUNT, OUTPUTS, default_inputs, fly, sensitivity, trajectory,
};
use criterion::{Criterion, Throughput};
use std::hint::black_box;

/// Tolerated error of a step, as in a batch.
const TOLERANCE: f64 = clubface_impact::flight::trajectory::TOLERANCE;
const SHOTS: usize = 4096;

/// The published average drive: 171 mph, 10.4 deg, 2545 rpm; `part` of 1 is all of its speed.
fn drive(part: f64) -> [f64; INPUT_COUNT] {
    let (speed, angle) = (part * 171.0 * 0.447_04, 10.4f64.to_radians());
    let mut inputs = default_inputs();
    let spin = 2545.0 * std::f64::consts::PI / 30.0;
    inputs[3..9].copy_from_slice(&[speed * angle.cos(), speed * angle.sin(), 0.0, 0.0, 0.0, spin]);
    inputs
}

fn print(title: &str, outputs: &[f64]) {
    let text: Vec<String> = OUTPUTS
        .iter()
        .zip(outputs)
        .map(|(output, value)| format!("{} {value:.4} {}", output.name, output.unit))
        .collect();
    println!("{title}: {}", text.join(", "));
}

fn flight(criterion: &mut Criterion) {
    let inputs = drive(1.0);
    print("drive", &fly(&FlightShot::from_inputs(&inputs), TOLERANCE).outputs());
    criterion.bench_function("flight of one drive, f64", |bencher| {
        bencher.iter(|| fly(&FlightShot::from_inputs(black_box(&inputs)), TOLERANCE).outputs());
    });
    criterion.bench_function("track of one drive", |bencher| {
        bencher.iter(|| trajectory(black_box(&inputs)));
    });

    let exact = sensitivity(&inputs).expect("a drive lands");
    println!("carry by backspin: {:.6} m/(rad/s)", exact.jacobian[0][8]);
    criterion.bench_function("flight of one drive with its derivatives by 20 inputs", |bencher| {
        bencher.iter(|| sensitivity(black_box(&inputs)));
    });

    let shots: Vec<[f64; INPUT_COUNT]> =
        (0..SHOTS).map(|i| drive(0.5 + 0.5 * i as f64 / (SHOTS - 1) as f64)).collect();
    let columns: Vec<Vec<f64>> =
        (0..INPUT_COUNT).map(|i| shots.iter().map(|shot| shot[i]).collect()).collect();
    let columns: Vec<Column<'_>> = columns.iter().map(|values| Column::Values(values)).collect();
    let batch = FlightBatch { inputs: &columns };
    let mut outputs = vec![vec![0.0; SHOTS]; OUTPUT_COUNT];
    let mut run = || batch.run(0..SHOTS, outputs.iter_mut().map(Vec::as_mut_slice).collect());
    run();
    let mut group = criterion.benchmark_group("batch on one core");
    group.throughput(Throughput::Elements(SHOTS as u64)).sample_size(20);
    group.bench_function("drives at half to full speed", |bencher| bencher.iter(&mut run));
    group.finish();
    let last: Vec<f64> = outputs.iter().map(|output| output[SHOTS - 1]).collect();
    print("last drive of the batch", &last);
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    flight(&mut criterion);
    criterion.final_summary();
}
