//! Steps sized by the estimated error.

use super::problems::{Curves, Linearization, Until, curves_at, distance};
use clubface_math::ode::{
    BOGACKI_SHAMPINE, Control, DORMAND_PRINCE, Method, Outcome, RK4, Rosenbrock, integrate,
};

const END: f64 = 10.0;

fn control(tolerance: f64) -> Control<f64, 3> {
    Control { tolerance, scale: [1.0; 3], first: 1e-3, longest: 1.0, max_steps: 1_000_000 }
}

fn run<M: Method<Curves, f64, 3>>(
    method: &M,
    control: &Control<f64, 3>,
) -> (Outcome<bool>, Until<f64, 3>, f64) {
    let start = curves_at(0.0);
    let mut watch = Until::new(END, start);
    let outcome = integrate(method, &Curves(Linearization::Exact), start, control, &mut watch);
    let error = distance(&watch.last, &curves_at(watch.time));
    (outcome, watch, error)
}

/// How much an error made at the start has grown at the end, by an integration at 1e-12.
fn amplification() -> f64 {
    let end_from = |shift: [f64; 3]| {
        let start = curves_at(0.0);
        let start = [0, 1, 2].map(|i| start[i] + shift[i]);
        let mut watch = Until::new(END, start);
        integrate(&DORMAND_PRINCE, &Curves(Linearization::Exact), start, &control(1e-12), &mut watch);
        watch.last
    };
    let size = 1e-6;
    let grown = |shift: [f64; 3]| {
        let end = end_from(shift);
        distance(&end, &curves_at(end[0])) / size
    };
    grown([0.0, size, 0.0]) + grown([0.0, 0.0, size])
}

/// A step's true error is below its estimate (local extrapolation), so the global error is at most the tolerance (of
/// numbers up to 1 + 2.7) times the number of steps times the amplification; and it falls with the tolerance: no slower
/// than its 0.8th power over four to six decades. Coarser ones are met in so few steps that the first, short ones
/// count.
fn assert_error_follows_tolerance<M: Method<Curves, f64, 3>>(method: &M, tolerances: [f64; 3]) {
    let runs = tolerances.map(|tolerance| run(method, &control(tolerance)));
    for ((outcome, _, error), tolerance) in runs.iter().zip(tolerances) {
        assert!(outcome.finished);
        let limit = tolerance * 3.7 * outcome.steps as f64 * amplification();
        assert!(*error < limit, "{error:e} at tolerance {tolerance:e}, limit {limit:e}");
    }
    for pair in [0, 1] {
        let gained = runs[pair].2 / runs[pair + 1].2;
        let asked = tolerances[pair] / tolerances[pair + 1];
        assert!(gained > asked.powf(0.8), "error falls by {gained} for {asked}");
    }
}

#[test]
fn the_global_error_of_dormand_prince_falls_with_the_tolerance() {
    assert_error_follows_tolerance(&DORMAND_PRINCE, [1e-5, 1e-8, 1e-11]);
}

#[test]
fn the_global_error_of_bogacki_shampine_falls_with_the_tolerance() {
    assert_error_follows_tolerance(&BOGACKI_SHAMPINE, [1e-4, 1e-6, 1e-8]);
}

#[test]
fn the_global_error_of_rosenbrock_falls_with_the_tolerance() {
    assert_error_follows_tolerance(&Rosenbrock, [1e-4, 1e-6, 1e-8]);
}

/// Steps go with tolerance^(-1/order), here over three decades; the controller's rounded exponents and the limits of
/// growth leave a quarter.
#[test]
fn the_number_of_steps_grows_as_the_order_says() {
    fn growth<M: Method<Curves, f64, 3>>(method: &M, tolerances: [f64; 2]) -> f64 {
        let [coarse, fine] = tolerances.map(|tolerance| run(method, &control(tolerance)).0.steps as f64);
        fine / coarse
    }
    let by_order_five = growth(&DORMAND_PRINCE, [1e-8, 1e-11]) / 1e3f64.powf(1.0 / 5.0);
    let by_order_three = growth(&BOGACKI_SHAMPINE, [1e-5, 1e-8]) / 1e3f64.powf(1.0 / 3.0);
    assert!((by_order_five - 1.0).abs() < 0.25, "{by_order_five}");
    assert!((by_order_three - 1.0).abs() < 0.25, "{by_order_three}");
}

/// A controller aims below the tolerance, so that where errors change little from step to step hardly any is too large:
/// no more than one of twenty on curves as smooth as these.
#[test]
fn hardly_any_step_of_a_smooth_problem_is_rejected() {
    fn rejected<M: Method<Curves, f64, 3>>(method: &M, tolerance: f64) -> f64 {
        let (outcome, watch, _) = run(method, &control(tolerance));
        1.0 - watch.count(0) as f64 / outcome.steps as f64
    }
    let shares =
        [rejected(&DORMAND_PRINCE, 1e-11), rejected(&BOGACKI_SHAMPINE, 1e-8), rejected(&Rosenbrock, 1e-8)];
    assert!(shares.iter().all(|share| (0.0..0.05).contains(share)), "{shares:?}");
}

#[test]
fn steps_are_never_longer_than_allowed_and_start_as_told() {
    let limits = Control { longest: 0.05, ..control(1e-3) };
    let (_, watch, _) = run(&DORMAND_PRINCE, &limits);
    assert_eq!(watch.steps[0].0, 1e-3);
    assert!(watch.steps.iter().all(|(h, _)| *h <= 0.05));
    assert!(watch.steps.last().is_some_and(|(h, _)| *h == 0.05));
}

#[test]
fn a_first_step_that_is_too_long_is_rejected_and_shortened() {
    let eager = Control { first: 5.0, longest: 5.0, ..control(1e-9) };
    let (outcome, watch, error) = run(&DORMAND_PRINCE, &eager);
    assert!(outcome.finished && outcome.steps > watch.count(0) && watch.steps[0].0 < 1.0);
    assert!(error < 1e-9 * 3.7 * outcome.steps as f64 * amplification());
}

#[test]
fn an_integration_that_runs_out_of_steps_says_so() {
    let few = Control { max_steps: 5, ..control(1e-9) };
    let (outcome, watch, _) = run(&DORMAND_PRINCE, &few);
    assert!(!outcome.finished && outcome.steps == 5 && watch.time < END);
}

#[test]
fn the_classical_method_takes_equal_steps() {
    let (outcome, watch, _) = run(&RK4, &control(1e-9));
    assert!(outcome.finished && watch.steps.iter().all(|(h, _)| *h == 1e-3));
    assert_eq!(watch.steps.len(), outcome.steps);
}
