//! The eight-node hexahedron with one integration point and hourglass control.

mod arrangement;
mod assemble;
mod constants;
mod element;
mod indexed;
mod interface;
mod interior;
mod lattice;
mod numbers;
mod output;
mod passes;
mod patch;
mod places;
mod reference;
mod sameness;
mod stress;

pub use patch::{constant_sets, solid_patches};
pub use reference::ReferenceHexahedron;
