//! Plates of shells, and what the checks do with them.

use crate::support::Loads;
use clubface_fem::element::{Isotropic, Kernels, Patch, SHELL_PATCH, ShellMaterial, ShellRows, parts};
use clubface_fem::environment::Environment;
use clubface_fem::mesh::ShellMesh;
use clubface_fem::solve::Structure;
use clubface_math::{Row, Vec3};

pub const YOUNG: f64 = 114e9;
pub const POISSON: f64 = 0.34;
pub const DENSITY: f64 = 4430.0;

pub fn titanium() -> ShellMaterial<f64> {
    ShellMaterial::elastic(Isotropic { young: YOUNG, poisson: POISSON }, DENSITY)
}

/// A mesh of `counts` elements over the unit square.
pub fn surface(counts: [usize; 2], thickness: f64, place: impl Fn(f64, f64) -> Vec3<f64>) -> ShellMesh<f64> {
    let [m, n] = counts;
    let at = |i: usize, j: usize| (j * (m + 1) + i) as u32;
    let nodes = (0..(m + 1) * (n + 1)).map(|k| (k % (m + 1), k / (m + 1)));
    let nodes = nodes.map(|(i, j)| place(i as f64 / m as f64, j as f64 / n as f64)).collect();
    let quads: Vec<_> = (0..m * n)
        .map(|e| (e % m, e / m))
        .map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
        .collect();
    ShellMesh { thickness: vec![thickness; quads.len()], nodes, quads }
}

/// A square plate of `n` by `n` elements in the plane of x and y, its inner nodes moved off the grid by up to `skew` of
/// an element.
pub fn plate(n: usize, side: f64, thickness: f64, skew: f64) -> ShellMesh<f64> {
    let step = side / n as f64;
    surface([n, n], thickness, |a, b| {
        let (i, j) = ((a * n as f64).round(), (b * n as f64).round());
        let inner = [i, j].iter().all(|&k| 0.0 < k && k < n as f64);
        let off = if inner { skew * step } else { 0.0 };
        let (along, across) = ((3.0 * i + 5.0 * j).sin(), (7.0 * i + 2.0 * j).cos());
        Vec3::new(i * step + off * along, j * step + off * across, 0.0)
    })
}

pub fn patch(mesh: &ShellMesh<f64>) -> Box<dyn Patch<f64>> {
    patch_of(mesh, titanium())
}

pub fn patch_of(mesh: &ShellMesh<f64>, material: ShellMaterial<f64>) -> Box<dyn Patch<f64>> {
    let rows = ShellRows { positions: 0, rotations: mesh.nodes.len() as u32 };
    f64::shell(mesh, 0..mesh.quads.len(), material, rows)
}

/// Largest force and moment on the given nodes.
pub fn largest(patch: &dyn Patch<f64>, nodes: usize, chosen: impl Fn(usize) -> bool) -> (f64, f64) {
    let mut most = (0.0_f64, 0.0_f64);
    for (&row, force) in patch.nodes().iter().zip(patch.forces()) {
        let row = row as usize;
        if chosen(row % nodes) {
            let size = force.vec().norm();
            if row < nodes {
                most.0 = most.0.max(size);
            } else {
                most.1 = most.1.max(size);
            }
        }
    }
    most
}

/// Rows of positions or velocities, those of rotations zero.
pub fn rows(nodes: &[Vec3<f64>]) -> Vec<Row<f64>> {
    [crate::support::rows(nodes), vec![Row::zero(); nodes.len()]].concat()
}

/// A component of the displacement (0 to 2) or rotation (3 to 5) of a node.
pub type Freedom = (usize, usize);

/// A body of shells in motion, some of whose freedoms are held.
pub struct Body {
    pub structure: Structure<f64>,
    pub loads: Loads,
    pub dt: f64,
    /// Row, component and place of what is held.
    held: Vec<(usize, usize, f64)>,
}

impl Body {
    pub fn new(
        mesh: &ShellMesh<f64>,
        material: &ShellMaterial<f64>,
        held: impl Iterator<Item = Freedom>,
        loads: Loads,
    ) -> Self {
        let count = mesh.nodes.len();
        let masses = mesh.masses(std::iter::once((0..mesh.quads.len(), material.density)));
        let all = masses.translation.into_iter().chain(masses.rotation).collect();
        let rows_of = ShellRows { positions: 0, rotations: count as u32 };
        let patches = parts(mesh.quads.len(), SHELL_PATCH)
            .map(|some| f64::shell(mesh, some, material.clone(), rows_of));
        let mut structure =
            Structure::new(rows(&mesh.nodes), all, patches.collect(), &loads.nodes, &Environment::native());
        structure.translations = count;
        let place = |(node, index): Freedom| {
            let (row, component) = (node + index / 3 * count, index % 3);
            (row, component, structure.positions[row].0[component])
        };
        let held = held.map(place).collect();
        let dt = 0.8 * structure.stable_step(60);
        Self { structure, loads, dt, held }
    }

    /// One step; `damping` is by how much velocities fall in a second, as a share.
    pub fn step(&mut self, damping: f64) {
        let Self { structure, loads, dt, held } = self;
        structure.assemble(loads, *dt);
        // Before the nodes move, so that elements see the velocities with which they move.
        for v in structure.velocities.iter_mut().flat_map(|row| &mut row.0) {
            *v -= *v * damping * *dt;
        }
        structure.advance(loads, *dt);
        for &(row, component, place) in held.iter() {
            structure.positions[row].0[component] = place;
            structure.velocities[row].0[component] = 0.0;
        }
    }

    /// Comes to rest under its loads; `frequency` (rad/s) is near that of the slowest motion. Returns the work of the
    /// loads over twice the elastic energy, less one: the error of equilibrium.
    pub fn relax(&mut self, frequency: f64, periods: f64) -> f64 {
        let before = self.structure.positions.clone();
        for _ in 0..(periods * std::f64::consts::TAU / (frequency * self.dt)) as usize {
            self.step(2.0 * frequency);
        }
        let moved = |node: u32| self.structure.positions[node as usize].vec() - before[node as usize].vec();
        let loads = self.loads.nodes.iter().zip(&self.loads.forces);
        let work: f64 = loads.map(|(&node, force)| moved(node).dot(force.vec())).sum();
        let energy = self.structure.energy();
        work / (2.0 * energy.total()) - 1.0
    }

    /// Displacement of a node along an axis, from where it stands in the mesh.
    pub fn moved(&self, mesh: &ShellMesh<f64>, node: usize, axis: usize) -> f64 {
        self.structure.positions[node].0[axis] - mesh.nodes[node].array()[axis]
    }
}
