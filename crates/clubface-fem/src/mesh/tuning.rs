//! Bringing a shell head to its mass, mass centre and inertia, by the thickness of its body and by trim masses.

use super::ShellMesh;
use clubface_math::{Mat3, Real, Vec3};

/// A mass spread over the nodes near a place on the head.
#[derive(Clone, Debug)]
pub struct Trim {
    /// Name, for the report.
    pub name: String,
    /// Place, m.
    pub at: Vec3<f64>,
    /// Most it may weigh, kg.
    pub most: f64,
}

/// What a head should reach.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Mass, kg.
    pub mass: f64,
    /// Mass centre, m, by component where it matters.
    pub centre: [Option<f64>; 3],
    /// Height of the mass centre above the face normal through the origin, m: the direction of "above", and the height.
    pub above: Option<(Vec3<f64>, f64)>,
    /// Moments of inertia about axes through the mass centre along x, y, z, kg m2, where they matter.
    pub inertia: [Option<f64>; 3],
}

/// Mass properties.
#[derive(Clone, Copy, Debug)]
pub struct MassProperties {
    /// Mass, kg.
    pub mass: f64,
    /// Mass centre, m.
    pub centre: Vec3<f64>,
    /// Inertia about it, kg m2.
    pub inertia: Mat3<f64>,
}

/// What tuning reached.
#[derive(Clone, Debug)]
pub struct Tuned {
    /// Factor on the thickness of the body.
    pub scale: f64,
    /// Trim masses, kg.
    pub trims: Vec<f64>,
    /// Mass added to each node, kg.
    pub added: Vec<f64>,
    /// Mass properties of the result.
    pub reached: MassProperties,
}

/// Of point masses.
#[must_use]
pub fn mass_properties(nodes: &[Vec3<f64>], masses: &[f64]) -> MassProperties {
    let (mut mass, mut first) = (0.0, Vec3::zero());
    for (p, &m) in nodes.iter().zip(masses) {
        mass += m;
        first += *p * m;
    }
    let centre = first * (1.0 / mass);
    let mut inertia = Mat3::diagonal(0.0);
    for (p, &m) in nodes.iter().zip(masses) {
        let r = *p - centre;
        inertia = inertia + (Mat3::diagonal(r.norm_squared()) + Mat3::outer(r, r).scale(-1.0)).scale(m);
    }
    MassProperties { mass, centre, inertia }
}

/// Radius about a trim's place within which nodes carry it, m.
const SPREAD: f64 = 0.008;
/// Rounds in which the mass centre, to which inertia refers, is brought up to date.
const ROUNDS: usize = 8;
/// Sweeps of the bounded least squares.
const SWEEPS: usize = 4000;

/// Tunes a head: `body` tells the elements whose thickness may change, within `scales`.
pub fn tune<R: Real>(
    mesh: &mut ShellMesh<R>,
    body: &[bool],
    density: f64,
    scales: (f64, f64),
    trims: &[Trim],
    target: &Target,
) -> Tuned {
    let count = mesh.nodes.len();
    // Mass by node of the fixed part, of the body, and of each trim at one kilogram.
    let mut columns = vec![vec![0.0; count]; 2 + trims.len()];
    for (element, quad) in mesh.quads.iter().enumerate() {
        let share = 0.25 * density * mesh.thickness[element].re() * mesh.area(element);
        for &node in quad {
            columns[usize::from(body[element])][node as usize] += share;
        }
    }
    for (trim, column) in trims.iter().zip(&mut columns[2..]) {
        let nearest = mesh.nodes.iter().fold(f64::INFINITY, |d, p| d.min((*p - trim.at).norm()));
        for (p, m) in mesh.nodes.iter().zip(column.iter_mut()) {
            *m = (1.0 - (*p - trim.at).norm() / (nearest + SPREAD)).max(0.0);
        }
        let sum: f64 = column.iter().sum();
        column.iter_mut().for_each(|m| *m /= sum);
    }
    let mut bounds = vec![(1.0, 1.0), scales];
    bounds.extend(trims.iter().map(|trim| (0.0, trim.most)));
    let mut x: Vec<f64> = bounds.iter().map(|b| 0.5 * (b.0 + b.1)).collect();
    let total = |x: &[f64]| -> Vec<f64> {
        (0..count).map(|n| columns.iter().zip(x).map(|(column, s)| column[n] * s).sum()).collect()
    };
    for _ in 0..ROUNDS {
        let now = mass_properties(&mesh.nodes, &total(&x));
        let rows = equations(&mesh.nodes, &columns, now.centre, target);
        bounded_least_squares(&rows, &bounds, &mut x);
    }
    for (t, &in_body) in mesh.thickness.iter_mut().zip(body) {
        if in_body {
            *t = *t * x[1];
        }
    }
    let added = (0..count).map(|n| columns[2..].iter().zip(&x[2..]).map(|(c, s)| c[n] * s).sum()).collect();
    Tuned { scale: x[1], trims: x[2..].to_vec(), added, reached: mass_properties(&mesh.nodes, &total(&x)) }
}

/// Rows of the least-squares problem, each a list of coefficients and a right side, in units in which one is a bad miss.
fn equations(
    nodes: &[Vec3<f64>],
    columns: &[Vec<f64>],
    centre: Vec3<f64>,
    target: &Target,
) -> Vec<(Vec<f64>, f64)> {
    let sums = |weight: &dyn Fn(Vec3<f64>) -> f64| -> Vec<f64> {
        columns.iter().map(|c| c.iter().zip(nodes).map(|(m, p)| m * weight(*p)).sum()).collect()
    };
    let mut rows = Vec::new();
    // Mass to 0.01 g, mass centre to 0.1 mm, inertia to 1 g cm2 are worth the same.
    let mut row = |coefficients: Vec<f64>, right: f64, unit: f64| {
        rows.push((coefficients.iter().map(|c| c / unit).collect(), right / unit));
    };
    row(sums(&|_| 1.0), target.mass, 1e-5);
    for axis in 0..3 {
        if let Some(wanted) = target.centre[axis] {
            row(sums(&|p| p.array()[axis]), target.mass * wanted, 1e-4 * target.mass);
        }
        if let Some(wanted) = target.inertia[axis] {
            let weight = |p: Vec3<f64>| {
                let r = p - centre;
                r.norm_squared() - r.array()[axis].powi(2)
            };
            row(sums(&weight), wanted, 1e-7);
        }
    }
    if let Some((up, wanted)) = target.above {
        row(sums(&|p| p.dot(up)), target.mass * wanted, 1e-4 * target.mass);
    }
    rows
}

/// Coordinate descent, kept within the bounds; a weak pull to the smallest values settles what the equations leave open.
fn bounded_least_squares(rows: &[(Vec<f64>, f64)], bounds: &[(f64, f64)], x: &mut [f64]) {
    let n = x.len();
    let (mut square, mut right) = (vec![vec![0.0; n]; n], vec![0.0; n]);
    for (coefficients, b) in rows {
        for i in 0..n {
            right[i] += coefficients[i] * b;
            for j in 0..n {
                square[i][j] += coefficients[i] * coefficients[j];
            }
        }
    }
    for (i, row) in square.iter_mut().enumerate() {
        row[i] *= 1.0 + 1e-9;
    }
    for _ in 0..SWEEPS {
        for i in 0..n {
            if square[i][i] > 0.0 {
                let rest: f64 = right[i] - square[i].iter().zip(x.iter()).map(|(a, b)| a * b).sum::<f64>();
                x[i] = (x[i] + rest / square[i][i]).clamp(bounds[i].0, bounds[i].1);
            }
        }
    }
}
