//! Time stepping: central differences over all nodes, elements and contact side by side.

mod structure;

pub use structure::{Kinetics, Structure};
