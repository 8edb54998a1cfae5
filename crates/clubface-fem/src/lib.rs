//! Explicit finite elements for the impact of club and ball.
//!
//! SI units throughout. Everything is generic over the stored number, [`clubface_math::Real`]: `f64`, or `f64` with
//! derivatives.

pub mod ball;
mod block;
pub mod cases;
pub mod contact;
pub mod description;
pub mod element;
pub mod environment;
pub mod error;
pub mod head;
pub mod material;
pub mod mesh;
pub mod moments;
pub mod sensitivity;
pub mod solve;

pub use error::FemError;
