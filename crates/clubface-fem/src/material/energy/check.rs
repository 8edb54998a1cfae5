//! Checks of an energy: what it is at rest, and whether it keeps its stiffness where elements are stretched.

use super::Energy;
use crate::error::FemError;
use clubface_math::Scalar;

/// Stretches of the elements of a ball in hard impacts, with room on both sides.
pub const STRETCHES: (f64, f64) = (0.5, 2.0);
/// Steps of the scan from rest to either end.
const STEPS: usize = 50;
/// How much energy at rest is rounding, over the shear modulus.
const ROUNDING: f64 = 1e-9;

/// Where an energy loses its stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instability {
    /// The kind of stretch: "tension", "compression" or "plane tension".
    pub mode: &'static str,
    /// The stretch next to rest at which it is lost.
    pub stretch: f64,
    /// Whether the energy is no number there.
    pub undefined: bool,
}

/// Ways to stretch a material that keeps its volume: exponents of the stretch along the three axes, and how far. Equal
/// tension both ways is compression along the third axis.
const MODES: [(&str, [f64; 3], f64); 3] = [
    ("tension", [1.0, -0.5, -0.5], STRETCHES.1),
    ("compression", [1.0, -0.5, -0.5], STRETCHES.0),
    ("plane tension", [1.0, 0.0, -1.0], STRETCHES.1),
];

impl Energy {
    /// At some invariants: the energy W (J/m3), its derivatives by the first and the second (Pa), and its second
    /// derivatives: twice by the first, by both, twice by the second (Pa).
    pub fn evaluate<S: Scalar>(&self, constants: &[S], invariants: [S; 2]) -> (S, [S; 2], [S; 3]) {
        let values = self.graph.values(self.last(), constants, invariants);
        (values[self.whole], self.slopes.map(|s| values[s]), self.curvatures.map(|c| values[c]))
    }

    /// Checks the constants and the energy at rest; messages call the material `name`.
    ///
    /// # Errors
    /// [`FemError::Input`] that says what is wrong.
    pub fn check(&self, constants: &[f64], name: &str) -> Result<(), FemError> {
        for (constant, value) in self.constants.iter().zip(constants) {
            if !value.is_finite() {
                return Err(FemError::input(format!("{constant} of {name}"), value, "it must be finite"));
            }
        }
        let refused =
            |value: String, allowed: &str| Err(FemError::input(format!("energy of {name}"), value, allowed));
        let shown = format!("{:?}", self.text);
        let (energy, slopes, _) = self.evaluate(constants, [3.0; 2]);
        if !energy.is_finite() || slopes.iter().any(|slope| !slope.is_finite()) {
            let allowed = "it must be finite at rest, where I1 and I2 are 3, as must its derivatives";
            return refused(shown, allowed);
        }
        let shear = self.shear(constants);
        if !(shear > 0.0 && shear.is_finite()) {
            let value = format!("{shown} with a shear modulus of {shear} Pa");
            let allowed = "it must be stiff at rest: its shear modulus is 2 (dW/dI1 + dW/dI2)";
            return refused(value, allowed);
        }
        if energy.abs() > ROUNDING * shear {
            let value = format!("{shown}, which is {energy:.6e} J/m3 at rest");
            let allowed = "it must be zero at rest, where I1 and I2 are 3: use (I1 - 3) and (I2 - 3)";
            return refused(value, allowed);
        }
        Ok(())
    }

    /// Where the material loses its stiffness within [`STRETCHES`], if anywhere: where some change of shape needs no
    /// more stress (Drucker's criterion in logarithmic strains and Kirchhoff stresses, which are conjugate to each other).
    #[must_use]
    pub fn instability(&self, constants: &[f64]) -> Option<Instability> {
        let mut nearest: Option<Instability> = None;
        for (mode, exponents, end) in MODES {
            for step in 0..=STEPS {
                let stretch = end.powf(step as f64 / STEPS as f64);
                let (energy, hessian) =
                    self.hessian(constants, exponents.map(|exponent| exponent * stretch.ln()));
                let [xx, xy, yy] = hessian;
                let undefined = !energy.is_finite() || hessian.iter().any(|h| !h.is_finite());
                if undefined || !(xx > 0.0 && xx * yy > xy * xy) {
                    if nearest.is_none_or(|other| stretch.ln().abs() < other.stretch.ln().abs()) {
                        nearest = Some(Instability { mode, stretch, undefined });
                    }
                    break;
                }
            }
        }
        nearest
    }

    /// W and its second derivatives by the first two of three logarithmic principal strains whose sum is zero.
    fn hessian(&self, constants: &[f64], strains: [f64; 3]) -> (f64, [f64; 3]) {
        let squares = strains.map(|strain| (2.0 * strain).exp());
        let inverses = squares.map(|square| 1.0 / square);
        let sum = |values: [f64; 3]| values.iter().sum::<f64>();
        let (energy, [first, second], [w11, w12, w22]) =
            self.evaluate(constants, [sum(squares), sum(inverses)]);
        // The third strain is minus the other two: d/dh1 of sum exp(2 h) is 2 (e1 - e3).
        let slope = |values: [f64; 3], i: usize| 2.0 * (values[i] - values[2]);
        let [one, other] =
            [squares, inverses.map(|value| -value)].map(|values| [slope(values, 0), slope(values, 1)]);
        let curvature =
            |values: [f64; 3], i: usize, j: usize| 4.0 * (if i == j { values[i] } else { 0.0 } + values[2]);
        let hessian = [(0, 0), (0, 1), (1, 1)].map(|(i, j)| {
            w11 * one[i] * one[j]
                + w12 * (one[i] * other[j] + other[i] * one[j])
                + w22 * other[i] * other[j]
                + first * curvature(squares, i, j)
                + second * curvature(inverses, i, j)
        });
        (energy, hessian)
    }
}
