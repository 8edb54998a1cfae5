//! The largest eigenvalue from which the stable step follows.

use clubface_fem::solve::largest_eigenvalue;

#[test]
fn eigenvalue_of_a_chain() {
    // Springs and masses in a row: 2 + 2 cos(pi / (n + 1)); the row has ended, so no residual is left.
    let n = 20;
    let mut beside = vec![-1.0; n];
    beside[n - 1] = 0.0;
    let exact = 2.0 + 2.0 * (std::f64::consts::PI / (n + 1) as f64).cos();
    // Bisection to 2^-60 of the bracket, then rounding.
    assert!((largest_eigenvalue(&vec![2.0; n], &beside) - exact).abs() < 1e-13);
}
