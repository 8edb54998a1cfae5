//! Whether a clubhead can exist: its mass, CG and inertia must be those of mass that is nowhere negative in its volume.
//!
//! The moments of a body up to the second order are one symmetric matrix of four rows, its pseudo-inertia: the integral of
//! (x, y, z, 1)(x, y, z, 1)' over its mass. It belongs to a body if and only if it is positive semidefinite. It belongs to
//! a body within the region where a quadratic form (x, y, z, 1) Q (x, y, z, 1)' is not negative only if trace(J Q) is not
//! negative, and for an ellipsoid these two conditions are enough (Wensing, Kim and Slotine, 2018). Moments add up, so what
//! a designer may place freely in a head has the moments of the head less those of the shell, and the same holds of them.
//!
//! The origin is the face centre, the axes are those of the club: x to the target, y up, z to the toe.

use clubface_impact::ImpactError;

/// A symmetric matrix of moments, or a quadratic form.
pub type Matrix = [[f64; 4]; 4];

/// Numbers that the distribution of mass determines: mass, way from the CG to the face centre (x, y, z), and the inertia
/// about the CG (xx, yy, zz, xy, xz, yz) [SI].
pub type MassProperties = [f64; MASS_PROPERTIES];

/// How many they are.
pub const MASS_PROPERTIES: usize = 10;

/// What a margin may miss, as a part of its natural size.
pub const ROUNDING: f64 = 1e-9;

/// Least mass by which margins are scaled [kg].
const LEAST_SCALE: f64 = 1e-6;

/// The pseudo-inertia about the face centre [kg m2, kg m and kg].
#[must_use]
pub fn pseudo_inertia(values: &MassProperties) -> Matrix {
    let &[mass, x, y, z, xx, yy, zz, xy, xz, yz] = values;
    let place = [-x, -y, -z]; // the club gives the way from its CG to the face centre
    let inertia = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let half_trace = 0.5 * (xx + yy + zz);
    let mut result = [[0.0; 4]; 4];
    for i in 0..3 {
        for j in 0..3 {
            let spread = if i == j { half_trace } else { 0.0 } - inertia[i][j];
            result[i][j] = spread + mass * (place[i] * place[j]);
        }
        result[i][3] = mass * place[i];
        result[3][i] = mass * place[i];
    }
    result[3][3] = mass;
    result
}

/// The shape of the space that mass lies in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// For which the conditions are exact.
    Ellipsoid,
    /// For which they are necessary: they refuse no body that is in it.
    Box,
}

impl Shape {
    /// The shape of a name.
    ///
    /// # Errors
    /// There is none of this name.
    pub fn named(name: &str) -> Result<Self, ImpactError> {
        match name {
            "ellipsoid" => Ok(Self::Ellipsoid),
            "box" => Ok(Self::Box),
            _ => Err(ImpactError::new("shape", "must be ellipsoid or box")),
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Ellipsoid => "ellipsoid",
            Self::Box => "box",
        }
    }
}

/// A condition trace(J Q) >= 0 that mass in a volume meets.
#[derive(Clone, Debug)]
pub struct QuadraticForm {
    /// What is wrong where it is not met.
    pub words: String,
    /// Q; without a unit.
    pub matrix: Matrix,
}

/// The space that mass lies in.
#[derive(Clone, Copy, Debug)]
pub struct Volume {
    /// Its shape.
    pub shape: Shape,
    /// Its centre, seen from the face centre [m].
    pub centre: [f64; 3],
    /// From face to back, from sole to crown, from heel to toe [m].
    pub size: [f64; 3],
}

impl Volume {
    /// A volume, whose sizes are above 0.
    ///
    /// # Errors
    /// A size is not above 0, or a number is not finite.
    pub fn new(shape: Shape, centre: [f64; 3], size: [f64; 3]) -> Result<Self, ImpactError> {
        let fine = |&each: &f64| each > 0.0 && each.is_finite();
        if !size.iter().all(fine) || !centre.iter().all(|each| each.is_finite()) {
            return Err(ImpactError::new("size", "must be above 0 along x, y and z"));
        }
        Ok(Self { shape, centre, size })
    }

    /// The conditions that mass within it meets.
    #[must_use]
    pub fn forms(&self) -> Vec<QuadraticForm> {
        // Rows that give (x - centre) / half, the place as a part of the way from the centre to the surface.
        let part: [[f64; 4]; 3] = core::array::from_fn(|axis| {
            let half = 0.5 * self.size[axis];
            let mut row = [0.0; 4];
            row[axis] = 1.0 / half;
            row[3] = -self.centre[axis] / half;
            row
        });
        let one = [0.0, 0.0, 0.0, 1.0];
        let whole = outer(&one, &one);
        if self.shape == Shape::Ellipsoid {
            let inside = part.iter().fold(whole, |sum, row| add(&sum, &outer(row, row), -1.0));
            let words = "it would have to lie outside the ellipsoid".to_owned();
            return vec![QuadraticForm { words, matrix: inside }];
        }
        let mut result: Vec<QuadraticForm> = ["face and back", "sole and crown", "heel and toe"]
            .iter()
            .zip(&part)
            .map(|(name, row)| QuadraticForm {
                words: format!("it would have to lie beyond {name} of the box"),
                matrix: add(&whole, &outer(row, row), -1.0),
            })
            .collect();
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            for (first, second) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                let from_side = |row: &[f64; 4], sign: f64| core::array::from_fn(|k| one[k] - sign * row[k]);
                let corner = outer(&from_side(&part[i], first), &from_side(&part[j], second));
                let matrix =
                    core::array::from_fn(|r| core::array::from_fn(|c| 0.5 * (corner[r][c] + corner[c][r])));
                let words = "it would have to lie beyond an edge of the box".to_owned();
                result.push(QuadraticForm { words, matrix });
            }
        }
        result
    }
}

/// One condition that a head meets or misses.
#[derive(Clone, Debug)]
pub struct Margin {
    /// What must be positive: of the head or of the discretionary mass.
    pub name: String,
    /// How much it is, without a unit; below 0 no such body exists.
    pub value: f64,
    /// What is wrong where it is below 0.
    pub reason: String,
}

/// What a head may be: a volume, a fixed shell in it, and mass that may be placed in it.
#[derive(Clone, Debug)]
pub struct Envelope {
    volume: Volume,
    whole: Volume,
    forms: Vec<QuadraticForm>,
    whole_forms: Vec<QuadraticForm>,
    shell: Matrix,
    budget: Option<f64>,
}

impl Envelope {
    /// What a head may be.
    ///
    /// * `volume`: where mass may be placed; `whole`: where the whole head is.
    /// * `shell`: pseudo-inertia of what cannot be moved.
    /// * `budget`: the most mass that may be placed freely [kg]; None where it is all that the shell leaves.
    ///
    /// # Errors
    /// The budget is not above 0.
    pub fn new(
        volume: Volume,
        whole: Volume,
        shell: Matrix,
        budget: Option<f64>,
    ) -> Result<Self, ImpactError> {
        if budget.is_some_and(|budget| budget.is_nan() || budget <= 0.0) {
            return Err(ImpactError::new("budget", "must be above 0 kg"));
        }
        Ok(Self { volume, whole, forms: volume.forms(), whole_forms: whole.forms(), shell, budget })
    }

    /// A head that is made lighter evenly by its `free` mass [kg], which is placed anew in the volume.
    ///
    /// # Errors
    /// The free mass is not between 0 and the mass of the head.
    pub fn lightened(volume: Volume, head: &MassProperties, free: f64) -> Result<Self, ImpactError> {
        if !(free > 0.0 && free < head[0]) {
            return Err(ImpactError::new("free", "must be between 0 and the mass of the head"));
        }
        let part = 1.0 - free / head[0];
        Self::new(volume, volume, pseudo_inertia(head).map(|row| row.map(|each| each * part)), None)
    }

    fn placed(&self, pseudo: &Matrix) -> (Matrix, f64) {
        let placed = add(pseudo, &self.shell, -1.0);
        (placed, self.budget.unwrap_or(placed[3][3].max(LEAST_SCALE)))
    }

    fn scale(&self, mass: f64) -> [f64; 4] {
        let [x, y, z] = self.volume.size.map(|each| 2.0 / each / mass.sqrt());
        [x, y, z, 1.0 / mass.sqrt()]
    }

    /// The smallest margin of a head with this pseudo-inertia.
    #[must_use]
    pub fn least(&self, pseudo: &Matrix) -> f64 {
        let (placed, budget) = self.placed(pseudo);
        let own = self.scale(pseudo[3][3].max(LEAST_SCALE));
        let over = self.budget.map_or(f64::INFINITY, |budget| 1.0 - placed[3][3] / budget);
        let least = |forms: &[QuadraticForm], moments: &Matrix, mass: f64| {
            forms.iter().map(|form| product(moments, &form.matrix) / mass).fold(f64::INFINITY, f64::min)
        };
        smallest(&scaled(pseudo, &own))
            .0
            .min(least(&self.whole_forms, pseudo, pseudo[3][3]))
            .min(smallest(&scaled(&placed, &self.scale(budget))).0)
            .min(least(&self.forms, &placed, budget))
            .min(over)
    }

    /// All conditions on a head with this pseudo-inertia.
    #[must_use]
    pub fn margins(&self, pseudo: &Matrix) -> Vec<Margin> {
        let (placed, budget) = self.placed(pseudo);
        let (head, rest) = ("the head", "the discretionary mass");
        let mut result =
            vec![positive("the mass of the head", pseudo, &self.scale(pseudo[3][3].max(LEAST_SCALE)))];
        inside(&mut result, head, pseudo, self.whole.shape, &self.whole_forms, pseudo[3][3]);
        result.push(positive(rest, &placed, &self.scale(budget)));
        inside(&mut result, rest, &placed, self.volume.shape, &self.forms, budget);
        if let Some(budget) = self.budget {
            let reason = format!(
                "it would need {:.1} g of discretionary mass, and the budget is {:.1} g",
                placed[3][3] * 1e3,
                budget * 1e3
            );
            let name = "the budget of discretionary mass".to_owned();
            result.push(Margin { name, value: 1.0 - placed[3][3] / budget, reason });
        }
        result
    }
}

/// Whether moments are those of mass that is nowhere negative.
fn positive(name: &str, pseudo: &Matrix, scale: &[f64; 4]) -> Margin {
    let (value, vector) = smallest(&scaled(pseudo, scale));
    let vector = core::array::from_fn(|i| vector[i] * scale[i]);
    let plane = describe_plane(pseudo, &vector);
    let reason = format!("no distribution of mass has these moments of {name}: {plane}");
    Margin { name: format!("{name} is nowhere negative"), value, reason }
}

/// Says which plane has a negative mean squared distance, or that the mass itself is negative.
fn describe_plane(pseudo: &Matrix, vector: &[f64; 4]) -> String {
    if pseudo[3][3] <= 0.0 {
        return format!("its mass would be {:.1} g", pseudo[3][3] * 1e3);
    }
    let length = vector[..3].iter().map(|each| each * each).sum::<f64>().sqrt();
    if length < 1e-12 {
        return "its mass would not be positive".to_owned();
    }
    let [x, y, z] = core::array::from_fn(|i| vector[i] / length);
    let second = product(pseudo, &outer(vector, vector)) / (length * length);
    format!(
        "the second moment of its mass along the direction ({x:.2}, {y:.2}, {z:.2}) would be {:.1} g cm2, and mass times a \
         squared distance is never negative",
        second * 1e7
    )
}

/// Adds whether moments are those of mass within a volume, in parts of a `mass` [kg].
fn inside(
    result: &mut Vec<Margin>,
    body: &str,
    pseudo: &Matrix,
    shape: Shape,
    forms: &[QuadraticForm],
    mass: f64,
) {
    let shape = shape.name();
    result.extend(forms.iter().map(|form| Margin {
        name: format!("{body} fits into the {shape}"),
        value: product(pseudo, &form.matrix) / mass,
        reason: format!("{body} does not fit into the {shape}: {}", form.words),
    }));
}

fn outer(one: &[f64; 4], other: &[f64; 4]) -> Matrix {
    one.map(|row| other.map(|column| row * column))
}

fn add(one: &Matrix, other: &Matrix, factor: f64) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| one[i][j] + factor * other[i][j]))
}

/// The trace of the product of two symmetric matrices.
fn product(one: &Matrix, other: &Matrix) -> f64 {
    one.as_flattened().iter().zip(other.as_flattened()).map(|(a, b)| a * b).sum()
}

fn scaled(matrix: &Matrix, scale: &[f64; 4]) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| matrix[i][j] * (scale[i] * scale[j])))
}

/// The smallest eigenvalue of a symmetric matrix and its vector, by the rotations of Jacobi (1846).
fn smallest(matrix: &Matrix) -> (f64, [f64; 4]) {
    const SWEEPS: usize = 30;
    let mut a = *matrix;
    let mut vectors: Matrix = core::array::from_fn(|i| core::array::from_fn(|j| f64::from(u8::from(i == j))));
    for _ in 0..SWEEPS {
        let off: f64 = (0..4).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| a[i][j] * a[i][j]).sum();
        let diagonal: f64 = (0..4).map(|i| a[i][i] * a[i][i]).sum();
        if off <= f64::EPSILON * f64::EPSILON * diagonal || off.is_nan() {
            break;
        }
        for p in 0..3 {
            for q in p + 1..4 {
                if a[p][q] == 0.0 {
                    continue;
                }
                let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let tangent = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
                let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
                let sine = tangent * cosine;
                for k in 0..4 {
                    (a[k][p], a[k][q]) =
                        (cosine * a[k][p] - sine * a[k][q], sine * a[k][p] + cosine * a[k][q]);
                }
                for k in 0..4 {
                    (a[p][k], a[q][k]) =
                        (cosine * a[p][k] - sine * a[q][k], sine * a[p][k] + cosine * a[q][k]);
                    (vectors[k][p], vectors[k][q]) = (
                        cosine * vectors[k][p] - sine * vectors[k][q],
                        sine * vectors[k][p] + cosine * vectors[k][q],
                    );
                }
            }
        }
    }
    let place = (1..4).fold(0, |best, i| if a[i][i] < a[best][best] { i } else { best });
    (a[place][place], vectors.map(|row| row[place]))
}
