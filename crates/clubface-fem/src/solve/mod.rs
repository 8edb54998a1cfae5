//! Time integration by central differences, for all nodes, elements and the contact at once.

mod assembly;
mod body_motion;
mod energy_balance;
mod gather;
mod impact_record;
mod integration;
mod measurement;
mod options;
mod recorder;
mod records;
mod run;
mod schedule;
mod shared_slice;
mod simulation;
mod snapshot;
mod stable_step;
mod structure;
mod subcycling;
mod worker_pool;

pub use body_motion::BodyMotion;
pub use impact_record::{ContactPoint, ElementHistory, ImpactRecord, Recording};
pub use integration::StepObserver;
pub use options::Options;
pub use records::{ContactRecord, EnergyRecord, MotionRecord, Records, Summary};
pub use run::SimulationResult;
pub use schedule::balanced;
pub use simulation::Simulation;
pub use snapshot::{NodeForce, Progress, Snapshot};
pub use stable_step::{largest_eigenvalue, springs_for_stable_step};
pub use structure::Structure;
pub use worker_pool::{Stage, WorkerPool};
