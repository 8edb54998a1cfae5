//! One impact from first touch to launch.

use super::history::{ContactFrame, EnergyFrame, History, MotionFrame};
use super::Structure;
use crate::contact::Contact;
use crate::error::FemError;
use clubface_impact::first_touch::Motion;
use clubface_math::{Real, Vec3};

/// How to run.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Simulated time, s.
    pub duration: f64,
    /// Time step over the stable step of the undeformed structure.
    pub safety: f64,
    /// Interval of the motion frames, s.
    pub interval: f64,
    /// Motion frames an energy frame.
    pub energy_every: usize,
    /// Whether to end soon after the last touch instead of at the end of the simulated time.
    pub until_separation: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { duration: 1e-3, safety: 0.8, interval: 5e-6, energy_every: 4, until_separation: false }
    }
}

impl Options {
    /// Checks the values.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first value that is not allowed.
    pub fn check(&self) -> Result<(), FemError> {
        if !(self.duration > 0.0 && self.duration <= 0.1) {
            return Err(FemError::input(
                "duration",
                format!("{} us", self.duration * 1e6),
                "above 0, at most 100000 us is allowed",
            ));
        }
        if !(self.safety > 0.0 && self.safety <= 1.0) {
            return Err(FemError::input(
                "safety",
                self.safety,
                "above 0, at most 1 (the stable step) is allowed",
            ));
        }
        if self.interval.is_nan() || self.interval <= 0.0 || self.energy_every == 0 {
            return Err(FemError::input("interval", self.interval, "above 0 s is allowed"));
        }
        Ok(())
    }
}

/// What a run has reached.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// Time since first touch, s.
    pub time: f64,
    /// Simulated time asked for, s.
    pub duration: f64,
    /// Steps done.
    pub steps: usize,
}

/// A ball about to meet a face.
pub struct Impact<R> {
    /// Ball and, if it deforms, head.
    pub structure: Structure<R>,
    /// The contact between them.
    pub contact: Box<dyn Contact<R>>,
    /// Nodes of the ball: the first ones.
    pub ball_nodes: usize,
    /// Radius of the ball, m.
    pub radius: f64,
    /// Moment of inertia of the undeformed ball about a diameter, kg m2.
    pub inertia: R,
    /// Face normal at the point of first touch, up the face, to the toe.
    pub axes: [Vec3<f64>; 3],
    /// Velocity of the head at first touch, m/s.
    pub head_velocity: Vec3<R>,
    /// Name of the part that each patch belongs to.
    pub parts: Vec<String>,
}

/// What came out.
#[derive(Clone, Debug)]
pub struct Outcome<R> {
    /// Ball after the impact: velocity of the mass centre, and angular momentum over the inertia of the undeformed ball, free of its vibration.
    pub ball: Motion<R>,
    /// Head after the impact.
    pub head: Motion<R>,
    /// Records, as far as they go.
    pub history: History,
    /// Why the run stopped early, if it did.
    pub stopped: Option<FemError>,
    /// Time step, s.
    pub step: f64,
    /// Steps taken.
    pub steps: usize,
    /// Time of the loop, s.
    pub wall: f64,
}

/// Time after the last touch at which a run until separation ends, s: long enough to be sure that the ball does not come back.
const AFTERWARDS: f64 = 30e-6;
/// Largest error of the energy balance over the initial kinetic energy.
const BALANCE: f64 = 0.01;
/// Volume ratios between which the laws hold.
const RATIOS: (f64, f64) = (0.3, 2.5);

impl<R: Real> Impact<R> {
    /// Runs it. `watch` is called at every motion frame, and stops the run by returning false.
    ///
    /// A run that fails ends with what it has, and says why in [`Outcome::stopped`].
    ///
    /// # Errors
    /// [`FemError::Input`] for options that are not allowed; nothing has run then.
    pub fn run(
        &mut self,
        options: &Options,
        watch: &mut dyn FnMut(&Progress, &Self) -> bool,
    ) -> Result<Outcome<R>, FemError> {
        options.check()?;
        let dt = rounded(self.structure.stable_step(40) * options.safety);
        let every = (options.interval / dt).round().max(1.0) as usize;
        let start = std::time::Instant::now();
        let mut run = Run { history: History::default(), touched: None, dt, step: 0 };
        let stopped = loop {
            let time = run.step as f64 * dt;
            if time > options.duration {
                break None;
            }
            if options.until_separation && run.touched.is_some_and(|last| time > last + AFTERWARDS) {
                break None;
            }
            let sample = run.step.is_multiple_of(every);
            if sample && !watch(&Progress { time, duration: options.duration, steps: run.step }, self) {
                break Some(FemError::Interrupted { microseconds: time * 1e6 });
            }
            let ledger = sample && (run.step / every).is_multiple_of(options.energy_every);
            if let Err(error) = run.advance(self, sample, ledger) {
                break Some(error);
            }
        };
        let missed =
            run.touched.is_none().then_some(FemError::Missed { microseconds: run.step as f64 * dt * 1e6 });
        Ok(Outcome {
            ball: self.ball(),
            head: self.head(),
            history: run.history,
            stopped: stopped.or(missed),
            step: dt,
            steps: run.step,
            wall: start.elapsed().as_secs_f64(),
        })
    }

    /// Velocity of the ball, and its angular momentum over the inertia of the undeformed ball.
    fn ball(&self) -> Motion<R> {
        let kinetics = self.structure.kinetics(0..self.ball_nodes);
        Motion { velocity: kinetics.velocity, spin: kinetics.angular_momentum * self.inertia.recip() }
    }

    fn head(&self) -> Motion<R> {
        self.contact.head().unwrap_or_else(|| {
            let kinetics = self.structure.kinetics(self.ball_nodes..self.structure.translations);
            Motion { velocity: kinetics.velocity, spin: kinetics.spin }
        })
    }

    fn along_axes(&self, v: Vec3<R>) -> [f64; 3] {
        let v = Vec3::new(v.x.re(), v.y.re(), v.z.re());
        self.axes.map(|axis| axis.dot(v))
    }
}

/// A step a little shorter, one of 64 in every factor of two: cases that hardly differ then take the same steps, and so differ smoothly.
fn rounded(step: f64) -> f64 {
    ((step.log2() * 64.0).floor() / 64.0).exp2()
}

/// State of a run.
struct Run {
    history: History,
    /// Time of the last touch.
    touched: Option<f64>,
    dt: f64,
    step: usize,
}

impl Run {
    fn advance<R: Real>(
        &mut self,
        impact: &mut Impact<R>,
        sample: bool,
        ledger: bool,
    ) -> Result<(), FemError> {
        let time = self.step as f64 * self.dt;
        impact.structure.assemble(impact.contact.as_mut(), self.dt);
        let resultant = impact.contact.resultant();
        let [_, up, toe] = impact.along_axes(resultant.force);
        let normal = resultant.normal.re();
        self.history.contact.push(ContactFrame { time, normal, tangential: -up, toe, area: resultant.area });
        if normal > 0.0 {
            self.touched = Some(time);
        }
        if sample {
            let kinetics = impact.structure.kinetics(0..impact.ball_nodes);
            self.history.motion.push(MotionFrame {
                time,
                velocity: impact.along_axes(kinetics.velocity - impact.head_velocity),
                spin: impact.along_axes(kinetics.spin),
                radius: impact.contact.nearest(kinetics.centre).0.re(),
            });
        }
        if ledger {
            self.ledger(impact, time)?;
        } else {
            impact.structure.advance(impact.contact.as_ref(), self.dt);
        }
        self.step += 1;
        Ok(())
    }

    /// A step with its energies.
    fn ledger<R: Real>(&mut self, impact: &mut Impact<R>, time: f64) -> Result<(), FemError> {
        let microseconds = time * 1e6;
        for (&ratios, part) in impact.structure.volume_ratios().iter().zip(&impact.parts) {
            for ratio in [ratios.0, ratios.1] {
                if !(RATIOS.0..=RATIOS.1).contains(&ratio) {
                    return Err(FemError::ElementLost { part: part.clone(), ratio, microseconds });
                }
            }
        }
        let before = impact.structure.velocities.clone();
        let elements = impact.structure.energy();
        let contact = impact.contact.energy();
        impact.structure.advance(impact.contact.as_ref(), self.dt);
        let frame = EnergyFrame {
            time,
            kinetic: impact.structure.kinetic_energy(&before) + contact.bodies,
            elements,
            contact: contact.stored,
            friction: contact.friction,
            damping: contact.damping,
        };
        self.history.energy.push(frame);
        let first = &self.history.energy[0];
        let error = (frame.total() - first.total()).abs() / first.kinetic;
        if error > BALANCE || error.is_nan() {
            return Err(FemError::Energy { percent: error * 100.0, microseconds });
        }
        Ok(())
    }
}
