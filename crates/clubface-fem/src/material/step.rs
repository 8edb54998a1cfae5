//! What stages are made of, apart from the law.

use super::viscous::Branches;

/// A material in one step.
#[derive(Clone, Copy, Debug)]
pub struct MaterialStep<'a, R> {
    /// Its viscoelastic branches.
    pub branches: Branches<'a, R>,
    /// Bulk modulus, Pa.
    pub bulk: R,
    /// The step, s; 0 where nothing moves on.
    pub time: f64,
}
