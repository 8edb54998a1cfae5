//! The eight-node hexahedron with eight integration points and one pressure.

mod element;
mod energies;
mod forces;
mod interface;
mod output;
mod patch;
mod stress;

pub use patch::{full_patches, FullPatch};
