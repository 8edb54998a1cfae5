//! Rules of integration through the thickness of shells.

use clubface_fem::element::Rule;

#[test]
fn rules_integrate_polynomials_of_their_degree() {
    for n in 2..=31 {
        for (rule, degree) in [(Rule::Gauss(n), 2 * n - 1), (Rule::Lobatto(n.max(3)), 2 * n.max(3) - 3)] {
            let points = rule.points();
            for power in 0..=degree as i32 {
                let sum: f64 = points.iter().map(|(x, w)| w * x.powi(power)).sum();
                let exact = if power % 2 == 0 { 2.0 / f64::from(power + 1) } else { 0.0 };
                // Rounding of weights that add up to 2.
                assert!((sum - exact).abs() < 1e-13, "{rule:?}, {power}: {sum}");
            }
        }
    }
    // Abramowitz and Stegun, tables 25.4 and 25.6.
    let (gauss, lobatto) = (Rule::Gauss(5).points(), Rule::Lobatto(5).points());
    assert!((gauss[4].0 - 0.906_179_845_938_664).abs() < 1e-14);
    assert!((gauss[4].1 - 0.236_926_885_056_189).abs() < 1e-14);
    assert!((lobatto[3].0 - 0.654_653_670_7).abs() < 1e-10 && (lobatto[3].1 - 49.0 / 90.0).abs() < 1e-14);
}
