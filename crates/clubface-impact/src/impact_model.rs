//! A model as it is chosen at run time: its description and its kernels, which are compiled once.

#[cfg(feature = "multibody")]
use crate::check::check_parameters;
use crate::columns::{Reject, Shots};
use crate::contact::History;
#[cfg(feature = "multibody")]
use crate::contact::SteppedContact;
use crate::description::{ModelInfo, ModelKind};
use crate::error::ImpactError;
#[cfg(feature = "multibody")]
use crate::first_touch::FirstTouch;
use crate::impact::Accuracy;
#[cfg(feature = "multibody")]
use crate::kernels::stepped;
use crate::kernels::{Differentiated, MOST_PARAMETERS, derivatives, history, launches};
use crate::launch::OUTPUT_COUNT;
use crate::model::Describe;
use crate::shot::INPUT_COUNT;
#[cfg(feature = "multibody")]
use clubface_math::{Dual, Scalar};
use core::fmt;
use core::ops::Range;

/// A model of a registry.
#[derive(Clone, Copy)]
pub struct ImpactModel(&'static Kernels);

type Launches = fn(&Shots, Range<usize>, &mut [&mut [f64]]) -> Vec<Reject>;
type Derivatives = fn(&Differentiated, &mut [f64]) -> Result<[f64; OUTPUT_COUNT], ImpactError>;
type Histories = fn(&[f64; INPUT_COUNT], &[f64], Accuracy) -> Result<Recorded, ImpactError>;
/// A history and the outputs.
type Recorded = (History, [f64; OUTPUT_COUNT]);

/// The description of a model and its kernels, compiled in the crate that holds the registry.
pub struct Kernels {
    info: ModelInfo,
    launches: Launches,
    derivatives: Derivatives,
    /// None for a model that does not follow the contact in time.
    history: Option<Histories>,
    #[cfg(feature = "multibody")]
    stepped: Stepped<f64>,
    #[cfg(feature = "multibody")]
    stepped_dual: Stepped<Tangents>,
}

/// The contact of a model from first touch, by its parameters.
#[cfg(feature = "multibody")]
type Stepped<S> = fn(&FirstTouch<S>, &[S]) -> Option<Box<dyn SteppedContact<S>>>;

/// Numbers with derivatives, of contacts that are stepped: some at a time, as many as keep the code short.
#[cfg(feature = "multibody")]
pub type Tangents = Dual<f64, 8>;

/// A kind of number for which contacts that are stepped are compiled.
#[cfg(feature = "multibody")]
pub trait SteppedScalar: Scalar {
    #[doc(hidden)]
    fn kernel(kernels: &Kernels) -> Stepped<Self>;
}

#[cfg(feature = "multibody")]
impl SteppedScalar for f64 {
    fn kernel(kernels: &Kernels) -> Stepped<Self> {
        kernels.stepped
    }
}

#[cfg(feature = "multibody")]
impl SteppedScalar for Tangents {
    fn kernel(kernels: &Kernels) -> Stepped<Self> {
        kernels.stepped_dual
    }
}

impl Kernels {
    /// The kernels of a model.
    #[must_use]
    pub const fn for_model<M: Describe>() -> Self {
        assert!(M::INFO.parameters.len() <= MOST_PARAMETERS, "a model has too many parameters");
        let history: Option<Histories> = match M::INFO.kind {
            ModelKind::Impulse => None,
            ModelKind::Contact => Some(history::<M>),
        };
        Self {
            info: M::INFO,
            launches: launches::<M>,
            derivatives: derivatives::<M>,
            history,
            #[cfg(feature = "multibody")]
            stepped: stepped::<M, f64>,
            #[cfg(feature = "multibody")]
            stepped_dual: stepped::<M, Tangents>,
        }
    }
}

impl ImpactModel {
    /// The model of these kernels.
    #[must_use]
    pub const fn new(kernels: &'static Kernels) -> Self {
        Self(kernels)
    }

    /// Its description.
    #[must_use]
    pub const fn info(self) -> &'static ModelInfo {
        &self.0.info
    }

    /// Computes launches of `rows` into `outputs`, one slice an output, each as long as `rows`.
    pub(crate) fn launches(
        self,
        shots: &Shots,
        rows: Range<usize>,
        outputs: &mut [&mut [f64]],
    ) -> Vec<Reject> {
        (self.0.launches)(shots, rows, outputs)
    }

    /// Outputs of a shot; their derivatives go into `jacobian`, outputs by variables.
    pub(crate) fn derivatives(
        self,
        shot: &Differentiated,
        jacobian: &mut [f64],
    ) -> Result<[f64; OUTPUT_COUNT], ImpactError> {
        (self.0.derivatives)(shot, jacobian)
    }

    /// Computes one shot by a contact model and keeps every step: its history and its outputs.
    ///
    /// # Errors
    /// A model without a contact, a faulty input, a wrong number of parameters, a club that moves away from the ball,
    /// or a contact that does not end.
    pub fn history(
        self,
        inputs: &[f64; INPUT_COUNT],
        parameters: &[f64],
        accuracy: Accuracy,
    ) -> Result<Recorded, ImpactError> {
        let info = self.info();
        let Some(history) = self.0.history else {
            let message = format!(
                "{} is an impulse model: it does not follow the contact in time and so has no history",
                info.name
            );
            return Err(ImpactError::new("model", message));
        };
        self.check_count(parameters)?;
        history(inputs, parameters, accuracy)
    }

    /// The contact of the model from first touch, for a program that moves the bodies itself.
    ///
    /// # Errors
    /// A model without a contact, or a parameter that is missing or not allowed.
    #[cfg(feature = "multibody")]
    pub fn stepped<S: SteppedScalar>(
        self,
        touch: &FirstTouch<S>,
        parameters: &[f64],
    ) -> Result<Box<dyn SteppedContact<S>>, ImpactError> {
        let info = self.info();
        self.check_count(parameters)?;
        check_parameters(info, parameters)?;
        let parameters: Vec<S> = parameters.iter().map(|&value| S::from_f64(value)).collect();
        S::kernel(self.0)(touch, &parameters).ok_or_else(|| {
            let message =
                format!("{} is an impulse model: it has no contact that could be stepped", info.name);
            ImpactError::new("model", message)
        })
    }

    /// Checks that there are as many parameters as the model has.
    pub(crate) fn check_count(self, parameters: &[f64]) -> Result<(), ImpactError> {
        let info = self.info();
        let (given, wanted) = (parameters.len(), info.parameters.len());
        if given == wanted {
            return Ok(());
        }
        let message = format!("{given} values given, {wanted} needed by {}", info.name);
        Err(ImpactError::new("parameters", message))
    }
}

/// Two models are the same if they have the same name.
impl PartialEq for ImpactModel {
    fn eq(&self, other: &Self) -> bool {
        self.info().name == other.info().name
    }
}

impl fmt::Debug for ImpactModel {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.info().name)
    }
}
