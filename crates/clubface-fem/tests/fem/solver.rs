//! Parts of the solver: tasks by worker, the stable step, the motion of a body, steps that also report energies.

use crate::support::{Random, bits, piece, rows};
use clubface_fem::ball::BallConstruction;
use clubface_fem::cases::ball_against_plane;
use clubface_fem::element::Element;
use clubface_fem::environment::Environment;
use clubface_fem::material::{Material, Maxwell, MooneyRivlin};
use clubface_fem::moments::{Nodes, Origin};
use clubface_fem::solve::{BodyMotion, balanced, largest_eigenvalue};
use clubface_math::{Vec3, with_lanes};

#[test]
fn workers_have_every_task_once_and_about_the_same_cost() {
    let costs = [1, 4, 4, 4, 4, 1];
    assert_eq!(balanced(&[0, 1, 2, 3, 4, 5], |task| costs[task], 2), [[0, 1, 2], [3, 4, 5]]);
    assert_eq!(balanced(&[7, 8], |task| if task == 7 { 9 } else { 1 }, 3), [vec![], vec![7], vec![8]]);
    assert_eq!(balanced(&[], |_| 1, 2), vec![vec![0; 0]; 2]);
}

#[test]
fn eigenvalue_of_a_chain() {
    // Springs and masses in a row: 2 + 2 cos(pi / (n + 1)); the row has ended, so no residual is left.
    let n = 20;
    let mut off_diagonal = vec![-1.0; n];
    off_diagonal[n - 1] = 0.0;
    let exact = 2.0 + 2.0 * (std::f64::consts::PI / (n + 1) as f64).cos();
    // Bisection to 2^-60 of the bracket, then rounding.
    assert!((largest_eigenvalue(&vec![2.0; n], &off_diagonal) - exact).abs() < 1e-13);
}

/// Fifteen bodies of different mass in a rigid motion: an odd number, so that packs are not full.
#[test]
fn a_rigid_motion_is_found_again() {
    let (drift, spin) = (Vec3::new(3.0, -2.0, 1.0), Vec3::new(40.0, 300.0, -7.0));
    let mut random = Random(1);
    let x: Vec<_> = (0..15).map(|_| random.vector() * 0.02 + Vec3::new(0.12, 0.02, 0.02)).collect();
    let masses: Vec<f64> = (0..15).map(|_| 1e-3 * (1.5 + 0.5 * random.next())).collect();
    let mass: f64 = masses.iter().sum();
    let centre = x.iter().zip(&masses).fold(Vec3::zero(), |sum, (x, m)| sum + *x * *m) * mass.recip();
    let v: Vec<_> = x.iter().map(|x| drift + spin.cross(*x - centre)).collect();
    let angular = x
        .iter()
        .zip(&v)
        .zip(&masses)
        .fold(Vec3::zero(), |sum, ((x, v), m)| sum + (*x - centre).cross(*v) * *m);
    let energy: f64 = v.iter().zip(&masses).map(|(v, m)| 0.5 * m * v.norm_squared()).sum();
    for lanes in [1, 4, 8] {
        let (positions, velocities) = (&rows(&x)[..], &rows(&v)[..]);
        let nodes = Nodes { positions, velocities, masses: &masses };
        let origin = Origin { position: positions[7].vec(), velocity: velocities[7].vec() };
        let all: Vec<u32> = (0..15).collect();
        // In two lists, of which the first fills its packs.
        let sums =
            with_lanes(lanes, || nodes.moments(&all[..8], origin).plus(&nodes.moments(&all[8..], origin)));
        let result = BodyMotion::from_moments(&sums, &origin);
        // Rounding, as large as the products are.
        assert!((result.mass - mass).abs() < 1e-16, "{result:?}");
        assert!((result.centre - centre).norm() < 1e-15, "{result:?}");
        assert!((result.velocity - drift).norm() < 1e-13, "{result:?}");
        assert!((result.spin - spin).norm() < 1e-10, "{result:?}");
        assert!((result.angular_momentum - angular).norm() < 1e-16, "{result:?}");
        assert!((result.energy - energy).abs() < 1e-14 * energy, "{result:?}");
    }
}

#[test]
fn a_step_with_energies_gives_those_between_assembly_and_motion() {
    let law = MooneyRivlin { c10: 4e6, c01: 1e6 }.law();
    let maxwell = vec![Maxwell { modulus: 0.3, time: 1e-4 }];
    let material = Material { law, bulk: 5e8, maxwell, density: 1150.0 };
    let pieces = vec![piece("core", 0.0214, 3, material)];
    let ball = BallConstruction { pieces, cube: 6, element: Element::OnePoint, mass: None };
    let environment = Environment::single_threaded();
    let [mut one, mut other] = [(); 2]
        .map(|()| ball_against_plane(&ball, 35.0, 0.2, 0.35, &environment).expect("the case is valid"));
    let dt = one.structure.stable_step(60) * 0.4;
    for simulation in [&mut one, &mut other] {
        let cube = simulation.parts.iter().enumerate().map(|(patch, _)| patch == 0).collect();
        simulation.structure.subcycle(cube);
        simulation.structure.integrate(simulation.contact.as_mut(), dt, 120, &mut |_, _| true);
    }
    let (result, ratios, kinetic) =
        one.structure.step_with_energies(one.contact.as_mut(), dt, &mut |_, _| true);
    one.structure.synchronise();
    let structure = &mut other.structure;
    structure.assemble(other.contact.as_mut(), dt);
    let (expected, expected_ratios) = structure.energies();
    let before = structure.velocities.clone();
    structure.advance(other.contact.as_ref(), dt);
    assert!(expected.hourglass > 0.0 && expected.viscous > 0.0);
    assert_eq!(format!("{result:?} {ratios:?}"), format!("{expected:?} {expected_ratios:?}"));
    // Summed in another order.
    assert!((kinetic / structure.kinetic_energy(&before) - 1.0).abs() < 1e-12);
    assert!(bits(&one.structure) == bits(structure));
}
