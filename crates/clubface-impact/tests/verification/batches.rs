//! A batch is its shots one by one, bit for bit, whatever else is in the batch and however many threads share the work.

use crate::shots::*;
use clubface_impact::batch::{Batch, CHUNK};
use clubface_impact::columns::{Column, Reject};
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::parallel::in_parallel;
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::{Accuracy, ImpactModel};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

/// Runs shots of one parameter set as a batch on this thread.
pub fn run(
    model: ImpactModel,
    shots: &[Inputs],
    parameters: &[f64],
    accuracy: Accuracy,
) -> (Vec<Outputs>, Vec<Reject>) {
    run_by(model, shots, parameters, accuracy, |batch, columns| batch.run(0..shots.len(), columns))
}

fn run_by(
    model: ImpactModel,
    shots: &[Inputs],
    parameters: &[f64],
    accuracy: Accuracy,
    work: impl FnOnce(&Batch, Vec<&mut [f64]>) -> Vec<Reject>,
) -> (Vec<Outputs>, Vec<Reject>) {
    let columns: Vec<Vec<f64>> =
        (0..INPUT_COUNT).map(|i| shots.iter().map(|shot| shot.0[i]).collect()).collect();
    let inputs: Vec<_> = columns.iter().map(|column| Column::Values(column)).collect();
    let parameters: Vec<_> = parameters.iter().copied().map(Column::Constant).collect();
    let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy };
    batch.validate(shots.len()).unwrap();
    let mut values = vec![vec![0.0; shots.len()]; OUTPUT_COUNT];
    let rejects = work(&batch, values.iter_mut().map(Vec::as_mut_slice).collect());
    let row = |i: usize| {
        let mut outputs = [0.0; OUTPUT_COUNT];
        for (output, column) in outputs.iter_mut().zip(&values) {
            *output = column[i];
        }
        Outputs(outputs)
    };
    ((0..shots.len()).map(row).collect(), rejects)
}

fn bits(outputs: &[Outputs]) -> Vec<[u64; OUTPUT_COUNT]> {
    outputs.iter().map(Outputs::bits).collect()
}

/// A shot that cannot be computed, in one of several ways.
fn spoiled(inputs: Inputs, way: usize) -> Inputs {
    match way {
        0 => inputs.with(&[("speed", f64::NAN)]),
        1 => inputs.with(&[("club_mass", -0.2)]),
        2 => inputs.with(&[("attack", -1.2), ("loft", 0.9)]),
        3 => inputs.with(&[("toe", 0.2)]),
        _ => inputs.with(&[("cg_x", f64::INFINITY)]),
    }
}

/// Shots of which some are spoiled.
fn mixed() -> impl Strategy<Value = (Club, Vec<(Inputs, bool)>)> {
    prop_oneof![Just(Club::Driver), Just(Club::Iron)].prop_flat_map(|club| {
        let one = (delivered(club), 0..20usize)
            .prop_map(|(inputs, way)| if way < 5 { (spoiled(inputs, way), true) } else { (inputs, false) });
        (Just(club), prop::collection::vec(one, 1..20))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn a_batch_is_its_shots_one_by_one((club, shots) in mixed()) {
        let inputs: Vec<Inputs> = shots.iter().map(|(inputs, _)| *inputs).collect();
        for model in every_model() {
            let parameters = published(model, club);
            let (outputs, rejects) = run(model, &inputs, &parameters, Accuracy::Fast);
            let bad: Vec<usize> = (0..shots.len()).filter(|&i| shots[i].1).collect();
            prop_assert_eq!(rejects.iter().map(|reject| reject.row).collect::<Vec<_>>(), bad);
            for (i, (shot, spoiled)) in shots.iter().enumerate() {
                match try_hit(model, shot, &parameters, Accuracy::Fast) {
                    Ok(alone) => {
                        prop_assert!(!spoiled);
                        prop_assert_eq!(alone.bits(), outputs[i].bits(), "{} row {}", model.info().name, i);
                    }
                    Err(error) => {
                        prop_assert!(outputs[i].0.iter().all(|value| value.is_nan()));
                        let reject = rejects.iter().find(|reject| reject.row == i).unwrap();
                        prop_assert_eq!(&reject.error, &error);
                    }
                }
            }
        }
    }
}

/// More than a chunk of different shots on 1, 2 and 5 threads.
#[test]
fn the_number_of_threads_does_not_change_a_bit() {
    let mut runner = TestRunner::deterministic();
    let deliveries = delivered(Club::Driver);
    let count = CHUNK + 77;
    let shots: Vec<Inputs> =
        (0..count).map(|_| deliveries.new_tree(&mut runner).unwrap().current()).collect();
    for model in every_model() {
        let parameters = published(model, Club::Driver);
        // The rings take 0.5 ms a shot: fewer, of the same two chunks.
        let shots = if model.info().lanes { &shots[..] } else { &shots[CHUNK - 40..] };
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let work = |batch: &Batch, columns: Vec<&mut [f64]>| {
                pool.install(|| {
                    in_parallel(CHUNK, 0..shots.len(), columns, |rows, part| batch.run(rows, part))
                })
            };
            bits(&run_by(model, shots, &parameters, Accuracy::Fast, work).0)
        };
        let one = on(1);
        assert_eq!(on(2), one, "{}", model.info().name);
        assert_eq!(on(5), one, "{}", model.info().name);
    }
}

/// Parameters may be columns too, and a bad one spoils its row alone.
#[test]
fn parameters_may_differ_from_row_to_row() {
    let model = STANDARD;
    let inputs = played(Club::Driver).0.map(Column::Constant);
    let cor = [0.7, 0.8, 1.5, 0.83];
    let batch = Batch {
        model,
        inputs: &inputs,
        parameters: &[Column::Values(&cor), Column::Constant(0.0)],
        accuracy: Accuracy::Fast,
    };
    let mut values = vec![vec![0.0; 4]; OUTPUT_COUNT];
    let rejects = batch.run(0..4, values.iter_mut().map(Vec::as_mut_slice).collect());
    assert_eq!(rejects.len(), 1);
    assert_eq!((rejects[0].row, rejects[0].error.input), (2, "cor"));
    assert!(rejects[0].error.message.contains("1.5") && rejects[0].error.message.contains("0 to 1"));
    for (i, e) in cor.into_iter().enumerate().filter(|(i, _)| *i != 2) {
        let alone = hit(model, &played(Club::Driver), &[e, 0.0], Accuracy::Fast);
        assert_eq!(values[output("ball_speed")][i], alone.at("ball_speed"));
    }
}

/// A part of a batch is computed as that part of the whole.
#[test]
fn a_range_of_rows_is_that_part_of_the_batch() {
    let model = VOLUMETRIC;
    let speeds: Vec<f64> = (0..30).map(|i| 35.0 + f64::from(i)).collect();
    let mut inputs = played(Club::Driver).0.map(Column::Constant);
    inputs[input("speed")] = Column::Values(&speeds);
    let parameters: Vec<_> = published(model, Club::Driver).into_iter().map(Column::Constant).collect();
    let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy: Accuracy::Fast };
    let part = |rows: std::ops::Range<usize>| {
        let mut values = vec![vec![0.0; rows.len()]; OUTPUT_COUNT];
        let rejects = batch.run(rows, values.iter_mut().map(Vec::as_mut_slice).collect());
        assert!(rejects.is_empty());
        values[output("total_spin")].clone()
    };
    let whole = part(0..30);
    assert_eq!(part(5..17), whole[5..17]);
    assert!(part(7..7).is_empty());
}

#[test]
fn a_batch_with_missing_columns_or_rows_says_so() {
    let inputs = played(Club::Driver).0.map(Column::Constant);
    let short = [1.0; 3];
    let mut uneven = inputs;
    uneven[0] = Column::Values(&short);
    let parameters = [Column::Constant(0.83), Column::Constant(0.0)];
    let check = |inputs: &[Column], parameters: &[Column]| {
        let batch = Batch { model: STANDARD, inputs, parameters, accuracy: Accuracy::Fast };
        batch.validate(4).unwrap_err()
    };
    let needed = format!("inputs: 30 columns given, {INPUT_COUNT} needed");
    assert_eq!(check(&inputs[..30], &parameters).to_string(), needed);
    assert_eq!(check(&inputs, &parameters[..1]).to_string(), "parameters: 1 columns given, 2 needed");
    assert_eq!(check(&uneven, &parameters).to_string(), "inputs: a column has 3 rows, the batch 4");
}
