//! A law as its file declares it, and as materials hold it.
//!
//! A law is one file and one line of [`materials!`](crate::materials): the file declares its constants, implements
//! the stress and the energy (see [`crate::material::OfInvariants`]) and a [`Family`]. Names in files, checks
//! and the contract tests are all made from the table.

use super::description::Description;
use super::energy::{Energy, Volumetric};
use super::law::PointLaw;
use super::own::OwnFunction;
use super::step::MaterialStep;
use crate::error::FemError;
use clubface_math::{Dual, Pack, Real, Scalar};
use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

/// A law as its file declares it, over no number in particular.
pub trait Family: Debug + Send + Sync + 'static {
    /// Description of the law.
    const DESCRIPTION: Description;
    /// The law over packs: [`super::Elastic`] or [`super::WithState`] of what the file implements.
    type Over<P: Pack>: PointLaw<P>;
    /// The law from its constants in the order of the table.
    fn over<P: Pack>(constants: &[P]) -> Self::Over<P>;
    /// Shear modulus of small deformation, Pa.
    fn shear<S: Scalar>(constants: &[S]) -> S;
    /// Checks what bounds of single constants cannot say; messages call the material `name`.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first constant that is not allowed.
    fn check(_constants: &[f64], _name: &str) -> Result<(), FemError> {
        Ok(())
    }
}

/// Derivatives that a number of [`crate::sensitivity`] has.
pub const DERIVATIVES: usize = 4;

/// Makes a law over a number from its constants.
pub type Constructor<R> = fn(&[R]) -> Arc<dyn Law<R>>;

/// A line of the table of laws.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Description of the law.
    pub description: &'static Description,
    /// The law over plain numbers.
    pub plain: Constructor<f64>,
    /// The law over numbers with derivatives.
    pub derived: Constructor<Dual<f64, DERIVATIVES>>,
}

/// What makes a law of its constants, over any number.
#[derive(Clone, Copy, Debug)]
pub enum Origin<'a> {
    /// A line of a table.
    Table(Entry),
    /// An energy that a file has written down.
    Energy(&'a Arc<Energy>),
    /// A function of C.
    Own(&'a Arc<OwnFunction>),
}

/// A law of the change of shape with its constants.
pub trait Law<R: Real>: Debug + Send + Sync {
    /// What makes it of its constants.
    fn origin(&self) -> Origin<'_>;
    /// The energy of the change of volume that stands with it, if it is not the common one.
    fn volumetric(&self) -> Option<&Arc<Volumetric>> {
        None
    }
    /// Description of the law.
    fn description(&self) -> &'static Description;
    /// Names of its constants, as in files.
    fn constant_names(&self) -> Vec<&str> {
        match self.origin() {
            Origin::Table(entry) => {
                entry.description.constants.iter().map(|constant| constant.name).collect()
            }
            Origin::Energy(energy) => energy.constants().iter().map(String::as_str).collect(),
            Origin::Own(function) => function.constants().iter().map(String::as_str).collect(),
        }
    }
    /// State variables of a point before any deformation, none for an elastic law.
    fn state(&self) -> &[f64] {
        self.description().state
    }
    /// Its constants, SI, in the order of the description.
    fn constants(&self) -> &[R];
    /// Shear modulus of small deformation, Pa.
    fn shear(&self) -> R;
    /// Checks the constants; messages call the material `name`.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first constant that is not allowed.
    fn check(&self, name: &str) -> Result<(), FemError>;
    /// Fills a `Slot` with the stage of a step, for packs of the slot's type.
    fn stage(&self, step: &MaterialStep<R>, slot: &mut dyn Any);
}
