//! Ten-node tetrahedra, and bonds between parts: exact identities, bending, vibrations, momentum.

use crate::support::{
    Loads, Random, block, distorted_cube, elastic, forces, largest, momenta, period, root, rows, step,
};
use clubface_fem::element::{BondPatch, Energy, Kernels, Patch, Tie};
use clubface_fem::environment::Environment;
use clubface_fem::material::{Material, Maxwell, MooneyRivlin};
use clubface_fem::mesh::{EDGES, SolidMesh, TET_NODES, bonded_nodes, mass_share, tet_volumes};
use clubface_fem::solve::Structure;
use clubface_math::{Row, Vec3};
use std::collections::HashMap;

const EDGE: f64 = 0.01;

/// A mesh of tetrahedra.
struct Tetrahedra {
    nodes: Vec<Vec3<f64>>,
    elements: Vec<[u32; TET_NODES]>,
}

impl Tetrahedra {
    /// Six for each hexahedron, along its paths from the first corner to the last.
    fn new(mesh: &SolidMesh) -> Self {
        let (mut nodes, mut middles) = (mesh.nodes.clone(), HashMap::new());
        let mut elements = Vec::new();
        for hexahedron in &mesh.elements {
            for [a, b, c] in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]] {
                let mut corners = [0, 1 << a, 1 << a | 1 << b, 1 << a | 1 << b | 1 << c]
                    .map(|corner: usize| hexahedron[corner]);
                let [p, q, r, s] = corners.map(|n| nodes[n as usize]);
                if (q - p).dot((r - p).cross(s - p)) < 0.0 {
                    corners.swap(1, 2);
                }
                let mut element = [0; TET_NODES];
                element[..4].copy_from_slice(&corners);
                for (place, ends) in EDGES.into_iter().enumerate() {
                    let [i, j] = ends.map(|end| corners[end]);
                    element[4 + place] = *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                        nodes.push((nodes[i as usize] + nodes[j as usize]) * 0.5);
                        nodes.len() as u32 - 1
                    });
                }
                elements.push(element);
            }
        }
        Self { nodes, elements }
    }

    /// The same with nodes in the middles of edges off their lines, by a share of an edge.
    fn curved(mut self, size: f64) -> Self {
        let corners = self.elements.iter().flat_map(|e| e[..4].iter()).max().map_or(0, |last| last + 1);
        let mut random = Random(9);
        for node in &mut self.nodes[corners as usize..] {
            *node += random.vector() * size;
        }
        self
    }

    fn patches(&self, material: &Material<f64>) -> Vec<Box<dyn Patch<f64>>> {
        f64::tetrahedra(&self.nodes, &self.elements, 0..self.elements.len(), 0, material)
    }

    fn volume(&self) -> f64 {
        self.elements.iter().flat_map(|e| tet_volumes(&e.map(|n| self.nodes[n as usize]))).sum()
    }

    fn masses(&self, density: f64) -> Vec<f64> {
        let mut masses = vec![0.0; self.nodes.len()];
        for element in &self.elements {
            let volume: f64 = tet_volumes(&element.map(|n| self.nodes[n as usize])).iter().sum();
            for (place, &node) in element.iter().enumerate() {
                masses[node as usize] += density * volume * mass_share(place);
            }
        }
        masses
    }

    fn structure(&self, material: &Material<f64>, more: Vec<Box<dyn Patch<f64>>>) -> Structure<f64> {
        let patches = self.patches(material).into_iter().chain(more).collect();
        let masses = self.masses(material.density);
        Structure::new(rows(&self.nodes), masses, patches, &[], &Environment::native())
    }

    fn moved(&self, place: impl Fn(Vec3<f64>) -> Vec3<f64>) -> Vec<Row<f64>> {
        rows(&self.nodes.iter().map(|x| place(*x)).collect::<Vec<_>>())
    }
}

fn materials() -> [Material<f64>; 2] {
    let rubber = MooneyRivlin { c10: 4e6, c01: 1e6 }.law();
    [Material { law: rubber, bulk: 500e6, maxwell: vec![], density: 1000.0 }, elastic(193e9, 0.29, 7800.0)]
}

fn energy(patches: &mut [Box<dyn Patch<f64>>], positions: &[Row<f64>]) -> Energy {
    let mut sum = Energy::default();
    for patch in patches {
        sum += patch.energy(positions);
    }
    sum
}

#[test]
fn patch_test() {
    // A linear deformation of a distorted mesh is a state of uniform stress: no force on inner nodes, and the energy of
    // a block. With straight edges: a quadratic map keeps neither exactly.
    let mesh = Tetrahedra::new(&distorted_cube(EDGE, 0.2));
    let whole = Tetrahedra::new(&distorted_cube(EDGE, 0.0));
    for material in materials() {
        let gradient = Random(3).gradient(0.1);
        let forces = forces(&mut mesh.patches(&material), &mesh.moved(|x| gradient * x), 0.0);
        // Corners of the cube of 27 hexahedra in binary counting, and the nodes on edges between inner ones.
        let inner = |n: usize| (0..3).all(|axis| (1..3).contains(&(n / 4_usize.pow(axis) % 4)));
        let mut inside: Vec<usize> = (0..64).filter(|&n| inner(n)).collect();
        for element in &mesh.elements {
            for (place, ends) in EDGES.into_iter().enumerate() {
                if ends.iter().all(|&end| inner(element[end] as usize)) {
                    inside.push(element[4 + place] as usize);
                }
            }
        }
        assert!(inside.len() > 8 + 12);
        let inside: Vec<_> = inside.into_iter().map(|n| forces[n]).collect();
        assert!(largest(&inside) < 1e-10 * largest(&forces), "{} {}", largest(&inside), largest(&forces));
        let density = |mesh: &Tetrahedra| {
            energy(&mut mesh.patches(&material), &mesh.moved(|x| gradient * x)).strain / mesh.volume()
        };
        assert!((density(&mesh) / density(&whole) - 1.0).abs() < 1e-10);
    }
}

#[test]
fn rigid_motion_makes_no_force() {
    // Relative to the force that a strain of one would make on the face of an element.
    let mesh = Tetrahedra::new(&distorted_cube(EDGE, 0.2)).curved(0.05 * EDGE / 3.0);
    for material in materials() {
        let turn = Random(4).rotation();
        let moved = mesh.moved(|x| turn * x + Vec3::new(0.3, -0.1, 0.2));
        let scale = material.bulk * (EDGE / 3.0).powi(2);
        let mut patches = mesh.patches(&material);
        assert!(largest(&forces(&mut patches, &moved, 0.0)) < 1e-10 * scale);
        assert!(energy(&mut patches, &moved).total().abs() < 1e-14 * scale * EDGE);
    }
}

#[test]
fn forces_are_derivatives_of_energy() {
    // Central differences of the energy with steps of 1e-5 of an element: 1e-10 from the step, 1e-10 from rounding.
    let mesh = Tetrahedra::new(&block([2, 1, 1], [EDGE; 3])).curved(0.05 * EDGE);
    for material in materials() {
        let mut patches = mesh.patches(&material);
        let mut random = Random(5);
        let mut moved: Vec<_> = mesh.nodes.iter().map(|x| *x + random.vector() * (0.03 * EDGE)).collect();
        let forces = forces(&mut patches, &rows(&moved), 0.0);
        let size = 1e-5 * EDGE;
        for node in 0..mesh.nodes.len() {
            let (direction, undeformed) = (random.vector(), moved[node]);
            let mut at = |side: f64| {
                moved[node] = undeformed + direction * (side * size);
                energy(&mut patches, &rows(&moved)).total()
            };
            let slope = (at(-1.0) - at(1.0)) / (2.0 * size);
            moved[node] = undeformed;
            assert!((slope - forces[node].dot(direction)).abs() < 1e-7 * largest(&forces));
        }
    }
}

#[test]
fn packs_of_every_width_agree() {
    // Widths differ only in what the compiler fuses; viscous histories take part over some steps.
    let mesh = Tetrahedra::new(&distorted_cube(EDGE, 0.2));
    for mut material in materials() {
        material.maxwell = vec![Maxwell { modulus: 0.5, time: 1e-5 }];
        let run = |lanes: usize| {
            clubface_math::with_lanes(lanes, || {
                let mut patches = mesh.patches(&material);
                let mut random = Random(6);
                let rest = vec![Row::zero(); mesh.nodes.len()];
                for _ in 0..5 {
                    let moved: Vec<_> =
                        mesh.nodes.iter().map(|x| *x + random.vector() * (0.02 * EDGE)).collect();
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
fn one_layer_bends_exactly() {
    // Saint-Venant's pure bending is a quadratic displacement, which the element has: a wall of one layer stores
    // E I k^2 L / 2 on any mesh with straight edges. The strain is so small that its square does not matter: the
    // largest is 1e-5.
    let (length, width, depth) = (0.04, 0.006, 0.003);
    let (young, poisson) = (193e9, 0.29);
    let mut hexahedra = block([6, 1, 1], [length, width, depth]);
    let mut random = Random(8);
    for node in &mut hexahedra.nodes {
        // Sections lie askew; the outline stays.
        if node.x > 0.0 && node.x < length {
            node.x += 0.2 * length / 6.0 * random.next();
        }
    }
    let mesh = Tetrahedra::new(&hexahedra);
    let curvature = 2e-5 / depth;
    let bent = mesh.moved(|p| {
        let (x, y, z) = (p.x, p.y - 0.5 * width, p.z - 0.5 * depth);
        let k = curvature;
        let anticlastic = 0.5 * poisson * k * (z * z - y * y);
        p + Vec3::new(-k * x * z, poisson * k * y * z, 0.5 * k * x * x + anticlastic)
    });
    let stored = energy(&mut mesh.patches(&elastic(young, poisson, 7800.0)), &bent).strain;
    let expected = 0.5 * young * width * depth.powi(3) / 12.0 * curvature.powi(2) * length;
    // The rotations of the free end, 1e-3 here, are linear in this field: their square is a strain of 1e-7.
    assert!((stored / expected - 1.0).abs() < 2e-3, "{stored} {expected}");
}

#[test]
fn period_of_a_free_bar() {
    // Without lateral contraction waves run at 1000 m/s. Masses of corners and edges in the ratio of the consistent ones
    // raise or lower the frequency of ten elements along half a wave by some 0.1%.
    let (length, width) = (0.1, 0.005);
    let mesh = Tetrahedra::new(&block([10, 1, 1], [length, width, width]));
    let mode: Vec<_> = (mesh.nodes.iter())
        .map(|x| Vec3::new(1e-3 * (std::f64::consts::PI * x.x / length).cos(), 0.0, 0.0))
        .collect();
    let mut bar = mesh.structure(&elastic(1e9, 0.0, 1000.0), vec![]);
    let expected = 2.0 * length / 1000.0;
    let result = period(&mut bar, &mode, expected);
    assert!((result / expected - 1.0).abs() < 3e-3, "{result} {expected}");
}

#[test]
fn masses_keep_mass_and_centre() {
    let mesh = Tetrahedra::new(&block([3, 2, 2], [0.03, 0.02, 0.01]));
    let masses = mesh.masses(1000.0);
    let whole: f64 = masses.iter().sum();
    let centre = mesh.nodes.iter().zip(&masses).fold(Vec3::zero(), |sum, (x, m)| sum + *x * (m / whole));
    assert!((whole / 6e-3 - 1.0).abs() < 1e-12);
    assert!((centre - Vec3::new(0.015, 0.01, 0.005)).norm() < 1e-12);
}

/// Two halves of a bar along x, one of more elements across, bonded in the middle.
fn bonded_bar(length: f64, width: f64, material: &Material<f64>, stiffness: f64) -> Structure<f64> {
    let half = [0.5 * length, width, width];
    let mut bar = Tetrahedra::new(&block([6, 2, 2], half));
    let first = bar.nodes.len() as u32;
    let fine = Tetrahedra::new(&block([6, 3, 3], half));
    bar.nodes.extend(fine.nodes.iter().map(|x| *x + Vec3::new(0.5 * length, 0.0, 0.0)));
    bar.elements.extend(fine.elements.iter().map(|element| element.map(|n| n + first)));
    // All triangles in the middle, of either half.
    let side = |of: &dyn Fn(u32) -> bool| {
        let mut triangles = Vec::new();
        for element in &bar.elements {
            for [i, j, k] in [[0, 1, 2], [0, 1, 3], [1, 2, 3], [0, 2, 3]] {
                let [p, q, r] = [i, j, k].map(|corner| element[corner]);
                let inside = |n: u32| of(n) && (bar.nodes[n as usize].x - 0.5 * length).abs() < 1e-9;
                if [p, q, r].into_iter().all(inside) {
                    let middle = |one: usize, other: usize| element[clubface_fem::mesh::between(one, other)];
                    let [pq, qr, rp] = [middle(i, j), middle(j, k), middle(k, i)];
                    triangles.extend([[p, pq, rp], [pq, q, qr], [rp, qr, r], [pq, qr, rp]]);
                }
            }
        }
        triangles
    };
    let (coarse, fine) = (side(&|n| n < first), side(&|n| n >= first));
    let bonded = bonded_nodes(&bar.nodes, &fine, &coarse, 1e-6);
    let area: f64 = bonded.iter().map(|each| each.area).sum();
    assert!((area / (width * width) - 1.0).abs() < 1e-12, "the whole section is bonded");
    let ties: Vec<_> = (bonded.iter())
        .map(|each| Tie {
            node: each.node,
            face: coarse[each.triangle],
            weights: each.weights,
            stiffness: stiffness * each.area,
        })
        .collect();
    bar.structure(material, vec![Box::new(BondPatch::new(&ties))])
}

#[test]
fn a_bond_carries_what_a_spring_of_its_stiffness_does() {
    // Half a wave of a bar with a spring in its middle that is as stiff as a share s of the bar: its phase w over the
    // bar has (w / 2) tan(w / 2) = 1 / s, and pi for a stiff spring.
    let (length, width, young) = (0.1, 0.005, 1e9);
    let material = elastic(young, 0.0, 1000.0);
    for layers in [0.002, 0.1] {
        // As stiff as that part of the bar.
        let stiffness = young / (layers * length);
        let phase = root(|w| 0.5 * w * (0.5 * w).tan() - 1.0 / layers, 0.1, std::f64::consts::PI - 1e-9);
        let mut bar = bonded_bar(length, width, &material, stiffness);
        let middle = 0.5 * length;
        let mode: Vec<_> = (bar.positions.iter().enumerate())
            .map(|(n, x)| {
                let first = (x.0[0] - middle).abs() < 1e-9 && n < bar.positions.len() / 2;
                let left = x.0[0] < middle - 1e-9 || first;
                let from_end = if left { x.0[0] } else { length - x.0[0] };
                let size = (phase * from_end / length).cos();
                Vec3::new(1e-3 * if left { size } else { -size }, 0.0, 0.0)
            })
            .collect();
        let expected = 2.0 * std::f64::consts::PI * length / (phase * 1000.0);
        let result = period(&mut bar, &mode, expected);
        // As a bar without a bond, and where coarse and fine nodes do not meet.
        assert!((result / expected - 1.0).abs() < 5e-3, "{layers}: {result} {expected}");
    }
}

#[test]
fn bonds_keep_momentum_and_energy() {
    let material = elastic(1e9, 0.3, 1000.0);
    let mut bar = bonded_bar(0.02, 0.01, &material, 1e12);
    let dt = 0.5 * bar.stable_step(60);
    let mut random = Random(12);
    let spin = Vec3::new(300.0, -200.0, 400.0);
    for index in 0..bar.velocities.len() {
        let x = bar.positions[index].vec();
        bar.velocities[index] = Row::from_vec(spin.cross(x) + random.vector() * 2.0);
    }
    let before = momenta(&bar);
    let mut energies = Vec::new();
    for _ in 0..400 {
        let velocities = bar.velocities.clone();
        let stored = bar.energy().total();
        step(&mut bar, &mut Loads::none(), dt);
        energies.push(stored + bar.kinetic_energy(&velocities));
    }
    // Rounding only: the force of a spring is along its opening.
    for (after, before) in momenta(&bar).iter().zip(before) {
        assert!((*after - before).norm() < 1e-10 * before.norm(), "{after:?} {before:?}");
    }
    let (least, most) = energies.iter().fold((f64::MAX, f64::MIN), |(a, b), e| (a.min(*e), b.max(*e)));
    // Central differences at half the stable step.
    assert!((most - least) / most < 0.02, "{least} {most}");
}
