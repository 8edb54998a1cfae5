//! Natural frequencies of square plates.

use super::support::{Body, DENSITY, POISSON, YOUNG, plate, titanium};
use crate::support::{Loads, period_of};
use clubface_math::{Row, Vec3};
use std::f64::consts::{PI, TAU};

const SIDE: f64 = 0.1;
const THICKNESS: f64 = 1e-3;

/// How a plate is held along its edge.
#[derive(Clone, Copy, PartialEq)]
enum Edge {
    Supported,
    Clamped,
}

/// First circular frequency of a plate of `n` by `n` elements, rad/s, over that of thin plates with `omega a^2 sqrt(rho
/// t / D) = coefficient`. It starts with velocities along the product of a shape along both sides, given with its slope
/// for places from 0 to 1.
fn frequency(n: usize, edge: Edge, coefficient: f64, shape: fn(f64) -> (f64, f64)) -> f64 {
    let mesh = plate(n, SIDE, THICKNESS, 0.0);
    let count = mesh.nodes.len();
    let on_edge = |i: &usize| [i % (n + 1), i / (n + 1)].iter().any(|&k| k == 0 || k == n);
    let freedoms = if edge == Edge::Clamped { 0..6 } else { 0..3 };
    let held = (0..count).filter(on_edge).flat_map(|i| freedoms.clone().map(move |f| (i, f)));
    let mut body = Body::new(&mesh, &titanium(), held, Loads::none());
    for (i, p) in mesh.nodes.iter().enumerate() {
        let ((a, da), (b, db)) = (shape(p.x / SIDE), shape(p.y / SIDE));
        body.structure.velocities[i] = Row::from_vec(Vec3::new(0.0, 0.0, a * b) * 1e-3);
        let turn = Vec3::new(a * db, -da * b, 0.0) * (1e-3 / SIDE);
        body.structure.velocities[count + i] = Row::from_vec(turn);
    }
    let mode = body.structure.velocities.clone();
    let rigidity = YOUNG * THICKNESS.powi(3) / 12.0 / (1.0 - POISSON * POISSON);
    let exact = coefficient / (SIDE * SIDE) * (rigidity / (DENSITY * THICKNESS)).sqrt();
    // Of the momentum along the shape.
    let result = period_of(body.dt, 3.3 * TAU / exact, || {
        body.step(0.0);
        let pairs = body.structure.velocities.iter().zip(&mode).zip(&body.structure.masses);
        pairs.map(|((v, w), m)| v.vec().dot(w.vec()) * m).sum()
    });
    TAU / result / exact
}

#[test]
fn frequency_of_a_simply_supported_plate() {
    // Navier: 2 pi^2.
    let at =
        |n| frequency(n, Edge::Supported, 2.0 * PI * PI, |s| ((PI * s).sin(), PI * (PI * s).cos())) - 1.0;
    let (coarse, fine) = (at(10), at(20));
    // Within 1%; the error (-1.8%, -0.6%) falls with the square of the element, to shear and rotary inertia of 0.1%.
    assert!(fine.abs() < 0.01 && fine.abs() < 0.5 * coarse.abs(), "{coarse} {fine}");
}

#[test]
fn frequency_of_a_clamped_plate() {
    // Leissa, Vibration of Plates, NASA SP-160, 1969, table 4.22: 35.992; the shape is that of a clamped beam.
    let shape = |s: f64| {
        let (k, share) = (4.730_040_745, 0.982_502_215);
        let (x, sinh, cosh) = (k * s, (k * s).sinh(), (k * s).cosh());
        (cosh - x.cos() - share * (sinh - x.sin()), k * (sinh + x.sin() - share * (cosh - x.cos())))
    };
    let at = |n| frequency(n, Edge::Clamped, 35.992, shape) - 1.0;
    let (coarse, fine) = (at(12), at(24));
    // Within 1%: -0.8% with 12 elements a side, -0.3% with 24.
    assert!(fine.abs() < 0.01 && fine.abs() < 0.5 * coarse.abs(), "{coarse} {fine}");
}
