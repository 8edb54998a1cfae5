//! A law that a file writes down as an energy of the first two invariants, such as `c10*(I1-3) + c20*(I1-3)^2`.
//!
//! It is read, differentiated and turned into a list of operations on packs; nothing of it is compiled, and nothing
//! is run as a program. The stress is that of any law of the invariants, so that it turns with the body, whatever the
//! energy.

mod check;
mod graph;
mod law;
mod parse;
mod program;
mod volume;
mod volume_law;

pub use check::{Instability, STRETCHES};
pub use law::EnergyLaw;
pub use volume::{VOLUMES, Volumetric};
pub use volume_law::VolumeLaw;

use crate::error::FemError;
use graph::{Graph, Id};
use program::Program;

/// An energy of the change of shape per unit reference volume, W(I1, I2), over no number in particular.
///
/// The invariants are those of `C̄ = J^(-2/3) F^T F`, `I1 = tr C̄` and `I2 = tr C̄^-1`, both 3 at rest.
#[derive(Clone, Debug)]
pub struct Energy {
    text: String,
    constants: Vec<String>,
    graph: Graph,
    whole: Id,
    /// Its derivatives by the invariants.
    slopes: [Id; 2],
    /// Its second derivatives: twice by the first, by both, twice by the second.
    curvatures: [Id; 3],
    /// Factors of the identity and of `C̄` in `2 dW/dC̄`.
    stress: Program<2>,
    energy: Program<1>,
}

impl Energy {
    /// Reads an energy.
    ///
    /// # Errors
    /// [`FemError::Input`] that says at which character what is wrong.
    pub fn new(text: &str) -> Result<Self, FemError> {
        let parse::Parsed { mut graph, whole, constants } = parse::parse(text, parse::Names::Shape)?;
        let slopes = [graph.derivative(whole, 0), graph.derivative(whole, 1)];
        let curvatures =
            [graph.derivative(slopes[0], 0), graph.derivative(slopes[0], 1), graph.derivative(slopes[1], 1)];
        // 2 dW/dC̄ = 2 (W1 + W2 I1) - 2 W2 C̄.
        let (two, first) = (graph.number(2.0), graph.invariant(0));
        let twice = slopes.map(|slope| graph.product(two, slope));
        let second = graph.product(twice[1], first);
        let (one, along) = (graph.sum(twice[0], second), graph.negative(twice[1]));
        if graph.full() {
            let allowed = format!(
                "with its derivatives it has more than {} parts; write it shorter",
                graph::MOST_PARTS
            );
            return Err(FemError::input("energy", format!("{text:?}"), allowed));
        }
        let (stress, energy) = (Program::new(&graph, [one, along]), Program::new(&graph, [whole]));
        Ok(Self { text: text.to_owned(), constants, graph, whole, slopes, curvatures, stress, energy })
    }
    /// As it was written.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }
    /// Names of its constants, in the order in which they come in it.
    #[must_use]
    pub fn constants(&self) -> &[String] {
        &self.constants
    }
}
