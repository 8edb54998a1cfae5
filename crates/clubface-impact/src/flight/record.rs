//! The path of one shot, for plots.

use super::check::{check, never_lands};
use super::shot::{FlightShot, INPUT_COUNT};
use super::trajectory::{Flight, TOLERANCE, fly_to_ground};
use crate::error::ImpactError;
use crate::series::Series;
use clubface_math::Vec3;

/// Longest time between two recorded points, s.
const INTERVAL: f64 = 0.02;

/// States of a ball from launch to landing, at times at most 0.02 s apart.
#[derive(Clone, Debug, Default)]
pub struct Track {
    /// Time since launch, s.
    pub time: Vec<f64>,
    /// Position, m.
    pub position: Vec<[f64; 3]>,
    /// Velocity, m/s.
    pub velocity: Vec<[f64; 3]>,
    /// Angular velocity, rad/s.
    pub spin: Vec<[f64; 3]>,
}

impl Track {
    fn push(&mut self, time: f64, position: Vec3<f64>, velocity: Vec3<f64>, spin: Vec3<f64>) {
        self.time.push(time);
        self.position.push(position.array());
        self.velocity.push(velocity.array());
        self.spin.push(spin.array());
    }

    /// Every quantity of the points.
    #[must_use]
    pub fn series(&self) -> [Series; 4] {
        [
            Series::scalars("time", &self.time, |&time| time),
            Series::vectors("position", &self.position, |&position| position),
            Series::vectors("velocity", &self.velocity, |&velocity| velocity),
            Series::vectors("spin", &self.spin, |&spin| spin),
        ]
    }
}

/// The flight of one shot; its last point is the landing.
///
/// # Errors
/// An input that is not allowed, or a ball that does not come down.
pub fn trajectory(inputs: &[f64; INPUT_COUNT]) -> Result<Track, ImpactError> {
    check(inputs)?;
    let shot = FlightShot::from_inputs(inputs);
    let flight = Flight::new(&shot.ball, shot.spin, &shot.air);
    let mut track = Track::default();
    track.push(0.0, Vec3::zero(), shot.velocity, shot.spin);
    let landing = fly_to_ground(&flight, shot.velocity, TOLERANCE, INTERVAL, |time, y| {
        track.push(time, Vec3::from_slice(y, 0), Vec3::from_slice(y, 3), shot.spin * y[6]);
    });
    if !landing.landed {
        return Err(never_lands());
    }
    if landing.time > 0.0 {
        track.push(landing.time, landing.position, landing.velocity, landing.spin);
    }
    Ok(track)
}
