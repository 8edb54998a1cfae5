//! How the clubhead arrives at the ball.

use clubface_math::{Mat3, Scalar, Vec3};

/// Delivery of the clubhead at first touch (meanings and signs: [`crate::shot::INPUTS`]).
#[derive(Clone, Copy, Debug)]
pub struct Delivery<S> {
    /// Speed of the clubhead CG, m/s.
    pub speed: S,
    /// Attack angle, rad, up is positive.
    pub attack: S,
    /// Path, rad, right is positive.
    pub path: S,
    /// Dynamic loft, rad.
    pub loft: S,
    /// Face angle, rad, right is positive.
    pub face: S,
    /// Lie tilt, rad, toe up is positive.
    pub lie: S,
    /// Impact offset towards the toe, m.
    pub toe: S,
    /// Impact offset towards the crown, m.
    pub high: S,
    /// Closure rate, rad/s, closing is positive.
    pub closure: S,
    /// Rate of loft, rad/s.
    pub pitch_rate: S,
    /// Rate of lie, rad/s, toe up is positive.
    pub lie_rate: S,
    /// Spin of the ball before impact about the horizontal to the right of the target, rad/s.
    pub ball_backspin: S,
    /// Spin of the ball before impact about the downward vertical, rad/s.
    pub ball_sidespin: S,
    /// Spin of the ball before impact about the horizontal to the target, rad/s.
    pub ball_riflespin: S,
}

impl<S: Scalar> Delivery<S> {
    /// The same swing seen in a mirror where `hand` is -1: path, face and the spin of the ball are given in world
    /// terms and change sign where a mirror does so, everything else follows the club.
    #[inline(always)]
    #[must_use]
    pub fn for_right_hander(mut self, hand: S) -> Self {
        self.path = self.path * hand;
        self.face = self.face * hand;
        self.ball_sidespin = self.ball_sidespin * hand;
        self.ball_riflespin = self.ball_riflespin * hand;
        self
    }

    /// Velocity of the clubhead CG in world axes, m/s (right-hander).
    #[inline(always)]
    pub fn velocity(&self) -> Vec3<S> {
        let (sin_attack, cos_attack) = self.attack.sin_cos();
        let (sin_path, cos_path) = self.path.sin_cos();
        Vec3::new(cos_attack * cos_path, sin_attack, cos_attack * sin_path) * self.speed
    }

    /// Angular velocity of the clubhead in world axes, rad/s (right-hander).
    #[inline(always)]
    pub fn spin(&self) -> Vec3<S> {
        Vec3::new(-self.lie_rate, self.closure, self.pitch_rate)
    }

    /// Angular velocity of the ball before impact in world axes, rad/s (right-hander).
    #[inline(always)]
    pub fn ball_spin(&self) -> Vec3<S> {
        Vec3::new(self.ball_riflespin, -self.ball_sidespin, self.ball_backspin)
    }

    /// Attitude of the clubhead: rotation from face axes to world axes (right-hander).
    ///
    /// From the reference pose (static loft, square): tilt by the lie, yaw the normal back to azimuth 0, turn about z
    /// until its elevation is the dynamic loft, yaw right by the face angle. Loft and face angle hold at any lie.
    #[inline(always)]
    pub fn attitude(&self, static_loft: S) -> Mat3<S> {
        let (sin_lie, cos_lie) = self.lie.sin_cos();
        let (sin_loft, cos_loft) = self.loft.sin_cos();
        let (sin_face, cos_face) = self.face.sin_cos();
        let static_turn = static_loft.sin_cos();
        let tilted = Mat3::rotation_x((-sin_lie, cos_lie)) * Mat3::rotation_z(static_turn);
        let normal = tilted.transpose().rows[0];
        let level = (normal.x.squared() + normal.z.squared()).sqrt();
        let square = Mat3::rotation_y((normal.z / level, normal.x / level));
        // Turning from elevation (level, normal.y) to the dynamic loft, without inverse functions.
        let raise = Mat3::rotation_z((
            sin_loft * level - cos_loft * normal.y,
            cos_loft * level + sin_loft * normal.y,
        ));
        let open = Mat3::rotation_y((-sin_face, cos_face));
        open * (raise * (square * tilted))
    }
}
