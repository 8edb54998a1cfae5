//! An energy of the change of volume that a file writes down, U(J), such as `bulk/4*(J^2 - 1 - 2*log(J))`, in the place
//! of `bulk/2*(J - 1)^2`, with any law of the change of shape.

use super::graph::{Graph, Id, MOST_PARTS};
use super::parse::{Names, Parsed, parse};
use super::program::Program;
use crate::error::FemError;
use clubface_math::Scalar;

/// Changes of volume at which the material must resist more of it: elements of a ball stay within them.
pub const VOLUMES: (f64, f64) = (0.8, 1.25);
/// Steps of the scan over them.
const STEPS: usize = 45;
/// What at rest is rounding, over the bulk modulus.
const ROUNDING: f64 = 1e-9;

/// An energy of the change of volume per unit reference volume, U(J), with the bulk modulus `bulk`.
#[derive(Clone, Debug)]
pub struct Volumetric {
    text: String,
    pub(super) graph: Graph,
    whole: Id,
    slope: Id,
    curvature: Id,
    /// Of dU/dJ.
    pub(super) stress: Program<1>,
    /// Of U.
    pub(super) energy: Program<1>,
}

impl Volumetric {
    /// Reads an energy and checks it.
    ///
    /// # Errors
    /// [`FemError::Input`] that says at which character what is wrong, or what it is not at rest.
    pub fn new(text: &str) -> Result<Self, FemError> {
        let Parsed { mut graph, whole, constants: _ } = parse(text, Names::Volume)?;
        let slope = graph.derivative(whole, 0);
        let curvature = graph.derivative(slope, 0);
        if graph.full() {
            let allowed =
                format!("with its derivatives it has more than {MOST_PARTS} parts; write it shorter");
            return Err(FemError::input("volumetric", format!("{text:?}"), allowed));
        }
        let (stress, energy) = (Program::new(&graph, [slope]), Program::new(&graph, [whole]));
        let read = Self { text: text.to_owned(), graph, whole, slope, curvature, stress, energy };
        read.check()?;
        Ok(read)
    }
    /// As it was written.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }
    /// U (J/m3), dU/dJ and its second derivative (Pa) at a ratio of volumes.
    pub fn evaluate<S: Scalar>(&self, bulk: S, ratio: S) -> [S; 3] {
        let values = self.graph.values(self.graph.parts().len() - 1, &[bulk], [ratio; 2]);
        [self.whole, self.slope, self.curvature].map(|part| values[part])
    }

    fn check(&self) -> Result<(), FemError> {
        let refused = |what: String, allowed: &str| {
            Err(FemError::input("volumetric", format!("{:?}{what}", self.text), allowed))
        };
        let [energy, slope, curvature] = self.evaluate(1.0, 1.0);
        if ![energy, slope, curvature].iter().all(|each| each.is_finite()) {
            return refused(
                String::new(),
                "it must be finite at rest, where J is 1, as must its derivatives",
            );
        }
        if energy.abs() > ROUNDING || slope.abs() > ROUNDING {
            let what = format!(", which is {energy:.6} bulk at rest with a pressure of {:.6} bulk", -slope);
            return refused(what, "it must be zero at rest, where J is 1, and without pressure");
        }
        if (curvature - 1.0).abs() > ROUNDING {
            let what = format!(" with a bulk modulus of {curvature:.6} bulk at rest");
            return refused(what, "it must be one whose second derivative at rest is bulk");
        }
        for step in 0..=STEPS {
            let ratio = VOLUMES.0 + (VOLUMES.1 - VOLUMES.0) * step as f64 / STEPS as f64;
            let [at, twice] = [1.0, 2.0].map(|bulk| self.evaluate(bulk, ratio));
            if !(at[2] > 0.0 && at[2].is_finite()) {
                let what = format!(", which loses its stiffness where J is {ratio:.3}");
                return refused(
                    what,
                    "it must be stiff from 0.8 to 1.25, with a second derivative above zero",
                );
            }
            if (twice[1] - 2.0 * at[1]).abs() > ROUNDING {
                return refused(String::new(), "it must be in proportion to bulk");
            }
        }
        Ok(())
    }
}
