//! What shells are made of.

use super::quadrature::Rule;
use super::section::Isotropic;
use crate::error::FemError;
use crate::material::Hardening;
use clubface_math::Real;

/// What shells are made of.
#[derive(Clone, Debug)]
pub struct ShellMaterial<R> {
    /// Elastic constants.
    pub elastic: Isotropic<R>,
    /// Density, kg/m3.
    pub density: R,
    /// When and how it yields; none for a metal that stays elastic.
    pub hardening: Option<Hardening<R>>,
    /// Points through the thickness; none for an elastic metal whose resultants are enough, which gives the same in
    /// less time.
    pub points: Option<Rule>,
}

impl<R: Real> ShellMaterial<R> {
    /// A metal that stays elastic, of a density in kg/m3.
    pub fn elastic(elastic: Isotropic<R>, density: R) -> Self {
        Self { elastic, density, hardening: None, points: None }
    }

    /// A metal that yields.
    #[must_use]
    pub fn yielding(self, hardening: Hardening<R>) -> Self {
        Self { hardening: Some(hardening), ..self }
    }

    /// Points through the thickness, if there are any: their places from -1 to 1, and weights.
    pub fn rule(&self) -> Option<Rule> {
        self.points.or(self.hardening.as_ref().map(|_| Rule::default()))
    }

    /// Checks the constants of the part called `name`.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first constant that is not allowed.
    pub fn check(&self, name: &str) -> Result<(), FemError> {
        let (young, poisson, density) =
            (self.elastic.young.re(), self.elastic.poisson.re(), self.density.re());
        if !(young > 0.0 && young.is_finite()) {
            let name = format!("{name}.youngs");
            return Err(FemError::input(name, format!("{young} Pa"), "it must be above zero"));
        }
        if !(poisson > -1.0 && poisson < 0.5) {
            let name = format!("{name}.poisson");
            return Err(FemError::input(name, poisson, "it must be above -1 and below 0.5"));
        }
        if !(density > 0.0 && density < 3e4) {
            let name = format!("{name}.density");
            let allowed = "it must be above 0 and below 30000 kg/m3";
            return Err(FemError::input(name, format!("{density} kg/m3"), allowed));
        }
        self.hardening.as_ref().map_or(Ok(()), |hardening| hardening.check(name))
    }
}
