//! Shots in packs of four and eight against the same shots one by one.

use crate::batches::run;
use crate::shots::*;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::sensitivity::sensitivity;
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::{Accuracy, ImpactModel};
use clubface_math::with_lanes;
use proptest::prelude::*;

/// Rounding is the same in every lane and each lane takes its own steps, so that more than the 1e-12 one could ask
/// holds: the same bits.
fn assert_same(model: ImpactModel, shots: &[Inputs], parameters: &[f64], accuracy: Accuracy) {
    let alone: Vec<Outputs> = shots.iter().map(|shot| hit(model, shot, parameters, accuracy)).collect();
    for width in [4, 8] {
        let packs = with_lanes(width, || launches(model, shots, parameters, accuracy));
        for (i, (one, other)) in alone.iter().zip(&packs).enumerate() {
            for (j, (a, b)) in one.0.iter().zip(&other.0).enumerate() {
                let (name, output) = (model.info().name, OUTPUTS[j].name);
                let same = a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
                assert!(same, "{name} shot {i} {output}: {b:e} in {width} lanes, {a:e} alone");
            }
        }
    }
}

/// Launches of shots that must succeed, in packs.
fn launches(model: ImpactModel, shots: &[Inputs], parameters: &[f64], accuracy: Accuracy) -> Vec<Outputs> {
    let (outputs, rejects) = run(model, shots, parameters, accuracy);
    assert!(rejects.is_empty(), "{rejects:?}");
    outputs
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn a_pack_of_shots_gives_the_bits_of_its_shots(
        drives in prop::collection::vec(delivered(Club::Driver), 1..12),
        irons in prop::collection::vec(delivered(Club::Iron), 1..12),
    ) {
        for model in every_model().filter(|model| model.info().lanes) {
            for (club, shots) in [(Club::Driver, &drives), (Club::Iron, &irons)] {
                let parameters = published(model, club);
                for accuracy in [Accuracy::Fast, Accuracy::Tolerance(1e-7)] {
                    assert_same(model, shots, &parameters, accuracy);
                }
            }
        }
    }

    /// Different clubs in one pack: a plane and a torus.
    #[test]
    fn different_clubs_may_share_a_pack(shots in prop::collection::vec(any_delivery(), 8)) {
        let shots: Vec<Inputs> = shots.into_iter().map(|(_, inputs)| inputs).collect();
        for model in every_model().filter(|model| model.info().lanes) {
            let parameters = published(model, Club::Driver);
            assert_same(model, &shots, &parameters, Accuracy::Fast);
        }
    }
}

/// The rings branch on values, so a pack may hold one shot only: the same one in every lane, with other derivatives.
#[test]
fn a_pack_of_one_shot_gives_its_bits_and_its_derivatives_in_any_width() {
    for model in every_model() {
        for club in CLUBS {
            let parameters = published(model, club);
            let shot = played(club).with(&[("toe", 0.01), ("path", 0.04)]);
            let variables = [0, 1, 3, 6, 12, 28, INPUT_COUNT, INPUT_COUNT + 1];
            let bits = |width: usize| {
                let result = with_lanes(width, || {
                    sensitivity(model, &shot.0, &parameters, &variables, Accuracy::Fast).unwrap()
                });
                let derivatives = result.jacobian.iter().flatten().map(|value| value.to_bits()).collect();
                (Outputs(result.values).bits(), derivatives)
            };
            let alone: (_, Vec<u64>) = bits(1);
            assert_eq!(bits(4), alone, "{}", model.info().name);
            assert_eq!(bits(8), alone, "{}", model.info().name);
        }
    }
}
