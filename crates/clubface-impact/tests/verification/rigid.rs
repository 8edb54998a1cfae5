//! Momentum, angular momentum, energy and relative velocity of an impact, worked out from its outputs.

use crate::shots::{Inputs, Outputs, moves, parameter};
use clubface_impact::ImpactModel;
use clubface_impact::first_touch::FirstTouch;
use clubface_math::{Mat3, Vec3};

/// An impact at one point in face axes, a left-hander's in the mirror.
pub struct Rigid {
    pub touch: FirstTouch<f64>,
    /// Mass that moves with the clubhead, kg.
    pub club_mass: f64,
    /// CG of the ball to the contact point, m.
    pub ball_arm: Vec3<f64>,
    pub ball_velocity: Vec3<f64>,
    pub ball_spin: Vec3<f64>,
    pub club_velocity: Vec3<f64>,
    pub club_spin: Vec3<f64>,
    /// Whether ball and head move while they touch.
    pub moves: bool,
}

impl Rigid {
    pub fn new(model: ImpactModel, inputs: &Inputs, parameters: &[f64], outputs: &Outputs) -> Self {
        let touch = FirstTouch::from_inputs(&inputs.0);
        let named = |name: &str| parameter(model, name).map_or(0.0, |index| parameters[index]);
        let (up, toe) = touch.tangents();
        let displaced = touch.normal * named("dcg_x") + up * named("dcg_y") + toe * named("dcg_z");
        let to_face = touch.attitude.transpose();
        let velocity = |v: Vec3<f64>| to_face * Vec3::new(v.x, v.y, v.z * touch.hand);
        let spin = |v: Vec3<f64>| to_face * Vec3::new(v.x * touch.hand, v.y * touch.hand, v.z);
        Self {
            club_mass: touch.head.mass + named("extra_mass"),
            ball_arm: touch.normal * -touch.ball.radius - displaced,
            ball_velocity: velocity(outputs.ball_velocity()),
            ball_spin: spin(outputs.ball_spin()),
            club_velocity: velocity(outputs.club_velocity()),
            club_spin: spin(outputs.club_spin()),
            touch,
            moves: moves(model),
        }
    }

    /// Impulse on the ball, N s.
    pub fn impulse(&self) -> Vec3<f64> {
        self.ball_velocity * self.touch.ball.mass
    }

    /// Spin that the ball gained, rad/s.
    pub fn spin_gained(&self) -> Vec3<f64> {
        self.ball_spin - self.touch.ball_spin
    }

    /// Momentum of the head before impact, N s.
    fn momentum_before(&self) -> f64 {
        self.club_mass * self.touch.club_velocity.norm()
    }

    /// Change of the momentum of both bodies, in units of the head's.
    pub fn momentum_error(&self) -> f64 {
        let club = (self.club_velocity - self.touch.club_velocity) * self.club_mass;
        (self.impulse() + club).norm() / self.momentum_before()
    }

    /// Change of the angular momentum of both bodies about the contact point, in units of the head's momentum times the
    /// radius of the ball. Where neither body moves during an impulse, the arms stay. Where the ball moves meanwhile,
    /// by a distance that the model knows, only the part along the impulse must vanish: no displacement of the ball
    /// changes it.
    pub fn angular_momentum_error(&self) -> f64 {
        let touch = &self.touch;
        let ball = (-self.ball_arm).cross(self.impulse()) + self.spin_gained() * touch.ball.inertia;
        let club_velocity = (self.club_velocity - touch.club_velocity) * self.club_mass;
        let club =
            (-touch.contact).cross(club_velocity) + touch.head.inertia * (self.club_spin - touch.club_spin);
        let (change, impulse) = (ball + club, self.impulse());
        let change =
            if self.moves { change.dot(impulse).abs() / (impulse.norm() + 1e-300) } else { change.norm() };
        change / (self.momentum_before() * touch.ball.radius)
    }

    fn energy(&self, ball: (Vec3<f64>, Vec3<f64>), club: (Vec3<f64>, Vec3<f64>)) -> f64 {
        0.5 * (self.touch.ball.mass * ball.0.norm_squared()
            + self.touch.ball.inertia * ball.1.norm_squared()
            + self.club_mass * club.0.norm_squared()
            + club.1.dot(self.touch.head.inertia * club.1))
    }

    /// Kinetic energy before impact, J.
    pub fn energy_before(&self) -> f64 {
        let touch = &self.touch;
        self.energy((Vec3::zero(), touch.ball_spin), (touch.club_velocity, touch.club_spin))
    }

    /// Kinetic energy lost, J.
    pub fn energy_lost(&self) -> f64 {
        let after = self.energy((self.ball_velocity, self.ball_spin), (self.club_velocity, self.club_spin));
        self.energy_before() - after
    }

    /// Velocity of the ball relative to the face at the contact point before impact, m/s.
    pub fn relative_before(&self) -> Vec3<f64> {
        let touch = &self.touch;
        touch.ball_spin.cross(self.ball_arm) - (touch.club_velocity + touch.club_spin.cross(touch.contact))
    }

    /// The same after impact.
    pub fn relative_after(&self) -> Vec3<f64> {
        let ball = self.ball_velocity + self.ball_spin.cross(self.ball_arm);
        ball - self.club_velocity - self.club_spin.cross(self.touch.contact)
    }

    /// Matrix from the impulse on the ball to the relative velocity it gives, by its columns, 1/kg.
    pub fn mobility(&self) -> Mat3<f64> {
        let touch = &self.touch;
        let inverse = touch.head.inertia.inverse();
        let angular = |p: Vec3<f64>| {
            let ball = p * touch.ball.mass.recip()
                + (self.ball_arm.cross(p) * touch.ball.inertia.recip()).cross(self.ball_arm);
            ball + p * self.club_mass.recip() + (inverse * touch.contact.cross(p)).cross(touch.contact)
        };
        let unit = |i: usize| {
            let mut v = [0.0; 3];
            v[i] = 1.0;
            Vec3::from_f64(v)
        };
        Mat3::from_columns(angular(unit(0)), angular(unit(1)), angular(unit(2)))
    }
}
