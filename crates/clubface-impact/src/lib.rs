//! From delivery to launch: clubs, balls, deliveries, one file per reduced impact model, and ball flight.
//!
//! World axes: x to the target, y up, z to the right. SI units and radians throughout.

pub mod ball;
pub mod batch;
pub mod check;
pub mod club;
pub mod columns;
pub mod contact;
pub mod delivery;
#[cfg(feature = "serde")]
pub mod describe;
pub mod description;
pub mod error;
pub mod face;
pub mod face_spring;
pub mod fault;
pub mod first_touch;
pub mod flight;
pub mod giving_face;
pub mod guided_mass;
pub mod head_inertia;
pub mod impact;
pub mod impact_model;
mod inertia_check;
mod kernels;
pub mod launch;
pub mod model;
pub mod models;
#[cfg(feature = "multibody")]
pub mod multibody;
#[cfg(feature = "multibody")]
pub mod own_law;
#[cfg(feature = "threads")]
pub mod parallel;
pub mod quantity;
pub mod registry;
pub mod rings;
pub mod sensitivity;
pub mod series;
pub mod shot;
#[cfg(feature = "multibody")]
pub mod struck_ball;
pub mod unit;

pub use description::{Law, ModelInfo, ModelKind};
pub use error::ImpactError;
pub use impact::Accuracy;
pub use impact_model::ImpactModel;
pub use shot::Shot;
