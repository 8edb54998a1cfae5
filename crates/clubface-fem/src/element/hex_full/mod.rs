//! The eight-node hexahedron with eight integration points and one pressure.

mod element;
mod forces;
mod interface;
mod patch;

pub use patch::full_patches;
