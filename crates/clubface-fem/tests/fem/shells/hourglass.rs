//! What a single shell resists with in the modes that its point does not see: those of a rectangle.

use super::support::{POISSON, YOUNG, patch, rows, surface};
use clubface_math::{Row, Vec3};

const SIDES: [f64; 2] = [0.004, 0.006];
const THICKNESS: f64 = 1.5e-3;
const SHEAR: f64 = YOUNG / (2.0 * (1.0 + POISSON));
const AMPLITUDE: f64 = 1e-9;

/// Twice the hourglass energy over the square of the amplitude of a pattern, c xi eta in a component of displacement
/// (0 to 2, m) or rotation (3 to 5).
fn stiffness(component: usize) -> f64 {
    let mesh = surface([1, 1], THICKNESS, |a, b| Vec3::new(a * SIDES[0], b * SIDES[1], 0.0));
    let count = mesh.nodes.len();
    let mut displacements = rows(&mesh.nodes);
    displacements.fill(Row::zero());
    for (i, p) in mesh.nodes.iter().enumerate() {
        let shape = (2.0 * p.x / SIDES[0] - 1.0) * (2.0 * p.y / SIDES[1] - 1.0);
        displacements[i + component / 3 * count].0[component % 3] = AMPLITUDE * shape;
    }
    let positions = rows(&mesh.nodes);
    let mut patch = patch(&mesh);
    patch.assemble(&positions, &displacements, 1.0);
    let forces = patch.nodes().iter().zip(patch.forces());
    let work: f64 = forces.map(|(&row, force)| -force.vec().dot(displacements[row as usize].vec())).sum();
    let energy = patch.energy(&positions);
    // All of it is hourglass energy, and the work of the forces: the amplitude is 1e-6 of a side.
    assert!((work / (2.0 * energy.hourglass) - 1.0).abs() < 1e-5, "{component}: {work} {energy:?}");
    2.0 * energy.hourglass / (AMPLITUDE * AMPLITUDE)
}

/// Relative to what is expected; the amplitude is 1e-6 of a side, its square relative to it.
fn assert_close(component: usize, expected: f64) {
    let result = stiffness(component);
    assert!((result / expected - 1.0).abs() < 1e-5, "{component}: {result} {expected}");
}

#[test]
fn in_its_plane_a_shell_bends_as_a_beam_does() {
    // u = c xi eta along a: the strain 4 c y / (a b) of a beam of modulus E and depth b, E t integral over the area:
    // 4/3 E t c^2 b / a.
    let [a, b] = SIDES;
    assert_close(0, 4.0 / 3.0 * YOUNG * THICKNESS * b / a);
    assert_close(1, 4.0 / 3.0 * YOUNG * THICKNESS * a / b);
}

#[test]
fn out_of_its_plane_a_shell_bends_and_twists_as_a_plate_does() {
    // A rotation c xi eta about b has the curvature 4 c y / (a b) along a, of the rigidity E I / (1 - nu^2), and half
    // that twist, 4 c x / (a b), of G I: 4/3 c^2 (E I / (1 - nu^2) b / a + G I a / b) with I = t^3 / 12.
    let [a, b] = SIDES;
    let moment = THICKNESS.powi(3) / 12.0;
    let (plate, torsion) = (YOUNG / (1.0 - POISSON * POISSON) * moment, SHEAR * moment);
    assert_close(4, 4.0 / 3.0 * (plate * b / a + torsion * a / b));
    assert_close(3, 4.0 / 3.0 * (plate * a / b + torsion * b / a));
}

#[test]
fn warped_without_turning_a_shell_is_sheared_across() {
    // w = c xi eta: slopes 2 c eta / a and 2 c xi / b, whose squares have the mean 1/3, and 5/6 of G t:
    // 5/6 G t 4/3 c^2 (b / a + a / b).
    let [a, b] = SIDES;
    assert_close(2, 5.0 / 6.0 * SHEAR * THICKNESS * 4.0 / 3.0 * (b / a + a / b));
}
