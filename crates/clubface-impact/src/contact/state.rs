//! The state vector of a contact and what it says about the contact point.

use crate::face::Nearest;
use crate::first_touch::FirstTouch;
use clubface_math::{Scalar, Vec3};

/// Ball centre relative to the clubhead CG, m.
pub const POSITION: usize = 0;
/// Velocity of the ball relative to the clubhead CG, m/s.
pub const VELOCITY: usize = 3;
/// Angular velocity of the clubhead, rad/s.
pub const CLUB_SPIN: usize = 6;
/// Angular velocity of the ball, or of its cover, rad/s.
pub const BALL_SPIN: usize = 9;
/// The states before this one are all that the contact force depends on.
pub const SEEN: usize = 12;
/// Attitude of the clubhead relative to first touch, a quaternion.
pub const ATTITUDE: usize = 12;
/// Work taken by the normal force and by friction, J.
pub const WORK: usize = 16;
/// Number of states of a ball in one piece.
pub const SOLID: usize = 18;
/// Sliding distance along y' and z', m (contacts that remember it).
pub const SLIP: usize = 18;
/// Number of states of a ball in one piece on a face that remembers the sliding distance.
pub const SLIDING: usize = 20;
/// Angular velocity of the core, rad/s (layered ball).
pub const CORE_SPIN: usize = 18;
/// Rotation of the cover relative to the core, rad (layered ball).
pub const TWIST: usize = 21;
/// Work taken by the damper between cover and core, J (layered ball).
pub const LAYER_WORK: usize = 24;
/// Number of states of a layered ball.
pub const LAYERED: usize = 25;

/// The contact point at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Touching<S> {
    /// Outward face normal there.
    pub normal: Vec3<S>,
    /// Mean curvature of the face there, 1/m.
    pub curvature: S,
    /// Distance of the ball centre from the face, m: the lever arm of friction on the ball.
    pub arm: S,
    /// Contact point relative to the clubhead CG, m.
    pub point: Vec3<S>,
    /// Penetration, m; negative when apart.
    pub depth: S,
    /// Rate of penetration, m/s.
    pub rate: S,
    /// Velocity of the ball's surface relative to the face, in the tangent plane, m/s.
    pub sliding: Vec3<S>,
}

impl<S: Scalar> Touching<S> {
    /// Reads a state vector, given the face as seen from the ball centre.
    #[inline(always)]
    pub fn of(nearest: &Nearest<S>, radius: S, y: &[S]) -> Self {
        let position = Vec3::of(y, POSITION);
        let normal = nearest.normal;
        let arm = nearest.distance;
        let point = position - normal * arm;
        let relative = Vec3::of(y, VELOCITY) - Vec3::of(y, CLUB_SPIN).cross(point);
        let rate = -normal.dot(relative);
        let surface = relative + normal.cross(Vec3::of(y, BALL_SPIN)) * arm;
        Self {
            normal,
            curvature: nearest.curvature,
            arm,
            point,
            depth: radius - arm,
            rate,
            sliding: surface.reject(normal),
        }
    }
}

/// State at first touch.
#[inline(always)]
pub fn initial<S: Scalar, const N: usize>(touch: &FirstTouch<S>) -> [S; N] {
    let mut y = [S::zero(); N];
    (touch.contact + touch.normal * touch.ball.radius).put(&mut y, POSITION);
    (-touch.club_velocity).put(&mut y, VELOCITY);
    touch.club_spin.put(&mut y, CLUB_SPIN);
    y[ATTITUDE] = S::one();
    y
}

/// Natural sizes of the state components, which step errors are measured against: from the approach speed in m/s
/// and the ball.
#[inline(always)]
pub fn scales<S: Scalar, const N: usize>(touch: &FirstTouch<S>) -> [S; N] {
    let speed = touch.approach();
    let turn = speed / touch.ball.radius;
    let mut scale = [S::one(); N];
    let mut set = |start: usize, count: usize, value: S| {
        for i in start..start + count {
            scale[i] = value;
        }
    };
    set(POSITION, 3, touch.ball.radius);
    set(VELOCITY, 3, speed);
    set(CLUB_SPIN, 3, turn * 0.1);
    set(BALL_SPIN, 3, turn);
    set(WORK, 2, touch.ball.mass * speed * speed);
    if N == LAYERED {
        set(CORE_SPIN, 3, turn);
        set(LAYER_WORK, 1, touch.ball.mass * speed * speed);
    }
    if N == SLIDING {
        set(SLIP, 2, touch.ball.radius * 0.1);
    }
    scale
}
