//! Coulomb friction of all rings at once: the law itself, from which all symmetries follow, and its derivatives.

use clubface_impact::rings::friction::{Friction, Given};
use clubface_impact::rings::influence::Influence;
use clubface_math::Dual;
use proptest::prelude::*;
use std::f64::consts::PI;

/// Bounds of a Hertzian pressure on the first m of n rings, the contact ending `reach` of a ring beyond the m-th.
fn hertz_bounds(n: usize, m: usize, reach: f64) -> Vec<f64> {
    let radius = |j: f64| (j + 0.5) / n as f64;
    let a = radius(m as f64 - 1.0 + reach);
    (0..m).map(|j| (1.0 - (radius(j as f64) / a).powi(2)).sqrt()).collect()
}

/// Largest error of a traction: its distance from the projection of y - s/M_jj on the disc of radius b, with the slip
/// s = g + M y computed here. Zero for the solution of Coulomb's law and for nothing else.
fn coulomb_error(friction: &Friction, bound: &[f64], free: [&[f64]; 2]) -> f64 {
    let influence = friction.influence();
    let mut largest: f64 = 0.0;
    for j in 0..bound.len() {
        let y = [0, 1].map(|axis| friction.traction()[axis][j]);
        let by = |i: usize| influence.displacement()[i * influence.stride() + j];
        let slip = [0, 1].map(|axis| {
            free[axis][j] + (0..bound.len()).map(|i| by(i) * friction.traction()[axis][i]).sum::<f64>()
        });
        let trial = [0, 1].map(|axis| y[axis] - slip[axis] / influence.diagonal()[j]);
        let length = trial[0].hypot(trial[1]);
        let scale = if length > bound[j] { bound[j] / length } else { 1.0 };
        let size = 1.0 + length;
        largest = largest.max((trial[0] * scale - y[0]).hypot(trial[1] * scale - y[1]) / size);
    }
    largest
}

fn solve(n: usize, bound: &[f64], free: &[Vec<f64>; 2]) -> Friction {
    let mut friction = Friction::new(Influence::shared(n));
    friction.solve(bound, [&free[0], &free[1]]);
    friction
}

/// Free slips from nothing to gross sliding, smooth in the radius with a rough part: a common slip, a gradient, noise.
fn free_slips() -> impl Strategy<Value = (usize, Vec<f64>, [Vec<f64>; 2])> {
    let size = prop_oneof![Just(0.1), Just(1.0), Just(10.0), Just(1e4)];
    let noise = prop_oneof![Just(0.0), Just(0.1), Just(1.0)];
    (1usize..=20, 0.001..1.0f64, size, noise, prop::collection::vec(-1.0..1.0f64, 44)).prop_map(
        |(m, reach, size, noise, values)| {
            let free = [0, 1].map(|axis| {
                let [common, slope] = [values[40 + axis], values[42 + axis]];
                (0..m)
                    .map(|j| size * (common + slope * j as f64 / 20.0 + noise * values[20 * axis + j]))
                    .collect()
            });
            (m, hertz_bounds(20, m, reach), free)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// 1e-10 is what is promised; the solver stops at 1e-11, the rest is for the rounding of this check.
    #[test]
    fn coulombs_law_holds_on_every_ring_from_any_start((m, bound, free) in free_slips(),
            (_, _, before) in free_slips()) {
        let mut friction = Friction::new(Influence::shared(20));
        // Another problem before this one: its solution is a start that has nothing to do with it.
        let k = before[0].len();
        friction.solve(&hertz_bounds(20, k, 0.5), [&before[0], &before[1]]);
        friction.solve(&bound, [&free[0], &free[1]]);
        prop_assert!(coulomb_error(&friction, &bound, [&free[0], &free[1]]) < 1e-10);
        for j in 0..m {
            let [y, z] = [0, 1].map(|axis| friction.traction()[axis][j]);
            prop_assert!(y.hypot(z) <= bound[j] + 1e-10);
            let [slip_y, slip_z] = [0, 1].map(|axis| friction.slip()[axis][j]);
            prop_assert!(slip_y * y + slip_z * z <= 1e-10, "ring {} is driven by its traction", j);
        }
    }

    /// Central differences of step 1e-6 are good to 1e-4 of the largest derivative, as long as no ring changes between
    /// sticking and slipping within the step, which is checked.
    #[test]
    fn derivatives_agree_with_central_differences((m, bound, free) in free_slips(),
            direction in prop::collection::vec(-1.0..1.0f64, 60)) {
        let step = 1e-6;
        let moved = |sign: f64| {
            let bound: Vec<f64> = (0..m).map(|j| bound[j] * (1.0 + sign * step * direction[j])).collect();
            let free = [0, 1].map(|axis| {
                (0..m).map(|j| free[axis][j] + sign * step * direction[20 + 20 * axis + j]).collect()
            });
            solve(20, &bound, &free)
        };
        let (plus, minus) = (moved(1.0), moved(-1.0));
        let mut friction = solve(20, &bound, &free);
        prop_assume!(plus.sticks()[..m] == minus.sticks()[..m] && plus.sticks()[..m] == friction.sticks()[..m]);
        let dual = |tangent: f64| Dual::<f64, 1> { value: 0.0, tangent: [tangent] };
        let change = Given {
            bound: (0..m).map(|j| dual(bound[j] * direction[j])).collect(),
            free: [0, 1].map(|axis| (0..m).map(|j| dual(direction[20 + 20 * axis + j])).collect()),
        };
        let mut traction = [vec![dual(0.0); m], vec![dual(0.0); m]];
        friction.differentiate(&change, &mut traction);
        let largest = traction.iter().flatten().fold(1.0, |largest: f64, d| largest.max(d.tangent[0].abs()));
        // A ring about to slip the other way has a derivative that changes over less than the step.
        prop_assume!(largest < 1e3);
        for axis in 0..2 {
            for j in 0..m {
                let difference = (plus.traction()[axis][j] - minus.traction()[axis][j]) / (2.0 * step);
                let derivative = traction[axis][j].tangent[0];
                prop_assert!((difference - derivative).abs() < 1e-4 * largest, "{} {}", difference, derivative);
            }
        }
    }
}

/// Gross sliding: all rings at their bound against the common slip.
#[test]
fn a_large_common_slip_is_opposed_by_the_whole_friction_everywhere() {
    let bound = hertz_bounds(20, 20, 0.5);
    let friction = solve(20, &bound, &[vec![60.0; 20], vec![80.0; 20]]);
    for j in 0..20 {
        assert!((friction.traction()[0][j] + 0.6 * bound[j]).abs() < 1e-10);
        assert!((friction.traction()[1][j] + 0.8 * bound[j]).abs() < 1e-10);
    }
}

/// Cattaneo and Mindlin: under constant normal load a contact of radius a = 1 that was moved by pi (1 - c^2), in our
/// units, sticks within c, with the force mu F_N (1 - c^3). Both tractions of that solution are discs that the rings
/// hold exactly if c is a ring radius, so only rounding is left.
#[test]
fn a_constant_load_sticks_within_the_radius_of_cattaneo_and_mindlin() {
    for n in [20usize, 40, 80] {
        let influence = Influence::shared(n);
        let bound: Vec<f64> = influence.radius().iter().map(|r| (1.0 - r * r).sqrt()).collect();
        for c in [0.25, 0.5, 0.75] {
            let moved = PI * (1.0 - c * c);
            let friction = solve(n, &bound, &[vec![moved; n], vec![0.0; n]]);
            let sticking = friction.sticks().iter().filter(|&&stick| stick).count();
            assert_eq!(sticking as f64, c * n as f64);
            let force: f64 = (0..n).map(|j| -influence.force()[j] * friction.traction()[0][j]).sum();
            assert!((force / (2.0 / 3.0 * PI) - (1.0 - c.powi(3))).abs() < 1e-12);
        }
    }
}
