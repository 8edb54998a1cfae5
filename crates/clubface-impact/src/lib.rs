//! From delivery to launch: clubs, balls, deliveries, one file per reduced impact model, and ball flight.
//!
//! World axes: x to the target, y up, z to the right. SI units and radians throughout.

pub mod ball;
pub mod batch;
pub mod check;
pub mod club;
pub mod contact;
pub mod delivery;
pub mod error;
pub mod face;
pub mod first_touch;
pub mod flight;
pub mod history;
pub mod launch;
pub mod model;
pub mod models;
pub mod registry;
pub mod rings;
pub mod sensitivity;
pub mod shot;

pub use error::ImpactError;
pub use model::{Accuracy, Law, ModelInfo};
pub use registry::ModelKind;
pub use shot::Shot;
