//! The Rosenbrock method on stiff decay: any step is stable, and a step much longer than the decay ends on the slow
//! solution.

use super::problems::Until;
use clubface_math::ode::{Control, DORMAND_PRINCE, Method, Rosenbrock, StiffSystem, System, integrate};

/// z' = lambda z for a complex lambda = a + ib, as two real equations.
struct Oscillator {
    a: f64,
    b: f64,
}

impl System<f64, 2> for Oscillator {
    fn rhs(&self, [x, y]: &[f64; 2]) -> [f64; 2] {
        [self.a * x - self.b * y, self.b * x + self.a * y]
    }
}

impl StiffSystem<f64, 2> for Oscillator {
    type Jacobian = ();
    type Solver = (f64, f64);
    fn linearize(&self, _: &[f64; 2]) {}
    fn factor(&self, (): &(), g: f64) -> (f64, f64) {
        (1.0 - g * self.a, -g * self.b)
    }
    fn solve(&self, (c, d): &(f64, f64), [x, y]: &[f64; 2]) -> [f64; 2] {
        let square = c * c + d * d;
        [(c * x + d * y) / square, (c * y - d * x) / square]
    }
}

/// |z| after a step of one second from 1: the stability function.
fn growth(a: f64, b: f64) -> f64 {
    let problem = Oscillator { a, b };
    let start = [1.0, 0.0];
    let end = Rosenbrock.attempt(&problem, &start, &problem.rhs(&start), 1.0);
    end.y[0].hypot(end.y[1])
}

#[test]
fn the_stability_function_is_the_exponential_near_zero() {
    // Order 3 leaves |a|^4 / 24 and a like term: under 1e-9 at 1/200.
    assert!((growth(-0.005, 0.0) - (-0.005f64).exp()).abs() < 1e-9);
}

/// A-stable: nothing that decays in truth grows, be it near the imaginary axis. 1e-12 is rounding.
#[test]
fn no_decaying_motion_grows_at_any_step() {
    for exponent in -12..=32 {
        let size = 10f64.powf(f64::from(exponent) / 4.0);
        for angle in 0..=90 {
            let (sine, cosine) = f64::from(angle).to_radians().sin_cos();
            let result = growth(-size * cosine, size * sine);
            assert!(result <= 1.0 + 1e-12, "size {size}, {angle} deg from the real axis: {result}");
        }
    }
}

/// L-stable: the stability function falls like 1/|z|, so that a step of 1e4 decay times leaves less than 1e-3.
#[test]
fn a_step_much_longer_than_the_decay_ends_it() {
    for decay in [1e4, 1e6, 1e8] {
        assert!(growth(-decay, 0.0) < 10.0 / decay, "{decay}: {}", growth(-decay, 0.0));
    }
}

/// Prothero and Robinson's problem, state (t, y): y' = -rate (y - cos t) - sin t, which tends to cos t.
struct Pursuit {
    rate: f64,
}

impl System<f64, 2> for Pursuit {
    fn rhs(&self, [t, y]: &[f64; 2]) -> [f64; 2] {
        [1.0, -self.rate * (y - t.cos()) - t.sin()]
    }
}

/// Only the stiff part is linearised: the derivative by y.
impl StiffSystem<f64, 2> for Pursuit {
    type Jacobian = ();
    type Solver = f64;
    fn linearize(&self, _: &[f64; 2]) {}
    fn factor(&self, (): &(), g: f64) -> f64 {
        1.0 / (1.0 + g * self.rate)
    }
    fn solve(&self, inverse: &f64, [t, y]: &[f64; 2]) -> [f64; 2] {
        [*t, y * inverse]
    }
}

/// The decay lasts a microsecond of the second that is integrated: an explicit method cannot step beyond some 3.3 of
/// them, 300 000 steps.
#[test]
fn stiff_decay_takes_steps_of_the_slow_motion() {
    let problem = Pursuit { rate: 1e6 };
    let start = [0.0, 2.0];
    let control = Control { tolerance: 1e-4, scale: [1.0; 2], first: 1e-7, longest: 0.1, max_steps: 1000 };
    let mut watch = Until::new(1.0, start);
    let outcome = integrate(&Rosenbrock, &problem, start, &control, &mut watch);
    assert!(outcome.finished && outcome.steps < 300, "{} steps", outcome.steps);
    // Global error of the order of the tolerance times the steps that matter.
    assert!((watch.last[1] - watch.time.cos()).abs() < 1e-3);
    let mut explicit = Until::new(1.0, start);
    assert!(!integrate(&DORMAND_PRINCE, &problem, start, &control, &mut explicit).finished);
}
