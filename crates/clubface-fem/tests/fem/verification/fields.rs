//! Stress and strain in elements, against the forces they exert and closed forms.

use crate::support::{ELEMENTS, Random, distorted_cube, elastic, patches, rows};
use clubface_fem::element::{ElementOutput, Patch};
use clubface_fem::material::{Deformation, Hardening, Material, Maxwell, MooneyRivlin, Symmetric, VonMises};
use clubface_math::{Mat3, Row};

const EDGE: f64 = 0.01;

/// A rubber, one with a branch, a cover and a metal that yields at the strains of these checks.
fn materials() -> [Material<f64>; 4] {
    let law = MooneyRivlin { c10: 4e6, c01: 1e6 }.law();
    let rubber = Material { law, bulk: 500e6, maxwell: vec![], density: 1000.0 };
    let maxwell = vec![Maxwell { modulus: 0.7, time: 2e-6 }];
    let cover = elastic(350e6, 0.4, 950.0);
    let metal = VonMises { shear: 40e9, hardening: Hardening::linear(1e9, 5e9) };
    let metal = Material { law: metal.law(), bulk: 100e9, maxwell: vec![], density: 4430.0 };
    [rubber.clone(), Material { maxwell, ..rubber }, cover, metal]
}

/// Stress and strain of every element, each of them once.
fn outputs(patches: &mut [Box<dyn Patch<f64>>], positions: &[Row<f64>], count: usize) -> Vec<ElementOutput> {
    let mut all = vec![None; count];
    for patch in patches {
        patch.element_output(positions, &mut |number, output| {
            assert!(all[number].replace(*output).is_none(), "{number} twice");
        });
    }
    all.into_iter()
        .enumerate()
        .map(|(n, output)| output.unwrap_or_else(|| panic!("{n} is missing")))
        .collect()
}

fn apart(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

#[test]
fn stress_is_that_of_the_forces() {
    // In a uniform deformation the stress times the volume is the sum of place times force, whatever the law and
    // its state variables: the second of two steps, of different directions.
    let mesh = distorted_cube(EDGE, 0.2);
    let volume: f64 = (0..mesh.elements.len()).map(|e| mesh.volume(e)).sum();
    for element in ELEMENTS {
        for material in materials() {
            let mut patches = patches(element, &mesh, &material);
            let mut random = Random(8);
            let (mut forces, mut moved, mut ratio, mut all) = (vec![], vec![], 1.0, vec![]);
            for _ in 0..2 {
                let gradient = random.gradient(0.05);
                ratio = Deformation::new(gradient).volume;
                moved = mesh.nodes.iter().map(|x| gradient * *x).collect();
                // Seen before the step, without consequences for it.
                all = outputs(&mut patches, &rows(&moved), mesh.elements.len());
                forces = crate::support::forces(&mut patches, &rows(&moved), 1e-6);
            }
            let mut virial = [0.0; 6];
            for (x, f) in moved.iter().zip(&forces) {
                let pairs = [(x.x, f.x), (x.y, f.y), (x.z, f.z), (x.x, f.y), (x.x, f.z), (x.y, f.z)];
                for (sum, (x, f)) in virial.iter_mut().zip(pairs) {
                    *sum -= x * f / (volume * ratio);
                }
            }
            let yields = !material.law.description().state.is_empty();
            for output in all {
                // The plastic flow of a step ends within 1e-9 of the yield stress.
                assert!(apart(&output.stress[0], &virial) < 1e-8 * material.shear(), "{output:?} {virial:?}");
                assert_eq!(output.stress[0], output.stress[1]);
                assert_eq!(output.plastic_strain > 0.0, yields);
            }
        }
    }
}

#[test]
fn strain_is_the_logarithm_of_stretch() {
    let mesh = distorted_cube(EDGE, 0.2);
    let stretches = [1.2, 0.9, 1.05];
    let turn = Random(9).rotation();
    let [a, b, c] = stretches;
    let o = 0.0;
    let gradient = turn * Mat3::symmetric([a, b, c, o, o, o]);
    let exact = Symmetric([a.ln(), b.ln(), c.ln(), o, o, o]).seen_through(&turn);
    let moved: Vec<_> = mesh.nodes.iter().map(|x| gradient * *x).collect();
    for element in ELEMENTS {
        let mut patches = patches(element, &mesh, &materials()[0]);
        for output in outputs(&mut patches, &rows(&moved), mesh.elements.len()) {
            // The root of the volume ratio is exact to 1e-10 here.
            assert!(apart(&output.strain[0], &exact.0) < 1e-9, "{output:?} {exact:?}");
        }
    }
}
