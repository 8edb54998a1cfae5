//! The fast one-point hexahedron against the plain one of the textbooks, for every law of the table.

use crate::support::{Random, block, distorted_cube};
use clubface_fem::element::{Element, Kernels, ReferenceHexahedron};
use clubface_fem::material::{DERIVATIVES, LAWS, Material, MaterialPoint, Maxwell, Number, from_table};
use clubface_fem::mesh::SolidMesh;
use clubface_math::{Dual, Real, Row, Vec3};

const EDGE: f64 = 0.01;
/// Time step, s: fast enough for the branches to matter.
const STEP: f64 = 2e-6;

/// Every law with its example; those without state variables of their own also with viscoelastic branches.
fn materials<R: Number>() -> Vec<(String, Material<R>)> {
    let number = R::from_f64;
    let mut all = Vec::new();
    for entry in LAWS {
        let description = entry.description;
        let constants: Vec<R> = description.example.iter().map(|&value| number(value)).collect();
        let law = from_table(LAWS, description.name, &constants).expect("the example is allowed");
        let elastic = Material { law, bulk: number(40e6), maxwell: vec![], density: number(1000.0) };
        if description.state.is_empty() {
            let branch = |modulus, time| Maxwell { modulus: number(modulus), time: number(time) };
            let maxwell = vec![branch(0.5, 1e-5), branch(0.2, 1e-6)];
            all.push((
                format!("{}, viscoelastic", description.name),
                Material { maxwell, ..elastic.clone() },
            ));
        }
        all.push((description.name.to_owned(), elastic));
    }
    all
}

/// The mesh with every node moved at random, by up to `share` of an element.
fn moved<R: Real>(mesh: &SolidMesh<R>, random: &mut Random, share: f64) -> Vec<Vec3<R>> {
    let mut near = || Vec3::from_f64(random.vector().array().map(|x| x * share * EDGE / 3.0));
    mesh.nodes.iter().map(|x| *x + near()).collect()
}

/// Largest difference of the forces of both elements over the largest force, after some steps to random positions, and
/// that of the hourglass energies.
fn difference<R: Kernels>(mesh: &SolidMesh<R>, material: &Material<R>) -> (f64, f64) {
    let mut fast = Element::OnePoint.patches(mesh, 0..mesh.elements.len(), material);
    let plain: Vec<_> = (0..mesh.elements.len())
        .map(|e| ReferenceHexahedron::new(&mesh.corners(e), material.shear()))
        .collect();
    let mut points: Vec<_> = plain.iter().map(|_| MaterialPoint::new(material)).collect();
    let (mut random, mut worst) = (Random(11), (0.0_f64, 0.0_f64));
    for _ in 0..4 {
        let positions = moved(mesh, &mut random, 0.3);
        let mut expected = vec![Vec3::zero(); positions.len()];
        let mut hourglass = 0.0;
        for ((element, hexahedron), point) in mesh.elements.iter().zip(&plain).zip(&mut points) {
            let corners = element.map(|node| positions[node as usize]);
            let forces = hexahedron.forces(&corners, |f| point.update(f, STEP));
            element.iter().zip(forces).for_each(|(&node, force)| expected[node as usize] += force);
            hourglass += hexahedron.hourglass_energy(&corners).re();
        }
        let rows: Vec<_> = positions.iter().map(|x| Row::from_vec(*x)).collect();
        let mut computed = vec![Vec3::zero(); positions.len()];
        let mut fast_hourglass = 0.0;
        for patch in &mut fast {
            patch.assemble(&rows, &rows, STEP);
            for (&node, force) in patch.nodes().iter().zip(patch.forces()) {
                computed[node as usize] += force.vec();
            }
            fast_hourglass += patch.energy(&rows).hourglass;
        }
        let size = expected.iter().map(|force| force.norm().re()).fold(0.0, f64::max);
        for (a, b) in computed.iter().zip(&expected) {
            let apart = *a - *b;
            worst.0 = worst.0.max(apart.norm_squared().re().sqrt() / size);
            for slope in [apart.x, apart.y, apart.z].iter().flat_map(clubface_math::Real::derivatives) {
                worst.1 = worst.1.max(slope.abs() / size);
            }
        }
        assert!((fast_hourglass / hourglass - 1.0).abs() < 1e-12, "{fast_hourglass} {hourglass}");
        assert!(hourglass > 0.0);
    }
    worst
}

#[test]
fn the_fast_element_computes_what_the_plain_one_does() {
    // Rounding: a few thousand operations, and 1e-12 of the cube root.
    for mesh in [distorted_cube(EDGE, 0.3), block([5, 4, 3], [EDGE, 0.8 * EDGE, 1.2 * EDGE])] {
        for (name, material) in materials::<f64>() {
            let (forces, _) = difference(&mesh, &material);
            assert!(forces < 2e-11, "{name}: {forces:e}");
        }
    }
}

#[test]
fn their_derivatives_by_the_size_of_the_mesh_agree() {
    // Derivatives by the scale of the mesh, of the order of the forces themselves.
    type Derived = Dual<f64, DERIVATIVES>;
    let plain = distorted_cube(EDGE, 0.2);
    let scale = Derived::variable(1.0, 1);
    let nodes = plain.nodes.iter().map(|x| Vec3::from_f64(x.array()) * scale).collect();
    let mesh = SolidMesh { nodes, elements: plain.elements, layer: plain.layer };
    for (name, material) in materials::<Derived>() {
        let (forces, slopes) = difference(&mesh, &material);
        assert!(forces < 2e-11 && slopes < 1e-9, "{name}: {forces:e} {slopes:e}");
    }
}
