//! The laws there are. A new one is one file and one line here.

use super::family::Law;
use super::hencky::Hencky;
use super::mooney_rivlin::MooneyRivlin;
use super::neo_hookean::NeoHookean;
use super::ogden::Ogden;
use super::own::registered;
use super::table::{Number, entry_from_name};
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

/// A law of the table or a registered one, from its name and constants (SI).
///
/// # Errors
/// [`FemError::Input`] for an unknown name, a wrong number of constants, or constants that are not allowed.
pub fn law_from_name<R: Number>(name: &str, constants: &[R]) -> Result<Arc<dyn Law<R>>, FemError> {
    let law = unchecked_law(name, constants)?;
    law.check(name)?;
    Ok(law)
}

/// The same, with constants of any value.
///
/// # Errors
/// [`FemError::Input`] for an unknown name or a wrong number of constants.
pub fn unchecked_law<R: Number>(name: &str, constants: &[R]) -> Result<Arc<dyn Law<R>>, FemError> {
    match registered(name) {
        Some(function) => function.law(constants),
        None => Ok(R::law(entry_from_name(LAWS, name, constants.len())?, constants)),
    }
}
