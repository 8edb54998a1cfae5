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
/// Attitude of the clubhead relative to first touch, a quaternion.
pub const ATTITUDE: usize = 12;
/// Number of states of a ball in one piece.
pub const SOLID: usize = 16;
/// Sliding distance along y' and z', m (of contacts with a history).
pub const SLIP: usize = 16;
/// Angular velocity of the core, rad/s (layered ball).
pub const CORE_SPIN: usize = 16;
/// Rotation of the cover relative to the core, rad (layered ball).
pub const TWIST: usize = 19;
/// Number of states of a layered ball.
pub const LAYERED: usize = 22;
/// The face, where it gives, behind the states of the ball: how far it has moved inwards in the head, m, and its rate,
/// m/s.
pub const FACE: usize = 2;
/// Number of states of a ball in one piece on a face that gives.
pub const SOLID_GIVING: usize = SOLID + FACE;
/// Number of states of a ball in one piece with the sliding distance, on a face that gives.
pub const SLIDING: usize = 18 + FACE;
/// Number of states of a layered ball on a face that gives.
pub const LAYERED_GIVING: usize = LAYERED + FACE;
/// The energy ledger, which recorded contacts carry behind their other states: work taken by the normal force, by
/// friction and by the damper between cover and core, J. It acts on nothing and has no part in the size of a step, so
/// that a recorded contact ends as any other.
pub const LEDGER: usize = 3;
/// Number of states of a recorded ball in one piece.
pub const RECORDED_SOLID: usize = SOLID_GIVING + LEDGER;
/// Number of states of a recorded ball in one piece with the sliding distance.
pub const RECORDED_SLIDING: usize = SLIDING + LEDGER;
/// Number of states of a recorded layered ball.
pub const RECORDED_LAYERED: usize = LAYERED_GIVING + LEDGER;

/// Natural size that takes a state out of the error of a step.
const UNMEASURED: f64 = 1e200;

/// Whether contacts of `n` states have a layered ball.
#[must_use]
pub const fn layered(n: usize) -> bool {
    n == LAYERED || n == LAYERED_GIVING || n == RECORDED_LAYERED
}
/// Whether contacts of `n` states have the sliding distance.
#[must_use]
pub const fn sliding(n: usize) -> bool {
    n == SLIDING || n == RECORDED_SLIDING
}
/// Whether contacts of `n` states carry the energy ledger: it is their last [`LEDGER`] states.
#[must_use]
pub const fn recorded(n: usize) -> bool {
    n == RECORDED_SOLID || n == RECORDED_SLIDING || n == RECORDED_LAYERED
}

/// Where contacts of `n` states have those of the face; nowhere where it does not give otherwise than the parameters say.
#[must_use]
pub const fn face(n: usize) -> Option<usize> {
    match n {
        SOLID | LAYERED => None,
        _ if recorded(n) => Some(n - LEDGER - FACE),
        _ => Some(n - FACE),
    }
}

/// The contact point at one instant.
#[derive(Clone, Copy, Debug)]
pub struct ContactPoint<S> {
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

impl<S: Scalar> ContactPoint<S> {
    /// Reads a state vector, given the face as seen from the ball centre.
    #[inline(always)]
    pub fn new(nearest: &Nearest<S>, radius: S, y: &[S]) -> Self {
        let position = Vec3::from_slice(y, POSITION);
        let normal = nearest.normal;
        // The face moves parallel to itself.
        let (moved, moving) = face(y.len()).map_or((S::zero(), S::zero()), |at| (y[at], y[at + 1]));
        let arm = nearest.distance + moved;
        let point = position - normal * arm;
        let relative = Vec3::from_slice(y, VELOCITY) - Vec3::from_slice(y, CLUB_SPIN).cross(point);
        let rate = -normal.dot(relative) - moving;
        let surface = relative + normal.cross(Vec3::from_slice(y, BALL_SPIN)) * arm;
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
    touch.ball_spin.put(&mut y, BALL_SPIN);
    if layered(N) {
        touch.ball_spin.put(&mut y, CORE_SPIN);
    }
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
    if layered(N) {
        set(CORE_SPIN, 3, turn);
    }
    if sliding(N) {
        set(SLIP, 2, touch.ball.radius * 0.1);
    }
    if let Some(at) = face(N) {
        // It counts in the launch by what it stores, a tenth of the energy.
        set(at, 1, touch.ball.radius * 2.0);
        set(at + 1, 1, speed * 2.0);
    }
    if recorded(N) {
        set(N - LEDGER, LEDGER, S::from_f64(UNMEASURED));
    }
    scale
}
