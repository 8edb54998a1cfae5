//! Parts of material laws: curves of yield stress, and functions of tensors against those of their principal values.

use clubface_fem::material::stretch::Stretches;
use clubface_fem::material::{Hardening, Symmetric};

#[test]
fn curves_go_through_their_points() {
    let points = [(0.0, 800e6), (0.01, 900e6), (0.05, 950e6), (0.2, 1000e6)];
    let law = Hardening::<f64>::table(&points, "face").expect("the table is valid");
    law.check("face").expect("it hardens");
    // Rounding of slopes up to 1e10 Pa.
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-4, "{a} {b}");
    for (strain, stress) in points {
        close(law.at(strain).0, stress);
    }
    close(law.at(0.03).0, 925e6);
    close(law.at(0.03).1, 50e6 / 0.04);
    close(law.at(0.5).0, 1000e6);
    let voce = Hardening::linear(200e6, 1e9).saturating(100e6, 20.0);
    close(voce.at(0.05).0, 200e6 + 50e6 + 100e6 * (1.0 - (-1.0_f64).exp()));
    close(voce.at(0.05).1, 1e9 + 2e9 * (-1.0_f64).exp());
}

#[test]
fn metals_that_soften_are_refused() {
    let message = |points: &[(f64, f64)]| {
        let law = Hardening::table(points, "face").and_then(|law| law.check("face"));
        law.expect_err("it must be refused").to_string()
    };
    assert!(message(&[(0.0, 800e6), (0.1, 700e6)]).contains("must not fall"));
    assert!(message(&[(0.0, 800e6), (0.1, 900e6), (0.1, 950e6)]).contains("increase"));
    assert!(message(&[(0.0, 0.0)]).contains("face.yield"));
    assert!(Hardening::linear(1e8, -1e9).check("crown").is_err());
}

/// A function of the tensor of determinant one that has two given stretches, about oblique axes.
fn tensor(first: f64, second: f64, function: fn(f64) -> f64) -> Symmetric<f64> {
    let axes = [[2.0, -3.0, 6.0], [6.0, -2.0, -3.0], [3.0, 6.0, 2.0]].map(|v| v.map(|x: f64| x / 7.0));
    let mut sum = Symmetric::diagonal(0.0);
    for ([x, y, z], square) in axes.iter().zip([first * first, second * second, (first * second).powi(-2)]) {
        sum = sum.plus(function(square), &Symmetric([x * x, y * y, z * z, x * y, x * z, y * z]));
    }
    sum
}

fn apart(a: &Symmetric<f64>, b: &Symmetric<f64>) -> f64 {
    a.0.iter().zip(b.0).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

#[test]
fn logarithm_and_powers_of_stretches() {
    for (a, b) in [(1.0, 1.0), (1.0 + 1e-9, 1.0), (1.3, 1.3), (0.8, 1.1), (2.0, 0.4), (5.0, 1.0), (0.2, 2.2)]
    {
        let c = tensor(a, b, |v| v);
        let stretches = Stretches::new(c.trace(), c.second());
        let log = stretches.logarithm();
        let identity = Symmetric::diagonal(1.0);
        let evaluate = |function| {
            let [one, linear, square] = stretches.factors(&function);
            identity.sandwich(&c).scale(square).plus(linear, &c).plus(one, &identity)
        };
        // Rounding, of the largest stretch.
        let size = a.max(b).max(1.0 / (a * b)).powi(2);
        let log_error = apart(&evaluate(log), &tensor(a, b, f64::ln));
        let error = |s, exact| apart(&evaluate(stretches.exponential(&log, s)), &tensor(a, b, exact));
        let (inverse, square) = (error(-1.0, f64::recip), error(2.0, |v| v * v));
        assert!(log_error < 1e-14 * size, "{a} {b}: {log_error}");
        assert!(inverse < 2e-14 * size * size && square < 2e-14 * size * size, "{a} {b}: {inverse} {square}");
    }
}
