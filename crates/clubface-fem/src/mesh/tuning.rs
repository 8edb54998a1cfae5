//! Tuning of a shell head to its mass, mass centre and inertia, by the thickness of its body and by trim masses.

use super::ShellMesh;
use clubface_math::{Mat3, Real, Vec3};

/// A mass that is spread over the nodes near a point of the head.
#[derive(Clone, Debug)]
pub struct Trim {
    /// Name, for the report.
    pub name: String,
    /// Position, m.
    pub at: Vec3<f64>,
    /// Largest mass, kg.
    pub most: f64,
}

/// Mass properties that a head should have.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(deny_unknown_fields))]
pub struct Target {
    /// Mass, kg.
    pub mass: f64,
    /// Mass centre, m, by component where it matters.
    pub centre: [Option<f64>; 3],
    /// Height of the mass centre above the face normal through the origin, m.
    pub above: Option<f64>,
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

/// Result of the tuning.
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

/// Mass properties of point masses.
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

/// Radius round a trim mass within which nodes carry it, m.
const SPREAD: f64 = 0.008;
/// Rounds, each with the mass centre of the last one as the origin of the inertia.
const ROUNDS: usize = 8;
/// Weight of a wall of twice its thickness, or of the largest trim mass, against the errors: it decides what the
/// equations leave open.
const REGULARISATION: f64 = 0.1;

/// Tunes a head: `body` says which elements may change their thickness, within the factors `scales`; `up` is the
/// direction up the face.
pub fn tune<R: Real>(
    mesh: &mut ShellMesh<R>,
    body: &[bool],
    density: f64,
    scales: (f64, f64),
    trims: &[Trim],
    target: &Target,
    up: Vec3<f64>,
) -> Tuned {
    let count = mesh.nodes.len();
    // Mass by node of the fixed part, of the body, and of each trim at one kilogram.
    let mut columns = vec![vec![0.0; count]; 2 + trims.len()];
    for (element, quad) in mesh.quads.iter().enumerate() {
        let nodal_mass = 0.25 * density * mesh.thickness[element].re() * mesh.area(element);
        for &node in quad {
            columns[usize::from(body[element])][node as usize] += nodal_mass;
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
    // As designed: no trim masses.
    let mut x = vec![0.0; bounds.len()];
    x[..2].fill(1.0);
    let total = |x: &[f64]| -> Vec<f64> {
        (0..count).map(|n| columns.iter().zip(x).map(|(column, s)| column[n] * s).sum()).collect()
    };
    for _ in 0..ROUNDS {
        let now = mass_properties(&mesh.nodes, &total(&x));
        let mut rows = equations(&mesh.nodes, &columns, now.centre, target, up);
        for (i, bound) in bounds.iter().enumerate().skip(1) {
            let mut pull = vec![0.0; bounds.len()];
            let (as_designed, unit) = if i == 1 { (1.0, 1.0) } else { (0.0, bound.1) };
            pull[i] = REGULARISATION / unit;
            rows.push((pull, REGULARISATION * as_designed / unit));
        }
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

/// Rows of the least-squares problem, each with its coefficients and right side, scaled so that an error of 1 is a bad
/// miss.
fn equations(
    nodes: &[Vec3<f64>],
    columns: &[Vec<f64>],
    centre: Vec3<f64>,
    target: &Target,
    up: Vec3<f64>,
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
    if let Some(wanted) = target.above {
        row(sums(&|p| p.dot(up)), target.mass * wanted, 1e-4 * target.mass);
    }
    rows
}

/// Least squares within bounds by an active set: values outside are put on their bounds, the farthest first, and freed
/// when they pull inwards.
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
    let mut free: Vec<bool> = bounds.iter().map(|b| b.0 < b.1).collect();
    for (value, bound) in x.iter_mut().zip(bounds) {
        *value = value.clamp(bound.0, bound.1);
    }
    for _ in 0..4 * n {
        solve_free(&square, &right, &free, x);
        let outside =
            |i: &usize| (bounds[*i].0 - x[*i]).max(x[*i] - bounds[*i].1) / (bounds[*i].1 - bounds[*i].0);
        let worst = (0..n).filter(|&i| free[i]).max_by(|i, j| outside(i).total_cmp(&outside(j)));
        if let Some(i) = worst.filter(|i| outside(i) > 0.0) {
            (x[i], free[i]) = (x[i].clamp(bounds[i].0, bounds[i].1), false);
            continue;
        }
        // Downhill is against the slope.
        let slope = |i: usize| square[i].iter().zip(x.iter()).map(|(a, b)| a * b).sum::<f64>() - right[i];
        let inwards = |i: usize| if x[i] <= bounds[i].0 { -slope(i) } else { slope(i) };
        let held = (0..n).filter(|&i| !free[i] && bounds[i].0 < bounds[i].1);
        match held.max_by(|&i, &j| inwards(i).total_cmp(&inwards(j))) {
            Some(i) if inwards(i) > 1e-6 * right[i].abs() => free[i] = true,
            _ => break,
        }
    }
}

/// Solves the rows and columns of the free values of a positive definite system, the others as they are, by Gaussian
/// elimination.
fn solve_free(square: &[Vec<f64>], right: &[f64], free: &[bool], x: &mut [f64]) {
    let chosen: Vec<usize> = (0..x.len()).filter(|&i| free[i]).collect();
    let held = |i: usize| (0..x.len()).filter(|&j| !free[j]).map(|j| square[i][j] * x[j]).sum::<f64>();
    let mut table: Vec<Vec<f64>> = chosen
        .iter()
        .map(|&i| chosen.iter().map(|&j| square[i][j]).chain([right[i] - held(i)]).collect())
        .collect();
    let n = chosen.len();
    for i in 0..n {
        for k in i + 1..n {
            let factor = table[k][i] / table[i][i];
            for j in i..=n {
                table[k][j] -= factor * table[i][j];
            }
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| table[i][j] * x[chosen[j]]).sum();
        x[chosen[i]] = (table[i][n] - known) / table[i][i];
    }
}
