//! Derivatives of the forces of hexahedra against differences of plain forces, whether the shapes depend on a variable
//! or not, in lattices and in any order, in packs of every width.

use clubface_fem::element::{Element, Kernels};
use clubface_fem::material::{Material, Maxwell, MooneyRivlin};
use clubface_fem::mesh::{Fineness, SolidMesh, cubed_sphere};
use clubface_math::{Dual, Row, Vec3, with_lanes};

/// What the forces depend on: how far the sphere is stretched and turned, its shear modulus (Pa), and the radius (m) of
/// a core, whose elements it scales, inside a cover, whose elements it squeezes.
const AT: [f64; 4] = [0.1, 0.3, 4e6, 0.013];
const OUTER_RADIUS: f64 = 0.02;

/// Forces of a sphere in two steps, so that its branch has something to remember.
fn forces<R: Kernels>(element: Element, mixed: bool, [stretch, turn, c10, radius]: [R; 4]) -> Vec<Vec3<R>> {
    let mut mesh: SolidMesh<R> =
        cubed_sphere(&[radius, R::from_f64(OUTER_RADIUS)], &Fineness { cube: 6, layers: vec![2, 2] });
    let count = mesh.elements.len();
    let given = mesh.elements.clone();
    for (place, element) in mesh.elements.iter_mut().enumerate().filter(|_| mixed) {
        *element = given[place * 211 % count];
    }
    let (sine, cosine) = turn.sin_cos();
    for node in &mut mesh.nodes {
        // Turned before and after it was meshed: the shapes stay.
        *node = Vec3::new(node.x * cosine - node.y * sine, node.x * sine + node.y * cosine, node.z);
    }
    let material = Material {
        law: MooneyRivlin { c10, c01: R::from_f64(1e6) }.law(),
        bulk: R::from_f64(5e8),
        maxwell: vec![Maxwell { modulus: R::from_f64(0.3), time: R::from_f64(1e-4) }],
        density: R::from_f64(1150.0),
    };
    let mut patches = element.patches(&mesh, 0..count, &material);
    let bent = |p: &Vec3<R>, share: f64| {
        let wave = (p.y * 300.0).sin_cos().0 * stretch * share + 1.0;
        Row::from_vec(Vec3::new(p.x * wave, p.y + p.z * (0.2 * share), p.z * (p.x * (10.0 * share) + 1.0)))
    };
    let rest = vec![Row::zero(); mesh.nodes.len()];
    let mut sum = vec![Vec3::zero(); mesh.nodes.len()];
    for share in [0.5, 1.0] {
        let positions: Vec<Row<R>> = mesh.nodes.iter().map(|p| bent(p, share)).collect();
        sum.fill(Vec3::zero());
        for patch in &mut patches {
            patch.assemble(&positions, &rest, 1e-6);
            for (&node, force) in patch.nodes().iter().zip(patch.forces()) {
                sum[node as usize] += force.vec();
            }
        }
    }
    sum
}

#[test]
fn derivatives_of_forces_are_their_differences() {
    let least = |v: &[Vec3<f64>]| v.iter().map(|v| v.norm()).fold(0.0, f64::max);
    for element in [Element::OnePoint, Element::FullyIntegrated] {
        for mixed in [false, true] {
            let difference = |index: usize| {
                let moved = |side: f64| {
                    let mut at = AT;
                    at[index] *= 1.0 + side * 1e-6;
                    forces(element, mixed, at)
                };
                let (low, high) = (moved(-1.0), moved(1.0));
                let slope = |(low, high): (&Vec3<f64>, &Vec3<f64>)| (*high - *low) * (0.5e6 / AT[index]);
                low.iter().zip(&high).map(slope).collect::<Vec<_>>()
            };
            let plain = forces(element, mixed, AT);
            let differences: Vec<_> = (0..4).map(difference).collect();
            for lanes in [1, 4, 8] {
                // With the radius every shape is one of its own; without it none is.
                for variables in [4, 3] {
                    let number = |index: usize| {
                        if index < variables {
                            Dual::<f64, 4>::variable(AT[index], index)
                        } else {
                            Dual::constant(AT[index])
                        }
                    };
                    let result = with_lanes(lanes, || forces(element, mixed, [0, 1, 2, 3].map(number)));
                    let what = format!("{element:?}, mixed {mixed}, {lanes} lanes, {variables} variables");
                    for (force, plain_force) in result.iter().zip(&plain) {
                        let value = Vec3::new(force.x.value, force.y.value, force.z.value);
                        // Products that are fused in one and not in the other.
                        assert!((value - *plain_force).norm() < 1e-11 * least(&plain), "{what}");
                    }
                    for index in 0..variables {
                        let size = least(&differences[index]);
                        for (force, expected) in result.iter().zip(&differences[index]) {
                            let [x, y, z] = force.array().map(|number| number.tangent[index]);
                            // Rounding of forces, 1e-15 of 1e4 of what cancels in them, over 1e-6, and the third
                            // derivative.
                            assert!(
                                (Vec3::new(x, y, z) - *expected).norm() < 1e-5 * size,
                                "{what}, by {index}"
                            );
                        }
                    }
                }
            }
        }
    }
}
