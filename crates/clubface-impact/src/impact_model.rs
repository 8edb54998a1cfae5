//! A model as it is chosen at run time: its description and its kernels, which are compiled once.

use crate::columns::{Reject, Shots};
use crate::contact::History;
use crate::description::{ModelInfo, ModelKind};
use crate::error::ImpactError;
use crate::impact::Accuracy;
use crate::kernels::{Differentiated, MOST_PARAMETERS, derivatives, history, launches};
use crate::launch::OUTPUT_COUNT;
use crate::model::Describe;
use crate::shot::INPUT_COUNT;
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
        Self { info: M::INFO, launches: launches::<M>, derivatives: derivatives::<M>, history }
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
