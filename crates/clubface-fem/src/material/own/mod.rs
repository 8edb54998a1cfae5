//! A law that is a function of C, compiled by whoever wrote it: from the change of shape at some points to stress and
//! energy, with state variables of its own if it has any.
//!
//! The function is handed `C̄ = J^(-2/3) F^T F` and gives `2 dW/dC̄`, so that its stress turns with the body whatever
//! it computes. It must be isotropic, since elements see the undeformed body in axes of their own. It is called for all
//! points of some packs at once.

mod check;
mod function;
mod law;
mod number;
mod stage;

pub use function::{LawFunction, OWN_NUMBERS, OwnFunction, registered};
pub(super) use number::Points;
