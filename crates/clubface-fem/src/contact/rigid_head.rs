//! A clubhead with a plane or torus face, moving freely: rigid but for a mass on a spring behind the face.

use super::RigidSurface;
use clubface_impact::face::Face;
use clubface_impact::first_touch::{FirstTouch, Motion};
use clubface_impact::guided_mass::GuidedMass;
use clubface_impact::head_inertia::{HeadInertia, HeadMobility};
use clubface_math::{Mat3, Quat, Real, Vec3};

/// The head, in face axes of first touch with the origin at its CG then.
#[derive(Clone, Debug)]
pub struct RigidHead<R> {
    face: Face<R>,
    /// Vector from CG to face centre in face axes, m.
    centre_to_face: Vec3<R>,
    inertia: HeadInertia<R>,
    mobility: HeadMobility<R>,
    guided: GuidedMass<R>,
    /// Velocity of the CG at first touch.
    approach: Vec3<R>,
    /// The CG.
    centre: Vec3<R>,
    attitude: Quat<R>,
    /// Rotation from face axes to those of first touch.
    rotation: Mat3<R>,
    /// Motion of the head as a whole.
    mean: Motion<R>,
    /// Momentum of head and mechanism in a frame that moves as the CG did at first touch, and angular momentum about the
    /// CG.
    momentum: Vec3<R>,
    angular_momentum: Vec3<R>,
    /// The mechanism's part of the momentum, half a step before the others.
    carried: Vec3<R>,
    /// Momentum of the guided mass inwards, kg m/s.
    guided_momentum: R,
    /// How far the face has given, m.
    depth: R,
    /// Motion of the body around the guided mass, and the speed of the mass in it, half a step before the others.
    around: Motion<R>,
    rate: R,
    /// Where the body around the guided mass has its own centre: apart from the CG while the face gives.
    position: Vec3<R>,
    force: Vec3<R>,
    torque: Vec3<R>,
    energy: f64,
}

impl<R: Real> RigidHead<R> {
    /// The head of a shot at first touch.
    pub fn new(touch: &FirstTouch<R>) -> Self {
        let mobility = touch.head_mobility();
        let motion = Motion { velocity: touch.club_velocity, spin: touch.club_spin };
        let guided = GuidedMass::new(touch.spring, &mobility, touch.contact, touch.normal);
        let (momentum, angular_momentum) = touch.head.momenta(Vec3::zero(), touch.club_spin);
        Self {
            face: touch.face,
            centre_to_face: touch.lever,
            inertia: touch.head,
            mobility,
            guided,
            approach: touch.club_velocity,
            centre: Vec3::zero(),
            attitude: Quat::identity(),
            rotation: Mat3::diagonal(R::one()),
            mean: motion,
            momentum,
            angular_momentum,
            carried: momentum,
            guided_momentum: guided.carried(motion),
            depth: R::zero(),
            around: motion,
            rate: R::zero(),
            position: Vec3::zero(),
            force: Vec3::zero(),
            torque: Vec3::zero(),
            energy: 0.0,
        }
    }
}

impl<R: Real> RigidSurface<R> for RigidHead<R> {
    fn nearest(&self, point: Vec3<R>) -> (R, Vec3<R>) {
        let origin = self.centre_to_face + self.guided.inward * self.depth;
        let local = self.rotation.transpose() * (point - self.position) - origin;
        let nearest = self.face.nearest(local);
        (nearest.distance, self.rotation * nearest.normal)
    }
    fn velocity(&self, point: Vec3<R>) -> Vec3<R> {
        let surface = self.around.velocity + self.rotation * self.guided.inward * self.rate;
        surface + self.around.spin.cross(point - self.position)
    }
    fn apply_force(&mut self, force: Vec3<R>, point: Vec3<R>) {
        self.force += force;
        self.torque += (point - self.centre).cross(force);
    }
    fn advance(&mut self, dt: f64) {
        let step = R::from_f64(dt);
        let stiffness = self.guided.spring.stiffness;
        self.momentum += self.force * step;
        self.angular_momentum += self.torque * step;
        if self.inertia.added.is_some() {
            // A free head's momentum is along its velocity.
            let change = self.mean.velocity - self.approach;
            self.angular_momentum += self.momentum.cross(change) * step;
        }
        let inwards = (self.rotation * self.guided.inward).dot(self.force);
        self.guided_momentum += (inwards - stiffness * self.depth) * step;
        // Momenta half a step later, velocities half a step earlier.
        let own = self.approach * self.inertia.mass + self.momentum;
        let carried = self.carried_momentum();
        let kinetic = own.dot(self.around.velocity)
            + self.angular_momentum.dot(self.around.spin)
            + self.guided_momentum * self.rate
            + self.approach.dot(self.carried + carried) * R::from_f64(0.5);
        self.carried = carried;
        self.energy = 0.5 * (kinetic + stiffness * self.depth.squared()).re();
        // Midpoint rule: half a step with the old rotation, then the whole step with the rotation found there.
        let middle = self.rotated(self.body_spin(self.rotation), dt * 0.5);
        self.attitude = self.rotated(self.body_spin(middle.matrix()), dt);
        self.rotation = self.attitude.matrix();
        let mean = self.mean_motion(self.rotation);
        self.mean = Motion {
            velocity: match self.inertia.added {
                None => self.approach + self.momentum * self.inertia.mass.recip(),
                Some(_) => self.rotation * mean.velocity,
            },
            spin: self.rotation * mean.spin,
        };
        self.rate = self.guided.rate(self.guided_momentum, mean);
        let recoil = self.guided.recoil(self.rate);
        self.around = Motion {
            velocity: self.mean.velocity + self.rotation * recoil.velocity,
            spin: self.rotation * (mean.spin + recoil.spin),
        };
        self.depth += self.rate * step;
        self.centre += self.mean.velocity * step;
        self.position = self.centre + self.rotation * self.guided.recoil(self.depth).velocity;
        self.force = Vec3::zero();
        self.torque = Vec3::zero();
    }
    fn energy(&self) -> f64 {
        self.energy
    }
    fn motion(&self) -> Motion<R> {
        self.mean
    }
}

impl<R: Real> RigidHead<R> {
    /// Mean motion in body axes, given the rotation of the body.
    fn mean_motion(&self, rotation: Mat3<R>) -> Motion<R> {
        let inverse = rotation.transpose();
        let (change, spin) = self.mobility.response(inverse * self.momentum, inverse * self.angular_momentum);
        Motion { velocity: inverse * self.approach + change, spin }
    }
    /// Momentum of the mechanism in the moving frame; zero for a free head.
    fn carried_momentum(&self) -> Vec3<R> {
        let Some(added) = &self.inertia.added else { return Vec3::zero() };
        let mean = self.mean_motion(self.rotation);
        let recoil = self.guided.recoil(self.guided.rate(self.guided_momentum, mean));
        let change = mean.velocity + recoil.velocity - self.rotation.transpose() * self.approach;
        self.rotation * added.multiply(change, mean.spin + recoil.spin).0
    }
    /// Angular velocity of the body around the guided mass in body axes, given the rotation of the body.
    fn body_spin(&self, rotation: Mat3<R>) -> Vec3<R> {
        let mean = self.mean_motion(rotation);
        mean.spin + self.guided.recoil(self.guided.rate(self.guided_momentum, mean)).spin
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
