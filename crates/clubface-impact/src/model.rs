//! What every impact model is: one generic function from first touch to launch.

use crate::contact::Recorder;
#[cfg(feature = "multibody")]
use crate::contact::SteppedContact;
use crate::description::{FromValues, ModelInfo};
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use clubface_math::Scalar;

/// A model without its numbers: what it is called, which parameters it has, and its physics over any of them.
pub trait Describe: 'static {
    /// Its description.
    const INFO: ModelInfo;
    /// The model over one kind of number.
    type Over<S: Scalar>: Model<S>;
}

/// A model with its parameters over a scalar.
pub trait Model<S: Scalar>: FromValues<S> {
    /// From first touch to launch; a contact model shows every step to the recorder `record`.
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, accuracy: Accuracy, record: &mut R) -> Impact<S>;

    /// Its contact from first touch, for a program that moves the bodies itself; None for a model without a contact.
    #[cfg(feature = "multibody")]
    fn stepped(&self, _touch: &FirstTouch<S>) -> Option<Box<dyn SteppedContact<S>>> {
        None
    }
}
