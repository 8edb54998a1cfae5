//! Response functions of a ball, regressed on the finite elements: how it leaves the face along the normal, along the
//! face, and with which spin.
//!
//! An impact is one impulse, as in the impulse models of Caldwell and McPhee (2023), but with the mechanism that Roh
//! and Lee found: the tangential force turns round before separation, and its lever is shorter than the ball's radius.
//! Both follow from the time that the contact lasts and from how easily ball and head move, so they are functions of
//! the impact, and not constants.

mod coefficients;
mod effective;
mod terms;

use crate::contact::Recorder;
use crate::description::{Bounds, Law, ModelInfo, ModelKind, ValidRange};
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::model::{Describe, Model};
use clubface_math::{Mat3, Scalar, Vec3};
pub use coefficients::Response;
use core::f64::consts::PI;
use effective::{Bodies, Impulse, Mobility, Place};
pub use terms::Features;

/// The strikes by finite elements that the coefficients of every ball are fitted to, which are made from this table. Places
/// on the face are not bounded: off centre a head gives way more easily, and the small heads among the strikes do so as
/// much as the built-in clubs 30 mm off the face centre.
const VALID: &[ValidRange] = &[
    ValidRange::new("speed", "clubhead speed", "mph", Bounds::new(10.0, 65.0)),
    ValidRange::new(
        "incidence",
        "angle between path and face normal",
        "deg",
        Bounds::new(0.0, 72.0 * (PI / 180.0)),
    ),
    ValidRange::new("friction", "friction", "1", Bounds::new(0.05, 0.6)),
    ValidRange::new("club_mass", "mass of the head", "g", Bounds::new(0.16, 5.0)),
    ValidRange::new("characteristic_time", "characteristic time", "us", Bounds::new(0.0, 350e-6)),
    ValidRange::new("ball_backspin", "backspin before impact", "rpm", SPINS),
    ValidRange::new("ball_sidespin", "sidespin before impact", "rpm", SPINS),
    ValidRange::new("ball_riflespin", "riflespin before impact", "rpm", SPINS),
];
const SPINS: Bounds = Bounds::within(100.0 * PI);

impl Describe for Response<()> {
    type Over<S: Scalar> = Response<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "response",
        title: "Response functions of the finite element ball",
        kind: ModelKind::Impulse,
        summary: "Restitution along the normal and along the face, and the lever of friction, as functions of the \
                  impact, regressed on runs of the finite element ball.",
        reference: "this project, after Roh and Lee (reversal of the tangential force, compression factor) and \
                    Caldwell and McPhee (2023) (impulses)",
        laws: &[Law::Momentum, Law::AngularMomentum, Law::Energy, Law::FrictionCone],
        laws_without: None,
        face_in: None,
        lacks: &[],
        gear_effect: true,
        ball: Some("modern"),
        valid: VALID,
        lanes: true,
        parameters: Response::PARAMETERS,
    };
}

/// Speed that normal approach speeds are measured by, m/s.
const SPEED: f64 = 40.0;
/// Characteristic time that those of clubs are measured by, s.
const FACE: f64 = 250e-6;

impl<S: Scalar> Model<S> for Response<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, _: Accuracy, _: &mut R) -> Impact<S> {
        let bodies = Bodies { touch, head: touch.head_mobility(), friction: self.friction };
        let speed = touch.approach();
        let Contact { middle, end, time } = self.contact(&bodies, speed);
        let mobility = bodies.mobility(middle);
        let sliding = bodies.sliding(middle);
        let at = self.features(&bodies, &mobility, sliding, speed, end);

        // Relative velocity at separation: along the normal, and along the face.
        let rebound = speed * S::zero().max(self.restitution(&at));
        let driven = mobility.coupling * ((speed + rebound) / mobility.normal);
        let along = driven * self.drive(&at)
            - sliding * self.tangential(&at)
            - mobility.scaled(sliding) * self.tangential_mobility(&at)
            + middle.normal.cross(sliding) * (bodies.turning(middle, sliding, speed) * self.swerve(&at));
        let arm = touch.ball.radius * self.lever(&at);
        let wanted = end.normal * rebound + along.reject(end.normal) - bodies.approach(end, arm);

        let turning = Mat3::cross(end.normal) * Mat3::cross(middle.normal);
        let gained =
            bodies.relative(end.point, middle.point) + turning.scale(-arm.squared() / touch.ball.inertia);
        let linear = self.within_friction(&bodies, gained, wanted, middle.normal, end.normal);
        let normal_impulse = middle.normal.dot(linear);
        let couple = self.couple(&bodies, &at, middle, linear, arm);
        let (ball, club) = Impulse { place: middle, linear, couple, arm }.motions(&bodies);
        let mut launch = touch.launch(ball, club);
        launch.contact_time = time;
        launch.peak_force = normal_impulse / time * self.peak(&at);
        Impact::certain(launch)
    }
}

/// Where and how long ball and face touch.
struct Contact<S> {
    /// The place where the impulse acts.
    middle: Place<S>,
    /// The place of separation.
    end: Place<S>,
    /// From first touch to separation, s.
    time: S,
}

/// What the impulse changes: spin of the head, rad/s, and relative velocity, m/s, over the time of the contact, s.
struct Changes<S> {
    turned: Vec3<S>,
    pushed: Vec3<S>,
    time: S,
}

impl<S: Scalar> Changes<S> {
    /// The place of contact after shares of the motions before impact and of their changes: turn, its change, shift and
    /// its change. No closure: it would not be compiled with the features of the CPU.
    #[inline(always)]
    fn place(&self, bodies: &Bodies<S>, [turn, turned, shift, pushed]: [S; 4]) -> Place<S> {
        let touch = bodies.touch;
        bodies.place(
            (touch.club_spin * turn + self.turned * turned) * self.time,
            (self.pushed * pushed - touch.club_velocity * shift) * self.time,
        )
    }
}

impl<S: Scalar> Response<S> {
    /// The contact, from an estimate of the impulse: ball and head move while they touch.
    #[inline(always)]
    fn contact(&self, bodies: &Bodies<S>, speed: S) -> Contact<S> {
        let touch = bodies.touch;
        let first = Place { point: touch.contact, normal: touch.normal };
        let mobility = bodies.mobility(first);
        let free = (mobility.normal * touch.ball.mass).recip();
        let face = face(touch);
        let time = (self.time_speed * (speed * SPEED.recip()).ln() + self.time_mobility * free.ln()).exp()
            * self.time
            * (face * self.time_face + 1.0);
        let impulse = bodies.estimate(first, speed, &mobility);
        let (slowed, turned) = bodies.head.response(impulse, first.point.cross(impulse));
        let changes = Changes { turned: -turned, pushed: impulse * touch.ball.mass.recip() + slowed, time };
        let middle = [self.middle_turn, self.middle_turned, self.middle_shift, self.middle_pushed];
        let end = [self.end_turn, self.end_turned, self.end_shift, self.end_pushed];
        Contact { middle: changes.place(bodies, middle), end: changes.place(bodies, end), time }
    }

    #[inline(always)]
    fn features(
        &self,
        bodies: &Bodies<S>,
        mobility: &Mobility<S>,
        sliding: Vec3<S>,
        speed: S,
        end: Place<S>,
    ) -> Features<S> {
        let normal = bodies.estimated_normal(speed, mobility);
        let rolling = bodies.rolling(sliding, normal, mobility);
        let need = bodies.need(rolling, normal);
        let slipping = need / (need + self.half_slip.squared());
        let coupling = mobility.coupling.dot(sliding) / mobility.normal;
        let gained = -bodies.approach(end, S::zero()).dot(end.normal) - speed;
        Features {
            speed: speed * SPEED.recip() - 0.75,
            friction: (self.friction - 0.3) * 3.0,
            slip: slipping - 0.5,
            mobility: ((mobility.normal * bodies.touch.ball.mass).recip() - 0.8) * 5.0,
            ratio: mobility.ratio(),
            coupling: coupling * 3.0 / (sliding.norm_squared() + speed.squared()).sqrt(),
            face: face(bodies.touch),
            bend: gained * 5.0 / (gained.squared() + speed.squared()).sqrt(),
            offset: mobility.coupling.norm_squared() * 10.0 / mobility.normal.squared(),
        }
    }

    /// The impulse that brings the `wanted` change of relative velocity, or as much along the face as friction gives.
    #[inline(always)]
    fn within_friction(
        &self,
        bodies: &Bodies<S>,
        gained: Mat3<S>,
        wanted: Vec3<S>,
        middle: Vec3<S>,
        end: Vec3<S>,
    ) -> Vec3<S> {
        let free = gained.inverse() * wanted;
        let normal = free.dot(middle);
        let along = free.reject(middle);
        // Smoothly the lesser of one and limit over need.
        let need = bodies.need(along, normal) + 1e-30;
        let sharpness = self.sharpness;
        let share = (-(((need.ln() * sharpness * 0.5).exp() + 1.0).ln() / sharpness)).exp();
        let along = along * share;
        let given = gained.transpose() * end;
        let normal = S::zero().max((wanted.dot(end) - given.dot(along)) / given.dot(middle));
        // A smaller normal impulse has a smaller limit of friction.
        let limit = self.friction * normal;
        let over = along.norm_squared().gt(limit.squared());
        let scale = limit / S::select(over, along.norm(), S::one());
        middle * normal + Vec3::select(over, along * scale, along)
    }

    /// Moments on the ball in addition to those of the impulse, N m s: about the normal the friction of a face and a
    /// ball that turn, and across it the pressure, which is greater ahead of a ball that rolls.
    #[inline(always)]
    fn couple(
        &self,
        bodies: &Bodies<S>,
        at: &Features<S>,
        middle: Place<S>,
        linear: Vec3<S>,
        arm: S,
    ) -> Vec3<S> {
        let Place { point, normal } = middle;
        let touch = bodies.touch;
        let inertia = touch.ball.inertia;
        let turned = -bodies.head.response(linear, point.cross(linear)).1;
        let before = touch.club_spin * self.twist_before - touch.ball_spin * self.twist_spin;
        let twist = normal.dot(before + turned) * self.torsion(at) * inertia;
        let limit = self.friction * linear.dot(normal) * touch.ball.radius * self.twist_arm + 1e-30;
        let twist = twist / ((twist / limit).squared() + 1.0).sqrt();
        let gained = linear.cross(normal) * (arm / inertia) - turned;
        let rolling = (touch.ball_spin - touch.club_spin + gained * self.rolling_gained).reject(normal);
        normal * twist - rolling * (self.rolling(at) * inertia)
    }
}

/// Square of the characteristic time over 250 us, to which the compliance of a face is proportional.
#[inline(always)]
fn face<S: Scalar>(touch: &FirstTouch<S>) -> S {
    (touch.characteristic_time * FACE.recip()).squared() - (touch.included_time * FACE.recip()).squared()
}
