//! The ball on a rigid plane: the same on any number of threads, with any order of elements, and with derivatives.

use crate::support::{ELEMENTS, forces, largest, on_threads, patches, piece, rows};
use clubface_fem::ball::BallConstruction;
use clubface_fem::cases::ball_against_plane;
use clubface_fem::element::{Element, Kernels};
use clubface_fem::environment::Environment;
use clubface_fem::material::{Hencky, Material, Maxwell, MooneyRivlin};
use clubface_fem::mesh::{Fineness, cubed_sphere};
use clubface_math::{Dual, Vec3};

fn rubber<R: Kernels>(c10: R) -> Material<R> {
    Material {
        law: MooneyRivlin { c10, c01: R::from_f64(1e6) }.law(),
        bulk: R::from_f64(5e8),
        maxwell: vec![Maxwell { modulus: R::from_f64(0.1), time: R::from_f64(1e-4) }],
        density: R::from_f64(1150.0),
    }
}

/// Velocity (m/s) and spin (rad/s) of a coarse ball after `steps` steps of 1 us.
fn fly<R: Kernels>(element: Element, speed: R, c10: R, steps: usize) -> [R; 3] {
    let cover = Material {
        law: Hencky { shear: R::from_f64(1.25e8) }.law(),
        bulk: R::from_f64(5.8e8),
        maxwell: vec![],
        density: R::from_f64(950.0),
    };
    let pieces = vec![
        piece("core", R::from_f64(0.0196), 2, rubber(c10)),
        piece("cover", R::from_f64(0.0214), 1, cover),
    ];
    let ball = BallConstruction { pieces, cube: 4, element, mass: Some(0.046) };
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
    for element in ELEMENTS {
        let flown = |threads| on_threads(threads, || fly(element, 35.0, 4e6, 300)).map(f64::to_bits);
        let one = flown(1);
        assert_eq!([flown(2), flown(3)], [one; 2], "{element:?}");
    }
}

#[test]
fn derivatives_are_those_of_the_same_run() {
    let plain = |c10| fly(Element::OnePoint, 35.0, c10, 200);
    let derived = fly(Element::OnePoint, Dual::<f64, 4>::variable(35.0, 0), Dual::variable(4e6, 1), 200);
    for (value, dual) in plain(4e6).iter().zip(derived) {
        // The arithmetic is the same, but for products that are fused in one and not in the other.
        assert!((value - dual.value).abs() < 1e-9 * value.abs().max(1.0), "{value} {}", dual.value);
    }
    // Central difference over 1e-5 of the modulus: rounding of the run (1e-12) over 1e-5, and nodes that touch the
    // plane a step sooner, within 1e-4.
    let change = 4e6 * 1e-5;
    let (less, more) = (plain(4e6 - change), plain(4e6 + change));
    let difference = (more[0] - less[0]) / (2.0 * change);
    let derivative = derived[0].tangent[1];
    assert!((difference / derivative - 1.0).abs() < 1e-4, "{difference} {derivative}");
}

#[test]
fn lattices_give_the_forces_of_elements_in_any_order() {
    // Rows of one pack of four, rows that do not fill packs, and rows that do in patches whose last pack is not full.
    for (cube, count) in [(4, 352), (6, 864), (20, 15200)] {
        let mesh = cubed_sphere(&[0.02], &Fineness { cube, layers: vec![3] });
        assert_eq!(mesh.elements.len(), count);
        let mut mixed = mesh.clone();
        // A step that shares no factor with the number of elements visits all of them, neighbours far apart.
        for (place, element) in mixed.elements.iter_mut().enumerate() {
            *element = mesh.elements[place * 211 % count];
        }
        let stretched = |p: &Vec3<f64>| {
            let stretch = 1.0 + 0.1 * (300.0 * p.y).sin();
            Vec3::new(p.x * stretch, p.y + 0.2 * p.z, p.z * (1.0 + 10.0 * p.x))
        };
        let positions = rows(&mesh.nodes.iter().map(stretched).collect::<Vec<_>>());
        let [(first, energy), (second, other)] = [&mesh, &mixed].map(|mesh| {
            let mut patches = patches(Element::OnePoint, mesh, &rubber(4e6));
            let forces = forces(&mut patches, &positions, 1e-6);
            (forces, patches.iter_mut().map(|patch| patch.energy(&positions).total()).sum::<f64>())
        });
        assert!(largest(&first) > 1.0);
        for (a, b) in first.iter().zip(&second) {
            // Sums in another order, and constants of a block shared with the blocks that are turned: rounding.
            assert!((*a - *b).norm() < 1e-11 * largest(&first), "cube {cube}: {a:?} {b:?}");
        }
        assert!((energy / other - 1.0).abs() < 1e-12);
    }
}
