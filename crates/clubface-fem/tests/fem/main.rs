//! Tests of the finite elements, in one binary since each would link and compile the kernels on its own.

mod ball_on_plane;
mod contact;
mod derived_forces;
mod first_touch;
mod materials;
mod meshes;
mod messages;
mod quadrature;
mod shared_constants;
mod shells;
mod solver;
mod support;
mod surface;
mod verification;
mod worker_pool;
