//! Options of a run.

use crate::contact::ContactMethod;
use crate::error::FemError;

/// Longest simulated time, s.
pub(super) const LONGEST: f64 = 0.1;

/// Options of a run.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Simulated time, s.
    pub duration: f64,
    /// Time step over the stable step of the undeformed structure; none for what impacts usually allow.
    pub safety: Option<f64>,
    /// Interval of the motion frames, s.
    pub interval: f64,
    /// Motion frames an energy frame.
    pub energy_every: usize,
    /// Whether to end soon after the last touch, be it before or after the end of the simulated time.
    pub until_separation: bool,
    /// How nodes are kept out of the other side.
    pub contact: ContactMethod,
    /// Linear bulk viscosity of solid elements over density, speed of waves and their size; 0 for none.
    pub bulk_viscosity: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            duration: 1e-3,
            safety: None,
            interval: 5e-6,
            energy_every: 10,
            until_separation: false,
            contact: ContactMethod::Penalty,
            bulk_viscosity: 0.0,
        }
    }
}

impl Options {
    /// Checks the values.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first value that is not allowed.
    pub fn check(&self) -> Result<(), FemError> {
        if !(self.duration > 0.0 && self.duration <= LONGEST) {
            let allowed = "it must be above 0 and at most 100000 us";
            return Err(FemError::input("duration", format!("{} us", self.duration * 1e6), allowed));
        }
        if let Some(safety) = self.safety.filter(|safety| !(*safety > 0.0 && *safety <= 1.0)) {
            let allowed = "it must be above 0 and at most 1 (the stable step)";
            return Err(FemError::input("safety", safety, allowed));
        }
        if self.interval.is_nan() || self.interval <= 0.0 || self.energy_every == 0 {
            return Err(FemError::input("interval", format!("{} s", self.interval), "it must be above 0"));
        }
        if !(0.0..=1.0).contains(&self.bulk_viscosity) {
            return Err(FemError::input("bulk_viscosity", self.bulk_viscosity, "it must be from 0 to 1"));
        }
        Ok(())
    }
}
