//! Laws by name, as case files and other languages ask for them.

use super::{Hencky, MooneyRivlin, NeoHookean, Shape};
use crate::error::FemError;
use clubface_math::Real;

/// A law that can be asked for by name.
#[derive(Clone, Copy, Debug)]
pub struct LawInfo {
    /// Name.
    pub name: &'static str,
    /// Names of its constants, all in Pa.
    pub constants: &'static [&'static str],
    /// What it is for.
    pub summary: &'static str,
}

/// All laws.
pub const LAWS: &[LawInfo] = &[
    LawInfo {
        name: "mooney-rivlin",
        constants: &["c10", "c01"],
        summary: "rubber, W = c10 (I1 - 3) + c01 (I2 - 3)",
    },
    LawInfo { name: "neo-hookean", constants: &["shear"], summary: "rubber, W = shear/2 (I1 - 3)" },
    LawInfo {
        name: "linear",
        constants: &["shear"],
        summary: "plastics and metals, linear in logarithmic strain",
    },
];

impl<R: Real> Shape<R> {
    /// The same law with other constants, each made from its name and value.
    pub fn map<T: Real>(&self, of: &mut dyn FnMut(&str, R) -> T) -> Shape<T> {
        match self {
            Self::MooneyRivlin(law) => {
                Shape::MooneyRivlin(MooneyRivlin { c10: of("c10", law.c10), c01: of("c01", law.c01) })
            }
            Self::NeoHookean(law) => Shape::NeoHookean(NeoHookean { shear: of("shear", law.shear) }),
            Self::Hencky(law) => Shape::Hencky(Hencky { shear: of("shear", law.shear) }),
        }
    }
    /// A law from its name and constants (Pa), in the order of [`LAWS`].
    ///
    /// # Errors
    /// [`FemError::Input`] for an unknown name, a wrong number of constants, or constants without positive shear modulus.
    pub fn from_name(name: &str, constants: &[R]) -> Result<Self, FemError> {
        let Some(info) = LAWS.iter().find(|law| law.name == name) else {
            let known: Vec<_> = LAWS.iter().map(|law| law.name).collect();
            return Err(FemError::input("law", name, format!("known are {}", known.join(", "))));
        };
        if constants.len() != info.constants.len() {
            let wanted = info.constants.join(", ");
            return Err(FemError::input(
                format!("constants of {name}"),
                constants.len(),
                format!("these are needed: {wanted}"),
            ));
        }
        let sum = constants.iter().map(|c| c.re()).sum::<f64>();
        if !(sum > 0.0 && sum.is_finite()) {
            return Err(FemError::input(
                format!("shear modulus of {name}"),
                format!("{sum} Pa"),
                "it must be above zero",
            ));
        }
        Ok(match name {
            "mooney-rivlin" => Self::MooneyRivlin(MooneyRivlin { c10: constants[0], c01: constants[1] }),
            "neo-hookean" => Self::NeoHookean(NeoHookean { shear: constants[0] }),
            _ => Self::Hencky(Hencky { shear: constants[0] }),
        })
    }
}
