//! Everything that can be computed, described for other languages: quantities, units, models, inputs and outputs.

use crate::description::ModelInfo;
use crate::flight::{self, FlightInput};
use crate::launch::OUTPUTS;
use crate::quantity::{QUANTITIES, Quantity};
use crate::registry;
use crate::shot::{INPUTS, Input};
use crate::unit::{DIMENSIONS, Dimension, UNITS, Unit};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// The tables of the core.
#[derive(Serialize)]
pub struct Tables {
    /// Every quantity.
    pub quantities: &'static [Quantity],
    /// Every unit.
    pub units: &'static [Unit],
    /// Every dimension.
    pub dimensions: &'static [Dimension],
    /// Every impact model.
    pub models: Vec<&'static ModelInfo>,
    /// Inputs of an impact, in the order of the columns.
    pub inputs: &'static [Input],
    /// Outputs of an impact, in order.
    pub outputs: Vec<Output>,
    /// Inputs of a flight, in order.
    pub flight_inputs: &'static [FlightInput],
    /// Outputs of a flight, in order.
    pub flight_outputs: Vec<Output>,
}

/// An output: name, unit, and meaning with the sign.
pub struct Output(&'static Quantity);

impl Tables {
    /// All of them.
    #[must_use]
    pub fn all() -> Self {
        Self {
            quantities: &QUANTITIES,
            units: UNITS,
            dimensions: DIMENSIONS,
            models: registry::ALL.iter().map(|model| model.info()).collect(),
            inputs: &INPUTS,
            outputs: OUTPUTS.iter().copied().map(Output).collect(),
            flight_inputs: &flight::INPUTS,
            flight_outputs: flight::OUTPUTS.iter().copied().map(Output).collect(),
        }
    }
}

/// Begins the description of a column by what it says of its quantity.
fn column<S: Serializer>(
    quantity: &Quantity,
    more: usize,
    serializer: S,
) -> Result<S::SerializeStruct, S::Error> {
    let mut fields = serializer.serialize_struct("Column", 3 + more)?;
    fields.serialize_field("name", quantity.name)?;
    fields.serialize_field("unit", quantity.unit)?;
    fields.serialize_field("meaning", &quantity.description())?;
    Ok(fields)
}

impl Serialize for Output {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        column(self.0, 0, serializer)?.end()
    }
}

impl Serialize for Input {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = column(self.quantity, 2, serializer)?;
        fields.serialize_field("group", self.group)?;
        fields.serialize_field("differentiable", &self.differentiable)?;
        fields.end()
    }
}

impl Serialize for FlightInput {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = column(self.quantity, 4, serializer)?;
        fields.serialize_field("group", self.group)?;
        fields.serialize_field("default", &self.default)?;
        fields.serialize_field("lower", &self.bounds.lower)?;
        fields.serialize_field("upper", &self.bounds.upper)?;
        fields.end()
    }
}
