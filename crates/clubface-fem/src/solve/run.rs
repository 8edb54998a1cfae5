//! Running an impact from first touch to launch.

use super::recorder::Recorder;
use super::subcycling::StepSize;
use super::worker_pool::WorkerPool;
use super::{Options, Progress, Records, Simulation, Snapshot};
use crate::error::FemError;
use clubface_impact::first_touch::Motion;
use clubface_math::Real;

/// Result of a run.
#[derive(Clone, Debug)]
pub struct SimulationResult<R> {
    /// Ball after the impact: velocity of the mass centre, and angular momentum over the inertia of the undeformed
    /// ball, which its vibration does not change.
    pub ball: Motion<R>,
    /// Head after the impact.
    pub head: Motion<R>,
    /// Records up to the end of the run.
    pub records: Records,
    /// Why there is no launch, if there is none.
    pub stopped: Option<FemError>,
    /// Whether the ball has reached round the edge of the face, where contact ends.
    pub over_edge: bool,
    /// Time step over the stable step of the undeformed structure, apart from rounding and bulk viscosity.
    pub safety: f64,
    /// Time step, s.
    pub step: f64,
    /// Steps taken.
    pub steps: usize,
    /// Time that the steps took by the clock of the environment, s.
    pub wall: f64,
}

impl<R: Real> Simulation<R> {
    /// Runs the impact. `observer` is called at every motion record, and ends the run by returning false.
    ///
    /// A run that fails returns what it has, with the reason in [`SimulationResult::stopped`].
    ///
    /// # Errors
    /// [`FemError::Input`] for options that are not allowed. Nothing has run then.
    pub fn run(
        &mut self,
        options: &Options,
        observer: &mut dyn FnMut(Snapshot<R>) -> bool,
    ) -> Result<SimulationResult<R>, FemError> {
        options.check()?;
        let size = self.choose_step(options);
        self.run_in_steps(options, size, observer)
    }

    /// As [`Simulation::run`], in steps that have been chosen.
    ///
    /// # Errors
    /// As [`Simulation::run`].
    pub(crate) fn run_in_steps(
        &mut self,
        options: &Options,
        StepSize { safety, dt, period, subcycled }: StepSize,
        observer: &mut dyn FnMut(Snapshot<R>) -> bool,
    ) -> Result<SimulationResult<R>, FemError> {
        options.check()?;
        self.contact.set_method(options.contact);
        self.structure.subcycle(subcycled);
        if options.bulk_viscosity > 0.0 {
            self.structure.set_bulk_viscosity(options.bulk_viscosity);
        }
        let interval = (options.interval / (dt * period as f64)).round().max(1.0) as usize * period;
        self.structure.track_moments(0..self.ball_nodes);
        let start = (self.clock)();
        let mut recorder = Recorder::new(dt);
        // One pool for the whole run: its workers stay awake, with their data at hand.
        let executor = self.structure.executor.clone();
        let stopped = WorkerPool::with(&*executor, |_| {
            loop {
                let time = recorder.time();
                if !recorder.goes_on(options) {
                    break None;
                }
                let ball = recorder.ball_state(self);
                let progress = Progress { time, duration: options.duration.max(time), steps: recorder.step };
                let snapshot = Snapshot { progress, centre: ball.centre, simulation: self };
                if recorder.step.is_multiple_of(interval) && !observer(snapshot) {
                    break Some(FemError::Interrupted { microseconds: time * 1e6 });
                }
                let failing = !self.structure.volumes_valid() || recorder.ball_gains_energy(&ball);
                if failing {
                    let ratios = self.structure.energies().1;
                    if let Err(error) = self.check_volumes(&ratios, time * 1e6) {
                        break Some(error);
                    }
                }
                // Energies are due in a full step, the next one at the latest.
                let due = recorder.step.is_multiple_of(interval * options.energy_every) || failing;
                if due && !self.structure.skip_subcycled {
                    if let Err(error) = recorder.step_with_balance(self, ball, options) {
                        break Some(error);
                    }
                } else {
                    let count = if due { 1 } else { interval - recorder.step % interval };
                    recorder.take_steps(self, ball, options, |structure, contact, dt, observer| {
                        structure.integrate(contact, dt, count, observer)
                    });
                }
            }
        });
        self.structure.synchronise();
        if stopped.as_ref().is_some_and(FemError::failed) {
            recorder.records.truncate();
        }
        let microseconds = recorder.time() * 1e6;
        let missed = recorder.last_contact.is_none().then_some(FemError::Missed { microseconds });
        let unfinished = recorder.records.in_contact().then_some(FemError::Unfinished { microseconds });
        Ok(SimulationResult {
            ball: self.ball_motion(),
            head: self.head_motion(),
            records: recorder.records,
            stopped: stopped.or(missed).or(unfinished),
            over_edge: self.contact.passed_edge(),
            safety,
            step: dt,
            steps: recorder.step,
            wall: (self.clock)() - start,
        })
    }
}
