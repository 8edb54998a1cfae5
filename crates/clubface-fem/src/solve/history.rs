//! What a run records, and what P2 reads from it.

use crate::element::Energy;

/// Contact at one step.
#[derive(Clone, Copy, Debug)]
pub struct ContactFrame {
    /// Time since first touch, s.
    pub time: f64,
    /// Force along the face normal, N.
    pub normal: f64,
    /// Force along the face: down the face on the ball is positive, since that makes backspin (P2's sign), N.
    pub tangential: f64,
    /// Force on the ball towards the toe, N.
    pub toe: f64,
    /// Contact area, m2.
    pub area: f64,
}

/// Motion of the ball at some steps.
#[derive(Clone, Copy, Debug)]
pub struct MotionFrame {
    /// Time since first touch, s.
    pub time: f64,
    /// Velocity of the ball's mass centre along the normal, up the face and to the toe, in the frame of the head at first touch, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity by the rigid-rotation fit, about the normal, the face's up and the toe direction, rad/s.
    pub spin: [f64; 3],
    /// Distance of the mass centre from the face, m: P2's R(t).
    pub radius: f64,
}

/// Energies at some steps, J.
#[derive(Clone, Copy, Debug)]
pub struct EnergyFrame {
    /// Time since first touch, s.
    pub time: f64,
    /// Kinetic, nodes and rigid head.
    pub kinetic: f64,
    /// Of the elements.
    pub elements: Energy,
    /// Stored in the contact.
    pub contact: f64,
    /// Turned into heat by friction.
    pub friction: f64,
    /// Turned into heat by the damping of nodes that arrive at the face.
    pub damping: f64,
}

impl EnergyFrame {
    /// Sum of all, J.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.elements.total() + self.contact + self.friction + self.damping
    }
}

/// Everything recorded.
#[derive(Clone, Debug, Default)]
pub struct History {
    /// Every step.
    pub contact: Vec<ContactFrame>,
    /// At the sampling interval.
    pub motion: Vec<MotionFrame>,
    /// At a multiple of it.
    pub energy: Vec<EnergyFrame>,
}

/// Figures of an impact, as P2 defines them.
#[derive(Clone, Copy, Debug)]
pub struct Figures {
    /// Largest normal force, N.
    pub peak_force: f64,
    /// Its time, s.
    pub peak_force_time: f64,
    /// Time of the last touch, s; NaN, as are f' and f, for a ball that is still on the face.
    pub contact_time: f64,
    /// Largest tangential force, N.
    pub tangential_max: f64,
    /// Smallest tangential force, N.
    pub tangential_min: f64,
    /// When the tangential force turns from making spin to taking it, s; NaN if it does not.
    pub reversal_time: f64,
    /// Largest spin about the toe direction (backspin) on the way, rad/s.
    pub spin_max: f64,
    /// Greatest loss of the distance from mass centre to face, over the ball's radius.
    pub contraction: f64,
    /// Its time, s.
    pub contraction_time: f64,
    /// P2's Eq. (9): f' = integral of F R over R0 times integral of F, with the tangential force.
    pub f_prime: f64,
    /// P2's Eq. (11): f = 7 f' / (5 f' + 2).
    pub f: f64,
    /// Largest error of the energy balance over the initial kinetic energy.
    pub energy_error: f64,
}

impl History {
    /// Drops what came after the last closed balance of energies: a run that failed failed somewhere there.
    pub fn cut(&mut self) {
        let last = self.energy.last().map_or(0.0, |frame| frame.time);
        self.contact.retain(|frame| frame.time <= last);
        self.motion.retain(|frame| frame.time <= last);
    }

    /// Whether the ball is on the face at the end of the records.
    #[must_use]
    pub fn touching(&self) -> bool {
        self.contact.last().is_some_and(|last| last.normal > 0.0)
    }

    /// Figures, for a ball of the given radius (m).
    #[must_use]
    pub fn figures(&self, radius: f64) -> Figures {
        let top = self.contact.iter().fold((0.0, 0.0), |best: (f64, f64), frame| {
            if frame.normal > best.0 {
                (frame.normal, frame.time)
            } else {
                best
            }
        });
        let least = self.motion.iter().fold((radius, 0.0), |best: (f64, f64), frame| {
            if frame.radius < best.0 {
                (frame.radius, frame.time)
            } else {
                best
            }
        });
        let fold = |start: f64, pick: fn(f64, f64) -> f64| {
            self.contact.iter().fold(start, |best, frame| pick(best, frame.tangential))
        };
        let left = !self.touching();
        let last = self.contact.iter().rfind(|frame| left && frame.normal > 0.0);
        let f_prime = if left { self.radius_weighted(radius) } else { f64::NAN };
        let start = self.energy.first().map_or(f64::NAN, EnergyFrame::total);
        let kinetic = self.energy.first().map_or(f64::NAN, |frame| frame.kinetic);
        Figures {
            peak_force: top.0,
            peak_force_time: top.1,
            contact_time: last.map_or(f64::NAN, |frame| frame.time),
            tangential_max: fold(0.0, f64::max),
            tangential_min: fold(0.0, f64::min),
            reversal_time: self.reversal(),
            spin_max: self.motion.iter().fold(0.0, |best: f64, frame| best.max(frame.spin[2])),
            contraction: 1.0 - least.0 / radius,
            contraction_time: least.1,
            f_prime,
            f: 7.0 * f_prime / (5.0 * f_prime + 2.0),
            energy_error: self.energy.iter().map(|e| (e.total() - start).abs() / kinetic).fold(0.0, f64::max),
        }
    }

    /// Where the impulse so far along the face is greatest: there the force changes its sign for good, whatever flutters before.
    fn reversal(&self) -> f64 {
        let (mut impulse, mut best, mut at) = (0.0, 0.0, None);
        for (i, pair) in self.contact.windows(2).enumerate() {
            impulse += 0.5 * (pair[0].tangential + pair[1].tangential) * (pair[1].time - pair[0].time);
            if impulse > best {
                best = impulse;
                at = Some(i);
            }
        }
        let Some(i) = at else { return f64::NAN };
        let frames = &self.contact[i..];
        let crossing = frames.windows(2).find(|p| p[0].tangential > 0.0 && p[1].tangential <= 0.0);
        crossing.map_or(f64::NAN, |p| {
            let share = p[0].tangential / (p[0].tangential - p[1].tangential);
            p[0].time + share * (p[1].time - p[0].time)
        })
    }

    /// Mean of R(t)/R0 weighted with the tangential force.
    fn radius_weighted(&self, radius: f64) -> f64 {
        let (mut weighted, mut plain) = (0.0, 0.0);
        for pair in self.motion.windows(2) {
            let middle = 0.5 * (pair[0].radius + pair[1].radius);
            let impulse: f64 = self.impulse_between(pair[0].time, pair[1].time);
            weighted += middle * impulse;
            plain += impulse;
        }
        weighted / (radius * plain)
    }

    fn impulse_between(&self, from: f64, to: f64) -> f64 {
        let first = self.contact.partition_point(|frame| frame.time < from);
        let last = self.contact.partition_point(|frame| frame.time < to);
        let step = if self.contact.len() > 1 { self.contact[1].time - self.contact[0].time } else { 0.0 };
        self.contact[first..last].iter().map(|frame| frame.tangential * step).sum()
    }
}
