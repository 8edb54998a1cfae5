//! Time stepping: central differences over all nodes, elements and contact side by side.

mod history;
mod impact;
mod kinetics;
mod march;
mod options;
mod rest;
mod schedule;
mod shares;
mod stable_step;
mod structure;
mod together;
mod view;
mod worker_pool;

pub use history::{ContactFrame, EnergyFrame, Figures, History, MotionFrame};
pub use impact::{Impact, Outcome};
pub use kinetics::Kinetics;
pub use options::Options;
pub use stable_step::springs_of;
pub use structure::Structure;
pub use view::{Progress, Touched, View};
