//! Descriptions of models: name, source, laws and a table of parameters.

/// Least and greatest value, SI, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Bounds {
    /// Least value.
    pub lower: f64,
    /// Greatest value.
    pub upper: f64,
}

impl Bounds {
    /// From the least to the greatest.
    #[must_use]
    pub const fn new(lower: f64, upper: f64) -> Self {
        Self { lower, upper }
    }

    /// From minus a size to plus it.
    #[must_use]
    pub const fn within(size: f64) -> Self {
        Self::new(-size, size)
    }

    /// Whether a value is within.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        (self.lower..=self.upper).contains(&value)
    }
}

/// Strikes for which a model is valid: bounds of one quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ValidRange {
    /// An input, a parameter of the model, or `incidence`, the angle between the velocity of the clubhead and the normal
    /// at the face centre.
    pub name: &'static str,
    /// What people call it.
    pub label: &'static str,
    /// The unit in which they read it.
    pub reading: &'static str,
    /// Its bounds.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub bounds: Bounds,
}

impl ValidRange {
    /// Bounds of a quantity.
    #[must_use]
    pub const fn new(name: &'static str, label: &'static str, reading: &'static str, bounds: Bounds) -> Self {
        Self { name, label, reading, bounds }
    }
}

/// Outputs of an impact that has no length in time: models without one lack them.
pub const TIMED_OUTPUTS: &[&str] = &["contact_time", "peak_force"];

/// One parameter of a model.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
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
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum ModelKind {
    /// Velocities jump: the contact is not followed in time.
    Impulse,
    /// Forces are integrated over the contact.
    Contact,
}

impl ModelKind {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Impulse => "impulse",
            Self::Contact => "contact",
        }
    }
}

/// A law of physics that a model obeys for any input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
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

impl Law {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Momentum => "momentum",
            Self::AngularMomentum => "angular_momentum",
            Self::Energy => "energy",
            Self::FrictionCone => "friction_cone",
        }
    }
}

/// Description of a model.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ModelInfo {
    /// Name, as on the command line.
    pub name: &'static str,
    /// Title.
    pub title: &'static str,
    /// Impulse or contact.
    pub kind: ModelKind,
    /// One sentence.
    pub summary: &'static str,
    /// Source.
    pub reference: &'static str,
    /// Laws it obeys for any parameters.
    pub laws: &'static [Law],
    /// Laws it obeys only while the named parameter is zero.
    pub laws_without: Option<(&'static str, &'static [Law])>,
    /// The parameter that sets the restitution, if its default was fitted to a driver and so includes the driver's
    /// face; nothing if the defaults are of the ball alone.
    pub face_in: Option<&'static str>,
    /// Outputs that it does not compute: they are NaN.
    pub lacks: &'static [&'static str],
    /// Whether a head that turns back turns the ball.
    pub gear_effect: bool,
    /// The ball whose coefficients the defaults are; nothing if they are of no ball in particular.
    pub ball: Option<&'static str>,
    /// Strikes for which it is valid with its defaults; nothing where it has no other limits than those of its inputs.
    pub valid: &'static [ValidRange],
    /// Whether the shots of a pack may differ (a model that branches on values runs one shot at a time).
    #[cfg_attr(feature = "serde", serde(skip))]
    pub lanes: bool,
    /// Its parameters, in order.
    pub parameters: &'static [Parameter],
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

/// What consists of some scalars, such as the parameters of a model or the constants of a material.
pub trait FromValues<S> {
    /// From values in the order of its table.
    fn from_values(values: &[S]) -> Self;
}

/// Declares a struct of scalars, and how it is read from a slice in the order of its fields.
#[macro_export]
macro_rules! scalars {
    ($(#[$doc:meta])* $name:ident { $($field:ident $meaning:literal;)+ }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        #[repr(C)]
        pub struct $name<S> {
            $(#[doc = $meaning] pub $field: S,)+
        }
        impl<S: Copy> $crate::description::FromValues<S> for $name<S> {
            #[inline(always)]
            fn from_values(values: &[S]) -> Self {
                const COUNT: usize = [$(stringify!($field)),+].len();
                assert!(values.len() == COUNT, "the number of values has been checked");
                // SAFETY: in C's layout a struct of some values is their array. Hundreds of them are copied at once.
                unsafe { values.as_ptr().cast::<Self>().read() }
            }
        }
    };
}

/// Declares the parameters of a model: a struct of scalars and its table.
#[macro_export]
macro_rules! parameters {
    ($(#[$doc:meta])* $name:ident {
        $($field:ident [$unit:literal] = $default:literal in $lower:literal ..= $upper:literal, $meaning:literal, $source:expr;)+
    }) => {
        $crate::scalars! { $(#[$doc])* $name { $($field $meaning;)+ } }
        impl $name<()> {
            /// Its parameters, in order.
            pub const PARAMETERS: &'static [$crate::description::Parameter] = {
                // One table, however many kernels point to it.
                static TABLE: [$crate::description::Parameter; [$(stringify!($field)),+].len()] =
                    [$($crate::description::Parameter {
                        name: stringify!($field),
                        unit: $unit,
                        meaning: $meaning,
                        default: $default,
                        lower: $lower,
                        upper: $upper,
                        source: $source,
                    },)+];
                &TABLE
            };
        }
    };
}
