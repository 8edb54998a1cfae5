//! The eight-node hexahedron with one integration point and hourglass control.

mod arrangement;
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
mod sameness;
mod stress;
mod walk;

pub use patch::{constant_sets, solid_patches};
