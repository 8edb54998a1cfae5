//! What the contact is on average: where club and ball touch, with which normal, and how easily they move there.

use crate::first_touch::{FirstTouch, Motion};
use crate::head_inertia::HeadMobility;
use clubface_math::{Computation, Mat3, Scalar, Vec3};

/// Lever of friction on the ball over its radius, where only an estimate is needed.
const LEVER: f64 = 0.95;
/// Impulse over that of a dead normal impact, where only an estimate is needed.
const REBOUND: f64 = 1.8;
/// Ratio of the mobilities against a plate, about.
const PLATE: f64 = 3.5;
/// Ratio of the mobilities of clubs, over that against a plate.
const RATIO: f64 = 0.85;
/// Friction over what rolling needs, where only an estimate is needed.
const GRIP: f64 = 1.2;

/// A place of contact: CG of the clubhead to the point, m, and the outward normal there; axes of first touch.
#[derive(Clone, Copy)]
pub struct Place<S> {
    pub point: Vec3<S>,
    pub normal: Vec3<S>,
}

/// How club and ball move apart per impulse at a place.
#[derive(Clone, Copy)]
pub struct Mobility<S> {
    /// Relative velocity of ball and face along the normal per impulse along it, 1/kg.
    pub normal: S,
    /// Velocity along the face per impulse along the normal, 1/kg.
    pub coupling: Vec3<S>,
    /// Along the face, with the turning of the ball, 1/kg; the identity along the normal.
    pub tangential: Mat3<S>,
}

/// The head and the ball of one impact.
pub struct Bodies<'a, S> {
    pub touch: &'a FirstTouch<S>,
    pub head: HeadMobility<S>,
    pub friction: S,
}

impl<S: Scalar> Mobility<S> {
    /// Mean mobility along the face over that along the normal, near zero for clubs.
    #[inline(always)]
    pub fn ratio(&self) -> S {
        let [a, b, c] = self.tangential.rows;
        ((a.x + b.y + c.z - 1.0) / (self.normal * (2.0 * PLATE)) - RATIO) * 5.0
    }

    /// The mobility along the face as a matrix, in the measure of the ratio, zero along the normal.
    #[inline(always)]
    pub fn scaled(&self, vector: Vec3<S>) -> Vec3<S> {
        (self.tangential * vector * (self.normal * PLATE).recip() - vector * S::from_f64(RATIO))
            * S::from_f64(5.0)
    }
}

impl<S: Scalar> Bodies<'_, S> {
    /// Velocity of the ball's surface, at a distance from its centre, relative to the face at a place, before impact,
    /// m/s.
    #[inline(always)]
    pub fn approach(&self, place: Place<S>, arm: S) -> Vec3<S> {
        let Place { point, normal } = place;
        let touch = self.touch;
        normal.cross(touch.ball_spin) * arm - (touch.club_velocity + touch.club_spin.cross(point))
    }

    /// The same along the face, where only an estimate of the lever is needed.
    #[inline(always)]
    pub fn sliding(&self, place: Place<S>) -> Vec3<S> {
        self.approach(place, self.touch.ball.radius * LEVER).reject(place.normal)
    }

    /// How fast the ball turns about the normal relative to the face, as its surface speed at one radius over that of the
    /// whole approach.
    #[inline(always)]
    pub fn turning(&self, place: Place<S>, sliding: Vec3<S>, speed: S) -> S {
        let turning = place.normal.dot(self.touch.ball_spin - self.touch.club_spin);
        turning * self.touch.ball.radius / (sliding.norm_squared() + speed.squared()).sqrt()
    }

    /// Relative velocity at `seen` per impulse at `point`, without the turning of the ball.
    #[inline(always)]
    pub fn relative(&self, seen: Vec3<S>, point: Vec3<S>) -> Mat3<S> {
        Mat3::diagonal(self.touch.ball.mass.recip()) + self.head.between(seen, point)
    }

    #[inline(always)]
    pub fn mobility(&self, place: Place<S>) -> Mobility<S> {
        S::outline(MobilityAt { bodies: self, place })
    }

    /// An estimate of the whole impulse on the ball: a normal one, and along the face as much as friction has.
    #[inline(always)]
    pub fn estimate(&self, place: Place<S>, speed: S, mobility: &Mobility<S>) -> Vec3<S> {
        let normal = self.estimated_normal(speed, mobility);
        let sliding = self.sliding(place);
        let rolling = self.rolling(sliding, normal, mobility) * S::from_f64(-GRIP);
        let need = self.need(rolling, normal);
        place.normal * normal + rolling * (need.squared() + 1.0).sqrt().sqrt().recip()
    }

    /// Normal impulse of a lively ball, N s, that meets the face at this speed.
    #[inline(always)]
    pub fn estimated_normal(&self, speed: S, mobility: &Mobility<S>) -> S {
        speed * REBOUND / mobility.normal
    }

    /// Square of an impulse along the face over the limit of friction, finite without friction, too.
    #[inline(always)]
    pub fn need(&self, along: Vec3<S>, normal: S) -> S {
        along.norm_squared() / ((self.friction.squared() + 1e-12) * normal.squared())
    }

    /// Minus the impulse along the face that ends in rolling, N s.
    #[inline(always)]
    pub fn rolling(&self, sliding: Vec3<S>, normal: S, mobility: &Mobility<S>) -> Vec3<S> {
        mobility.tangential.inverse() * (sliding + mobility.coupling * normal)
    }

    /// The place of contact after ball and head have moved: `turn` is the rotation of the head, `shift` the
    /// displacement of the ball relative to the head's CG.
    #[inline(always)]
    pub fn place(&self, turn: Vec3<S>, shift: Vec3<S>) -> Place<S> {
        S::outline(PlaceAfter { touch: self.touch, turn, shift })
    }
}

// What a contact needs twice, as functions of their own.

struct MobilityAt<'a, S> {
    bodies: &'a Bodies<'a, S>,
    place: Place<S>,
}

impl<S: Scalar> Computation for MobilityAt<'_, S> {
    type Output = Mobility<S>;
    #[inline(always)]
    fn run(self) -> Mobility<S> {
        let Self { bodies, place } = self;
        let head = bodies.relative(place.point, place.point);
        let gained = head * place.normal;
        let normal = place.normal.dot(gained);
        let coupling = gained.reject(place.normal);
        let ball = &bodies.touch.ball;
        let rolling = (ball.radius * LEVER).squared() / ball.inertia;
        // Head and rolling along the face alone: P (H + rolling) P, and the identity along the normal.
        let along = Mat3::outer(place.normal, place.normal).scale(-S::one()) + Mat3::diagonal(S::one());
        let tangential =
            along * ((head + Mat3::diagonal(rolling)) * along) + Mat3::outer(place.normal, place.normal);
        Mobility { normal, coupling, tangential }
    }
}

struct PlaceAfter<'a, S> {
    touch: &'a FirstTouch<S>,
    turn: Vec3<S>,
    shift: Vec3<S>,
}

impl<S: Scalar> Computation for PlaceAfter<'_, S> {
    type Output = Place<S>;
    #[inline(always)]
    fn run(self) -> Place<S> {
        let Self { touch, turn, shift } = self;
        let ball = touch.contact + touch.normal * touch.ball.radius + shift;
        let in_head = ball - turn.cross(ball);
        let nearest = touch.face.nearest(in_head - touch.lever);
        let normal = nearest.normal + turn.cross(nearest.normal);
        let point = in_head - nearest.normal * nearest.distance;
        Place { point: point + turn.cross(point), normal: normal * normal.norm_squared().sqrt().recip() }
    }
}

/// What an impulse at a place, and a couple there, make of club and ball.
pub struct Impulse<S> {
    pub place: Place<S>,
    /// On the ball, N s.
    pub linear: Vec3<S>,
    /// On the ball, N m s.
    pub couple: Vec3<S>,
    /// Distance of the ball's CG from the contact point, m.
    pub arm: S,
}

impl<S: Scalar> Impulse<S> {
    /// Both motions after impact. An impulse that would make energy is scaled down to where it makes none.
    #[inline(always)]
    pub fn motions(&self, bodies: &Bodies<S>) -> (Motion<S>, Motion<S>) {
        let Self { place, linear, couple, arm } = *self;
        let touch = bodies.touch;
        let ball = &touch.ball;
        let spin = (linear.cross(place.normal) * arm + couple) * ball.inertia.recip();
        let head_torque = place.point.cross(linear) + couple;
        let (slowed, head_spin) = bodies.head.response(linear, head_torque);
        // Energy gained by a share of the impulse: share * first + share^2 * second.
        let first = linear.dot(bodies.approach(place, arm)) - couple.dot(touch.club_spin - touch.ball_spin);
        let second = (linear.norm_squared() * ball.mass.recip()
            + linear.dot(slowed)
            + spin.norm_squared() * ball.inertia
            + head_spin.dot(head_torque))
            * 0.5;
        let nothing = second.le(S::zero());
        let most = -first / S::select(nothing, S::one(), second);
        let share = S::zero().max(S::one().min(most));
        let [linear, spin, slowed, head_spin] = [linear, spin, slowed, head_spin].map(|each| each * share);
        (
            Motion { velocity: linear * ball.mass.recip(), spin: touch.ball_spin + spin },
            Motion { velocity: touch.club_velocity - slowed, spin: touch.club_spin - head_spin },
        )
    }
}
