//! Parts of the solver.

mod body_motion;
mod schedule;
mod stable_step;
mod steps;
mod worker_pool;
