//! Shots in packs of four and eight against the same shots one by one.

use crate::shots::*;
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::history::Unrecorded;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::{Accuracy, ModelKind};
use clubface_math::lanes::{Kernel, Lanes};
use clubface_math::Mask;
use proptest::prelude::*;

#[derive(Clone, Copy)]
struct Shots<'a> {
    model: ModelKind,
    shots: &'a [Inputs],
    parameters: &'a [f64],
    accuracy: Accuracy,
}

impl Kernel for Shots<'_> {
    type Output = Vec<Outputs>;
    #[inline(always)]
    fn run<S: Lanes>(self) -> Vec<Outputs> {
        let parameters: Vec<S> = self.parameters.iter().map(|&value| S::from_f64(value)).collect();
        let mut results = Vec::new();
        for pack in self.shots.chunks(S::LANES) {
            let mut inputs = [S::zero(); INPUT_COUNT];
            for (i, value) in inputs.iter_mut().enumerate() {
                *value = S::from_fn(|lane| pack[lane.min(pack.len() - 1)].0[i]);
            }
            let touch = FirstTouch::of_inputs(&inputs);
            let impact = self.model.impact(&touch, &parameters, self.accuracy, &mut Unrecorded);
            assert!(impact.separated.all());
            let values = impact.launch.outputs();
            for lane in 0..pack.len() {
                let mut outputs = [0.0; OUTPUT_COUNT];
                for (output, value) in outputs.iter_mut().zip(&values) {
                    *output = value.lane(lane);
                }
                results.push(Outputs(outputs));
            }
        }
        results
    }
}

/// Rounding is the same in every lane and each lane takes its own steps, so that more than the 1e-12 one could ask holds:
/// the same bits.
fn assert_same(kernel: Shots) {
    let alone = kernel.run::<f64>();
    #[allow(unused_mut)]
    let mut packs: Vec<(usize, Vec<Outputs>)> = Vec::new();
    #[cfg(target_arch = "x86_64")]
    {
        use clubface_math::lanes::x86;
        if x86::has_four() {
            // SAFETY: the CPU has the features of this width.
            packs.push((4, unsafe { x86::run_four(kernel) }));
        }
        if x86::has_eight() {
            // SAFETY: as above.
            packs.push((8, unsafe { x86::run_eight(kernel) }));
        }
    }
    for (width, results) in packs {
        for (i, (one, other)) in alone.iter().zip(&results).enumerate() {
            for (j, (a, b)) in one.0.iter().zip(&other.0).enumerate() {
                let name = clubface_impact::launch::OUTPUTS[j].name;
                let same = a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
                assert!(
                    same,
                    "{} shot {i} {name}: {b:e} in {width} lanes, {a:e} alone",
                    kernel.model.info().name
                );
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn a_pack_of_shots_gives_the_bits_of_its_shots(
        drives in prop::collection::vec(delivered(Club::Driver), 1..12),
        irons in prop::collection::vec(delivered(Club::Iron), 1..12),
    ) {
        for &model in ModelKind::ALL.iter().filter(|model| model.info().lanes) {
            for (club, shots) in [(Club::Driver, &drives), (Club::Iron, &irons)] {
                let parameters = published(model, club);
                for accuracy in [Accuracy::Fast, Accuracy::Tolerance(1e-7)] {
                    assert_same(Shots { model, shots, parameters: &parameters, accuracy });
                }
            }
        }
    }

    /// Different clubs in one pack: plane beside torus.
    #[test]
    fn different_clubs_may_share_a_pack(shots in prop::collection::vec(any_delivery(), 8)) {
        let shots: Vec<Inputs> = shots.into_iter().map(|(_, inputs)| inputs).collect();
        for &model in ModelKind::ALL.iter().filter(|model| model.info().lanes) {
            let parameters = published(model, Club::Driver);
            assert_same(Shots { model, shots: &shots, parameters: &parameters, accuracy: Accuracy::Fast });
        }
    }
}

/// The rings branch on values, so a pack may hold one shot only: the same one in every lane.
#[test]
fn a_pack_of_one_shot_by_rings_gives_its_bits() {
    let model = ModelKind::Rings;
    for club in CLUBS {
        let parameters = published(model, club);
        let shots = [played(club).with(&[("toe", 0.01), ("path", 0.04)])];
        assert_same(Shots { model, shots: &shots, parameters: &parameters, accuracy: Accuracy::Fast });
    }
}
