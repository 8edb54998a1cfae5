//! Descriptions of laws, for files, checks and bindings.

use crate::error::FemError;

/// A constant of a law.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Constant {
    /// Name, as in files.
    pub name: &'static str,
    /// What kind of quantity: "pressure" (Pa) or "dimensionless".
    pub dimension: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// Smallest allowed value, SI.
    pub least: f64,
    /// Largest allowed value, SI.
    pub most: f64,
}

impl Constant {
    /// SI unit, as messages write it.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match self.dimension {
            "pressure" => "Pa",
            _ => "",
        }
    }
}

/// Description of the law.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Description {
    /// Name, as in files.
    pub name: &'static str,
    /// What it is for, and its energy.
    pub summary: &'static str,
    /// Who published it.
    pub source: &'static str,
    /// Its constants.
    pub constants: &'static [Constant],
    /// How many of them must be given, from the first; the others come in groups of `group`.
    pub needed: usize,
    /// See [`Description::needed`].
    pub group: usize,
    /// Whether files choose it by its name; a metal that yields is chosen by its yield stress.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub listed: bool,
    /// State variables of a point before any deformation, none for an elastic law.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub state: &'static [f64],
    /// Rough time of a one-point element in a step, ns: to give threads as much to do.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub cost: usize,
    /// Constants of a material that contract tests compute with.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub example: &'static [f64],
}

impl Description {
    /// Checks the number of constants.
    ///
    /// # Errors
    /// [`FemError::Input`] that says which are needed.
    pub(super) fn check_count(&self, count: usize) -> Result<(), FemError> {
        let fits = (self.needed..=self.constants.len()).contains(&count);
        if fits && (count - self.needed).is_multiple_of(self.group) {
            return Ok(());
        }
        let wanted: Vec<_> = self.constants.iter().map(|constant| constant.name).collect();
        let (needed, group) = (self.needed, self.group);
        let more = if count > needed { format!(" and then {group} at a time") } else { String::new() };
        let allowed = format!("it needs the first {needed}{more} of {}", wanted.join(", "));
        Err(FemError::input(format!("constants of {}", self.name), count, allowed))
    }
}

/// Declares the constants of a law: a struct of numbers and its table.
#[macro_export]
macro_rules! constants {
    ($(#[$doc:meta])* $name:ident {
        $($field:ident [$dimension:literal] in $least:literal ..= $most:literal, $meaning:literal;)+
    }) => {
        $crate::material::scalars! { $(#[$doc])* $name { $($field $meaning;)+ } }
        impl $name<()> {
            /// Its constants, in order.
            pub const CONSTANTS: &'static [$crate::material::Constant] = &[$($crate::material::Constant {
                name: stringify!($field),
                dimension: $dimension,
                meaning: $meaning,
                least: $least,
                most: $most,
            },)+];
        }
        impl<R: $crate::material::Number> $name<R> {
            /// As a law of materials.
            pub fn law(&self) -> std::sync::Arc<dyn $crate::material::Law<R>> {
                $crate::material::build::<$name<()>, R>(&[$(self.$field),+])
            }
        }
    };
}
