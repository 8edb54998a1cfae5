//! Derivatives of a batch are those of its shots one by one, bit for bit, on any number of threads.

use crate::shots::*;
use clubface_impact::batch::Batch;
use clubface_impact::columns::{Column, Reject};
use clubface_impact::parallel::in_parallel;
use clubface_impact::sensitivity::{CHUNK, Sensitivities, sensitivity};
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::{Accuracy, ImpactModel};

const OUTPUTS: [&str; 3] = ["ball_speed", "backspin", "contact_time"];

/// Values and derivatives of drives at several speeds: columns by shots.
fn run(
    model: ImpactModel,
    speeds: &[f64],
    parameters: &[f64],
    variables: &[usize],
    threads: usize,
) -> (Vec<Vec<f64>>, Vec<Reject>) {
    let mut inputs = played(Club::Driver).0.map(Column::Constant);
    inputs[input("speed")] = Column::Values(speeds);
    let parameters: Vec<_> = parameters.iter().copied().map(Column::Constant).collect();
    let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy: Accuracy::Fast };
    let outputs = OUTPUTS.map(output);
    let wanted = Sensitivities { batch, outputs: &outputs, variables };
    wanted.validate(speeds.len()).unwrap();
    let mut columns = vec![vec![0.0; speeds.len()]; wanted.columns()];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let slices = columns.iter_mut().map(Vec::as_mut_slice).collect();
    let rejects =
        pool.install(|| in_parallel(CHUNK, 0..speeds.len(), slices, |rows, part| wanted.run(rows, part)));
    (columns, rejects)
}

fn bits(columns: &[Vec<f64>]) -> Vec<Vec<u64>> {
    columns.iter().map(|column| column.iter().map(|value| value.to_bits()).collect()).collect()
}

#[test]
fn a_shot_of_a_batch_has_the_derivatives_it_has_alone() {
    // More than a chunk; one shot cannot be computed.
    let bad = CHUNK + 1;
    let mut speeds: Vec<f64> = (0..CHUNK + 3).map(|i| 45.0 + 0.7 * i as f64).collect();
    speeds[bad] = f64::NAN;
    for model in every_model() {
        let parameters = published(model, Club::Driver);
        let mut variables = vec![input("toe"), input("speed")];
        variables.extend(INPUT_COUNT..INPUT_COUNT + parameters.len());
        let (columns, rejects) = run(model, &speeds, &parameters, &variables, 1);
        assert_eq!(bits(&columns), bits(&run(model, &speeds, &parameters, &variables, 3).0));
        assert_eq!(rejects.iter().map(|reject| reject.row).collect::<Vec<_>>(), [bad]);
        assert!(columns.iter().all(|column| column[bad].is_nan()));
        for row in (0..speeds.len()).filter(|&row| row != bad) {
            let shot = played(Club::Driver).with(&[("speed", speeds[row])]);
            let alone = sensitivity(model, &shot.0, &parameters, &variables, Accuracy::Fast).unwrap();
            for (column, name) in columns.chunks(1 + variables.len()).zip(OUTPUTS) {
                assert_eq!(column[0][row].to_bits(), alone.values[output(name)].to_bits());
                for (i, derivative) in alone.jacobian[output(name)].iter().enumerate() {
                    assert_eq!(column[1 + i][row].to_bits(), derivative.to_bits(), "{}", model.info().name);
                }
            }
        }
    }
}

#[test]
fn what_cannot_be_differentiated_is_named() {
    let inputs = played(Club::Driver).0.map(Column::Constant);
    let parameters = published(STANDARD, Club::Driver);
    let parameters: Vec<_> = parameters.into_iter().map(Column::Constant).collect();
    let model = STANDARD;
    let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy: Accuracy::Fast };
    let fault = |outputs: &[usize], variables: &[usize]| {
        Sensitivities { batch, outputs, variables }.validate(1).unwrap_err().input
    };
    assert_eq!(fault(&[0], &[input("hand")]), "variables");
    assert_eq!(fault(&[0], &[INPUT_COUNT + 2]), "variables");
    assert_eq!(fault(&[99], &[0]), "outputs");
}
