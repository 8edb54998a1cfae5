//! Elements: how forces at nodes follow from their positions.
//!
//! Each kind has a room: the data of its patches, the kernels that compute on them, and what the solver calls.

mod block_nodes;
mod bond;
mod bulk_viscosity;
mod field;
mod hex_full;
mod hex_one_point;
mod kind;
mod output;
mod patch;
mod point;
mod shell;
mod tet_ten;

pub use bond::{BondPatch, Tie};
pub use bulk_viscosity::damped_step_ratio;
pub use field::Scratch;
pub use hex_one_point::{ReferenceHexahedron, constant_sets};
pub use kind::{Element, Kernels, Patches};
pub use output::{ElementOutput, OutputSink};
pub use patch::{Energy, Patch, RATIOS, StepOutput, parts};
pub use shell::{DEFAULT_POINTS, Isotropic, MAX_POINTS, Rule, SHELL_PATCH, ShellMaterial, ShellRows};
