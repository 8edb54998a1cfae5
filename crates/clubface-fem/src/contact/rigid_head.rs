//! A rigid clubhead with a plane or torus face, moving freely.

use super::RigidSurface;
use clubface_impact::face::Face;
use clubface_impact::first_touch::{FirstTouch, Motion};
use clubface_math::{Mat3, Quat, Real, Vec3};

/// The head, in face axes of first touch with the origin at its CG then.
#[derive(Clone, Debug)]
pub struct RigidHead<R> {
    face: Face<R>,
    /// Vector from CG to face centre in face axes, m.
    centre_to_face: Vec3<R>,
    mass: R,
    inverse_inertia: Mat3<R>,
    position: Vec3<R>,
    attitude: Quat<R>,
    /// Rotation from face axes to those of first touch.
    rotation: Mat3<R>,
    velocity: Vec3<R>,
    angular_momentum: Vec3<R>,
    spin: Vec3<R>,
    force: Vec3<R>,
    torque: Vec3<R>,
    /// Velocity and angular velocity half a step earlier.
    before: (Vec3<R>, Vec3<R>),
}

impl<R: Real> RigidHead<R> {
    /// The head of a shot at first touch.
    pub fn new(touch: &FirstTouch<R>) -> Self {
        Self {
            face: touch.face,
            centre_to_face: touch.lever,
            mass: touch.club_mass,
            inverse_inertia: touch.inertia.inverse(),
            position: Vec3::zero(),
            attitude: Quat::identity(),
            rotation: Mat3::diagonal(R::one()),
            velocity: touch.club_velocity,
            angular_momentum: touch.inertia * touch.club_spin,
            spin: touch.club_spin,
            force: Vec3::zero(),
            torque: Vec3::zero(),
            before: (touch.club_velocity, touch.club_spin),
        }
    }
}

impl<R: Real> RigidSurface<R> for RigidHead<R> {
    fn nearest(&self, point: Vec3<R>) -> (R, Vec3<R>) {
        let local = self.rotation.transpose() * (point - self.position) - self.centre_to_face;
        let nearest = self.face.nearest(local);
        (nearest.distance, self.rotation * nearest.normal)
    }
    fn velocity(&self, point: Vec3<R>) -> Vec3<R> {
        self.velocity + self.spin.cross(point - self.position)
    }
    fn apply_force(&mut self, force: Vec3<R>, point: Vec3<R>) {
        self.force += force;
        self.torque += (point - self.position).cross(force);
    }
    fn advance(&mut self, dt: f64) {
        let step = R::from_f64(dt);
        self.before = (self.velocity, self.spin);
        self.velocity += self.force * (step / self.mass);
        self.angular_momentum += self.torque * step;
        // Midpoint rule: half a step with the old rotation, then the whole step with the rotation found there.
        let middle = self.rotated(self.body_spin(self.rotation), dt * 0.5);
        self.attitude = self.rotated(self.body_spin(middle.matrix()), dt);
        self.rotation = self.attitude.matrix();
        self.spin = self.rotation * self.body_spin(self.rotation);
        self.position += self.velocity * step;
        self.force = Vec3::zero();
        self.torque = Vec3::zero();
    }
    fn kinetic_energy(&self) -> f64 {
        let (velocity, spin) = self.before;
        0.5 * (self.mass * self.velocity.dot(velocity) + self.angular_momentum.dot(spin)).re()
    }
    fn motion(&self) -> Motion<R> {
        Motion { velocity: self.velocity, spin: self.spin }
    }
}

impl<R: Real> RigidHead<R> {
    /// Angular velocity in body axes, given the rotation of the body.
    fn body_spin(&self, rotation: Mat3<R>) -> Vec3<R> {
        self.inverse_inertia * (rotation.transpose() * self.angular_momentum)
    }
    /// Attitude after a rotation of `dt` seconds, of unit length.
    fn rotated(&self, body_spin: Vec3<R>, dt: f64) -> Quat<R> {
        let rate = self.attitude.rate(body_spin);
        let step = R::from_f64(dt);
        let (w, v) = (self.attitude.w + rate.w * step, self.attitude.v + rate.v * step);
        let scale = (w * w + v.norm_squared()).sqrt().recip();
        Quat { w: w * scale, v: v * scale }
    }
}
