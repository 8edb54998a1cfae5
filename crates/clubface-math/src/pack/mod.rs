//! Packs: numbers that are computed side by side in one register. Shots of a batch, or elements of a mesh.
//!
//! A field on the nodes of a mesh is stored as one [`Row`] a node. A pack reads the rows of as many nodes as it has
//! lanes and transposes them in registers, which costs less than the arithmetic it feeds; eight separate reads a
//! component cost more.

mod dispatch;
mod dual;
mod operators;
mod part;
mod plain;
mod prefetch;
mod single;
mod traits;
mod twin;
#[cfg(any(target_arch = "aarch64", all(target_arch = "wasm32", target_feature = "simd128")))]
mod two;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use dispatch::{ONE_WIDTH, dispatch, dispatch_rows, with_lanes};
pub use prefetch::prefetch;
pub use traits::{Kernel, Lanes, Numbers, Pack, PackKernel, Part, Real, Row, RowsKernel};
pub use twin::Twin;
#[cfg(any(target_arch = "aarch64", all(target_arch = "wasm32", target_feature = "simd128")))]
pub use two::F64x2;
#[cfg(target_arch = "x86_64")]
pub use x86::{F64x4, F64x8};
