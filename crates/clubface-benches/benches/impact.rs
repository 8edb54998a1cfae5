//! Time of an impact next to the launch, by every model: shots in a batch on one core, one shot, all derivatives.

use clubface_impact::batch::Batch;
use clubface_impact::columns::Column;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::sensitivity::sensitivity;
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::{Accuracy, registry};
use criterion::{Criterion, Throughput};
use std::hint::black_box;

/// Shots of a batch: enough to fill every pack, few enough to repeat.
const SHOTS: usize = 2048;

/// Caldwell and McPhee's driver and ball, delivered at 108 mph, attack 2 deg, dynamic loft 13 deg; the face outline is
/// assumed.
fn drive() -> [f64; INPUT_COUNT] {
    let degrees = |angle: f64| angle.to_radians();
    let mut inputs = [0.0; INPUT_COUNT];
    inputs[..4].copy_from_slice(&[108.0 * 0.447_04, degrees(2.0), 0.0, degrees(13.0)]);
    inputs[14..18].copy_from_slice(&[0.204, 40.8e-3, 11.4e-3, 1e-3]);
    inputs[18..24].copy_from_slice(&[2843e-7, 5679e-7, 4085e-7, -733e-7, 530.2e-7, 0.5e-7]);
    inputs[24..31].copy_from_slice(&[degrees(9.8), 0.305, 0.305, 0.12, 0.06, 0.0, 1.0]);
    inputs[31..34].copy_from_slice(&[0.0459, 0.0213, 83.36e-7]);
    inputs
}

/// Speeds of 97 to 119 mph, every shot another, with impact points over the face.
fn deliveries(inputs: &[f64; INPUT_COUNT]) -> Vec<Vec<f64>> {
    let mut columns: Vec<Vec<f64>> = inputs.iter().map(|&value| vec![value; SHOTS]).collect();
    for shot in 0..SHOTS {
        let part = shot as f64 / SHOTS as f64;
        columns[0][shot] *= 0.9 + 0.2 * part;
        columns[6][shot] = 0.02 * (40.0 * part).sin();
        columns[7][shot] = 0.01 * (27.0 * part).cos();
    }
    columns
}

fn spread(reference: &[f64], values: &[f64]) -> f64 {
    reference.iter().zip(values).map(|(a, b)| (b / a - 1.0).abs()).fold(0.0, f64::max)
}

fn impact(criterion: &mut Criterion) {
    let inputs = drive();
    let columns = deliveries(&inputs);
    let columns: Vec<Column<'_>> = columns.iter().map(|values| Column::Values(values)).collect();
    for &model in registry::ALL {
        let info = model.info();
        let parameters = info.defaults();
        let fixed: Vec<Column<'_>> = parameters.iter().map(|&value| Column::Constant(value)).collect();
        // Into room that is there: to clear and return it would cost as much as a closed form.
        let run = |accuracy: Accuracy, outputs: &mut [Vec<f64>]| {
            let shots = outputs[0].len();
            let part: Vec<Column<'_>> = columns
                .iter()
                .map(|column| match column {
                    Column::Values(values) => Column::Values(&values[..shots]),
                    constant @ Column::Constant(_) => *constant,
                })
                .collect();
            let batch = Batch { model, inputs: &part, parameters: &fixed, accuracy };
            let slices = outputs.iter_mut().map(Vec::as_mut_slice).collect();
            let rejects = batch.run(0..shots, slices);
            assert!(rejects.is_empty(), "{rejects:?}");
        };
        let room = |shots: usize| vec![vec![0.0; shots]; OUTPUT_COUNT];
        let [mut fast, mut tight] = [room(64), room(64)];
        run(Accuracy::Fast, &mut fast);
        run(Accuracy::Tolerance(1e-9), &mut tight);
        println!(
            "{}: ball speed {:.3} m/s, launch {:.3} deg, total spin {:.1} rpm; fast against tight over 64 shots: ball \
             speed {:.1e}, total spin {:.1e}",
            info.name,
            fast[0][32],
            fast[2][32].to_degrees(),
            fast[6][32] * 30.0 / std::f64::consts::PI,
            spread(&tight[0], &fast[0]),
            spread(&tight[6], &fast[6]),
        );
        let mut group = criterion.benchmark_group(info.name);
        group.sample_size(10);
        group.throughput(Throughput::Elements(SHOTS as u64));
        for (title, shots) in [("batch on one core", SHOTS), ("one shot", 1)] {
            let mut outputs = room(shots);
            group.throughput(Throughput::Elements(shots as u64));
            group.bench_function(title, |bencher| {
                bencher.iter(|| run(Accuracy::Fast, black_box(&mut outputs)));
            });
        }
        // The delivery, mass, CG and inertia of the club but one element.
        let variables: Vec<usize> = (0..20).collect();
        group.bench_function("one shot with 20 derivatives", |bencher| {
            bencher.iter(|| {
                sensitivity(model, black_box(&inputs), &parameters, &variables, Accuracy::Fast)
                    .expect("a good shot")
            });
        });
        group.finish();
    }
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    impact(&mut criterion);
    criterion.final_summary();
}
