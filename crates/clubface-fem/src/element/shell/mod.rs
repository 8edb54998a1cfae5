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
pub use patch::{ShellPatch, ShellRows, SHELL_PATCH};
pub use quadrature::{Rule, DEFAULT_POINTS, MAX_POINTS};
pub use section::Isotropic;
