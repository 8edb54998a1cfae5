//! The ten-node tetrahedron with four integration points.

mod element;
mod forces;
mod interface;
mod patch;

pub use patch::tetrahedron_patches;
