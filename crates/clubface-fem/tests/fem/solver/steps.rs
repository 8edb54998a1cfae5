//! Steps that also report energies.

use clubface_fem::ball::{BallConstruction, BallPiece};
use clubface_fem::cases::ball_against_plane;
use clubface_fem::element::Element;
use clubface_fem::environment::Environment;
use clubface_fem::material::{Material, Maxwell, MooneyRivlin};

#[test]
fn a_step_with_energies_gives_those_between_assembly_and_motion() {
    let law = MooneyRivlin { c10: 4e6, c01: 1e6 }.law();
    let maxwell = vec![Maxwell { modulus: 0.3, time: 1e-4 }];
    let material = Material { law, bulk: 5e8, maxwell, density: 1150.0 };
    let pieces = vec![BallPiece { name: "core".into(), radius: 0.0214, layers: 3, material }];
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
    let (found, ratios, kinetic) =
        one.structure.step_with_energies(one.contact.as_mut(), dt, &mut |_, _| true);
    one.structure.synchronise();
    let structure = &mut other.structure;
    structure.assemble(other.contact.as_mut(), dt);
    let (expected, expected_ratios) = structure.energies();
    let before = structure.velocities.clone();
    structure.advance(other.contact.as_ref(), dt);
    assert!(expected.hourglass > 0.0 && expected.viscous > 0.0);
    assert_eq!(format!("{found:?} {ratios:?}"), format!("{expected:?} {expected_ratios:?}"));
    // Summed in another order.
    assert!((kinetic / structure.kinetic_energy(&before) - 1.0).abs() < 1e-12);
    let bits =
        |rows: &[clubface_math::Row<f64>]| rows.iter().map(|row| row.0.map(f64::to_bits)).collect::<Vec<_>>();
    assert!(bits(&one.structure.positions) == bits(&structure.positions));
}
