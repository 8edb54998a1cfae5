//! A function with its constants, as materials hold it.

use super::function::OwnFunction;
use crate::error::FemError;
use crate::material::description::Description;
use crate::material::family::{Law, Origin};
use crate::material::step::MaterialStep;
use crate::material::table::Number;
use clubface_math::Scalar;
use std::any::Any;
use std::sync::Arc;

/// What stands in the place of the description of a law of the table.
const DESCRIPTION: Description = Description {
    name: "own",
    summary: "a function of C",
    source: "whoever registered it",
    constants: &[],
    needed: 0,
    group: 1,
    listed: false,
    state: &[],
    cost: 40,
    example: &[],
};

impl OwnFunction {
    /// As a law of materials, with its constants (SI).
    ///
    /// # Errors
    /// [`FemError::Input`] for another number of constants.
    pub fn law<R: Number>(self: &Arc<Self>, constants: &[R]) -> Result<Arc<dyn Law<R>>, FemError> {
        if constants.len() != self.constants.len() {
            let names = if self.constants.is_empty() { "none".to_owned() } else { self.constants.join(", ") };
            let (name, allowed) = (&self.name, format!("it needs {names}"));
            return Err(FemError::input(format!("constants of {name}"), constants.len(), allowed));
        }
        Ok(Arc::new(OwnLaw { function: Arc::clone(self), constants: constants.into() }))
    }
}

/// A function with its constants.
#[derive(Clone, Debug)]
pub struct OwnLaw<R> {
    pub(super) function: Arc<OwnFunction>,
    pub(super) constants: Arc<[R]>,
}

impl<R: Number> Law<R> for OwnLaw<R> {
    fn origin(&self) -> Origin<'_> {
        Origin::Own(&self.function)
    }
    fn description(&self) -> &'static Description {
        const { &DESCRIPTION }
    }
    fn state(&self) -> &[f64] {
        &self.function.states
    }
    fn constants(&self) -> &[R] {
        &self.constants
    }
    fn shear(&self) -> R {
        let mut moduli = self.shear_moduli().into_iter();
        // The largest: the stable step follows from it.
        moduli.next().map_or(R::zero(), |first| moduli.fold(first, Scalar::max))
    }
    fn check(&self, name: &str) -> Result<(), FemError> {
        self.check_values(name)
    }
    fn stage(&self, step: &MaterialStep<R>, slot: &mut dyn Any) {
        R::stage(self, step, slot);
    }
}
