//! How finely an impact is computed, and what comes of it.

use crate::error::ImpactError;
use crate::launch::Launch;
use clubface_math::{Mask, Scalar};

/// How finely a contact is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accuracy {
    /// Launch correct to 1e-4, by the method that is fastest for the model.
    Fast,
    /// Dormand-Prince with this relative tolerance a step.
    Tolerance(f64),
}

impl Accuracy {
    /// A relative tolerance a step, or the fast setting where none or 0 is given.
    ///
    /// # Errors
    /// A tolerance that is not allowed.
    pub fn from_tolerance(tolerance: Option<f64>) -> Result<Self, ImpactError> {
        match tolerance {
            None | Some(0.0) => Ok(Self::Fast),
            Some(value) if (1e-13..=1e-2).contains(&value) => Ok(Self::Tolerance(value)),
            Some(value) => {
                let message = format!("{value} is not allowed; 1e-13 to 1e-2, or 0 for the fast setting");
                Err(ImpactError::new("tolerance", message))
            }
        }
    }
}

/// Result of an impact.
#[derive(Clone, Copy, Debug)]
pub struct Impact<S: Scalar> {
    /// Motion after impact.
    pub launch: Launch<S>,
    /// Lanes in which contact ended in separation.
    pub separated: S::Mask,
}

impl<S: Scalar> Impact<S> {
    /// Result of a model that cannot fail.
    #[inline(always)]
    pub fn certain(launch: Launch<S>) -> Self {
        Self { launch, separated: S::Mask::splat(true) }
    }
}
