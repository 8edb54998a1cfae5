//! Everything that can be computed, described for other languages: quantities, units, models, inputs and outputs.

use crate::description::{Bounds, ModelInfo};
use crate::flight::{self, FlightInput, SHOT_SHAPES, ShotShapes};
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
    /// The shapes of shots and the limits between them.
    pub shot_shapes: &'static ShotShapes,
}

/// An output: name, unit, and meaning with the sign.
pub struct Output(&'static Quantity);

impl Tables {
    /// All of them.
    #[must_use]
    pub fn all() -> Self {
        Self {
            quantities: QUANTITIES,
            units: UNITS,
            dimensions: DIMENSIONS,
            models: registry::ALL.iter().map(|model| model.info()).collect(),
            inputs: &INPUTS,
            outputs: OUTPUTS.iter().copied().map(Output).collect(),
            flight_inputs: &flight::INPUTS,
            flight_outputs: flight::OUTPUTS.iter().copied().map(Output).collect(),
            shot_shapes: &SHOT_SHAPES,
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

fn bounds<F: SerializeStruct>(fields: &mut F, allowed: Bounds) -> Result<(), F::Error> {
    fields.serialize_field("lower", &allowed.lower)?;
    fields.serialize_field("upper", &allowed.upper)
}

fn usual<F: SerializeStruct>(fields: &mut F, usual: Option<Bounds>) -> Result<(), F::Error> {
    fields.serialize_field("usual", &usual.map(|each| (each.lower, each.upper)))
}

impl Serialize for Output {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        column(self.0, 0, serializer)?.end()
    }
}

impl Serialize for Input {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = column(self.quantity, 6, serializer)?;
        fields.serialize_field("group", self.group)?;
        fields.serialize_field("differentiable", &self.differentiable)?;
        bounds(&mut fields, self.bounds)?;
        fields.serialize_field("half_of", &self.half_of)?;
        usual(&mut fields, self.usual)?;
        fields.end()
    }
}

impl Serialize for FlightInput {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = column(self.quantity, 5, serializer)?;
        fields.serialize_field("group", self.group)?;
        fields.serialize_field("default", &self.default)?;
        bounds(&mut fields, self.bounds)?;
        usual(&mut fields, self.usual)?;
        fields.end()
    }
}
