//! Deformable heads, of shells or of hexahedra.

mod deformable;
mod driver;
mod shell;
mod solid;

pub use deformable::{face_axes, DeformableHead};
pub use driver::{Driver, MeshedDriver};
pub use shell::{ShellHead, ShellPart};
pub use solid::SolidHead;
