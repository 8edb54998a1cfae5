//! The contact of a head that a multibody program moves, in world axes.
//!
//! World axes: x to the target, y up, z to the right of the target line. The axes of a head are those of the world while
//! the club stands at its static loft with a square face. Everything of a left-hander is given and returned as it is; it
//! is computed in the mirror image.

use crate::check::{check_approach, check_equipment};
use crate::contact::{Instant, Loads, RelativeMotion, SteppedContact};
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::impact_model::{ImpactModel, SteppedScalar, Tangents};
use crate::shot::{INPUT_COUNT, Shot};
use clubface_math::{Mat3, Scalar, Vec3};

/// Where a body is and how it moves, world axes.
#[derive(Clone, Copy, Debug)]
pub struct Body<S> {
    /// Centre of mass, m.
    pub position: Vec3<S>,
    /// Its velocity, m/s.
    pub velocity: Vec3<S>,
    /// Angular velocity, rad/s; of a layered ball all its angular momentum over its inertia.
    pub spin: Vec3<S>,
}

/// Where a head is and how it moves.
#[derive(Clone, Copy, Debug)]
pub struct Head<S> {
    /// From the axes of the head to those of the world.
    pub rotation: Mat3<S>,
    /// Place and motion.
    pub body: Body<S>,
}

/// Numbers of a [`Body`], of a [`Head`] and of a [`Wrench`].
pub const BODY: usize = 9;
/// Rotation row by row, then those of the body.
pub const HEAD: usize = 9 + BODY;
/// Numbers of a [`Wrench`].
pub const WRENCH: usize = 15;

/// What acts between head and ball at one instant, world axes.
#[derive(Clone, Copy, Debug)]
pub struct Wrench<S> {
    /// Force on the ball, N; its opposite acts on the head.
    pub force: Vec3<S>,
    /// Torque on the ball about its centre, N m.
    pub ball_torque: Vec3<S>,
    /// Torque on the head about its CG, N m.
    pub head_torque: Vec3<S>,
    /// Point at which the force acts, m.
    pub point: Vec3<S>,
    /// Normal force, N.
    pub normal_force: S,
    /// Penetration, m; negative when apart.
    pub depth: S,
    /// Its rate, m/s.
    pub rate: S,
}

/// The mirror image in z of a vector, where `hand` is -1.
fn mirrored<S: Scalar>(v: Vec3<S>, hand: S) -> Vec3<S> {
    Vec3::new(v.x, v.y, v.z * hand)
}

/// The mirror image of an angular velocity or a torque.
fn mirrored_turn<S: Scalar>(v: Vec3<S>, hand: S) -> Vec3<S> {
    Vec3::new(v.x * hand, v.y * hand, v.z)
}

impl<S: Scalar> Body<S> {
    /// From position, velocity and angular velocity.
    #[must_use]
    pub fn from_values(v: &[S; BODY]) -> Self {
        let at = |start| Vec3::from_slice(v, start);
        Self { position: at(0), velocity: at(3), spin: at(6) }
    }

    /// Position, velocity and angular velocity.
    #[must_use]
    pub fn values(&self) -> [S; BODY] {
        let mut values = [S::zero(); BODY];
        self.position.put(&mut values, 0);
        self.velocity.put(&mut values, 3);
        self.spin.put(&mut values, 6);
        values
    }

    /// The mirror image in z, where `hand` is -1.
    #[must_use]
    pub fn mirrored(&self, hand: S) -> Self {
        Self {
            position: mirrored(self.position, hand),
            velocity: mirrored(self.velocity, hand),
            spin: mirrored_turn(self.spin, hand),
        }
    }
}

impl<S: Scalar> Head<S> {
    /// From the rotation row by row, position, velocity and angular velocity.
    #[must_use]
    pub fn from_values(v: &[S; HEAD]) -> Self {
        let at = |start| Vec3::from_slice(v, start);
        let body = Body { position: at(9), velocity: at(12), spin: at(15) };
        Self { rotation: Mat3::from_rows(at(0), at(3), at(6)), body }
    }

    /// The mirror image in z, where `hand` is -1.
    #[must_use]
    pub fn mirrored(&self, hand: S) -> Self {
        let [a, b, c] = self.rotation.rows;
        let rotation =
            Mat3::from_rows(mirrored(a, hand), mirrored(b, hand), Vec3::new(c.x * hand, c.y * hand, c.z));
        Self { rotation, body: self.body.mirrored(hand) }
    }
}

impl<S: Scalar> Wrench<S> {
    /// Force, torque on the ball, torque on the head, point, normal force, penetration, its rate.
    #[must_use]
    pub fn values(&self) -> [S; WRENCH] {
        let mut values = [S::zero(); WRENCH];
        for (i, vector) in [self.force, self.ball_torque, self.head_torque, self.point].iter().enumerate() {
            vector.put(&mut values, 3 * i);
        }
        values[12..].copy_from_slice(&[self.normal_force, self.depth, self.rate]);
        values
    }

    fn mirrored(&self, hand: S) -> Self {
        Self {
            force: mirrored(self.force, hand),
            ball_torque: mirrored_turn(self.ball_torque, hand),
            head_torque: mirrored_turn(self.head_torque, hand),
            point: mirrored(self.point, hand),
            ..*self
        }
    }
}

/// Checks that a rotation is one, and that a motion is of finite numbers.
///
/// # Errors
/// What is not, as "head" or "ball".
pub fn check_motion(head: &[f64; HEAD], ball: &[f64; BODY]) -> Result<(), ImpactError> {
    for (name, values) in [("head", &head[..]), ("ball", &ball[..])] {
        if let Some(value) = values.iter().find(|value| !value.is_finite()) {
            return Err(ImpactError::new(
                name,
                format!("{value} among pose and motion; allowed: finite numbers"),
            ));
        }
    }
    let rotation = Head::from_values(head).rotation;
    let product = rotation.transpose() * rotation;
    let identity = Mat3::<f64>::diagonal(1.0);
    let off = (0..3).map(|i| (product.rows[i] - identity.rows[i]).norm()).fold(0.0, f64::max);
    let upright = rotation.rows[0].cross(rotation.rows[1]).dot(rotation.rows[2]);
    // As exact as a quaternion in single precision.
    if off > 1e-6 || upright < 0.0 {
        let message = format!(
            "the rotation times its transpose misses the identity by {off:.1e}, its determinant is {upright:.3}; \
             allowed: a rotation to 1e-6"
        );
        return Err(ImpactError::new("head", message));
    }
    Ok(())
}

/// The contact of a model between a head and a ball that someone else moves.
///
/// Where head and ball are apart nothing acts. Everything is a function of the arguments; the internal states are those of
/// [`SteppedContact`], in axes fixed in the face: x along its normal at the centre, y up, z towards the toe.
pub struct HeadContact<S> {
    contact: Box<dyn SteppedContact<S>>,
    /// From the axes of the face to those of the head.
    face: Mat3<S>,
    hand: S,
    ball_inertia: S,
}

/// Distance, m, from which on bodies count as apart: rounding at first touch is less, and no law has a force by it.
const APART: f64 = 1e-12;

impl<S: SteppedScalar> HeadContact<S> {
    /// The contact that begins where head and ball are now. Of the `inputs` of a shot those of the delivery have no part.
    ///
    /// # Errors
    /// A model without a contact, faulty club, ball, parameters, pose or motion, or a face that moves away from the ball.
    pub fn begin(
        model: ImpactModel,
        inputs: &[f64; INPUT_COUNT],
        parameters: &[f64],
        head: &[f64; HEAD],
        ball: &[f64; BODY],
    ) -> Result<Self, ImpactError> {
        check_equipment(inputs)?;
        check_motion(head, ball)?;
        let shot = Shot::from_inputs(&inputs.map(S::from_f64));
        let hand = shot.club.hand;
        let head = Head::from_values(&head.map(S::from_f64)).mirrored(hand);
        let ball = Body::from_values(&ball.map(S::from_f64)).mirrored(hand);
        let touch = touch(&shot, &head, &ball);
        check_approach(touch.approach().re())?;
        Ok(Self {
            contact: model.stepped(&touch, parameters)?,
            face: Mat3::rotation_z(shot.club.static_loft.sin_cos()),
            hand,
            ball_inertia: shot.ball.inertia,
        })
    }
}

/// Head and ball at first touch, of a right-hander.
pub(crate) fn touch<S: Scalar>(shot: &Shot<S>, head: &Head<S>, ball: &Body<S>) -> FirstTouch<S> {
    let club = &shot.club;
    let attitude = head.rotation * Mat3::rotation_z(club.static_loft.sin_cos());
    let to_face = attitude.transpose();
    let velocity = head.body.velocity - ball.velocity;
    let centre = to_face * (ball.position - head.body.position);
    let nearest = club.face().nearest(centre - club.lever());
    FirstTouch {
        attitude,
        contact: centre - nearest.normal * nearest.distance,
        normal: nearest.normal,
        club_velocity: to_face * velocity,
        club_spin: to_face * head.body.spin,
        ball_spin: to_face * ball.spin,
        speed: head.body.velocity.norm(),
        ..FirstTouch::from_shot(shot)
    }
}

impl<S: Scalar> HeadContact<S> {
    /// Names of the internal states.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.contact.names()
    }

    /// The internal states at first touch.
    #[must_use]
    pub fn initial(&self) -> &[S] {
        self.contact.initial()
    }

    /// What acts now; the rates of the internal states go into `rates`.
    pub fn evaluate(&self, head: &Head<S>, ball: &Body<S>, internal: &[S], rates: &mut [S]) -> Wrench<S> {
        let (head, ball) = (head.mirrored(self.hand), ball.mirrored(self.hand));
        self.evaluate_right(&head, &ball, internal, rates).mirrored(self.hand)
    }

    /// The same of a right-hander.
    pub(crate) fn evaluate_right(
        &self,
        head: &Head<S>,
        ball: &Body<S>,
        internal: &[S],
        rates: &mut [S],
    ) -> Wrench<S> {
        let attitude = head.rotation * self.face;
        let motion = self.relative(attitude, head, ball, internal);
        let Instant { loads, normal_force, depth, rate } = self.contact.evaluate(&motion, internal, rates);
        let Loads { force, point, .. } = loads;
        let apart = depth.lt(S::from_f64(-APART));
        let force = Vec3::select(apart, Vec3::zero(), force);
        Wrench {
            force: attitude * force,
            ball_torque: attitude * (point - motion.position).cross(force),
            head_torque: attitude * -point.cross(force),
            point: head.body.position + attitude * point,
            normal_force,
            depth,
            rate,
        }
    }

    /// Ends a step at this instant: brings the memory among the internal states up to date.
    pub fn commit(&self, head: &Head<S>, ball: &Body<S>, internal: &mut [S]) {
        self.commit_right(&head.mirrored(self.hand), &ball.mirrored(self.hand), internal);
    }

    /// The same of a right-hander.
    pub(crate) fn commit_right(&self, head: &Head<S>, ball: &Body<S>, internal: &mut [S]) {
        let motion = self.relative(head.rotation * self.face, head, ball, internal);
        self.contact.commit(&motion, internal);
    }

    fn relative(
        &self,
        attitude: Mat3<S>,
        head: &Head<S>,
        ball: &Body<S>,
        internal: &[S],
    ) -> RelativeMotion<S> {
        let to_face = attitude.transpose();
        let ball_spin = to_face * ball.spin;
        let surface_spin = match self.contact.core() {
            // The core's is the first of the internal states of a layered ball.
            Some(core) => {
                let rest = (self.ball_inertia - core.inertia).recip();
                (ball_spin * self.ball_inertia - Vec3::from_slice(internal, 0) * core.inertia) * rest
            }
            None => ball_spin,
        };
        RelativeMotion {
            position: to_face * (ball.position - head.body.position),
            velocity: to_face * (ball.velocity - head.body.velocity),
            head_spin: to_face * head.body.spin,
            surface_spin,
        }
    }
}

/// Numbers of motion that a wrench is differentiated by: position, small turn about the axes of the world, velocity and
/// angular velocity of the head; position, velocity and angular velocity of the ball. The internal states follow.
pub const MOTION: usize = 12 + BODY;

impl HeadContact<Tangents> {
    /// The wrench and the rates of the internal states with their derivatives: a row for each of the [`WRENCH`] numbers and
    /// each rate, with the value first and then the derivatives by the [`MOTION`] and the internal states.
    #[must_use]
    pub fn jacobian(&self, head: &[f64; HEAD], ball: &[f64; BODY], internal: &[f64]) -> Vec<Vec<f64>> {
        const WIDTH: usize = 8;
        let variables = MOTION + internal.len();
        let mut rows = vec![vec![0.0; 1 + variables]; WRENCH + internal.len()];
        let mut rates = vec![Tangents::zero(); internal.len()];
        for start in (0..variables).step_by(WIDTH) {
            let vary = |index: usize, value: f64| {
                let mut dual = Tangents::from_f64(value);
                if (start..start + WIDTH).contains(&index) {
                    dual.tangent[index - start] = 1.0;
                }
                dual
            };
            let vector = |index: usize, values: &[f64]| {
                Vec3::new(vary(index, values[0]), vary(index + 1, values[1]), vary(index + 2, values[2]))
            };
            let turn = Mat3::diagonal(Tangents::one()) + Mat3::cross(vector(3, &[0.0; 3]));
            let still = Head::from_values(&head.map(Tangents::from_f64));
            let moved = Head {
                rotation: turn * still.rotation,
                body: Body {
                    position: vector(0, &head[9..]),
                    velocity: vector(6, &head[12..]),
                    spin: vector(9, &head[15..]),
                },
            };
            let ball = Body {
                position: vector(12, ball),
                velocity: vector(15, &ball[3..]),
                spin: vector(18, &ball[6..]),
            };
            let states: Vec<_> = internal.iter().enumerate().map(|(i, &v)| vary(MOTION + i, v)).collect();
            let wrench = self.evaluate(&moved, &ball, &states, &mut rates).values();
            for (row, value) in rows.iter_mut().zip(wrench.iter().chain(&rates)) {
                row[0] = value.value;
                let end = variables.min(start + WIDTH);
                row[1 + start..=end].copy_from_slice(&value.tangent[..end - start]);
            }
        }
        rows
    }
}
