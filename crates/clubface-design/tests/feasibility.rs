//! A head must be a body in its volume: moments of positive mass pass, and nothing else does.

#![allow(clippy::unwrap_used)]

use clubface_design::feasibility::{Envelope, MassProperties, Matrix, Shape, Volume, pseudo_inertia};
use proptest::prelude::*;

/// The modern driver of the package.
const DRIVER: MassProperties =
    [0.204, 0.04218, 0.00434, 0.001, 2843e-7, 5679e-7, 4085e-7, -733e-7, 530.2e-7, 0.5e-7];
const CENTRE: [f64; 3] = [-0.055, -0.001, 0.003];
const SIZE: [f64; 3] = [0.115, 0.062, 0.124];

fn space(shape: Shape) -> Volume {
    Volume::new(shape, CENTRE, SIZE).unwrap()
}

/// The pseudo-inertia of point masses, straight from its definition.
fn moments(masses: &[(f64, [f64; 3])]) -> Matrix {
    let mut result = [[0.0; 4]; 4];
    for &(mass, [x, y, z]) in masses {
        let row = [x, y, z, 1.0];
        for i in 0..4 {
            for j in 0..4 {
                result[i][j] += mass * row[i] * row[j];
            }
        }
    }
    result
}

fn place(part: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|axis| CENTRE[axis] + 0.5 * SIZE[axis] * part[axis])
}

proptest! {
    #[test]
    fn point_masses_in_the_box_on_a_shell_are_a_head(
        bodies in prop::collection::vec((1e-4..0.1, prop::array::uniform3(-1.0..1.0)), 1..8),
    ) {
        let inside: Vec<_> = bodies.iter().map(|&(mass, part)| (mass, place(part))).collect();
        let shell = moments(&inside.iter().map(|&(mass, at)| (3.0 * mass, at)).collect::<Vec<_>>());
        let budget = inside.iter().map(|(mass, _)| mass).sum::<f64>() * (1.0 + 1e-9);
        let volume = space(Shape::Box);
        let envelope = Envelope::new(volume, volume, shell, Some(budget)).unwrap();
        let all = core::array::from_fn(|i| core::array::from_fn(|j| shell[i][j] + moments(&inside)[i][j]));
        prop_assert!(envelope.margins(&all).iter().all(|margin| margin.value >= -1e-9));
    }

    #[test]
    fn a_mass_beyond_a_wall_is_refused(axis in 0..3_usize, side in prop::bool::ANY) {
        let mut part = [0.0; 3];
        part[axis] = if side { 1.01 } else { -1.01 };
        let volume = space(Shape::Box);
        let envelope = Envelope::new(volume, volume, [[0.0; 4]; 4], None).unwrap();
        prop_assert!(envelope.least(&moments(&[(0.2, place(part))])) < -1e-3);
    }
}

#[test]
fn the_least_margin_is_the_least_of_all() {
    let envelope = Envelope::lightened(space(Shape::Box), &DRIVER, 0.03).unwrap();
    for (place, change) in [(1, 0.004), (2, -0.006), (5, 3e-5), (6, -2e-4), (0, -0.05)] {
        let mut values = DRIVER;
        values[place] += change;
        let pseudo = pseudo_inertia(&values);
        let least = envelope.margins(&pseudo).iter().map(|each| each.value).fold(f64::INFINITY, f64::min);
        assert_eq!(envelope.least(&pseudo), least, "{place}");
    }
}

/// 30 g of 204 g all at the back wall, 70 mm behind the CG, move the CG back by 10.3 mm.
#[test]
fn a_driver_is_built_until_its_free_mass_lies_at_the_back() {
    let envelope = Envelope::lightened(space(Shape::Box), &DRIVER, 0.03).unwrap();
    let moved = |back: f64| {
        let mut values = DRIVER;
        values[1] += back;
        envelope.margins(&pseudo_inertia(&values))
    };
    assert!(moved(0.0).iter().all(|each| each.value > -1e-12));
    let behind = moved(0.0104);
    let broken = behind.iter().find(|each| each.value < 0.0).unwrap();
    assert!(broken.reason.contains("the discretionary mass"), "{}", broken.reason);
}

#[test]
fn eigenvalues_are_those_of_a_diagonal_matrix_in_any_order() {
    let envelope = Envelope::new(space(Shape::Box), space(Shape::Box), [[0.0; 4]; 4], None).unwrap();
    for axis in 0..3 {
        let mut pseudo = moments(&[(0.2, [0.0; 3])]);
        pseudo[axis][axis] -= 1e-5;
        let margins = envelope.margins(&pseudo);
        assert!(
            margins[0].value < 0.0 && margins[0].reason.contains("would be -100.0 g cm2"),
            "{}",
            margins[0].reason
        );
    }
}
