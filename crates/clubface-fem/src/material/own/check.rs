//! Checks of a function of C: what it gives at rest, its stiffness, and whether its stress belongs to its energy.

use super::function::{ENERGY, SHAPES};
use super::law::OwnLaw;
use super::number::Points;
use crate::error::FemError;
use crate::material::symmetric::Symmetric;
use crate::material::table::Number;

/// What of stress and energy at rest is rounding, over the shear modulus.
const ROUNDING: f64 = 1e-9;
/// Strain of the differences that the shear modulus is found by.
const STRAIN: f64 = 1e-3;
/// Largest difference of the stress from the slope of the energy, over the shear modulus.
const SLOPE: f64 = 1e-5;
/// Rows of the two axes of each component.
const AXES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Changes of shape that keep the volume: shears in the three planes, and tension along an axis that is compression
/// along the next. `C̄ = exp(2 strain N)` and its derivative by the strain.
fn shape(mode: usize, strain: f64) -> [Symmetric<f64>; 2] {
    let axis = mode % 3;
    let (next, shear) = ((axis + 1) % 3, [3, 5, 4][axis]);
    let [mut c, mut slope] = [Symmetric::diagonal(1.0), Symmetric::diagonal(0.0)];
    if mode < 3 {
        for along in [axis, next] {
            (c.0[along], slope.0[along]) = ((2.0 * strain).cosh(), 2.0 * (2.0 * strain).sinh());
        }
        (c.0[shear], slope.0[shear]) = ((2.0 * strain).sinh(), 2.0 * (2.0 * strain).cosh());
    } else {
        for (along, sign) in [(axis, 2.0), (next, -2.0)] {
            (c.0[along], slope.0[along]) = ((sign * strain).exp(), sign * (sign * strain).exp());
        }
    }
    [c, slope]
}

/// Turned about all axes, so that no component is zero; and the same of its derivative.
fn turned(tensor: &Symmetric<f64>) -> Symmetric<f64> {
    let (s, c) = (0.6, 0.8);
    let mut rows = [[0.0; 3]; 3];
    for (component, (i, j)) in AXES.into_iter().enumerate() {
        (rows[i][j], rows[j][i]) = (tensor.0[component], tensor.0[component]);
    }
    for (i, j) in [(0, 1), (1, 2), (0, 2)] {
        let mut turn = [[0.0; 3]; 3];
        (0..3).for_each(|k| turn[k][k] = 1.0);
        (turn[i][i], turn[j][j], turn[i][j], turn[j][i]) = (c, c, -s, s);
        let product = |a: [[f64; 3]; 3], b: [[f64; 3]; 3], across: bool| -> [[f64; 3]; 3] {
            std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    (0..3).map(|k| a[i][k] * if across { b[j][k] } else { b[k][j] }).sum::<f64>()
                })
            })
        };
        rows = product(product(turn, rows, false), turn, true);
    }
    Symmetric(AXES.map(|(i, j)| rows[i][j]))
}

impl<R: Number> OwnLaw<R> {
    /// Stress and energies at some changes of shape, from no deformation in no time.
    fn results(&self, shapes: &[Symmetric<f64>]) -> Points<R> {
        let mut points = Points { count: 0, shapes: vec![], states: vec![], results: vec![] };
        let count = shapes.len();
        points.resize(count, self.function.states.len(), R::zero());
        for (point, shape) in shapes.iter().enumerate() {
            for row in 0..SHAPES {
                points.shapes[row * count + point] = R::from_f64(shape.0[row]);
            }
        }
        R::call(&mut points, &self.function, &self.constants, 0.0);
        points
    }
    /// Shear moduli (Pa) of small strains in each way to change the shape, from `4 mu` as the second derivative of the
    /// energy by the strain.
    pub(super) fn shear_moduli(&self) -> Vec<R> {
        let strains = [(1.0, 8.0), (-1.0, -8.0), (2.0, -1.0), (-2.0, 1.0)];
        let modulus = |mode: usize| {
            let at = strains.map(|(steps, _)| shape(mode, steps * STRAIN));
            let points = self.results(&at.map(|[c, _]| c));
            let mut sum = R::zero();
            for (point, (_, weight)) in strains.into_iter().enumerate() {
                sum += power(&points, point, &at[point][1]) * (weight / (4.0 * 12.0 * STRAIN));
            }
            sum
        };
        (0..6).map(modulus).collect()
    }

    /// Checks constants and function; messages call the material `name`.
    pub(super) fn check_values(&self, name: &str) -> Result<(), FemError> {
        let shown = &self.function.name;
        for (constant, value) in self.function.constants.iter().zip(&*self.constants) {
            if !value.re().is_finite() {
                return Err(FemError::input(
                    format!("{constant} of {name}"),
                    value.re(),
                    "it must be finite",
                ));
            }
        }
        let law = format!("law of {name}");
        let refused =
            |what: String, allowed: &str| Err(FemError::input(&*law, format!("{shown} {what}"), allowed));
        // More points than one, so that a function that confuses rows and points is found out.
        let rest = self.results(&[Symmetric::diagonal(1.0); 3]);
        let written = &rest.results[..(ENERGY + 1) * rest.count];
        if written.iter().chain(&rest.states).any(|each| !each.re().is_finite()) {
            let allowed = "it must be a function that writes seven finite numbers a point: six of the stress, and the energy";
            return refused("at rest".to_owned(), allowed);
        }
        let moduli: Vec<f64> = self.shear_moduli().iter().map(|each| each.re()).collect();
        if let Some(modulus) = moduli.iter().find(|&&each| !(each > 0.0 && each.is_finite())) {
            return refused(
                format!("with a shear modulus of {modulus} Pa"),
                "it must be stiff at rest in every direction",
            );
        }
        let shear = moduli.into_iter().fold(0.0, f64::max);
        for point in 0..rest.count {
            let [energy, heat] = [ENERGY, ENERGY + 1].map(|row| rest.results[row * rest.count + point].re());
            if energy.abs().max(heat.abs()) > ROUNDING * shear {
                let what =
                    format!("with an energy of {energy:.6e} J/m3 at rest, and heat of {heat:.6e} J/m3");
                return refused(what, "it must be without both at rest, where C is the identity");
            }
            // A multiple of the identity is a pressure, which is taken out.
            let stress: [f64; 6] = std::array::from_fn(|row| rest.results[row * rest.count + point].re());
            let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
            let largest =
                AXES.iter().zip(stress).map(|((i, j), each)| if i == j { each - mean } else { each });
            let largest = largest.fold(0.0, |most: f64, each| most.max(each.abs()));
            if largest > ROUNDING * shear {
                let what = format!("with a stress of {largest:.6e} Pa at rest");
                return refused(what, "it must be free of stress at rest, but for a pressure");
            }
        }
        self.check_slopes(shear).or_else(|what| {
            refused(what, "it must be one whose stress is 2 dW/dC, in the rows xx, yy, zz, xy, xz, yz")
        })?;
        self.check_turned(shear).or_else(|what| {
            refused(
                what,
                "it must be isotropic: elements hand it their own axes, which differ from one to the next",
            )
        })
    }

    /// Checks that energy and stress are the same for turned changes of shape; says where they are not.
    fn check_turned(&self, shear: f64) -> Result<(), String> {
        for mode in 0..6 {
            let [shape, slope] = shape(mode, STRAINED);
            let points = self.results(&[shape, turned(&shape)]);
            let of_energy = [0, 1].map(|point| points.results[ENERGY * points.count + point].re());
            let of_stress = [power(&points, 0, &slope).re(), power(&points, 1, &turned(&slope)).re()];
            for [one, other] in [of_energy, of_stress] {
                if !agree(one, other, ROUNDING * shear) {
                    return Err(format!(
                        "with {other:.6e} where the axes are turned, and {one:.6e} where they are not"
                    ));
                }
            }
        }
        Ok(())
    }

    /// Checks that the stress is the slope of the energy at changes of shape of 10% in all directions; says where it is
    /// not. Stresses that depend on what has happened before have no such energy.
    fn check_slopes(&self, shear: f64) -> Result<(), String> {
        if !self.function.states.is_empty() {
            return Ok(());
        }
        let step = 1e-4;
        for mode in 0..6 {
            let at = [-step, 0.0, step].map(|more| shape(mode, STRAINED + more).map(|each| turned(&each)));
            let [shapes, slopes] = [0, 1].map(|which| at.map(|each| each[which]));
            let points = self.results(&shapes);
            let energy = |point: usize| points.results[ENERGY * points.count + point].re();
            let (slope, power) = ((energy(2) - energy(0)) / (2.0 * step), power(&points, 1, &slopes[1]).re());
            if !agree(slope, power, SLOPE * shear) {
                let share = power / slope;
                return Err(format!("with a stress that does {share:.6} of the work that its energy gains"));
            }
        }
        Ok(())
    }
}

/// Whether two numbers are as near to each other as that; what is no number is near to none.
fn agree(one: f64, other: f64, within: f64) -> bool {
    (one - other).abs() <= within
}

/// Changes of shape of 10% in all directions.
const STRAINED: f64 = 0.1;

/// Work of the stress at a point on a change of `C̄`, per unit of what changes it: `S : dC̄ / 2`.
fn power<R: Number>(points: &Points<R>, point: usize, slope: &Symmetric<f64>) -> R {
    let mut sum = R::zero();
    for (row, (i, j)) in AXES.into_iter().enumerate() {
        let weight = if i == j { 0.5 } else { 1.0 };
        sum += points.results[row * points.count + point] * (weight * slope.0[row]);
    }
    sum
}
