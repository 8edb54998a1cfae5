//! Bulk viscosity: breathing that dies away as that of a damped oscillator does, and work that is what the pressure
//! does.

use crate::support::{ELEMENTS, Loads, block, elastic, rows, step, structure};
use clubface_fem::material::Material;
use clubface_math::Vec3;

const EDGE: f64 = 2e-3;
const COEFFICIENT: f64 = 0.06;

fn rubber() -> Material<f64> {
    elastic(30e6, 0.45, 1100.0)
}

/// Pressure for a ratio of volumes that grows by one in a second, Pa s: coefficient, density, speed of waves, size.
fn drag(matter: &Material<f64>) -> f64 {
    let stiffness = matter.bulk + matter.shear() * (4.0 / 3.0);
    COEFFICIENT * matter.density * (stiffness / matter.density).sqrt() * EDGE
}

#[test]
fn a_cube_breathes_as_a_damped_oscillator() {
    for element in ELEMENTS {
        let material = rubber();
        let mut cube = structure(element, &block([1; 3], [EDGE; 3]), &material, &[]);
        cube.set_bulk_viscosity(COEFFICIENT);
        // With x = (1 + s) X and an eighth of the mass m at each corner, 3/4 of the edge squared from the centre, the
        // energies are 1/2 K (3 s)^2 V and 1/2 m 3/4 a^2 (ds/dt)^2, and the pressure does 3 ds/dt V of work a second.
        let inertia = 0.75 * material.density * EDGE * EDGE;
        let decay = 9.0 * drag(&material) / (2.0 * inertia);
        let frequency = (9.0 * material.bulk / inertia - decay * decay).sqrt();
        let centre = Vec3::from_f64([0.5 * EDGE; 3]);
        let speed = 1e-5 * frequency;
        for (v, x) in cube.velocities.iter_mut().zip(&cube.positions) {
            *v = rows(&[(x.vec() - centre) * speed])[0];
        }
        let count = 2000;
        let whole = 3.0 * std::f64::consts::TAU / frequency;
        let energy = |s: &clubface_fem::solve::Structure<f64>| -> f64 {
            s.velocities.iter().zip(&s.masses).map(|(v, m)| 0.5 * m * v.vec().norm_squared()).sum()
        };
        let before = energy(&cube);
        for _ in 0..count {
            step(&mut cube, &mut Loads::none(), whole / f64::from(count));
        }
        let after = energy(&cube);
        // Velocities are half a step early, of 667 a period; the pressure too: half a per cent of the exponent, which
        // is 4.
        let expected = (-2.0 * decay * whole).exp();
        let left = after / before;
        assert!((left - expected).abs() < 0.02 * expected, "{element:?}: {left} {expected}");
        let lost = cube.energy().viscous / before;
        assert!((lost - (1.0 - expected)).abs() < 0.01, "{element:?}: {lost} {expected}");
    }
}

#[test]
fn work_is_that_of_the_pressure_in_every_arrangement() {
    let (growth, dt) = (1e-3, 1e-7);
    for element in ELEMENTS {
        for counts in [[1, 1, 1], [6, 5, 4]] {
            let material = rubber();
            let size = counts.map(|n| n as f64 * EDGE);
            let mut body = structure(element, &block(counts, size), &material, &[]);
            body.set_bulk_viscosity(COEFFICIENT);
            for x in &mut body.positions {
                *x = rows(&[x.vec() * (1.0 + growth)])[0];
            }
            body.assemble(&mut Loads::none(), dt);
            let ratio = (1.0 + growth).powi(3) - 1.0;
            let volume: f64 = size.iter().product();
            let expected = drag(&material) * ratio * ratio / dt * volume;
            let result = body.energy().viscous;
            assert!(
                (result - expected).abs() < 1e-9 * expected,
                "{element:?} {counts:?}: {result} {expected}"
            );
            // Held where it is, nothing more is done.
            body.assemble(&mut Loads::none(), dt);
            assert!((body.energy().viscous - expected).abs() < 1e-9 * expected);
        }
    }
}
