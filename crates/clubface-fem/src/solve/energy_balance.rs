//! The energy balance of a run, which shows whether its results can be trusted.

use super::recorder::{BallState, Recorder};
use super::records::EnergyRecord;
use super::{Options, Simulation};
use crate::error::FemError;
use clubface_math::Real;

/// Largest error of the energy balance over the initial kinetic energy.
const TOLERANCE: f64 = 0.01;

impl Recorder {
    /// Whether the ball has more energy than there was in all at the start. Then elements are failing, and it is time
    /// to find out which while it can still be seen.
    pub(super) fn ball_gains_energy<R>(&self, ball: &BallState<R>) -> bool {
        let all = self.records.energy.first().map_or(f64::INFINITY, EnergyRecord::total);
        ball.kinetic_energy > all * (1.0 + TOLERANCE) || ball.kinetic_energy.is_nan()
    }

    /// Takes a step with a motion record and an energy record.
    ///
    /// # Errors
    /// [`FemError::ElementLost`] where the volume of an element has left the range of its law, [`FemError::Energy`]
    /// where the balance is off.
    pub(super) fn step_with_balance<R: Real>(
        &mut self,
        simulation: &mut Simulation<R>,
        ball: BallState<R>,
        options: &Options,
    ) -> Result<(), FemError> {
        let (time, microseconds) = (self.time(), self.time() * 1e6);
        let (elements, ratios, kinetic) =
            self.take_steps(simulation, ball, options, |structure, contact, dt, observer| {
                structure.step_with_energies(contact, dt, observer)
            });
        simulation.check_volumes(&ratios, microseconds)?;
        let contact = simulation.contact.energy();
        let record = EnergyRecord {
            time,
            kinetic: kinetic + contact.bodies,
            elements,
            contact: contact.stored,
            friction: contact.friction,
            damping: contact.damping,
        };
        let first = *self.records.energy.first().unwrap_or(&record);
        let error = (record.total() - first.total()).abs() / first.kinetic;
        if error > TOLERANCE || error.is_nan() {
            let (element, part) = simulation.most_strained();
            let edge = simulation.contact.passed_edge();
            return Err(FemError::Energy { element, part, percent: error * 100.0, edge, microseconds });
        }
        self.records.energy.push(record);
        Ok(())
    }
}
