//! Time stepping: central differences over all nodes, elements and contact side by side.

mod history;
mod impact;
mod kinetics;
mod march;
mod options;
mod rest;
mod roster;
mod shares;
mod stable_step;
mod structure;
mod team;
mod together;
mod view;

pub use history::{ContactFrame, EnergyFrame, Figures, History, MotionFrame};
pub use impact::{Impact, Outcome};
pub use kinetics::Kinetics;
pub use options::Options;
pub use stable_step::springs_of;
pub use structure::Structure;
pub use view::{Progress, Touched, View};
