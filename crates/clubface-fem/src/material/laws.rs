//! The laws there are. A new one is one file and one line here.

use super::family::Law;
use super::hencky::Hencky;
use super::mooney_rivlin::MooneyRivlin;
use super::neo_hookean::NeoHookean;
use super::ogden::Ogden;
use super::table::{Number, from_table};
use super::von_mises::VonMises;
use crate::error::FemError;
use crate::materials;
use std::sync::Arc;

materials! {
    /// All laws.
    pub static LAWS;
    MooneyRivlin<()>;
    NeoHookean<()>;
    Hencky<()>;
    Ogden<()>;
    VonMises<()>;
}

/// A law from its name and constants (SI), in the order of [`LAWS`].
///
/// # Errors
/// [`FemError::Input`] for an unknown name, a wrong number of constants, or constants that are not allowed.
pub fn law_from_name<R: Number>(name: &str, constants: &[R]) -> Result<Arc<dyn Law<R>>, FemError> {
    from_table(LAWS, name, constants)
}
