//! Published problems for shells, solved by letting the body come to rest.

use super::support::{Body, Freedom, surface};
use crate::support::Loads;
use clubface_fem::element::{Isotropic, ShellMaterial};
use clubface_math::Vec3;

fn elastic(young: f64, poisson: f64) -> ShellMaterial<f64> {
    // The density sets the time it takes, not where it ends.
    ShellMaterial::elastic(Isotropic { young, poisson }, 1.0)
}

/// A cylinder pinched by two forces at mid length, its ends held round by diaphragms: an eighth of it, `n` by `n`
/// elements. Displacement under the force over the series solution 1.8248e-5 (Belytschko et al., Comput. Methods Appl.
/// Mech. Eng. 51, 1985, after Flügge).
fn pinched_cylinder(n: usize) -> f64 {
    let (radius, half, young, force): (f64, f64, f64, f64) = (300.0, 300.0, 3e6, 1.0);
    // From the side (z = 0) to the force (y = 0), and from the middle (x = 0) to the end.
    let mesh = surface([n, n], 3.0, |a, b| {
        let (s, c) = (a * std::f64::consts::FRAC_PI_2).sin_cos();
        Vec3::new(half * b, radius * c, radius * s)
    });
    let node = |i: usize, j: usize| j * (n + 1) + i;
    let held = |k: usize| -> Vec<Freedom> {
        let (i, j) = (node(k, 0), node(k, n));
        let (side, top) = (node(0, k), node(n, k));
        vec![
            (i, 0),
            (i, 4),
            (i, 5), // middle
            (j, 1),
            (j, 2), // diaphragm
            (side, 2),
            (side, 3),
            (side, 4),
            (top, 1),
            (top, 3),
            (top, 5),
        ]
    };
    // A quarter of the force acts on the eighth.
    let top = node(n, 0);
    let loads = Loads::new(&[(top, Vec3::new(0.0, 0.0, -0.25 * force))]);
    let mut body = Body::new(&mesh, &elastic(young, 0.3), (0..=n).flat_map(held), loads);
    // The slowest motion: about 0.12 c / R.
    let error = body.relax(0.12 * young.sqrt() / radius, 1.5);
    assert!(error.abs() < 1e-4, "not at rest: {error}");
    -body.moved(&mesh, top, 2) / 1.8248e-5
}

#[test]
fn pinched_cylinder_with_diaphragms() {
    let (coarse, fine) = (pinched_cylinder(16), pinched_cylinder(32));
    // Asked: 2%. 0.932 with 16 by 16 elements, 0.989 with 32 by 32.
    assert!((fine - 1.0).abs() < 0.02 && (fine - 1.0).abs() < 0.4 * (coarse - 1.0).abs(), "{coarse} {fine}");
}

/// A beam twisted by a quarter of a turn, clamped at one end and loaded at the other along an axis: displacement there
/// (MacNeal and Harder, Finite Elem. Anal. Des. 1, 1985, table 3; inches and pounds).
fn twisted_beam(across: usize, axis: usize) -> f64 {
    let (length, width, along) = (12.0, 1.1, 6 * across);
    let mesh = surface([along, across], 0.32, |a, b| {
        let (s, c) = (a * std::f64::consts::FRAC_PI_2).sin_cos();
        let at = width * (b - 0.5);
        Vec3::new(length * a, at * c, at * s)
    });
    let node = |i: usize, j: usize| j * (along + 1) + i;
    let held = (0..=across).flat_map(|j| (0..6).map(move |f| (node(0, j), f)));
    let mut force = [0.0; 3];
    force[axis] = 1.0;
    // As an even load does: half as much at the corners.
    let share = |j: usize| if j == 0 || j == across { 0.5 } else { 1.0 } / across as f64;
    let loads: Vec<_> = (0..=across).map(|j| (node(along, j), Vec3::from_f64(force) * share(j))).collect();
    let mut body = Body::new(&mesh, &elastic(29e6, 0.22), held, Loads::new(&loads));
    // The slowest motion of the straight beam: 3.5 c t / (sqrt(12) L^2).
    let error = body.relax(2.26e-3 * 29e6_f64.sqrt(), 3.0);
    assert!(error.abs() < 1e-4, "not at rest: {error}");
    body.moved(&mesh, node(along, across / 2), axis)
}

#[test]
fn twisted_beam_of_macneal_and_harder() {
    // At the loaded end the width lies along z.
    for (axis, exact) in [(2, 5.424e-3), (1, 1.754e-3)] {
        let (coarse, fine) = (twisted_beam(2, axis) / exact, twisted_beam(4, axis) / exact);
        // Asked: 2%. Within 0.5% with 2 by 12 elements, the mesh of MacNeal and Harder, and within 0.2% with 4 by 24.
        assert!((coarse - 1.0).abs() < 0.01 && (fine - 1.0).abs() < 5e-3, "along {axis}: {coarse} {fine}");
    }
}
