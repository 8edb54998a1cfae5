//! Bodies of one material, and what the checks measure on them.

use clubface_fem::ball::BallPiece;
use clubface_fem::contact::{Contact, PenaltySprings};
use clubface_fem::element::{Element, Patch};
use clubface_fem::environment::Environment;
use clubface_fem::material::{Hencky, Material};
use clubface_fem::mesh::{CORNERS, SolidMesh};
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
    positions.iter().map(|p| Row::from_vec(*p)).collect()
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

/// Sum over patches of the forces on each node, N, after a step of `dt` seconds to given positions.
pub fn forces(patches: &mut [Box<dyn Patch<f64>>], positions: &[Row<f64>], dt: f64) -> Vec<Vec3<f64>> {
    let rest = vec![Row::zero(); positions.len()];
    let mut sum = vec![Vec3::zero(); positions.len()];
    for patch in patches {
        patch.assemble(positions, &rest, dt);
        for (&node, force) in patch.nodes().iter().zip(patch.forces()) {
            sum[node as usize] += force.vec();
        }
    }
    sum
}

pub fn largest(vectors: &[Vec3<f64>]) -> f64 {
    vectors.iter().map(|v| v.norm()).fold(0.0, f64::max)
}

/// Forces that stay as they are.
#[derive(Default)]
pub struct Loads {
    pub nodes: Vec<u32>,
    pub forces: Vec<Row<f64>>,
}

impl Loads {
    /// Forces (N) on nodes.
    pub fn new(loads: &[(usize, Vec3<f64>)]) -> Self {
        let (nodes, forces) = loads.iter().map(|(node, force)| (*node as u32, Row::from_vec(*force))).unzip();
        Self { nodes, forces }
    }
    pub fn none() -> Self {
        Self::default()
    }
}

impl Contact<f64> for Loads {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn assemble(&mut self, _: &[Row<f64>], _: &[Row<f64>], _: f64) {}
    fn forces(&self) -> &[Row<f64>] {
        &self.forces
    }
    fn nearest(&self, _: &[Row<f64>], _: Vec3<f64>) -> (f64, Vec3<f64>) {
        (f64::INFINITY, Vec3::new(1.0, 0.0, 0.0))
    }
}

pub fn step(structure: &mut Structure<f64>, contact: &mut dyn Contact<f64>, dt: f64) {
    structure.assemble(contact, dt);
    structure.advance(contact, dt);
}

/// Period of a free vibration that starts with velocities along `mode`, over three periods; `about` is the period
/// expected, s.
pub fn period(structure: &mut Structure<f64>, mode: &[Vec3<f64>], about: f64) -> f64 {
    let dt = structure.stable_step(60) * 0.8;
    structure.velocities = rows(mode);
    period_of(dt, 3.4 * about, || {
        step(structure, &mut Loads::none(), dt);
        (0..mode.len()).map(|n| structure.masses[n] * structure.velocities[n].vec().dot(mode[n])).sum()
    })
}

/// Period of what swings about zero, from the first to the last change of its sign; one value a step.
pub fn period_of(dt: f64, duration: f64, mut next: impl FnMut() -> f64) -> f64 {
    let (mut crossings, mut last, mut time) = (Vec::new(), f64::NAN, 0.0);
    while time < duration {
        let now = next();
        if last * now < 0.0 {
            crossings.push(time - dt * now / (now - last));
        }
        (last, time) = (now, time + dt);
    }
    2.0 * (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64
}

/// Momentum (kg m/s), and angular momentum about the origin with the spins of the shells' nodes (kg m2/s).
pub fn momenta(s: &Structure<f64>) -> [Vec3<f64>; 2] {
    let [mut linear, mut angular] = [Vec3::zero(); 2];
    for (i, (v, &m)) in s.velocities.iter().zip(&s.masses).enumerate() {
        let p = v.vec() * m;
        if i < s.translations {
            linear += p;
            angular += s.positions[i].vec().cross(p);
        } else {
            angular += p;
        }
    }
    [linear, angular]
}

/// Bits of positions and velocities.
pub fn bits(s: &Structure<f64>) -> Vec<[u64; 4]> {
    s.positions.iter().chain(&s.velocities).map(|row| row.0.map(f64::to_bits)).collect()
}

/// Runs something on a number of threads.
pub fn on_threads<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads").install(run)
}

pub fn piece<R>(name: &str, radius: R, layers: usize, material: Material<R>) -> BallPiece<R> {
    BallPiece { name: name.into(), radius, layers, material }
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
