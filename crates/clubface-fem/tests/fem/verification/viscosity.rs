//! Maxwell branches against closed forms of linear viscoelasticity.

use clubface_fem::material::{Material, MaterialPoint, Maxwell, NeoHookean};
use clubface_math::{Mat3, Vec3};

const SHEAR: f64 = 2e6;
const BULK: f64 = 8e6;
const TERMS: [Maxwell<f64>; 2] = [Maxwell { modulus: 0.6, time: 1e-4 }, Maxwell { modulus: 1.5, time: 7e-4 }];

/// A point with two branches, which takes steps of one length.
struct Point {
    point: MaterialPoint<f64>,
    dt: f64,
}

impl Point {
    fn new(dt: f64) -> Self {
        let law = NeoHookean { shear: SHEAR }.law();
        let material = Material { law, bulk: BULK, maxwell: TERMS.to_vec(), density: 1e3 };
        Self { point: MaterialPoint::new(&material), dt }
    }
    /// First Piola-Kirchhoff stress at the end of a step to the gradient `f`, Pa.
    fn step(&mut self, f: Mat3<f64>) -> Mat3<f64> {
        self.point.update(&f, self.dt)
    }
    /// Work done on the branches so far, J/m3.
    fn work(&mut self) -> f64 {
        self.point.energy(&Mat3::diagonal(1.0)).viscous
    }
}

/// Simple shear.
fn shear(angle: f64) -> Mat3<f64> {
    Mat3::from_rows(Vec3::new(1.0, angle, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0))
}

#[test]
fn a_held_shear_relaxes_along_the_closed_curve() {
    // Sheared within one step, which counts as sheared at its middle; the rest is the square of the shear, 1e-8.
    let (dt, angle) = (1e-6, 1e-4);
    let mut point = Point::new(dt);
    for n in 0..3000 {
        let stress = point.step(shear(angle)).rows[0].y;
        let time = (f64::from(n) + 0.5) * dt;
        let decay: f64 = TERMS.iter().map(|term| term.modulus * (-time / term.time).exp()).sum();
        let expected = SHEAR * angle * (1.0 + decay);
        assert!((stress - expected).abs() < 1e-6 * expected, "{time}: {stress} {expected}");
    }
}

#[test]
fn a_swinging_shear_loses_the_work_of_its_loss_modulus() {
    // Second order in the step: (w dt)^2 = 1e-3 with 200 steps a period, times a factor below one half.
    let (steps, angle) = (200, 1e-4);
    for time in [1e-4, 7e-4] {
        let rate = 1.0 / time;
        let dt = std::f64::consts::TAU / rate / f64::from(steps);
        let mut point = Point::new(dt);
        let mut work = [0.0; 2];
        // Twelve relaxation times of the slower branch, then one period to measure.
        let settle = (12.0 * 7e-4 * rate / std::f64::consts::TAU).ceil() as i32 * steps;
        for n in 1..=settle + steps {
            point.step(shear(angle * (rate * dt * f64::from(n)).sin()));
            if n == settle {
                work[0] = point.work();
            }
            work[1] = point.work();
        }
        let loss: f64 =
            TERMS.iter().map(|t| t.modulus * rate * t.time / (1.0 + (rate * t.time).powi(2))).sum();
        let expected = std::f64::consts::PI * SHEAR * loss * angle * angle;
        let lost = work[1] - work[0];
        assert!((lost / expected - 1.0).abs() < 5e-4, "{lost} {expected}");
    }
}
