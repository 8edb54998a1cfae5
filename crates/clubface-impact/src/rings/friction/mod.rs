//! Which rings stick, which slip and where to: Coulomb friction of all rings at once, in the plane of contact.
//!
//! Dimensionless: tractions y_j are in units of mu p0, displacements and slips in units of (2 - nu)/(8 G) a_max mu p0.
//! With M of [`Influence`](super::influence::Influence), bounds b_j = p_j/p0 and g_j the slip of a ring without
//! traction, ring j slips by s_j = g_j + (M y)_j, where either s_j = 0 and |y_j| <= b_j, or y_j = -b_j s_j/|s_j|.
//!
//! Newton's method on the set of sticking rings and the slip directions. Sticking rings are eliminated by the matrix
//! exchanged on them (cached where they are the innermost ones, as they nearly always are); what is left is one
//! unknown angle a slipping ring, and none where all slips are collinear. If the sets do not settle, projected
//! Gauss-Seidel sweeps lead to the neighbourhood of the solution.

mod directions;
mod factors;
mod given;
mod newton;
mod planes;
mod state;
mod sweeps;

pub use given::Given;
pub use newton::TOLERANCE;
pub use planes::Plane;
pub use state::{Effort, Friction};
