//! The fast setting against the tight one over realistic deliveries.

use crate::shots::*;
use clubface_impact::{Accuracy, ImpactModel};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

const TIGHT: Accuracy = Accuracy::Tolerance(1e-10);

/// Largest differences over a sample: velocity and surface speed (spin times radius) over ball speed, and spin over
/// spin.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    launch: f64,
    spin: f64,
}

fn worst(model: ImpactModel, club: Club, face: (f64, f64), count: usize) -> Worst {
    let mut runner = TestRunner::deterministic();
    let deliveries = delivered(club);
    let mut worst = Worst::default();
    for _ in 0..count {
        let inputs = on_face(deliveries.new_tree(&mut runner).unwrap().current(), face);
        let parameters = published(model, club);
        let fast = hit(model, &inputs, &parameters, Accuracy::Fast);
        let tight = hit(model, &inputs, &parameters, TIGHT);
        let speed = tight.at("ball_speed");
        let velocity = (fast.ball_velocity() - tight.ball_velocity()).norm() / speed;
        let spin = (fast.ball_spin() - tight.ball_spin()).norm();
        worst.launch = worst.launch.max(velocity).max(spin * inputs.at("ball_radius") / speed);
        worst.spin = worst.spin.max(spin / tight.ball_spin().norm());
    }
    println!("{} {club:?} {face:?}: worst of {count}: {worst:?}", model.info().name);
    worst
}

/// The launch is its velocity and the velocity of the ball's surface, both in units of the ball speed: 1e-4.
#[test]
fn the_fast_setting_gives_the_launch_to_one_part_in_ten_thousand() {
    for club in CLUBS {
        for model in [VOLUMETRIC, AREA] {
            assert!(worst(model, club, FACES[0], 150).launch < 1e-4);
            for face in &FACES[1..] {
                assert!(worst(model, club, *face, 40).launch < 1e-4);
            }
        }
    }
}

/// Rings come into contact one by one. Of all deliveries some have little spin to compare with: 1%.
#[test]
fn the_fast_setting_of_the_rings_gives_the_spin_to_a_percent() {
    for club in CLUBS {
        for face in FACES {
            let worst = worst(RINGS, club, face, 12);
            // A face that gives swings between the steps.
            let most = if face == FACES[0] { 1e-2 } else { 2e-2 };
            assert!(worst.spin < most && worst.launch < 1e-3);
        }
    }
}

/// Each hundredth of the tolerance brings the launch nearer to that of the tightest.
#[test]
fn tighter_tolerances_converge() {
    let inputs = played(Club::Driver).with(&[("toe", 0.015), ("path", 0.05)]);
    for model in [VOLUMETRIC, AREA] {
        let parameters = published(model, Club::Driver);
        let at = |tolerance: f64| hit(model, &inputs, &parameters, Accuracy::Tolerance(tolerance));
        let limit = at(1e-12);
        let error = |tolerance: f64| {
            (at(tolerance).ball_spin() - limit.ball_spin()).norm() / limit.ball_spin().norm()
        };
        let errors = [error(1e-6), error(1e-8), error(1e-10)];
        assert!(errors[1] < errors[0].max(1e-9) && errors[2] < 1e-8, "{}: {errors:?}", model.info().name);
    }
}
