//! One impact from first touch to launch.

use super::history::{ContactFrame, EnergyFrame, History, MotionFrame};
use super::march::Watch;
use super::options::LONGEST;
use super::rest::Pace;
use super::worker_pool::WorkerPool;
use super::{Options, Progress, Structure, View};
use crate::contact::Contact;
use crate::element::RATIOS;
use crate::error::FemError;
use clubface_impact::first_touch::Motion;
use clubface_math::{Real, Vec3};

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
    /// Bound of the stable step of the ball alone, s.
    pub ball_limit: f64,
    /// The clock that times its run, s.
    pub clock: fn() -> f64,
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
    /// Why there is no launch, if there is none.
    pub stopped: Option<FemError>,
    /// Whether the ball has reached round the edge of the face, where contact ends.
    pub over_edge: bool,
    /// Time step over the stable step of the undeformed structure, but for rounding and bulk viscosity.
    pub safety: f64,
    /// Time step, s.
    pub step: f64,
    /// Steps taken.
    pub steps: usize,
    /// Time that the loop took by the clock of the environment, s.
    pub wall: f64,
}

/// Time after the last touch at which a run until separation ends, s: long enough to be sure that the ball does not come back.
const AFTERWARDS: f64 = 30e-6;
/// Largest error of the energy balance over the initial kinetic energy.
const BALANCE: f64 = 0.01;

impl<R: Real> Impact<R> {
    /// Runs it. `watch` sees every motion frame, and stops the run by returning false.
    ///
    /// A run that fails ends with what it has, and says why in [`Outcome::stopped`].
    ///
    /// # Errors
    /// [`FemError::Input`] for options that are not allowed; nothing has run then.
    pub fn run(
        &mut self,
        options: &Options,
        watch: &mut dyn FnMut(View<R>) -> bool,
    ) -> Result<Outcome<R>, FemError> {
        options.check()?;
        self.contact.keep_out(options.contact);
        let Pace { safety, dt, stride } = self.pace(options);
        if options.bulk_viscosity > 0.0 {
            self.structure.damp(options.bulk_viscosity);
        }
        let every = (options.interval / (dt * stride as f64)).round().max(1.0) as usize * stride;
        self.structure.follow(0..self.ball_nodes);
        let start = (self.clock)();
        let mut run = Run { history: History::default(), touched: None, dt, step: 0 };
        // One pool for the whole run: its workers are awake, and have their data at hand.
        let executor = self.structure.executor.clone();
        let stopped = WorkerPool::with(&*executor, |_| loop {
            let time = run.step as f64 * dt;
            if !run.goes_on(options) {
                break None;
            }
            let motion = run.motion(self);
            let progress = Progress { time, duration: options.duration.max(time), steps: run.step };
            let view = View { progress, centre: motion.centre, impact: self };
            if run.step.is_multiple_of(every) && !watch(view) {
                break Some(FemError::Interrupted { microseconds: time * 1e6 });
            }
            let fails = !self.structure.sound() || run.runs_away(&motion);
            if fails {
                let ratios = self.structure.look().1;
                if let Err(error) = self.check(&ratios, time * 1e6) {
                    break Some(error);
                }
            }
            // In a step in which all patches take part, at the latest the next one.
            let due = run.step.is_multiple_of(every * options.energy_every) || fails;
            if due && !self.structure.pause {
                if let Err(error) = run.ledger(self, motion, options) {
                    break Some(error);
                }
            } else {
                let count = if due { 1 } else { every - run.step % every };
                run.steps(self, motion, options, |structure, contact, dt, watch| {
                    structure.march(contact, dt, count, watch)
                });
            }
        });
        self.structure.settle();
        if stopped.as_ref().is_some_and(FemError::failed) {
            run.history.cut();
        }
        let microseconds = run.step as f64 * dt * 1e6;
        let missed = run.touched.is_none().then_some(FemError::Missed { microseconds });
        let unfinished = run.history.touching().then_some(FemError::Unfinished { microseconds });
        Ok(Outcome {
            ball: self.ball(),
            head: self.head(),
            history: run.history,
            stopped: stopped.or(missed).or(unfinished),
            over_edge: self.contact.wrapped(),
            safety,
            step: dt,
            steps: run.step,
            wall: (self.clock)() - start,
        })
    }

    /// Whether all elements are as large as their laws bear, by the smallest and largest volume ratio of each patch at some time, µs.
    fn check(&mut self, ratios: &[(f64, f64)], microseconds: f64) -> Result<(), FemError> {
        for (patch, ratios) in ratios.iter().enumerate() {
            for ratio in [ratios.0, ratios.1] {
                if !(RATIOS.0..=RATIOS.1).contains(&ratio) {
                    let element = self.structure.most_strained(patch).0;
                    let part = self.parts[patch].clone();
                    return Err(FemError::ElementLost { element, part, ratio, microseconds });
                }
            }
        }
        Ok(())
    }

    /// Velocity of the ball, and its angular momentum over the inertia of the undeformed ball.
    fn ball(&mut self) -> Motion<R> {
        let kinetics = self.structure.kinetics(0..self.ball_nodes);
        Motion { velocity: kinetics.velocity, spin: kinetics.angular_momentum * self.inertia.recip() }
    }

    fn head(&mut self) -> Motion<R> {
        self.contact.head().unwrap_or_else(|| {
            let kinetics = self.structure.kinetics(self.ball_nodes..self.structure.translations);
            Motion { velocity: kinetics.velocity, spin: kinetics.spin }
        })
    }
}

/// Motion of the ball, its mass centre (m) and its kinetic energy (J).
#[derive(Clone, Copy)]
struct BallMotion<R> {
    frame: MotionFrame,
    centre: Vec3<R>,
    energy: f64,
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
    fn time(&self) -> f64 {
        self.step as f64 * self.dt
    }

    /// Whether there is another step.
    fn goes_on(&self, options: &Options) -> bool {
        let time = self.time();
        match self.touched {
            Some(last) if options.until_separation => time <= (last + AFTERWARDS).min(LONGEST),
            _ => time <= options.duration,
        }
    }

    /// Records the contact of the current step.
    fn record<R: Real>(&mut self, contact: &dyn Contact<R>, axes: &[Vec3<f64>; 3]) {
        let (time, resultant) = (self.time(), contact.resultant());
        let [_, up, toe] = along(axes, resultant.force);
        let normal = resultant.normal.re();
        self.history.contact.push(ContactFrame { time, normal, tangential: -up, toe, area: resultant.area });
        if normal > 0.0 {
            self.touched = Some(time);
        }
    }

    /// Motion of the ball at the current step; its distance from the face comes with the contact.
    fn motion<R: Real>(&self, impact: &mut Impact<R>) -> BallMotion<R> {
        let kinetics = impact.structure.kinetics(0..impact.ball_nodes);
        let velocity = along(&impact.axes, kinetics.velocity - impact.head_velocity);
        let spin = along(&impact.axes, kinetics.spin);
        let frame = MotionFrame { time: self.time(), velocity, spin, radius: f64::NAN };
        BallMotion { frame, centre: kinetics.centre, energy: kinetics.energy.re() }
    }

    /// Whether the ball has more energy than everything had at first: time to look closer, while it can still be seen which element fails.
    fn runs_away<R>(&self, motion: &BallMotion<R>) -> bool {
        let all = self.history.energy.first().map_or(f64::INFINITY, EnergyFrame::total);
        motion.energy > all * (1.0 + BALANCE) || motion.energy.is_nan()
    }

    /// Steps, the first with a motion frame, taken by `go`.
    fn steps<R: Real, T>(
        &mut self,
        impact: &mut Impact<R>,
        motion: BallMotion<R>,
        options: &Options,
        go: impl FnOnce(&mut Structure<R>, &mut dyn Contact<R>, f64, &mut Watch<'_, R>) -> T,
    ) -> T {
        let BallMotion { frame, centre, .. } = motion;
        let mut frame = Some(frame);
        let Impact { structure, contact, axes, .. } = impact;
        go(structure, contact.as_mut(), self.dt, &mut |contact, positions| {
            self.record(contact, axes);
            if let Some(frame) = frame.take() {
                let radius = contact.nearest(positions, centre).0.re();
                self.history.motion.push(MotionFrame { radius, ..frame });
            }
            self.step += 1;
            self.goes_on(options)
        })
    }

    /// A step with a motion frame and its energies.
    fn ledger<R: Real>(
        &mut self,
        impact: &mut Impact<R>,
        motion: BallMotion<R>,
        options: &Options,
    ) -> Result<(), FemError> {
        let (time, microseconds) = (self.time(), self.time() * 1e6);
        let (elements, ratios, kinetic) =
            self.steps(impact, motion, options, |structure, contact, dt, watch| {
                structure.step_and_look(contact, dt, watch)
            });
        impact.check(&ratios, microseconds)?;
        let contact = impact.contact.energy();
        let frame = EnergyFrame {
            time,
            kinetic: kinetic + contact.bodies,
            elements,
            contact: contact.stored,
            friction: contact.friction,
            damping: contact.damping,
        };
        let first = *self.history.energy.first().unwrap_or(&frame);
        let error = (frame.total() - first.total()).abs() / first.kinetic;
        if error > BALANCE || error.is_nan() {
            let found = impact
                .parts
                .iter()
                .enumerate()
                .map(|(patch, part)| (impact.structure.most_strained(patch), part));
            let worst = found.max_by(|((_, one), _), ((_, other), _)| one.total_cmp(other));
            let (element, part) =
                worst.map_or((0, String::new()), |((element, _), part)| (element, part.clone()));
            let edge = impact.contact.wrapped();
            return Err(FemError::Energy { element, part, percent: error * 100.0, edge, microseconds });
        }
        self.history.energy.push(frame);
        Ok(())
    }
}

/// Components of a vector along axes.
fn along<R: Real>(axes: &[Vec3<f64>; 3], v: Vec3<R>) -> [f64; 3] {
    let v = Vec3::new(v.x.re(), v.y.re(), v.z.re());
    axes.map(|axis| axis.dot(v))
}
