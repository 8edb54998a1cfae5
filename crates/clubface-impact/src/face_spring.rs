//! A face that gives: one mass on one spring behind it, set by the characteristic time of the club.

use clubface_math::Scalar;

/// Mass that moves with the face, kg. Restitution and contact time of titanium drivers of shells with walls of 2 to 5 mm,
/// struck at 30, 49 and 60 m/s, are the same function of the spring to 0.002 and 3 us for any mass from 6 to 16 g.
pub const GUIDED_MASS: f64 = 0.012;

/// Compliance of the spring over the square of the characteristic time, 1/kg. With it the driver of Caldwell and McPhee
/// and the ball `modern` meet the two pairs of the Equipment Rules at 160 ft/s, 239 us with 0.822 and 257 us with 0.830,
/// to 0.001. A pendulum of 0.2 kg on that head, free and on one spring, would give 1.97: pressed at a point, a face gives
/// more than under a ball.
pub const COMPLIANCE: f64 = 1.17;

/// Characteristic times of faces that give, s: no club lies outside.
pub const CHARACTERISTIC_TIMES: [f64; 2] = [20e-6, 600e-6];

/// Mass and spring behind the face.
#[derive(Clone, Copy, Debug)]
pub struct FaceSpring<S> {
    /// Guided mass, kg; 0 where the face is rigid.
    pub mass: S,
    /// Its inverse, 1/kg; 0 where the face is rigid, as the mass is locked.
    pub inverse_mass: S,
    /// Stiffness, N/m; 0 where the face is rigid.
    pub stiffness: S,
}

impl<S: Scalar> FaceSpring<S> {
    /// Spring of a face with a characteristic time (s); 0 is rigid.
    #[inline(always)]
    pub fn new(characteristic_time: S) -> Self {
        let gives = characteristic_time.gt(S::zero());
        let only = |value: S| S::select(gives, value, S::zero());
        let time = S::select(gives, characteristic_time, S::one());
        Self {
            mass: only(S::from_f64(GUIDED_MASS)),
            inverse_mass: only(S::from_f64(GUIDED_MASS.recip())),
            stiffness: only((time.squared() * COMPLIANCE).recip()),
        }
    }
}
