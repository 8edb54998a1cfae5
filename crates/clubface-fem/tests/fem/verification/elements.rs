//! Exact identities of elements: patch test, rigid motion, forces as derivatives of energy, packs of any width.

use crate::support::{
    ELEMENTS, Loads, Random, block, distorted_cube, elastic, forces, largest, patches, rows, structure,
};
use clubface_fem::element::{Element, Energy};
use clubface_fem::material::{Material, Maxwell, MooneyRivlin};
use clubface_math::{Row, Vec3};

const EDGE: f64 = 0.01;

/// Every element, with a nearly incompressible rubber and with a stiff cover.
fn cases() -> Vec<(Element, Material<f64>)> {
    let rubber = MooneyRivlin { c10: 4e6, c01: 1e6 }.law();
    let rubber = Material { law: rubber, bulk: 500e6, maxwell: vec![], density: 1000.0 };
    let cover = elastic(350e6, 0.4, 950.0);
    ELEMENTS.into_iter().flat_map(|element| [(element, rubber.clone()), (element, cover.clone())]).collect()
}

fn energy(patches: &mut [Box<dyn clubface_fem::element::Patch<f64>>], positions: &[Row<f64>]) -> Energy {
    let mut sum = Energy::default();
    for patch in patches {
        sum += patch.energy(positions);
    }
    sum
}

#[test]
fn patch_test() {
    // A linear deformation of a distorted mesh is a state of uniform stress: no force on inner nodes, and the energy of
    // a block.
    let mesh = distorted_cube(EDGE, 0.2);
    let volume: f64 = (0..mesh.elements.len()).map(|e| mesh.volume(e)).sum();
    for (element, material) in cases() {
        let mut patches = patches(element, &mesh, &material);
        let gradient = Random(3).gradient(0.1);
        let moved: Vec<_> = mesh.nodes.iter().map(|x| gradient * *x).collect();
        let forces = forces(&mut patches, &rows(&moved), 0.0);
        let inner = |n: usize| (0..3).all(|axis| (1..3).contains(&(n / 4_usize.pow(axis) % 4)));
        let inside: Vec<_> = (0..64).filter(|&n| inner(n)).map(|n| forces[n]).collect();
        assert_eq!(inside.len(), 8);
        assert!(largest(&inside) < 1e-10 * largest(&forces), "{} {}", largest(&inside), largest(&forces));
        let stored = energy(&mut patches, &rows(&moved));
        assert!(stored.hourglass < 1e-20 * stored.strain, "{stored:?}");
        let undistorted = distorted_cube(EDGE, 0.0);
        let moved: Vec<_> = undistorted.nodes.iter().map(|x| gradient * *x).collect();
        let block = energy(&mut crate::support::patches(element, &undistorted, &material), &rows(&moved));
        let density = block.strain / EDGE.powi(3);
        assert!((stored.strain / volume / density - 1.0).abs() < 1e-10);
    }
}

#[test]
fn rigid_motion_makes_no_force() {
    // Relative to the force that a strain of one would make on the face of an element.
    let mesh = distorted_cube(EDGE, 0.2);
    for (element, material) in cases() {
        let mut patches = patches(element, &mesh, &material);
        let turn = Random(4).rotation();
        let moved: Vec<_> = mesh.nodes.iter().map(|x| turn * *x + Vec3::new(0.3, -0.1, 0.2)).collect();
        let scale = material.bulk * (EDGE / 3.0).powi(2);
        assert!(largest(&forces(&mut patches, &rows(&moved), 0.0)) < 1e-10 * scale);
        // Energies are differences of invariants: rounding of the moduli times the volume.
        assert!(energy(&mut patches, &rows(&moved)).total().abs() < 1e-14 * scale * EDGE);
    }
}

#[test]
fn forces_are_derivatives_of_energy() {
    // Central differences of the energy with steps of 1e-5 of an element: 1e-10 from the step, 1e-10 from rounding.
    let mesh = distorted_cube(EDGE, 0.2);
    for (element, material) in cases() {
        let mut patches = patches(element, &mesh, &material);
        let mut random = Random(5);
        let mut moved: Vec<_> = mesh.nodes.iter().map(|x| *x + random.vector() * (0.05 * EDGE)).collect();
        let forces = forces(&mut patches, &rows(&moved), 0.0);
        let stored = energy(&mut patches, &rows(&moved));
        let bent = element == Element::FullyIntegrated || stored.hourglass > 0.01 * stored.strain;
        assert!(bent, "hourglass modes must take part: {stored:?}");
        let size = 1e-5 * EDGE;
        for node in 0..mesh.nodes.len() {
            let direction = random.vector();
            let undeformed = moved[node];
            moved[node] = undeformed + direction * size;
            let after = energy(&mut patches, &rows(&moved)).total();
            moved[node] = undeformed + direction * -size;
            let before = energy(&mut patches, &rows(&moved)).total();
            moved[node] = undeformed;
            let slope = (before - after) / (2.0 * size);
            assert!((slope - forces[node].dot(direction)).abs() < 1e-7 * largest(&forces));
        }
    }
}

#[test]
fn packs_of_every_width_agree() {
    // Widths differ only in what the compiler fuses; viscous histories take part over some steps.
    let mesh = distorted_cube(EDGE, 0.2);
    for (element, mut material) in cases() {
        material.maxwell = vec![Maxwell { modulus: 0.5, time: 1e-5 }];
        let run = |lanes: usize| {
            clubface_math::with_lanes(lanes, || {
                let mut patches = patches(element, &mesh, &material);
                let mut random = Random(6);
                let rest = vec![Row::zero(); mesh.nodes.len()];
                for _ in 0..5 {
                    let moved: Vec<_> =
                        mesh.nodes.iter().map(|x| *x + random.vector() * (0.05 * EDGE)).collect();
                    patches[0].assemble(&rows(&moved), &rest, 1e-6);
                }
                patches[0].forces().iter().map(Row::vec).collect::<Vec<_>>()
            })
        };
        let narrow = run(1);
        for lanes in [4, 8] {
            for (a, b) in run(lanes).iter().zip(&narrow) {
                assert!((*a - *b).norm() < 1e-12 * largest(&narrow), "{lanes} lanes: {a:?} {b:?}");
            }
        }
    }
}

#[test]
fn integration_ends_with_the_step_in_which_an_element_leaves_its_law() {
    // A lattice of cubes, and a list of elements without order; of the outermost element one side is moved.
    for ([ni, nj, nk], kind) in ELEMENTS.into_iter().flat_map(|kind| [([4, 4, 3], kind), ([2, 2, 2], kind)]) {
        let mesh = block([ni, nj, nk], [EDGE; 3]);
        for (ratio, within) in
            [(1.0, true), (0.35, true), (0.25, false), (-0.2, false), (2.4, true), (2.6, false)]
        {
            let mut body = structure(kind, &mesh, &elastic(350e6, 0.4, 950.0), &[]);
            // So short that nothing else moves.
            let dt = 1e-6 * body.stable_step(40);
            let edge = EDGE / ni as f64;
            for x in body.positions.iter_mut().filter(|x| x.0[0] > EDGE - 0.5 * edge) {
                x.0[0] += (ratio - 1.0) * edge;
            }
            let steps = body.integrate(&mut Loads::none(), dt, 5, &mut |_, _| true);
            assert_eq!(steps, if within { 5 } else { 1 }, "{kind:?} {ni} {ratio}");
        }
    }
}
