//! The influence matrices against closed forms of the elastic half-space.

use clubface_impact::rings::influence::{Influence, disc_displacement};
use std::f64::consts::PI;

/// M applied to `q(r)` over the first m rings.
fn displaced(influence: &Influence, m: usize, q: impl Fn(f64) -> f64) -> Vec<f64> {
    let (n, stride) = (influence.rings(), influence.stride());
    let mut u = vec![0.0; n];
    for i in 0..m {
        for j in 0..n {
            u[j] += influence.displacement()[i * stride + j] * q(influence.radius()[i]);
        }
    }
    u
}

/// A disc of radius a_m is in the space of tractions, so displacement and force are exact up to rounding (n^2 eps).
#[test]
fn a_hertzian_traction_gives_its_closed_form_displacement_and_force() {
    for (n, m) in [(1, 1), (20, 20), (20, 7), (64, 33)] {
        let influence = Influence::shared(n);
        let a = m as f64 / n as f64;
        let q = |r: f64| (a * a - r * r).sqrt();
        let u = displaced(&influence, m, q);
        for j in 0..n {
            let exact = disc_displacement(a, influence.radius()[j]);
            assert!((u[j] - exact).abs() < 1e-12, "ring {j} of {n}: {} for {exact}", u[j]);
        }
        let force: f64 = (0..m).map(|j| influence.force()[j] * q(influence.radius()[j])).sum();
        assert!((force - 2.0 * PI / 3.0 * a.powi(3)).abs() < 1e-13);
    }
}

/// Both forms of U give pi a^2/2 and the slope -pi a where the disc ends; 1e-6 beyond it, nothing else is left but
/// terms of order (1e-6)^1.5.
#[test]
fn displacement_of_a_disc_and_its_slope_are_continuous_at_its_edge() {
    let (a, step) = (0.7, 1e-6);
    let expected = PI / 2.0 * a * a - PI * a * step;
    assert!((disc_displacement(a, a + step) - expected).abs() < 1e-8);
}

/// A uniform displacement of the whole contact needs the traction 1/sqrt(a^2 - r^2) of a sticking punch, whose
/// stiffness is F = 8 a G u/(2 - nu), that is 1 in our units, reached like 1/n.
#[test]
fn uniform_sticking_has_the_stiffness_of_a_rigid_punch() {
    let error = |n: usize| {
        let influence = Influence::shared(n);
        let inverse = influence.exchanged(n);
        let force: f64 = (0..n)
            .flat_map(|i| (0..n).map(move |j| (i, j)))
            .map(|(i, j)| influence.force()[j] * inverse[i * influence.stride() + j])
            .sum();
        force - 1.0
    };
    assert!((error(40) / error(20) - 0.5).abs() < 0.01 && error(80).abs() < 0.003);
}

/// Exchanging all rings inverts the matrix: rounding only, the condition grows like n.
#[test]
fn exchanging_every_ring_inverts_the_matrix() {
    let influence = Influence::shared(40);
    let (n, stride) = (40, influence.stride());
    let mut identity_error: f64 = 0.0;
    for i in 0..n {
        for j in 0..n {
            let sum: f64 = (0..n)
                .map(|l| influence.displacement()[l * stride + j] * influence.exchanged(n)[i * stride + l])
                .sum();
            identity_error = identity_error.max((sum - f64::from(i == j)).abs());
        }
    }
    assert!(identity_error < 1e-12, "{identity_error}");
}
