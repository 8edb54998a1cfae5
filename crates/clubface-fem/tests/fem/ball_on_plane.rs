//! The ball on a rigid plane: the same on any number of threads, with any order of elements, and with derivatives.

use clubface_fem::ball::{BallConstruction, BallPiece};
use clubface_fem::cases::ball_against_plane;
use clubface_fem::element::{Element, Kernels};
use clubface_fem::environment::Environment;
use clubface_fem::material::{Hencky, Material, Maxwell, MooneyRivlin};
use clubface_fem::mesh::{cubed_sphere, Fineness};
use clubface_math::{Dual, Row};
use std::collections::HashMap;

fn rubber<R: Kernels>(c10: R) -> Material<R> {
    Material {
        law: MooneyRivlin { c10, c01: R::from_f64(1e6) }.law(),
        bulk: R::from_f64(5e8),
        maxwell: vec![Maxwell { modulus: R::from_f64(0.1), time: R::from_f64(1e-4) }],
        density: R::from_f64(1150.0),
    }
}

/// Velocity (m/s) and spin (rad/s) of a coarse ball after `steps` steps of 1 us.
fn fly<R: Kernels>(speed: R, c10: R, steps: usize) -> [R; 3] {
    let cover = Material {
        law: Hencky { shear: R::from_f64(1.25e8) }.law(),
        bulk: R::from_f64(5.8e8),
        maxwell: vec![],
        density: R::from_f64(950.0),
    };
    let pieces = vec![
        BallPiece { name: "core".into(), radius: R::from_f64(0.0196), layers: 2, material: rubber(c10) },
        BallPiece { name: "cover".into(), radius: R::from_f64(0.0214), layers: 1, material: cover },
    ];
    let ball = BallConstruction { pieces, cube: 4, element: Element::OnePoint, mass: Some(0.046) };
    let friction = R::from_f64(0.35);
    let impact = ball_against_plane(&ball, speed, R::from_f64(0.2), friction, &Environment::native())
        .expect("the case is valid");
    let (mut structure, mut contact) = (impact.structure, impact.contact);
    for _ in 0..steps {
        structure.assemble(contact.as_mut(), 1e-6);
        structure.advance(contact.as_ref(), 1e-6);
    }
    let kinetics = structure.body_motion(0..structure.positions.len());
    [kinetics.velocity.x, kinetics.velocity.y, kinetics.spin.z]
}

#[test]
fn same_bits_on_any_number_of_threads() {
    let [one, two, three] = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| fly(35.0, 4e6, 300)).map(f64::to_bits)
    });
    assert_eq!(one, two);
    assert_eq!(one, three);
}

#[test]
fn derivatives_are_those_of_the_same_run() {
    let plain = fly(35.0, 4e6, 200);
    let derived = fly(Dual::<f64, 4>::variable(35.0, 0), Dual::variable(4e6, 1), 200);
    for (value, dual) in plain.iter().zip(derived) {
        // The arithmetic is the same, but for products that are fused in one and not in the other.
        assert!((value - dual.value).abs() < 1e-9 * value.abs().max(1.0), "{value} {}", dual.value);
    }
    // Central difference over 1e-5 of the modulus: rounding of the run (1e-12) over 1e-5, and nodes that touch the
    // plane a step sooner, within 1e-4.
    let change = 4e6 * 1e-5;
    let (less, more) = (fly(35.0, 4e6 - change, 200), fly(35.0, 4e6 + change, 200));
    let difference = (more[0] - less[0]) / (2.0 * change);
    let derivative = derived[0].tangent[1];
    assert!((difference / derivative - 1.0).abs() < 1e-4, "{difference} {derivative}");
}

#[test]
fn lattices_give_the_forces_of_elements_in_any_order() {
    // Rows of one pack of four, rows that do not fill packs, and rows that do in patches whose last pack is not full.
    for (cube, count) in [(4, 352), (6, 864), (20, 15200)] {
        lattices_give_the_forces_of_elements(cube, count);
    }
}

fn lattices_give_the_forces_of_elements(cube: usize, count: usize) {
    let mesh = cubed_sphere(&[0.02], &Fineness { cube, layers: vec![3] });
    assert_eq!(mesh.elements.len(), count);
    let mut mixed = mesh.clone();
    // A step that shares no factor with the number of elements visits all of them, neighbours far apart.
    for (place, element) in mixed.elements.iter_mut().enumerate() {
        *element = mesh.elements[place * 211 % count];
    }
    let positions: Vec<Row<f64>> = mesh
        .nodes
        .iter()
        .map(|p| {
            let stretch = 1.0 + 0.1 * (300.0 * p.y).sin();
            Row([p.x * stretch, p.y + 0.2 * p.z, p.z * (1.0 + 10.0 * p.x), 0.0])
        })
        .collect();
    let velocities = vec![Row::zero(); positions.len()];
    let [first, second] = [&mesh, &mixed].map(|mesh| {
        let mut forces: HashMap<u32, [f64; 3]> = HashMap::new();
        let mut energy = 0.0;
        for mut patch in Element::OnePoint.patches(mesh, 0..count, &rubber(4e6)) {
            patch.assemble(&positions, &velocities, 1e-6);
            for (&node, force) in patch.nodes().iter().zip(patch.forces()) {
                let sum = forces.entry(node).or_default();
                (0..3).for_each(|c| sum[c] += force.0[c]);
            }
            energy += patch.energy(&positions).total();
        }
        (forces, energy)
    });
    let largest = first.0.values().flatten().fold(0.0_f64, |most, f| most.max(f.abs()));
    assert!(largest > 1.0);
    for (node, force) in &first.0 {
        for c in 0..3 {
            // Sums in another order, and constants of a block shared with the blocks that are turned: rounding.
            assert!((force[c] - second.0[node][c]).abs() < 1e-11 * largest, "node {node} of cube {cube}");
        }
    }
    assert!((first.1 / second.1 - 1.0).abs() < 1e-12);
}
