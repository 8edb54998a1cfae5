//! Laws by name, as case files and other languages ask for them.

use super::{Hencky, MooneyRivlin, NeoHookean, Ogden, OgdenTerm, Shape, VonMises};
use crate::error::FemError;
use clubface_math::Real;

/// A constant of a law.
#[derive(Clone, Copy, Debug)]
pub struct Constant {
    /// Name.
    pub name: &'static str,
    /// What kind of quantity: "pressure" (Pa) or "dimensionless".
    pub dimension: &'static str,
}

const fn pressure(name: &'static str) -> Constant {
    Constant { name, dimension: "pressure" }
}
const fn number(name: &'static str) -> Constant {
    Constant { name, dimension: "dimensionless" }
}

/// A law that can be asked for by name.
#[derive(Clone, Copy, Debug)]
pub struct LawInfo {
    /// Name.
    pub name: &'static str,
    /// Its constants.
    pub constants: &'static [Constant],
    /// How many of them must be given; the others come in groups of as many.
    pub needed: usize,
    /// What it is for.
    pub summary: &'static str,
}

/// All laws.
pub const LAWS: &[LawInfo] = &[
    LawInfo {
        name: "mooney-rivlin",
        constants: &[pressure("c10"), pressure("c01")],
        needed: 2,
        summary: "rubber, W = c10 (I1 - 3) + c01 (I2 - 3)",
    },
    LawInfo {
        name: "neo-hookean",
        constants: &[pressure("shear")],
        needed: 1,
        summary: "rubber, W = shear/2 (I1 - 3)",
    },
    LawInfo {
        name: "linear",
        constants: &[pressure("shear")],
        needed: 1,
        summary: "plastics and metals, linear in logarithmic strain",
    },
    LawInfo {
        name: "ogden",
        constants: &[
            pressure("mu1"),
            number("alpha1"),
            pressure("mu2"),
            number("alpha2"),
            pressure("mu3"),
            number("alpha3"),
        ],
        needed: 2,
        summary: "rubber, W = sum of mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3), one to three terms",
    },
];

const TERMS: [[&str; 2]; 3] = [["mu1", "alpha1"], ["mu2", "alpha2"], ["mu3", "alpha3"]];

impl<R: Real> Shape<R> {
    /// The same law with other constants, each made from its name and value.
    pub fn map<T: Real>(&self, of: &mut dyn FnMut(&str, R) -> T) -> Shape<T> {
        match self {
            Self::MooneyRivlin(law) => {
                Shape::MooneyRivlin(MooneyRivlin { c10: of("c10", law.c10), c01: of("c01", law.c01) })
            }
            Self::NeoHookean(law) => Shape::NeoHookean(NeoHookean { shear: of("shear", law.shear) }),
            Self::Hencky(law) => Shape::Hencky(Hencky { shear: of("shear", law.shear) }),
            Self::Ogden(law) => {
                let named = law.terms().iter().zip(TERMS);
                let terms: Vec<_> = named
                    .map(|(term, [mu, alpha])| OgdenTerm {
                        mu: of(mu, term.mu),
                        alpha: of(alpha, term.alpha),
                    })
                    .collect();
                Shape::Ogden(Ogden::new(&terms))
            }
            Self::VonMises(law) => {
                let shear = of("shear", law.shear);
                Shape::VonMises(VonMises { shear, hardening: law.hardening.map(of) })
            }
        }
    }
    /// A law from its name and constants (SI), in the order of [`LAWS`].
    ///
    /// # Errors
    /// [`FemError::Input`] for an unknown name, a wrong number of constants, or constants without positive shear modulus.
    pub fn from_name(name: &str, constants: &[R]) -> Result<Self, FemError> {
        let Some(info) = LAWS.iter().find(|law| law.name == name) else {
            let known: Vec<_> = LAWS.iter().map(|law| law.name).collect();
            return Err(FemError::input("law", name, format!("known are {}", known.join(", "))));
        };
        let count = constants.len();
        if !(count.is_multiple_of(info.needed) && (info.needed..=info.constants.len()).contains(&count)) {
            let wanted: Vec<_> = info.constants.iter().map(|constant| constant.name).collect();
            return Err(FemError::input(
                format!("constants of {name}"),
                count,
                format!("these are needed, {} at a time: {}", info.needed, wanted.join(", ")),
            ));
        }
        let shape = match name {
            "mooney-rivlin" => Self::MooneyRivlin(MooneyRivlin { c10: constants[0], c01: constants[1] }),
            "neo-hookean" => Self::NeoHookean(NeoHookean { shear: constants[0] }),
            "ogden" => {
                let pairs = constants.chunks_exact(2);
                let terms: Vec<_> = pairs.map(|pair| OgdenTerm { mu: pair[0], alpha: pair[1] }).collect();
                Self::Ogden(Ogden::new(&terms))
            }
            _ => Self::Hencky(Hencky { shear: constants[0] }),
        };
        let shear = shape.shear().re();
        if !(shear > 0.0 && shear.is_finite()) {
            return Err(FemError::input(
                format!("shear modulus of {name}"),
                format!("{shear} Pa"),
                "it must be above zero",
            ));
        }
        Ok(shape)
    }
}
