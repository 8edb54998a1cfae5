//! Time stepping: central differences over all nodes, elements and contact side by side.

mod history;
mod impact;
mod stable_step;
mod structure;

pub use history::{ContactFrame, EnergyFrame, Figures, History, MotionFrame};
pub use impact::{Impact, Options, Outcome, Progress};
pub use structure::{Kinetics, Structure};
