//! Meshes of hexahedra for solids and of quadrilaterals for shells; the meshes of balls and heads.

mod bonding;
mod cubed_sphere;
mod driver;
mod driver_shape;
mod driver_surface;
mod iron;
mod shell_check;
mod shell_mesh;
mod solid_mesh;
mod tetrahedra;
mod tuning;

pub use bonding::{BondedNode, bonded_nodes};
pub use cubed_sphere::{Fineness, cubed_sphere};
pub use driver::DriverMesh;
pub use driver_shape::{DriverFineness, DriverShape, DriverThickness, Region};
pub use iron::{IronFineness, IronMesh, IronShape};
pub use shell_check::{check_connected, check_wall};
pub use shell_mesh::{ROTARY, ShellMasses, ShellMesh};
pub use solid_mesh::{CORNERS, SolidMesh, base_vectors, jacobian, signs};
pub use tetrahedra::{EDGES, OTHER, OWN, TET_NODES, WEIGHT, between, mass_share, tet_base, tet_volumes};
pub use tuning::{MassProperties, Target, Trim, Tuned, mass_properties, tune};
