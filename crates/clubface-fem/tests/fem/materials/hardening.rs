//! Curves of yield stress.

use clubface_fem::material::Hardening;

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
    let told = |points: &[(f64, f64)]| {
        let law = Hardening::table(points, "face").and_then(|law| law.check("face"));
        law.expect_err("it must be refused").to_string()
    };
    assert!(told(&[(0.0, 800e6), (0.1, 700e6)]).contains("must not fall"));
    assert!(told(&[(0.0, 800e6), (0.1, 900e6), (0.1, 950e6)]).contains("increase"));
    assert!(told(&[(0.0, 0.0)]).contains("face.yield"));
    assert!(Hardening::linear(1e8, -1e9).check("crown").is_err());
}
