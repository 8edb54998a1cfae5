//! Impacts and the flights that follow them, quantity by quantity.

use crate::slices;
use clubface_impact::batch::Batch;
use clubface_impact::columns::{Column, Reject};
use clubface_impact::flight::{self, FlightBatch};
use clubface_impact::launch::OUTPUTS;
use clubface_impact::quantity::Quantity;
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::{Accuracy, ImpactModel};

/// What the shots of a batch have in common.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShotBatch<'a> {
    /// What computes the impacts, and the values of its parameters.
    pub(crate) model: ImpactModel,
    pub(crate) parameters: &'a [f64],
    /// Accuracy of contact models.
    pub(crate) accuracy: Accuracy,
    /// Inputs of the flight, of which the launch is replaced.
    pub(crate) flight: &'a [f64; flight::INPUT_COUNT],
}

impl ShotBatch<'_> {
    /// Computes as many shots as `columns` have rows, and writes the quantities of these names, a column each. Nothing is
    /// flown where the launch has them all. Returned are the shots without a result, which are NaN.
    pub(crate) fn run(
        &self,
        inputs: &[Column<'_>; INPUT_COUNT],
        names: impl Iterator<Item = &'static str> + Clone,
        columns: Vec<&mut [f64]>,
    ) -> Vec<Reject> {
        let rows = columns[0].len();
        let room = |count: usize| vec![vec![0.0; rows]; count];
        let parameters: Vec<Column> = self.parameters.iter().map(|&value| Column::Constant(value)).collect();
        let batch = Batch { model: self.model, inputs, parameters: &parameters, accuracy: self.accuracy };
        let mut launches = room(OUTPUTS.len());
        let mut rejects = batch.run(0..rows, slices(&mut launches));

        let mut flights = Vec::new();
        if names.clone().any(|name| place_of(&OUTPUTS, name).is_none()) {
            let mut inputs = self.flight.map(Column::Constant);
            for (input, described) in inputs.iter_mut().zip(&flight::INPUTS) {
                if let Some(place) = place_of(&OUTPUTS, described.quantity.name) {
                    *input = Column::Values(&launches[place]);
                }
            }
            flights = room(flight::OUTPUTS.len());
            rejects.extend(FlightBatch { inputs: &inputs }.run(0..rows, slices(&mut flights)));
        }
        for (name, column) in names.zip(columns) {
            let launched = place_of(&OUTPUTS, name).map(|place| &launches[place]);
            if let Some(values) = launched.or_else(|| flights.get(place_of(&flight::OUTPUTS, name)?)) {
                column.copy_from_slice(values);
            }
        }
        rejects
    }
}

fn place_of(outputs: &[&Quantity], name: &str) -> Option<usize> {
    outputs.iter().position(|output| output.name == name)
}
