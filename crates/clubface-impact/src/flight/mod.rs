//! What the ball does after impact: flight through moist air and wind, bounces, roll.
//!
//! World axes: x to the target, y up, z right of the target line; the ball starts at the origin and lands where its
//! height returns to zero. Everything is generic over [`clubface_math::Scalar`], so one shot, packs of shots and
//! exact derivatives run through the same code.

pub mod aerodynamics;
pub mod air;
mod batch;
mod check;
pub mod event;
pub mod ground;
mod record;
mod sensitivities;
mod sensitivity;
mod shot;
pub mod shot_shape;
pub mod trajectory;

pub use batch::FlightBatch;
pub use check::check;
pub use record::{Track, trajectory};
pub use sensitivities::{CHUNK as DIFFERENTIATED, FlightSensitivities};
pub use sensitivity::{FlightSensitivity, sensitivity};
pub use shot::{
    FlightInput, FlightShot, Flown, INPUT_COUNT, INPUTS, OUTPUT_COUNT, OUTPUTS, default_inputs, fly,
};
pub use shot_shape::{SHOT_SHAPES, ShotShapes};
