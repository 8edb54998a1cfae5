//! A material: its law, how it resists a change of volume, how it creeps, and what of it is allowed.

use super::family::Law;
use super::stage::{Slot, StressStage};
use super::state_variables::{StateVariables, Update};
use super::step::MaterialStep;
use super::viscous::{Branches, Decay, MAX_TERMS, Maxwell, undeformed};
use crate::error::FemError;
use clubface_math::{Pack, Real};
use std::sync::Arc;

/// Largest Poisson's ratio: beyond it the time step shrinks without a change in the result.
const POISSON: f64 = 0.4999;
/// Largest modulus of a branch over the slow one.
const BRANCH: f64 = 1000.0;

/// A value above zero, and finite.
fn positive(value: f64, unit: &str, name: impl FnOnce() -> String) -> Result<(), FemError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(FemError::input(name(), format!("{value} {unit}").trim_end(), "it must be above zero and finite"))
    }
}

/// A material: change of shape, change of volume, creep, density.
#[derive(Clone, Debug)]
pub struct Material<R> {
    /// Law of the change of shape.
    pub law: Arc<dyn Law<R>>,
    /// Bulk modulus K, Pa.
    pub bulk: R,
    /// Viscoelastic terms, none for an elastic material.
    pub maxwell: Vec<Maxwell<R>>,
    /// Density, kg/m3.
    pub density: R,
}

impl<R: Real> Material<R> {
    /// Shear modulus of small, slow deformation, Pa.
    pub fn shear(&self) -> R {
        self.law.shear()
    }
    /// Shear modulus of small, fast deformation, Pa.
    pub fn instantaneous_shear(&self) -> R {
        let mut sum = R::one();
        for term in &self.maxwell {
            sum += term.modulus;
        }
        self.shear() * sum
    }
    /// State variables of undeformed points, in as many blocks of eight: none in an elastic material.
    #[must_use]
    pub fn state(&self, blocks: usize) -> StateVariables<R> {
        let of_law = self.law.state();
        let state = if of_law.is_empty() && !self.maxwell.is_empty() {
            undeformed(self.maxwell.len())
        } else {
            [of_law.iter().map(|&number| R::from_f64(number)).collect(), vec![]]
        };
        StateVariables::new(state, blocks)
    }
    /// The stage that computes its stress in a step, for packs of type P.
    pub fn stage<P: Pack<Real = R>>(&self, step: Update) -> Box<dyn StressStage<P>> {
        assert!(self.maxwell.len() <= MAX_TERMS, "at most {MAX_TERMS} viscoelastic terms");
        let mut decays = [Decay { way: R::zero(), half: R::zero() }; MAX_TERMS];
        for (decay, term) in decays.iter_mut().zip(&self.maxwell) {
            *decay = term.decay(step.dt);
        }
        let step = MaterialStep {
            branches: Branches { decays: &decays[..self.maxwell.len()], add_work: step.add_work },
            bulk: self.bulk,
            time: step.dt,
        };
        let mut slot: Slot<P> = None;
        self.law.stage(&step, &mut slot);
        let Some(stage) = slot else { unreachable!("a law fills the slot") };
        stage
    }
    /// Poisson's ratio of small, slow deformation.
    #[must_use]
    pub fn poisson(&self) -> f64 {
        let (shear, bulk) = (self.shear().re(), self.bulk.re());
        (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))
    }

    /// Checks the constants; messages call the material `name`.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first value that is not allowed.
    pub fn check(&self, name: &str) -> Result<(), FemError> {
        positive(self.density.re(), "kg/m3", || format!("density of {name}"))?;
        self.check_law(name)
    }

    /// As [`Material::check`], but for the density.
    ///
    /// # Errors
    /// As [`Material::check`].
    pub fn check_law(&self, name: &str) -> Result<(), FemError> {
        let qualified = |what: &str| format!("{what} of {name}");
        self.law.check(name)?;
        positive(self.bulk.re(), "Pa", || {
            qualified(
                "bulk modulus (which is infinite for a Poisson's ratio of 0.5; use 0.49 to 0.499 for rubber)",
            )
        })?;
        if self.poisson() > POISSON {
            let allowed = format!(
                "it must be at most {POISSON}, since the time step goes to zero at 0.5; rubber behaves as if incompressible from 0.49 on"
            );
            return Err(FemError::input(
                qualified("Poisson's ratio"),
                format!("{:.6}", self.poisson()),
                allowed,
            ));
        }
        if self.maxwell.len() > MAX_TERMS {
            let allowed = format!("it must be at most {MAX_TERMS}");
            return Err(FemError::input(
                qualified("number of viscoelastic terms"),
                self.maxwell.len(),
                allowed,
            ));
        }
        if !self.law.state().is_empty() && !self.maxwell.is_empty() {
            let allowed =
                "it must be 0, since the law has state variables of its own (as a metal that yields has)";
            return Err(FemError::input(
                qualified("number of viscoelastic terms"),
                self.maxwell.len(),
                allowed,
            ));
        }
        for (number, term) in self.maxwell.iter().enumerate() {
            let qualified = |what: &str| format!("{what} of viscoelastic term {} of {name}", number + 1);
            positive(term.modulus.re(), "", || qualified("relative modulus"))?;
            positive(term.time.re(), "s", || qualified("relaxation time"))?;
            if term.modulus.re() > BRANCH {
                let allowed = format!("it must be at most {BRANCH} times the long-term modulus");
                return Err(FemError::input(qualified("relative modulus"), term.modulus.re(), allowed));
            }
        }
        Ok(())
    }
}
