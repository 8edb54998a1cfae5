//! Constants of materials that no law can work with.

use super::{Material, Shape, MAX_TERMS};
use crate::error::FemError;
use clubface_math::Real;

/// Largest Poisson's ratio: beyond it the time step shrinks without a change in the result.
const POISSON: f64 = 0.4999;
/// Largest modulus of a branch over the slow one.
const BRANCH: f64 = 1000.0;

/// Largest exponent of stretches, positive or negative.
const EXPONENT: f64 = 30.0;

/// A value above zero, and finite.
fn positive(value: f64, unit: &str, name: impl FnOnce() -> String) -> Result<(), FemError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(FemError::input(name(), format!("{value} {unit}").trim_end(), "it must be above zero and finite"))
    }
}

impl<R: Real> Material<R> {
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
        let of = |what: &str| format!("{what} of {name}");
        self.shape.check(name)?;
        positive(self.shear().re(), "Pa", || of("shear modulus"))?;
        positive(self.bulk.re(), "Pa", || {
            of("bulk modulus (infinite for a Poisson's ratio of 0.5: take 0.49 to 0.499 for rubber)")
        })?;
        if self.poisson() > POISSON {
            let allowed = format!(
                "at most {POISSON} is allowed, since the time step falls to nothing at 0.5; rubber behaves as incompressible from 0.49 on"
            );
            return Err(FemError::input(of("Poisson's ratio"), format!("{:.6}", self.poisson()), allowed));
        }
        if self.maxwell.len() > MAX_TERMS {
            let allowed = format!("at most {MAX_TERMS} are allowed");
            return Err(FemError::input(of("number of viscoelastic terms"), self.maxwell.len(), allowed));
        }
        if matches!(self.shape, Shape::VonMises(_)) && !self.maxwell.is_empty() {
            let allowed = "none are allowed in a metal that yields";
            return Err(FemError::input(of("number of viscoelastic terms"), self.maxwell.len(), allowed));
        }
        for (number, term) in self.maxwell.iter().enumerate() {
            let of = |what: &str| format!("{what} of viscoelastic term {} of {name}", number + 1);
            positive(term.modulus.re(), "", || of("relative modulus"))?;
            positive(term.time.re(), "s", || of("relaxation time"))?;
            if term.modulus.re() > BRANCH {
                let allowed = format!("at most {BRANCH} times the slow modulus is allowed");
                return Err(FemError::input(of("relative modulus"), term.modulus.re(), allowed));
            }
        }
        Ok(())
    }
}

impl<R: Real> Shape<R> {
    /// Refuses constants of rubber that would soften until it runs away.
    fn check(&self, name: &str) -> Result<(), FemError> {
        let of = |what: &str| format!("{what} of {name}");
        match self {
            Self::MooneyRivlin(law) => {
                for (constant, value) in [("C10", law.c10.re()), ("C01", law.c01.re())] {
                    if !(value >= 0.0 && value.is_finite()) {
                        let allowed =
                            "it must not be negative: such a rubber would soften until it runs away";
                        return Err(FemError::input(of(constant), format!("{value} Pa"), allowed));
                    }
                }
            }
            Self::Ogden(law) => {
                for (number, term) in law.terms().iter().enumerate() {
                    let (mu, alpha) = (term.mu.re(), term.alpha.re());
                    if !(alpha != 0.0 && alpha.abs() <= EXPONENT) {
                        let allowed = format!("from -{EXPONENT} to {EXPONENT}, not zero, is allowed");
                        return Err(FemError::input(of(&format!("alpha{}", number + 1)), alpha, allowed));
                    }
                    if !(mu * alpha > 0.0 && mu.is_finite()) {
                        let allowed = "it must have the sign of its alpha: otherwise rubber may soften until it runs away";
                        return Err(FemError::input(
                            of(&format!("mu{}", number + 1)),
                            format!("{mu} Pa"),
                            allowed,
                        ));
                    }
                }
            }
            Self::VonMises(law) => law.hardening.check(name)?,
            Self::NeoHookean(_) | Self::Hencky(_) => {}
        }
        Ok(())
    }
}
