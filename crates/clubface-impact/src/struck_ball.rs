//! A ball that a multibody program strikes: it is moved here, from rest through the contact into flight, while the program
//! moves the head.
//!
//! For a program that exchanges forces at steps of its own (co-simulation). Within a step the head goes on as it came, and
//! gives way to the ball by its own inertia and by what its mechanism adds ([`crate::head_inertia`]). What the program
//! applies to its head over the step is the mean force and torque, so that momentum is kept, and a step may be as long as
//! what else acts on the head allows: a step that takes in the whole contact is the impact of the model.

use crate::error::ImpactError;
use crate::first_touch::Motion;
use crate::head_inertia::{HeadInertia, HeadMobility};
use crate::impact_model::ImpactModel;
use crate::launch::{Launch, OUTPUT_COUNT};
use crate::multibody::{BODY, Body, HEAD, Head, HeadContact, Wrench, check_motion};
use crate::shot::{INPUT_COUNT, Shot};
use clubface_math::{Mat3, Vec3};

/// Longest time, s, over which bodies in contact move at once: the stiffest friction slows sliding at 5e6 1/s, and Runge
/// and Kutta's method is stable up to 2.8 over that.
const LONGEST_STAGE: f64 = 0.25e-6;
/// Longest step, s, that [`StruckBall::advance`] takes.
pub const LONGEST_STEP: f64 = 0.1;
/// How deep in the face, m, a ball may be when it is first seen to touch it: more than a club moves in a stage.
const SEEN: f64 = 1e-4;

/// What happens to the ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// The head has not reached it.
    Waiting = 0,
    /// Head and ball touch.
    Contact = 1,
    /// It has left the face.
    Launched = 2,
}

/// What acted over a step, world axes.
#[derive(Clone, Copy, Debug)]
pub struct StepLoads {
    /// Mean force on the head, N; its opposite acted on the ball.
    pub force: Vec3<f64>,
    /// Mean torque on the head about its CG, N m.
    pub torque: Vec3<f64>,
    /// Normal force at the end, N.
    pub normal_force: f64,
    /// Penetration at the end, m; negative when apart.
    pub depth: f64,
}

/// The ball, and the contact while there is one. All of it is kept of a right-hander.
pub struct StruckBall {
    model: ImpactModel,
    inputs: [f64; INPUT_COUNT],
    parameters: Vec<f64>,
    shot: Shot<f64>,
    /// From the axes of the face to those of the head.
    face: Mat3<f64>,
    /// Inertia of the head, face axes.
    head: HeadInertia<f64>,
    mobility: HeadMobility<f64>,
    gives_way: bool,
    ball: Body<f64>,
    contact: Option<Touching>,
    launch: Option<[f64; OUTPUT_COUNT]>,
}

/// A contact that goes on.
struct Touching {
    contact: HeadContact<f64>,
    internal: Vec<f64>,
    /// Velocity and speed of the head at first touch; its mechanism moves as it did then.
    entry: Vec3<f64>,
    time: f64,
    peak_force: f64,
}

// Places in the state of a stage: the head, the ball, the impulses on the head so far, the internal states.
const HEAD_POSITION: usize = 0;
const ROTATION: usize = 3;
const HEAD_VELOCITY: usize = 12;
const HEAD_SPIN: usize = 15;
const BALL: usize = 18;
const IMPULSE: usize = BALL + BODY;
const MOMENT: usize = IMPULSE + 3;
const INTERNAL: usize = MOMENT + 3;

fn vector(y: &[f64], at: usize) -> Vec3<f64> {
    Vec3::from_slice(y, at)
}

fn rotation(y: &[f64]) -> Mat3<f64> {
    Mat3::from_rows(vector(y, ROTATION), vector(y, ROTATION + 3), vector(y, ROTATION + 6))
}

fn put_rotation(rotation: Mat3<f64>, y: &mut [f64]) {
    rotation.rows.iter().enumerate().for_each(|(i, row)| row.put(y, ROTATION + 3 * i));
}

fn head(y: &[f64]) -> Head<f64> {
    let body = Body {
        position: vector(y, HEAD_POSITION),
        velocity: vector(y, HEAD_VELOCITY),
        spin: vector(y, HEAD_SPIN),
    };
    Head { rotation: rotation(y), body }
}

fn ball(y: &[f64]) -> Body<f64> {
    Body { position: vector(y, BALL), velocity: vector(y, BALL + 3), spin: vector(y, BALL + 6) }
}

/// How face and ball stand to each other.
struct Gap {
    /// Distance of the surfaces, m.
    distance: f64,
    /// Whether the ball is before the outline of the face.
    within: bool,
    /// Speed at which they approach, m/s.
    approach: f64,
    /// Speed beyond which no point of the face moves against the ball, m/s.
    fastest: f64,
}

impl StruckBall {
    /// A ball that lies or moves as `ball` says. Of the `inputs` of a shot those of the delivery have no part. `gives_way`:
    /// whether the head gives way to the ball within a step, as a body does, or moves as prescribed.
    ///
    /// # Errors
    /// A model without a contact, or a faulty club, ball, parameter or motion.
    pub fn new(
        model: ImpactModel,
        inputs: &[f64; INPUT_COUNT],
        parameters: &[f64],
        ball: &[f64; BODY],
        gives_way: bool,
    ) -> Result<Self, ImpactError> {
        let shot = Shot::from_inputs(inputs);
        let face = Mat3::rotation_z(shot.club.static_loft.sin_cos());
        let head = shot.club.head_inertia();
        let new = Self {
            model,
            inputs: *inputs,
            parameters: parameters.to_vec(),
            shot,
            face,
            head,
            mobility: head.mobility(),
            gives_way,
            ball: Body::from_values(ball).mirrored(shot.club.hand),
            contact: None,
            launch: None,
        };
        // Faults of club, ball and model are found now: a contact could begin where the head stands at the ball.
        let normal = face * Vec3::new(1.0, 0.0, 0.0);
        let position = new.ball.position - normal * shot.ball.radius - shot.club.cg_to_face;
        let body = Body { position, velocity: new.ball.velocity + normal, spin: Vec3::zero() };
        new.begin(&Head { rotation: Mat3::diagonal(1.0), body }, &new.ball)?;
        Ok(new)
    }

    /// Place and motion of the ball.
    #[must_use]
    pub fn ball(&self) -> Body<f64> {
        self.ball.mirrored(self.shot.club.hand)
    }

    /// What happens to the ball.
    #[must_use]
    pub fn phase(&self) -> Phase {
        match (&self.launch, &self.contact) {
            (Some(_), _) => Phase::Launched,
            (None, Some(_)) => Phase::Contact,
            (None, None) => Phase::Waiting,
        }
    }

    /// The outputs of the impact, once the ball has left the face.
    #[must_use]
    pub fn launch(&self) -> Option<&[f64; OUTPUT_COUNT]> {
        self.launch.as_ref()
    }

    /// Moves the ball on by `duration` seconds while the head moves on from where it is now.
    ///
    /// # Errors
    /// A pose or a motion that is not allowed, a duration that is not from 0 to [`LONGEST_STEP`].
    pub fn advance(&mut self, head: &[f64; HEAD], duration: f64) -> Result<StepLoads, ImpactError> {
        check_motion(head, &self.ball().values())?;
        if !(0.0..=LONGEST_STEP).contains(&duration) {
            let message = format!("{duration} s; allowed: 0 to {LONGEST_STEP} s a step");
            return Err(ImpactError::new("duration", message));
        }
        let hand = self.shot.club.hand;
        let mut y = self.state(&Head::from_values(head).mirrored(hand));
        let mut passed = 0.0;
        while passed < duration {
            let mut h = duration - passed;
            if self.contact.is_none() && self.launch.is_none() {
                let gap = self.gap(&y);
                if gap.within
                    && gap.approach > 0.0
                    && (-SEEN..=gap.approach * LONGEST_STAGE).contains(&gap.distance)
                {
                    let mut touching = self.begin(&self::head(&y), &self::ball(&y))?;
                    // Time counts from first touch.
                    touching.time = -gap.distance / gap.approach;
                    self.contact = Some(touching);
                    y.extend(self.contact.iter().flat_map(|touching| &touching.internal));
                }
                // No part of the face can be at the ball before.
                let reached = gap.distance.abs() / gap.fastest.max(f64::MIN_POSITIVE);
                h = h.min(reached.max(LONGEST_STAGE));
            }
            if self.contact.is_some() {
                h = (duration - passed).min(LONGEST_STAGE);
                self.touch_on(&mut y, h);
            } else {
                drift(&mut y, h);
            }
            passed += h;
        }
        self.ball = self::ball(&y);
        let mut rates = vec![0.0; y.len() - INTERNAL];
        let (normal_force, depth) = match &mut self.contact {
            Some(touching) => {
                touching.internal.copy_from_slice(&y[INTERNAL..]);
                let wrench = touching.wrench(&y, &mut rates);
                (wrench.normal_force, wrench.depth)
            }
            None => (0.0, -self.gap(&y).distance),
        };
        let share = if duration > 0.0 { duration.recip() } else { 0.0 };
        let (impulse, moment) = (vector(&y, IMPULSE) * share, vector(&y, MOMENT) * share);
        let mean = Body { position: Vec3::zero(), velocity: impulse, spin: moment }.mirrored(hand);
        Ok(StepLoads { force: mean.velocity, torque: mean.spin, normal_force, depth })
    }

    fn state(&self, head: &Head<f64>) -> Vec<f64> {
        let mut y = vec![0.0; INTERNAL];
        head.body.position.put(&mut y, HEAD_POSITION);
        head.body.velocity.put(&mut y, HEAD_VELOCITY);
        head.body.spin.put(&mut y, HEAD_SPIN);
        put_rotation(head.rotation, &mut y);
        y[BALL..IMPULSE].copy_from_slice(&self.ball.values());
        y.extend(self.contact.iter().flat_map(|touching| &touching.internal));
        y
    }

    fn gap(&self, y: &[f64]) -> Gap {
        let (head, ball, club) = (head(y), ball(y), &self.shot.club);
        let attitude = head.rotation * self.face;
        let away = ball.position - head.body.position;
        let centre = attitude.transpose() * away - club.lever();
        let nearest = club.face().nearest(centre);
        let point = centre - nearest.normal * nearest.distance;
        let velocity = head.body.velocity - ball.velocity;
        let arm = attitude * (club.lever() + point);
        Gap {
            distance: nearest.distance - self.shot.ball.radius,
            within: point.z.abs() <= club.face_width / 2.0 && point.y.abs() <= club.face_height / 2.0,
            approach: (attitude * nearest.normal).dot(velocity + head.body.spin.cross(arm)),
            fastest: velocity.norm() + head.body.spin.norm() * away.norm().max(arm.norm()),
        }
    }

    /// The contact that begins where a right-hander's head and ball are now.
    fn begin(&self, head: &Head<f64>, ball: &Body<f64>) -> Result<Touching, ImpactError> {
        let hand = self.shot.club.hand;
        let mut given = [0.0; HEAD];
        let own = head.mirrored(hand);
        own.rotation.rows.iter().enumerate().for_each(|(i, row)| row.put(&mut given, 3 * i));
        given[9..].copy_from_slice(&own.body.values());
        let ball = ball.mirrored(hand).values();
        let contact = HeadContact::begin(self.model, &self.inputs, &self.parameters, &given, &ball)?;
        let internal = contact.initial().to_vec();
        Ok(Touching { contact, internal, entry: head.body.velocity, time: 0.0, peak_force: 0.0 })
    }

    /// Moves bodies in contact on by `h`, Runge and Kutta's method.
    fn touch_on(&mut self, y: &mut Vec<f64>, h: f64) {
        let Some(touching) = &self.contact else { return };
        let before = touching.wrench(y, &mut vec![0.0; y.len() - INTERNAL]);
        let moved = |rates: &[f64], part: f64| -> Vec<f64> {
            y.iter().zip(rates).map(|(value, rate)| value + rate * (h * part)).collect()
        };
        let k1 = self.rates(touching, y);
        let k2 = self.rates(touching, &moved(&k1, 0.5));
        let k3 = self.rates(touching, &moved(&k2, 0.5));
        let k4 = self.rates(touching, &moved(&k3, 1.0));
        for (i, value) in y.iter_mut().enumerate() {
            *value += (k1[i] + (k2[i] + k3[i]) * 2.0 + k4[i]) * (h / 6.0);
        }
        let (head, ball) = (head(y), ball(y));
        touching.contact.commit_right(&head, &ball, &mut y[INTERNAL..]);
        let after = touching.wrench(y, &mut vec![0.0; y.len() - INTERNAL]);

        let mut time = touching.time + h;
        let peak_force = touching.peak_force.max(after.normal_force);
        let parted = after.depth <= 0.0 && after.rate < 0.0;
        if parted {
            // Depth is linear over so short a time.
            let beyond = (after.depth / (after.depth - before.depth)).clamp(0.0, 1.0);
            time -= h * beyond;
            let motion = |body: &Body<f64>| {
                let own = body.mirrored(self.shot.club.hand);
                Motion { velocity: own.velocity, spin: own.spin }
            };
            let (ball, club) = (motion(&ball), motion(&head.body));
            let launch = Launch {
                ball_velocity: ball.velocity,
                ball_spin: ball.spin,
                club_velocity: club.velocity,
                club_spin: club.spin,
                club_speed: touching.entry.norm(),
                contact_time: time,
                peak_force,
            };
            self.launch = Some(launch.outputs());
            self.contact = None;
            y.truncate(INTERNAL);
        } else if let Some(touching) = &mut self.contact {
            (touching.time, touching.peak_force) = (time, peak_force);
        }
    }

    /// Rates of the state of a stage.
    fn rates(&self, touching: &Touching, y: &[f64]) -> Vec<f64> {
        let mut rates = vec![0.0; y.len()];
        let wrench = touching.wrench(y, &mut rates[INTERNAL..]);
        let head = head(y);
        head.body.velocity.put(&mut rates, HEAD_POSITION);
        put_rotation(Mat3::cross(head.body.spin) * head.rotation, &mut rates);
        if self.gives_way {
            // As crate::head_inertia: in a frame that moves as the CG did at first touch.
            let attitude = head.rotation * self.face;
            let to_face = attitude.transpose();
            let spin = to_face * head.body.spin;
            let velocity = to_face * (head.body.velocity - touching.entry);
            let (linear, angular) = self.head.momenta(velocity, spin);
            let (rate, spin_rate) = self.mobility.response(
                linear.cross(spin) - to_face * wrench.force,
                angular.cross(spin) + linear.cross(velocity) + to_face * wrench.head_torque,
            );
            (attitude * (rate + spin.cross(velocity))).put(&mut rates, HEAD_VELOCITY);
            (attitude * spin_rate).put(&mut rates, HEAD_SPIN);
        }
        ball(y).velocity.put(&mut rates, BALL);
        (wrench.force * self.shot.ball.mass.recip()).put(&mut rates, BALL + 3);
        (wrench.ball_torque * self.shot.ball.inertia.recip()).put(&mut rates, BALL + 6);
        (-wrench.force).put(&mut rates, IMPULSE);
        wrench.head_torque.put(&mut rates, MOMENT);
        rates
    }
}

impl Touching {
    fn wrench(&self, y: &[f64], rates: &mut [f64]) -> Wrench<f64> {
        self.contact.evaluate_right(&head(y), &ball(y), &y[INTERNAL..], rates)
    }
}

/// Moves bodies that are apart on by `h`, with constant velocities and angular velocities.
fn drift(y: &mut [f64], h: f64) {
    for (place, velocity) in [(HEAD_POSITION, HEAD_VELOCITY), (BALL, BALL + 3)] {
        (vector(y, place) + vector(y, velocity) * h).put(y, place);
    }
    // Rodrigues' formula.
    let spin = vector(y, HEAD_SPIN);
    let rate = spin.norm();
    if rate > 0.0 {
        let (axis, angle) = (Mat3::cross(spin * rate.recip()), rate * h);
        let turn = Mat3::diagonal(1.0) + axis.scale(angle.sin()) + (axis * axis).scale(1.0 - angle.cos());
        put_rotation(turn * rotation(y), y);
    }
}
