//! What comes out of an impact.

use crate::quantity::{Quantity, quantities};
use clubface_math::{Computation, Scalar, Vec3};

/// Motion of both bodies after impact, world axes.
#[derive(Clone, Copy, Debug)]
pub struct Launch<S> {
    /// Ball velocity, m/s.
    pub ball_velocity: Vec3<S>,
    /// Ball angular velocity, rad/s.
    pub ball_spin: Vec3<S>,
    /// Clubhead velocity, m/s.
    pub club_velocity: Vec3<S>,
    /// Clubhead angular velocity, rad/s.
    pub club_spin: Vec3<S>,
    /// Clubhead speed before impact, m/s.
    pub club_speed: S,
    /// Time from first touch to separation, s; NaN for a model without a time scale.
    pub contact_time: S,
    /// Largest normal force, N; NaN for a model without a time scale.
    pub peak_force: S,
}

/// Number of outputs.
pub const OUTPUT_COUNT: usize = 22;

/// All outputs, in the order of [`Launch::outputs`].
pub const OUTPUTS: [&Quantity; OUTPUT_COUNT] = quantities! {
    ball_speed smash launch azimuth backspin sidespin total_spin spin_axis
    velocity_x velocity_y velocity_z spin_x spin_y spin_z
    club_velocity_x club_velocity_y club_velocity_z club_spin_x club_spin_y club_spin_z
    contact_time peak_force
};

impl<S: Scalar> Launch<S> {
    /// Values in the order of [`OUTPUTS`].
    #[inline(always)]
    pub fn outputs(&self) -> [S; OUTPUT_COUNT] {
        S::outline(Outputs(self))
    }
}

struct Outputs<'a, S>(&'a Launch<S>);

impl<S: Scalar> Computation for Outputs<'_, S> {
    type Output = [S; OUTPUT_COUNT];
    #[inline(always)]
    fn run(self) -> [S; OUTPUT_COUNT] {
        let launch = self.0;
        let (v, w) = (launch.ball_velocity, launch.ball_spin);
        let speed = v.norm();
        let level = (v.x.squared() + v.z.squared()).safe_sqrt();
        // Backspin about the horizontal axis to the right of the launch direction, (-v.z, 0, v.x) / level.
        let upright = level.le(S::zero());
        let safe_level = S::select(upright, S::one(), level);
        let backspin = S::select(upright, w.z, (w.z * v.x - w.x * v.z) / safe_level);
        let sidespin = -w.y;
        [
            speed,
            speed / launch.club_speed,
            v.y.atan2(level),
            v.z.atan2(v.x),
            backspin,
            sidespin,
            w.norm(),
            sidespin.atan2(backspin),
            v.x,
            v.y,
            v.z,
            w.x,
            w.y,
            w.z,
            launch.club_velocity.x,
            launch.club_velocity.y,
            launch.club_velocity.z,
            launch.club_spin.x,
            launch.club_spin.y,
            launch.club_spin.z,
            launch.contact_time,
            launch.peak_force,
        ]
    }
}
