//! Bodies of one material, and what the checks measure on them.

use clubface_fem::contact::{Contact, PenaltySprings};
use clubface_fem::element::{Element, Patch};
use clubface_fem::environment::Environment;
use clubface_fem::material::{Hencky, Material};
use clubface_fem::mesh::{SolidMesh, CORNERS};
use clubface_fem::solve::Structure;
use clubface_math::{Mat3, Row, Vec3};

/// Every kind of solid element.
pub const ELEMENTS: [Element; 2] = [Element::OnePoint, Element::FullyIntegrated];

/// Numbers between -1 and 1, the same ones every time.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
    }
    pub fn vector(&mut self) -> Vec3<f64> {
        Vec3::new(self.next(), self.next(), self.next())
    }
    /// The identity and something up to `size` in each element.
    pub fn gradient(&mut self, size: f64) -> Mat3<f64> {
        let mut row = || self.vector() * size;
        Mat3::from_rows(row(), row(), row()) + Mat3::diagonal(1.0)
    }
    pub fn rotation(&mut self) -> Mat3<f64> {
        let turn = |angle: f64| angle.sin_cos();
        Mat3::rotation_x(turn(3.0 * self.next()))
            * Mat3::rotation_y(turn(3.0 * self.next()))
            * Mat3::rotation_z(turn(3.0 * self.next()))
    }
}

/// Linear elastic material by Young's modulus (Pa), Poisson's ratio and density (kg/m3).
pub fn elastic(young: f64, poisson: f64, density: f64) -> Material<f64> {
    let shear = young / (2.0 * (1.0 + poisson));
    let bulk = young / (3.0 * (1.0 - 2.0 * poisson));
    Material { law: Hencky { shear }.law(), bulk, maxwell: vec![], density }
}

/// A block of `counts` elements and `size` metres with a corner at the origin.
pub fn block(counts: [usize; 3], size: [f64; 3]) -> SolidMesh {
    let index = |i: usize, j: usize, k: usize| (i + (counts[0] + 1) * (j + (counts[1] + 1) * k)) as u32;
    let mut mesh = SolidMesh { nodes: vec![], elements: vec![], layer: vec![] };
    for k in 0..=counts[2] {
        for j in 0..=counts[1] {
            for i in 0..=counts[0] {
                let at =
                    [(i, 0), (j, 1), (k, 2)].map(|(n, axis)| size[axis] * n as f64 / counts[axis] as f64);
                mesh.nodes.push(Vec3::from_f64(at));
                if i < counts[0] && j < counts[1] && k < counts[2] {
                    let mut element = [0; CORNERS];
                    for corner in 0..CORNERS {
                        element[corner] =
                            index(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2 & 1));
                    }
                    mesh.elements.push(element);
                    mesh.layer.push(0);
                }
            }
        }
    }
    mesh
}

/// A cube of 3 elements an edge (m), every node moved by up to `share` of an element.
pub fn distorted_cube(edge: f64, share: f64) -> SolidMesh {
    let mut mesh = block([3; 3], [edge; 3]);
    let mut random = Random(7);
    for node in &mut mesh.nodes {
        *node += random.vector() * (share * edge / 3.0);
    }
    mesh
}

/// Elements of a mesh by patches.
pub fn patches(element: Element, mesh: &SolidMesh, material: &Material<f64>) -> Vec<Box<dyn Patch<f64>>> {
    element.patches(mesh, 0..mesh.elements.len(), material)
}

/// Mass of each node, kg.
pub fn masses(mesh: &SolidMesh, density: f64) -> Vec<f64> {
    let mut masses = vec![0.0; mesh.nodes.len()];
    for (e, element) in mesh.elements.iter().enumerate() {
        for &node in element {
            masses[node as usize] += density * mesh.volume(e) / 8.0;
        }
    }
    masses
}

pub fn rows(positions: &[Vec3<f64>]) -> Vec<Row<f64>> {
    positions.iter().map(|p| Row([p.x, p.y, p.z, 0.0])).collect()
}

/// A body of one material, whose nodes `touching` a contact will act on.
pub fn structure(
    element: Element,
    mesh: &SolidMesh,
    material: &Material<f64>,
    touching: &[u32],
) -> Structure<f64> {
    Structure::new(
        rows(&mesh.nodes),
        masses(mesh, material.density),
        patches(element, mesh, material),
        touching,
        &Environment::native(),
    )
}

/// Sum over patches of the forces on each node, N, at given positions.
pub fn forces(patches: &mut [Box<dyn Patch<f64>>], positions: &[Row<f64>]) -> Vec<Vec3<f64>> {
    let rest = vec![Row::zero(); positions.len()];
    let mut sum = vec![Vec3::zero(); positions.len()];
    for patch in patches {
        patch.assemble(positions, &rest, 0.0);
        for (&node, force) in patch.nodes().iter().zip(patch.forces()) {
            sum[node as usize] += force.vec();
        }
    }
    sum
}

pub fn largest(vectors: &[Vec3<f64>]) -> f64 {
    vectors.iter().map(|v| v.norm()).fold(0.0, f64::max)
}

/// No contact.
pub struct Free;

impl Contact<f64> for Free {
    fn nodes(&self) -> &[u32] {
        &[]
    }
    fn assemble(&mut self, _positions: &[Row<f64>], _velocities: &[Row<f64>], _dt: f64) {}
    fn forces(&self) -> &[Row<f64>] {
        &[]
    }
    fn nearest(&self, _: &[Row<f64>], _point: Vec3<f64>) -> (f64, Vec3<f64>) {
        (f64::INFINITY, Vec3::new(1.0, 0.0, 0.0))
    }
}

pub fn step(structure: &mut Structure<f64>, contact: &mut dyn Contact<f64>, dt: f64) {
    structure.assemble(contact, dt);
    structure.advance(contact, dt);
}

/// Period of a free vibration that starts with velocities along `mode`: from the first to the last change of sign, over
/// three periods, of the momentum along it. `about` is the period expected, s.
pub fn period(structure: &mut Structure<f64>, mode: &[Vec3<f64>], about: f64) -> f64 {
    let dt = structure.stable_step(60) * 0.8;
    for (v, m) in structure.velocities.iter_mut().zip(mode) {
        *v = Row([m.x, m.y, m.z, 0.0]);
    }
    let (mut crossings, mut last, mut time) = (Vec::new(), f64::NAN, 0.0);
    while time < 3.4 * about {
        step(structure, &mut Free, dt);
        let sum: f64 =
            (0..mode.len()).map(|n| structure.masses[n] * structure.velocities[n].vec().dot(mode[n])).sum();
        if last * sum < 0.0 {
            crossings.push(time - dt * sum / (sum - last));
        }
        (last, time) = (sum, time + dt);
    }
    let halves = (crossings.len() - 1) as f64;
    2.0 * (crossings[crossings.len() - 1] - crossings[0]) / halves
}

/// Root of `f` between `a` and `b`.
pub fn root(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    let sign = f(a).signum();
    assert!(sign != f(b).signum(), "no change of sign");
    for _ in 0..60 {
        let middle = 0.5 * (a + b);
        if f(middle).signum() == sign {
            a = middle;
        } else {
            b = middle;
        }
    }
    a
}

/// Stiff, undamped contact springs, for comparison with closed forms that have none.
pub const SPRING: PenaltySprings =
    PenaltySprings { stiffness: 0.25, damping: 0.0, step: None, multiplier: None };

/// Outer nodes of a mesh, and the share of each node in its surface, m2.
pub fn outside(mesh: &SolidMesh) -> (Vec<u32>, Vec<f64>) {
    let mut areas = vec![0.0; mesh.nodes.len()];
    for side in mesh.surface() {
        let [a, b, c, d] = side.map(|n| mesh.nodes[n as usize]);
        for node in side {
            areas[node as usize] += (c - a).cross(d - b).norm() / 8.0;
        }
    }
    ((0..areas.len() as u32).filter(|&n| areas[n as usize] > 0.0).collect(), areas)
}
