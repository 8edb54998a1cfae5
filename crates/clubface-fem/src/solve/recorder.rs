//! The records of a run while it goes on.

use super::integration::StepObserver;
use super::options::LONGEST;
use super::records::{ContactRecord, MotionRecord, Records};
use super::{Options, Simulation, Structure};
use crate::contact::Contact;
use clubface_math::{Real, Vec3};

/// Time after the last contact at which a run until separation ends, s: long enough to be sure that the ball does not
/// come back.
const TIME_AFTER_CONTACT: f64 = 30e-6;

/// The ball at some step.
#[derive(Clone, Copy)]
pub(super) struct BallState<R> {
    record: MotionRecord,
    /// Mass centre, m.
    pub(super) centre: Vec3<R>,
    /// Kinetic energy, J.
    pub(super) kinetic_energy: f64,
}

/// Time, and the records up to it.
pub(super) struct Recorder {
    pub(super) records: Records,
    /// Time of the last contact, s.
    pub(super) last_contact: Option<f64>,
    pub(super) dt: f64,
    /// Steps done.
    pub(super) step: usize,
}

impl Recorder {
    pub(super) fn new(dt: f64) -> Self {
        Self { records: Records::default(), last_contact: None, dt, step: 0 }
    }

    pub(super) fn time(&self) -> f64 {
        self.step as f64 * self.dt
    }

    /// Whether there is another step.
    pub(super) fn goes_on(&self, options: &Options) -> bool {
        let time = self.time();
        match self.last_contact {
            Some(last) if options.until_separation => time <= (last + TIME_AFTER_CONTACT).min(LONGEST),
            _ => time <= options.duration,
        }
    }

    /// Records the contact of the current step.
    fn record_contact<R: Real>(&mut self, contact: &dyn Contact<R>, axes: &[Vec3<f64>; 3]) {
        let (time, resultant) = (self.time(), contact.resultant());
        let [_, up, toe] = components(axes, resultant.force);
        let normal = resultant.normal.re();
        self.records.contact.push(ContactRecord { time, normal, tangential: -up, toe, area: resultant.area });
        if normal > 0.0 {
            self.last_contact = Some(time);
        }
    }

    /// The ball at the current step. Its distance from the face is measured with the contact.
    pub(super) fn ball_state<R: Real>(&self, simulation: &mut Simulation<R>) -> BallState<R> {
        let body = simulation.structure.body_motion(0..simulation.ball_nodes);
        let velocity = components(&simulation.axes, body.velocity - simulation.head_velocity);
        let spin = components(&simulation.axes, body.spin);
        let record = MotionRecord { time: self.time(), velocity, spin, radius: f64::NAN };
        BallState { record, centre: body.centre, kinetic_energy: body.energy.re() }
    }

    /// Lets `integrate` take steps, the first of which has a motion record.
    pub(super) fn take_steps<R: Real, T>(
        &mut self,
        simulation: &mut Simulation<R>,
        ball: BallState<R>,
        options: &Options,
        integrate: impl FnOnce(&mut Structure<R>, &mut dyn Contact<R>, f64, &mut StepObserver<'_, R>) -> T,
    ) -> T {
        let BallState { record, centre, .. } = ball;
        let mut record = Some(record);
        let Simulation { structure, contact, axes, .. } = simulation;
        integrate(structure, contact.as_mut(), self.dt, &mut |contact, positions| {
            self.record_contact(contact, axes);
            if let Some(record) = record.take() {
                let radius = contact.nearest(positions, centre).0.re();
                self.records.motion.push(MotionRecord { radius, ..record });
            }
            self.step += 1;
            self.goes_on(options)
        })
    }
}

/// Components of a vector along axes.
fn components<R: Real>(axes: &[Vec3<f64>; 3], v: Vec3<R>) -> [f64; 3] {
    let v = Vec3::new(v.x.re(), v.y.re(), v.z.re());
    axes.map(|axis| axis.dot(v))
}
