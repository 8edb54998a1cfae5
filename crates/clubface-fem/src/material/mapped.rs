//! Laws over numbers with derivatives.

use super::energy::VolumeLaw;
use super::family::{Law, Origin};
use super::table::Number;
use clubface_math::Real;
use std::sync::Arc;

/// The same law over another number, each constant made from its name and value.
pub fn map_law<R: Real, T: Number>(
    law: &dyn Law<R>,
    number: &mut dyn FnMut(&str, R) -> T,
) -> Arc<dyn Law<T>> {
    let named = law.constant_names().into_iter().zip(law.constants());
    let constants: Vec<T> = named.map(|(name, value)| number(name, *value)).collect();
    let made = match law.origin() {
        Origin::Table(entry) => Ok(T::law(&entry, &constants)),
        Origin::Energy(energy) => energy.law(&constants),
        Origin::Own(function) => function.law(&constants),
    };
    let Ok(made) = made else { unreachable!("as many constants as the law has") };
    match law.volumetric() {
        Some(volumetric) => VolumeLaw::over(made, volumetric),
        None => made,
    }
}
