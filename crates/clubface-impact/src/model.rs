//! What every impact model is: a table of parameters and one generic function from first touch to launch.

use crate::first_touch::FirstTouch;
use crate::history::Recorder;
use crate::launch::Launch;
use clubface_math::{Mask, Scalar};

/// One parameter of a model.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Name, as in the Python API and in parameter files.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// Default value.
    pub default: f64,
    /// Smallest allowed value.
    pub lower: f64,
    /// Largest allowed value.
    pub upper: f64,
    /// Where the default comes from.
    pub source: &'static str,
}

/// Whether a model resolves the contact in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Velocities jump; no time scale.
    Impulse,
    /// Forces are integrated over the contact.
    Contact,
}

/// A law of physics that a model obeys for any input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Linear momentum of club and ball is kept.
    Momentum,
    /// Angular momentum of club and ball is kept.
    AngularMomentum,
    /// Kinetic energy is never created.
    Energy,
    /// The tangential force never exceeds the friction coefficient times the normal force.
    FrictionCone,
}

/// What a model says of itself.
#[derive(Clone, Copy, Debug)]
pub struct ModelInfo {
    /// Name, as on the command line.
    pub name: &'static str,
    /// Title.
    pub title: &'static str,
    /// Impulse or contact.
    pub kind: Kind,
    /// One sentence.
    pub summary: &'static str,
    /// Source.
    pub reference: &'static str,
    /// Laws it obeys for any parameters.
    pub laws: &'static [Law],
    /// Laws it obeys only while the named parameter is zero.
    pub laws_without: Option<(&'static str, &'static [Law])>,
    /// Whether the shots of a pack may differ (a model that branches on values runs one shot at a time).
    pub lanes: bool,
    /// Its parameters, in order.
    pub parameters: &'static [Parameter],
}

/// How finely a contact is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accuracy {
    /// Launch correct to 1e-4, by the method that is fastest for the model.
    Fast,
    /// Dormand-Prince with this relative tolerance a step.
    Tolerance(f64),
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

impl ModelInfo {
    /// Whether the model with these parameter values obeys a law.
    #[must_use]
    pub fn obeys(&self, law: Law, values: &[f64]) -> bool {
        let conditional = self.laws_without.is_some_and(|(name, laws)| {
            let index = self.parameters.iter().position(|p| p.name == name);
            laws.contains(&law) && index.is_some_and(|i| values[i] == 0.0)
        });
        self.laws.contains(&law) || conditional
    }
    /// Default parameter values.
    #[must_use]
    pub fn defaults(&self) -> Vec<f64> {
        self.parameters.iter().map(|p| p.default).collect()
    }
}

/// What a model is called and which parameters it has.
pub trait Describe {
    /// Its description.
    const INFO: ModelInfo;
}

/// A model with its parameters over a scalar.
pub trait Model<S: Scalar>: Sized {
    /// From parameter values in the order of [`ModelInfo::parameters`].
    fn from_values(values: &[S]) -> Self;
    /// From first touch to launch; a contact model shows every step to the recorder.
    fn impact<R: Recorder<S>>(
        &self,
        touch: &FirstTouch<S>,
        accuracy: Accuracy,
        recorder: &mut R,
    ) -> Impact<S>;
}

/// Declares the parameters of a model: a struct of scalars, its table, and how to read it from a slice.
macro_rules! parameters {
    ($(#[$doc:meta])* $name:ident {
        $($field:ident [$unit:literal] = $default:literal in $lower:literal ..= $upper:literal, $meaning:literal, $source:expr;)+
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name<S> {
            $(#[doc = $meaning] pub $field: S,)+
        }
        impl $name<()> {
            /// Its parameters, in order.
            pub const PARAMETERS: &'static [$crate::model::Parameter] = &[$($crate::model::Parameter {
                name: stringify!($field),
                unit: $unit,
                meaning: $meaning,
                default: $default,
                lower: $lower,
                upper: $upper,
                source: $source,
            },)+];
        }
        impl<S: clubface_math::Scalar> $name<S> {
            /// From values in the order of the table.
            #[inline(always)]
            pub fn from_slice(values: &[S]) -> Self {
                let [$($field),+] = *values else {
                    unreachable!("the registry checks the number of parameters")
                };
                Self { $($field),+ }
            }
        }
    };
}
pub(crate) use parameters;
