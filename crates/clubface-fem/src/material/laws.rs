//! The laws there are. A new one is one file and one line here.

use super::family::Law;
use super::hencky::Hencky;
use super::mooney_rivlin::MooneyRivlin;
use super::neo_hookean::NeoHookean;
use super::ogden::Ogden;
use super::own::{OwnFunction, registered};
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

/// Makes a function a law that materials name; one of the same name is replaced, but for the materials that have it.
/// Returns its shear modulus of small strains, Pa.
///
/// # Errors
/// [`FemError::Input`] for the name of a law of the package, and for what [`Law::check`] refuses with these constants.
pub fn register_law(function: OwnFunction, constants: &[f64]) -> Result<f64, FemError> {
    let name = function.name().to_owned();
    let taken = LAWS.iter().any(|entry| entry.description.name == name) || name == "energy";
    if name.is_empty() || taken {
        return Err(FemError::input("name", format!("{name:?}"), "it must be one that no other law has"));
    }
    let function = Arc::new(function);
    let law = function.law(constants)?;
    law.check(&name)?;
    function.register();
    Ok(law.shear())
}
