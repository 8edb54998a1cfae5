//! The four-node shell with one point in its plane.

mod forces;
mod interface;
mod layers;
mod material;
mod modes;
mod patch;
mod quadrature;
mod quadrilateral;
mod response;
mod section;

pub use material::ShellMaterial;
pub use patch::{SHELL_PATCH, ShellPatch, ShellRows};
pub use quadrature::{DEFAULT_POINTS, MAX_POINTS, Rule};
pub use section::Isotropic;
