//! Functions of tensors against those of their principal values.

use clubface_fem::material::stretch::Stretches;
use clubface_fem::material::Symmetric;

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
        let of = |function| {
            let [one, linear, square] = stretches.factors(&function);
            identity.sandwich(&c).scale(square).plus(linear, &c).plus(one, &identity)
        };
        // Rounding, of the largest stretch.
        let size = a.max(b).max(1.0 / (a * b)).powi(2);
        let log_error = apart(&of(log), &tensor(a, b, f64::ln));
        let error = |s, exact| apart(&of(stretches.exponential(&log, s)), &tensor(a, b, exact));
        let (inverse, square) = (error(-1.0, f64::recip), error(2.0, |v| v * v));
        assert!(log_error < 1e-14 * size, "{a} {b}: {log_error}");
        assert!(inverse < 2e-14 * size * size && square < 2e-14 * size * size, "{a} {b}: {inverse} {square}");
    }
}
