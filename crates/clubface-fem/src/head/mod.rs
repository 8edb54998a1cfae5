//! Deformable heads, of shells or of solid elements.

mod deformable;
mod driver;
mod shell;
mod solid;

pub use deformable::{DeformableHead, face_axes};
pub use driver::{Driver, MeshedDriver};
pub use shell::{ShellHead, ShellPart};
pub use solid::{Bond, SolidHead, SolidPart};
