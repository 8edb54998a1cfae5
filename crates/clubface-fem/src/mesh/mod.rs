//! Meshes of hexahedra for solids and of quadrilaterals for shells; the meshes of balls and heads.

mod cubed_sphere;
mod driver;
mod driver_shape;
mod driver_surface;
mod iron;
mod shell_check;
mod shell_mesh;
mod solid_mesh;
mod tuning;

pub use cubed_sphere::{cubed_sphere, Fineness};
pub use driver::DriverMesh;
pub use driver_shape::{DriverFineness, DriverShape, DriverThickness, Region};
pub use iron::{IronFineness, IronMesh, IronShape};
pub use shell_check::check_wall;
pub use shell_mesh::{ShellMasses, ShellMesh, ROTARY};
pub use solid_mesh::{base_vectors, jacobian, signs, SolidMesh, CORNERS};
pub use tuning::{mass_properties, tune, MassProperties, Target, Trim, Tuned};
