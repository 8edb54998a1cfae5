//! Rigid motion and states of uniform strain.

use super::support::{POISSON, YOUNG, largest, patch, patch_of, plate, rows, titanium};
use crate::support::Random;
use clubface_fem::element::Patch;
use clubface_fem::material::Hardening;
use clubface_math::{Mat3, Row, Vec3};

#[test]
fn rigid_motion_makes_no_force() {
    let mut mesh = plate(4, 0.02, 2e-3, 0.2);
    for (i, node) in mesh.nodes.iter_mut().enumerate() {
        // Warped elements.
        node.z = 1e-3 * (i as f64 * 1.7).sin();
    }
    let count = mesh.nodes.len();
    let mut patch = patch(&mesh);
    let (dt, angle, steps) = (4e-7, 2e-5, 500);
    let axis = Vec3::new(2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0);
    let turned = |k: usize| -> Vec<Vec3<f64>> {
        let (s, c) = (angle * k as f64).sin_cos();
        let turn = Mat3::diagonal(c) + Mat3::cross(axis).scale(s) + Mat3::outer(axis, axis).scale(1.0 - c);
        let shift = Vec3::new(35.0, -3.0, 2.0) * (dt * k as f64);
        mesh.nodes.iter().map(|p| turn * *p + shift).collect()
    };
    let mut before = turned(0);
    for k in 1..=steps {
        let now = turned(k);
        let mut velocities =
            rows(&now.iter().zip(&before).map(|(a, b)| (*a - *b) * (1.0 / dt)).collect::<Vec<_>>());
        velocities[count..].fill(Row::from_vec(axis * (angle / dt)));
        patch.assemble(&rows(&now), &velocities, dt);
        before = now;
    }
    // Over the force of strain one. A rotation by `angle` a step leaves shear of angle^3 / 6, in 500 steps 7e-13;
    // rounding of the velocities adds as much.
    let (force, moment) = largest(&*patch, count, |_| true);
    let scale = YOUNG * 2e-3 * 5e-3;
    assert!(force < 1e-10 * scale && moment < 1e-10 * scale * 5e-3, "{force} N, {moment} N m");
}

/// Forces on inner nodes over those on the edge, for a displacement (and rotation) given by position, and the strain
/// energy.
fn patch_test(field: impl Fn(Vec3<f64>) -> (Vec3<f64>, Vec3<f64>)) -> (f64, f64, f64) {
    let (n, mesh) = (5, plate(5, 0.02, 1.5e-3, 0.25));
    let count = mesh.nodes.len();
    let mut displacements = rows(&mesh.nodes);
    for (i, p) in mesh.nodes.iter().enumerate() {
        let (u, r) = field(*p);
        displacements[i] = Row::from_vec(u);
        displacements[count + i] = Row::from_vec(r);
    }
    let positions = rows(&mesh.nodes);
    let mut patch = patch(&mesh);
    patch.assemble(&positions, &displacements, 1.0);
    let inner = |i: usize| (1..n).contains(&(i % (n + 1))) && (1..n).contains(&(i / (n + 1)));
    let (a, b) = (largest(&*patch, count, inner), largest(&*patch, count, |i| !inner(i)));
    let energy = patch.energy(&positions);
    assert!(energy.hourglass < 1e-12 * energy.strain, "{energy:?}");
    (a.0 / b.0.max(b.1 / 4e-3), a.1 / b.1.max(b.0 * 4e-3), energy.strain)
}

#[test]
fn membrane_patch_test() {
    let [xx, yy, xy] = [1e-9, -0.4e-9, 0.7e-9];
    let (force, moment, energy) =
        patch_test(|p| (Vec3::new(xx * p.x + xy * p.y, yy * p.y + xy * p.x, 0.0), Vec3::zero()));
    // Rounding alone.
    assert!(force < 1e-10 && moment < 1e-10, "{force} {moment}");
    let plane = YOUNG / (1.0 - POISSON * POISSON);
    let density =
        0.5 * plane * (xx * xx + yy * yy + 2.0 * POISSON * xx * yy) + YOUNG / (1.0 + POISSON) * xy * xy;
    let exact = density * 1.5e-3 * 4e-4;
    // The square of the displacement gradient, 1e-9 of the strain.
    assert!((energy / exact - 1.0).abs() < 1e-8, "{energy} {exact}");
}

#[test]
fn bending_patch_test() {
    let [xx, yy, xy] = [1e-12, 0.6e-12, -0.8e-12];
    let (force, moment, energy) = patch_test(|p| {
        let w = -0.5 * (xx * p.x * p.x + yy * p.y * p.y) - xy * p.x * p.y;
        let (wx, wy) = (-(xx * p.x + xy * p.y), -(yy * p.y + xy * p.x));
        (Vec3::new(0.0, 0.0, w), Vec3::new(wy, -wx, 0.0))
    });
    // Membrane forces of the second order in the slopes of 1e-14; rounding is less.
    assert!(force < 1e-10 && moment < 1e-10, "{force} {moment}");
    let rigidity = YOUNG * 1.5e-3_f64.powi(3) / 12.0 / (1.0 - POISSON * POISSON);
    let density =
        0.5 * rigidity * (xx * xx + yy * yy + 2.0 * POISSON * xx * yy + 2.0 * (1.0 - POISSON) * xy * xy);
    assert!((energy / (density * 4e-4) - 1.0).abs() < 1e-8, "{energy}");
}

#[test]
fn forces_do_the_work_that_becomes_energy() {
    // A skewed, warped plate, every node displaced and turned at random.
    let mut mesh = plate(4, 0.02, 2e-3, 0.2);
    let mut random = Random(1);
    for node in &mut mesh.nodes {
        node.z = 1e-3 * random.next();
    }
    let count = mesh.nodes.len();
    let mut displacements = rows(&mesh.nodes);
    for (i, row) in displacements.iter_mut().enumerate() {
        let size = if i < count { 1e-11 } else { 1e-9 };
        *row = Row::from_vec(random.vector() * size);
    }
    let positions = rows(&mesh.nodes);
    let mut patch = patch(&mesh);
    patch.assemble(&positions, &displacements, 1.0);
    let forces = patch.nodes().iter().zip(patch.forces());
    let work: f64 = forces.map(|(&row, force)| -force.vec().dot(displacements[row as usize].vec())).sum();
    let energy = patch.energy(&positions).total();
    // The square of displacement gradients of 1e-9 relative to them.
    assert!((work / (2.0 * energy) - 1.0).abs() < 1e-8, "{work} {energy}");
}

#[test]
fn packs_of_every_width_agree() {
    // Resultants, and points of a metal that yields, over steps of half a per cent of strain. Widths differ in what the
    // CPU fuses alone.
    let mut mesh = plate(5, 0.02, 2e-3, 0.2);
    let mut bumps = Random(1);
    mesh.nodes.iter_mut().for_each(|node| node.z = 1e-3 * bumps.next());
    let yielding = titanium().yielding(Hardening::linear(0.8e9, 1e9).saturating(0.1e9, 20.0));
    for material in [titanium(), yielding] {
        let run = |lanes: usize| -> Box<dyn Patch<f64>> {
            clubface_math::with_lanes(lanes, || {
                let (mut patch, mut random) = (patch_of(&mesh, material.clone()), Random(1));
                let positions = rows(&mesh.nodes);
                for _ in 0..5 {
                    let velocities: Vec<Row<f64>> = (0..positions.len())
                        .map(|i| if i < mesh.nodes.len() { 20.0 } else { 5000.0 })
                        .map(|size| Row::from_vec(random.vector() * size))
                        .collect();
                    patch.assemble(&positions, &velocities, 1e-6);
                }
                patch
            })
        };
        let mut narrow = run(1);
        let positions = rows(&mesh.nodes);
        let count = mesh.nodes.len();
        let plastic = narrow.energy(&positions).plastic;
        assert_eq!(plastic > 0.0, material.hardening.is_some(), "{plastic} J");
        let (force, moment) = largest(&*narrow, count, |_| true);
        for lanes in [4, 8] {
            let wide = run(lanes);
            for ((&row, a), b) in narrow.nodes().iter().zip(wide.forces()).zip(narrow.forces()) {
                let scale = if (row as usize) < count { force } else { moment };
                assert!((a.vec() - b.vec()).norm() < 1e-12 * scale, "{lanes} lanes: {a:?} {b:?}");
            }
        }
    }
}
