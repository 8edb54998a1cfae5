//! What a run records, and the quantities that summarise an impact.
//!
//! "Roh and Lee" is W.-J. Roh and C.-W. Lee, "Analysis of golf ball spin mechanism at impact by FEM", KAIST.

use crate::element::Energy;

/// Contact at one step.
#[derive(Clone, Copy, Debug)]
pub struct ContactRecord {
    /// Time since first touch, s.
    pub time: f64,
    /// Force along the face normal, N.
    pub normal: f64,
    /// Force on the ball along the face, N. Down the face is positive since that makes backspin, as with Roh and Lee.
    pub tangential: f64,
    /// Force on the ball towards the toe, N.
    pub toe: f64,
    /// Contact area, m2.
    pub area: f64,
}

/// Motion of the ball at one step.
#[derive(Clone, Copy, Debug)]
pub struct MotionRecord {
    /// Time since first touch, s.
    pub time: f64,
    /// Velocity of the ball's mass centre along the normal, up the face and to the toe, relative to the head at first
    /// touch, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity of the rigid rotation that fits the ball's velocities best, about the same axes, rad/s.
    pub spin: [f64; 3],
    /// Distance of the mass centre from the face, m: R(t) of Roh and Lee.
    pub radius: f64,
}

/// Energies at one step, J.
#[derive(Clone, Copy, Debug)]
pub struct EnergyRecord {
    /// Time since first touch, s.
    pub time: f64,
    /// Kinetic energy of nodes and rigid head.
    pub kinetic: f64,
    /// Energies of the elements.
    pub elements: Energy,
    /// Stored in the contact.
    pub contact: f64,
    /// Turned into heat by friction.
    pub friction: f64,
    /// Turned into heat by the damping of nodes that arrive at the face.
    pub damping: f64,
}

impl EnergyRecord {
    /// Sum of all, J.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.elements.total() + self.contact + self.friction + self.damping
    }
}

/// Everything that a run records.
#[derive(Clone, Debug, Default)]
pub struct Records {
    /// Every step.
    pub contact: Vec<ContactRecord>,
    /// At the sampling interval.
    pub motion: Vec<MotionRecord>,
    /// At a multiple of it.
    pub energy: Vec<EnergyRecord>,
}

/// Quantities that summarise an impact, as Roh and Lee define them.
#[derive(Clone, Copy, Debug)]
pub struct Summary {
    /// Largest normal force, N.
    pub peak_force: f64,
    /// Its time, s.
    pub peak_force_time: f64,
    /// Time of the last contact, s; NaN, as are f' and f, for a ball that is still on the face.
    pub contact_time: f64,
    /// Largest tangential force, N.
    pub tangential_max: f64,
    /// Smallest tangential force, N.
    pub tangential_min: f64,
    /// When the tangential force turns from making spin to taking it, s; NaN if it does not.
    pub reversal_time: f64,
    /// Largest spin about the toe direction (backspin) during the impact, rad/s.
    pub spin_max: f64,
    /// Greatest decrease of the distance from mass centre to face, over the ball's radius.
    pub contraction: f64,
    /// Its time, s.
    pub contraction_time: f64,
    /// f' of their Eq. (9): the integral of F R over R0 times the integral of F, with the tangential force F.
    pub f_prime: f64,
    /// f of their Eq. (11): 7 f' / (5 f' + 2).
    pub f: f64,
    /// Largest error of the energy balance over the initial kinetic energy.
    pub energy_error: f64,
}

impl Records {
    /// Drops what came after the last energy balance that was right: a run that fails has failed somewhere there.
    pub(super) fn truncate(&mut self) {
        let last = self.energy.last().map_or(0.0, |record| record.time);
        self.contact.retain(|record| record.time <= last);
        self.motion.retain(|record| record.time <= last);
    }

    /// Whether the ball is on the face at the end of the records.
    #[must_use]
    pub fn in_contact(&self) -> bool {
        self.contact.last().is_some_and(|last| last.normal > 0.0)
    }

    /// Summary for a ball of the given radius (m).
    #[must_use]
    pub fn summary(&self, radius: f64) -> Summary {
        let peak = self.contact.iter().fold((0.0, 0.0), |best: (f64, f64), record| {
            if record.normal > best.0 { (record.normal, record.time) } else { best }
        });
        let least = self.motion.iter().fold((radius, 0.0), |best: (f64, f64), record| {
            if record.radius < best.0 { (record.radius, record.time) } else { best }
        });
        let fold = |start: f64, pick: fn(f64, f64) -> f64| {
            self.contact.iter().fold(start, |best, record| pick(best, record.tangential))
        };
        let left = !self.in_contact();
        let last = self.contact.iter().rfind(|record| left && record.normal > 0.0);
        let f_prime = if left { self.mean_radius(radius) } else { f64::NAN };
        let start = self.energy.first().map_or(f64::NAN, EnergyRecord::total);
        let kinetic = self.energy.first().map_or(f64::NAN, |record| record.kinetic);
        Summary {
            peak_force: peak.0,
            peak_force_time: peak.1,
            contact_time: last.map_or(f64::NAN, |record| record.time),
            tangential_max: fold(0.0, f64::max),
            tangential_min: fold(0.0, f64::min),
            reversal_time: self.reversal_time(),
            spin_max: self.motion.iter().fold(0.0, |best: f64, record| best.max(record.spin[2])),
            contraction: 1.0 - least.0 / radius,
            contraction_time: least.1,
            f_prime,
            f: 7.0 * f_prime / (5.0 * f_prime + 2.0),
            energy_error: self.energy.iter().map(|e| (e.total() - start).abs() / kinetic).fold(0.0, f64::max),
        }
    }

    /// When the impulse along the face is greatest: there the force changes its sign for good, however it oscillates
    /// before.
    fn reversal_time(&self) -> f64 {
        let (mut impulse, mut best, mut at) = (0.0, 0.0, None);
        for (i, pair) in self.contact.windows(2).enumerate() {
            impulse += 0.5 * (pair[0].tangential + pair[1].tangential) * (pair[1].time - pair[0].time);
            if impulse > best {
                best = impulse;
                at = Some(i);
            }
        }
        let Some(i) = at else { return f64::NAN };
        let records = &self.contact[i..];
        let crossing = records.windows(2).find(|p| p[0].tangential >= 0.0 && p[1].tangential < 0.0);
        crossing.map_or(f64::NAN, |p| {
            let fraction = p[0].tangential / (p[0].tangential - p[1].tangential);
            p[0].time + fraction * (p[1].time - p[0].time)
        })
    }

    /// Mean of R(t)/R0, weighted with the tangential force.
    fn mean_radius(&self, radius: f64) -> f64 {
        let (mut weighted, mut plain) = (0.0, 0.0);
        for pair in self.motion.windows(2) {
            let middle = 0.5 * (pair[0].radius + pair[1].radius);
            let impulse: f64 = self.impulse_between(pair[0].time, pair[1].time);
            weighted += middle * impulse;
            plain += impulse;
        }
        weighted / (radius * plain)
    }

    /// Impulse of the tangential force between two times, N s.
    fn impulse_between(&self, from: f64, to: f64) -> f64 {
        let first = self.contact.partition_point(|record| record.time < from);
        let last = self.contact.partition_point(|record| record.time < to);
        let step = if self.contact.len() > 1 { self.contact[1].time - self.contact[0].time } else { 0.0 };
        self.contact[first..last].iter().map(|record| record.tangential * step).sum()
    }
}
