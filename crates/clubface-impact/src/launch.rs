//! What comes out of an impact.

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

/// One output.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    /// Name, as in the Python API.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// What it is, and what positive means.
    pub meaning: &'static str,
}

macro_rules! outputs {
    ($($name:ident [$unit:literal], $meaning:literal;)+) => {
        [$(Output { name: stringify!($name), unit: $unit, meaning: $meaning }),+]
    };
}

/// Number of outputs.
pub const OUTPUT_COUNT: usize = 22;

/// All outputs, in the order of [`Launch::outputs`].
pub const OUTPUTS: [Output; OUTPUT_COUNT] = outputs! {
    ball_speed ["m/s"], "speed of the ball";
    smash ["1"], "smash factor: ball speed over clubhead speed";
    launch ["rad"], "launch angle above horizontal";
    azimuth ["rad"], "launch direction, right of target is positive";
    backspin ["rad/s"], "angular velocity about the horizontal axis right of the launch direction: lifts";
    sidespin ["rad/s"], "minus the vertical angular velocity: curves right";
    total_spin ["rad/s"], "magnitude of the angular velocity";
    spin_axis ["rad"], "spin axis tilt atan2(sidespin, backspin): right is positive";
    velocity_x ["m/s"], "ball velocity to the target";
    velocity_y ["m/s"], "ball velocity upwards";
    velocity_z ["m/s"], "ball velocity to the right";
    spin_x ["rad/s"], "ball angular velocity about x";
    spin_y ["rad/s"], "ball angular velocity about y";
    spin_z ["rad/s"], "ball angular velocity about z";
    club_velocity_x ["m/s"], "clubhead velocity to the target after impact";
    club_velocity_y ["m/s"], "clubhead velocity upwards after impact";
    club_velocity_z ["m/s"], "clubhead velocity to the right after impact";
    club_spin_x ["rad/s"], "clubhead angular velocity about x after impact";
    club_spin_y ["rad/s"], "clubhead angular velocity about y after impact";
    club_spin_z ["rad/s"], "clubhead angular velocity about z after impact";
    contact_time ["s"], "time from first touch to separation";
    peak_force ["N"], "largest normal force";
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
