//! Both bodies at the moment of first touch, in face axes: where every model starts.

use crate::ball::Ball;
use crate::face::{Face, tangents};
use crate::face_spring::FaceSpring;
use crate::head_inertia::{HeadInertia, HeadMobility};
use crate::launch::Launch;
use crate::shot::{INPUT_COUNT, Shot};
use clubface_math::{Computation, Mat3, Scalar, Vec3};

/// State at first touch. Face axes are fixed in the clubhead: origin of directions at the face centre, x along the
/// normal there, y up the face, z to the toe.
#[derive(Clone, Copy, Debug)]
pub struct FirstTouch<S> {
    /// Rotation from face axes to world axes (right-hander).
    pub attitude: Mat3<S>,
    /// Face curvatures.
    pub face: Face<S>,
    /// Characteristic time of the face, s; 0 is rigid.
    pub characteristic_time: S,
    /// Characteristic time of the face that the parameters of the model include, s.
    pub included_time: S,
    /// Mass and spring behind the face.
    pub spring: FaceSpring<S>,
    /// The ball.
    pub ball: Ball<S>,
    /// Inertia of the clubhead, face axes.
    pub head: HeadInertia<S>,
    /// CG to face centre, face axes, m.
    pub lever: Vec3<S>,
    /// CG to impact point, face axes, m.
    pub contact: Vec3<S>,
    /// Outward normal at the impact point (x'), face axes.
    pub normal: Vec3<S>,
    /// Clubhead velocity, face axes, m/s.
    pub club_velocity: Vec3<S>,
    /// Clubhead angular velocity, face axes, rad/s.
    pub club_spin: Vec3<S>,
    /// Angular velocity of the ball, face axes, rad/s; its centre is at rest.
    pub ball_spin: Vec3<S>,
    /// 1 or -1.
    pub hand: S,
    /// Clubhead speed, m/s.
    pub speed: S,
}

impl<S: Scalar> FirstTouch<S> {
    /// Sets the scene for a shot.
    #[inline(always)]
    pub fn from_shot(shot: &Shot<S>) -> Self {
        let Shot { delivery, club, ball, included_time } = shot;
        let delivery = delivery.for_right_hander(club.hand);
        let attitude = delivery.attitude(club.static_loft);
        let to_face = attitude.transpose();
        let face = club.face();
        let lever = club.lever();
        let point = face.point(delivery.toe, delivery.high);
        Self {
            attitude,
            face,
            characteristic_time: club.characteristic_time,
            included_time: *included_time,
            spring: FaceSpring::new(club.characteristic_time),
            ball: *ball,
            head: club.head_inertia(),
            lever,
            contact: lever + point,
            normal: face.nearest(point).normal,
            club_velocity: to_face * delivery.velocity(),
            club_spin: to_face * delivery.spin(),
            ball_spin: to_face * delivery.ball_spin(),
            hand: club.hand,
            speed: delivery.speed,
        }
    }

    /// Sets the scene for a shot given by its inputs, in their order.
    #[inline(always)]
    pub fn from_inputs(inputs: &[S; INPUT_COUNT]) -> Self {
        S::outline(Touch(inputs))
    }

    /// Speed at which face and ball approach along the normal at the impact point, m/s.
    #[inline(always)]
    pub fn approach(&self) -> S {
        self.normal.dot(self.club_velocity + self.club_spin.cross(self.contact))
    }

    /// Speed of approach gained per normal impulse at the impact point, 1/kg.
    #[inline(always)]
    pub fn normal_mobility(&self) -> S {
        self.ball.mass.recip() + self.head_mobility().along(self.contact, self.normal)
    }

    /// Velocities of the head by impulses, face axes.
    #[inline(always)]
    pub fn head_mobility(&self) -> HeadMobility<S> {
        self.head.mobility()
    }

    /// Whether the face gives otherwise than the one that the parameters include, or a derivative asks if it did.
    #[inline(always)]
    pub fn gives(&self) -> bool {
        !(self.characteristic_time.squared() - self.included_time.squared()).vanishes()
    }

    /// Tangent directions y' and z' at the impact point, face axes.
    #[inline(always)]
    pub fn tangents(&self) -> (Vec3<S>, Vec3<S>) {
        tangents(self.normal)
    }

    /// A velocity in world axes: for a left-hander the mirror image, turned round in z.
    #[inline(always)]
    pub fn world_velocity(&self, v: Vec3<S>) -> Vec3<S> {
        let w = self.attitude * v;
        Vec3::new(w.x, w.y, w.z * self.hand)
    }

    /// An angular velocity in world axes: for a left-hander the mirror image, turned round in x and y.
    #[inline(always)]
    pub fn world_spin(&self, v: Vec3<S>) -> Vec3<S> {
        let w = self.attitude * v;
        Vec3::new(w.x * self.hand, w.y * self.hand, w.z)
    }

    /// Launch from motions in face axes of first touch.
    #[inline(always)]
    pub fn launch(&self, ball: Motion<S>, club: Motion<S>) -> Launch<S> {
        S::outline(ToWorld { touch: self, ball: &ball, club: &club })
    }
}

struct ToWorld<'a, S> {
    touch: &'a FirstTouch<S>,
    ball: &'a Motion<S>,
    club: &'a Motion<S>,
}

impl<S: Scalar> Computation for ToWorld<'_, S> {
    type Output = Launch<S>;
    #[inline(always)]
    fn run(self) -> Launch<S> {
        let Self { touch, ball, club } = self;
        Launch {
            ball_velocity: touch.world_velocity(ball.velocity),
            ball_spin: touch.world_spin(ball.spin),
            club_velocity: touch.world_velocity(club.velocity),
            club_spin: touch.world_spin(club.spin),
            club_speed: touch.speed,
            contact_time: S::from_f64(f64::NAN),
            peak_force: S::from_f64(f64::NAN),
        }
    }
}

struct Touch<'a, S>(&'a [S; INPUT_COUNT]);

impl<S: Scalar> Computation for Touch<'_, S> {
    type Output = FirstTouch<S>;
    #[inline(always)]
    fn run(self) -> FirstTouch<S> {
        FirstTouch::from_shot(&Shot::from_inputs(self.0))
    }
}

/// Velocity and angular velocity of a body.
#[derive(Clone, Copy, Debug)]
pub struct Motion<S> {
    /// Velocity of the centre of mass, m/s.
    pub velocity: Vec3<S>,
    /// Angular velocity, rad/s.
    pub spin: Vec3<S>,
}
