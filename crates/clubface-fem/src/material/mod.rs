//! What solids are made of: a law for the change of shape, one file each, and one common law for the change of volume.
//!
//! Every law is an energy per unit reference volume, `W(C̄) + K/2 (J - 1)^2` with `C̄ = J^(-2/3) F^T F`, so that
//! nearly incompressible rubber and compressible plastics are treated alike (Holzapfel, Nonlinear Solid Mechanics,
//! 2000, section 6.4).

mod body;
mod deformation;
mod description;
mod energy;
mod family;
mod hardening;
mod hencky;
mod law;
mod laws;
mod mapped;
mod mooney_rivlin;
mod neo_hookean;
mod ogden;
mod own;
mod plane_stress;
mod point;
mod stage;
mod state_variables;
mod step;
pub mod stretch;
mod symmetric;
mod table;
mod viscous;
mod von_mises;

pub use body::Material;
pub use clubface_impact::{description::FromValues, scalars};
pub use deformation::{Deformation, Kinematics};
pub use description::{Constant, Description};
pub use energy::{Energy, EnergyLaw, Instability, STRETCHES, VOLUMES, VolumeLaw, Volumetric};
pub use family::{DERIVATIVES, Entry, Family, Law, Origin};
pub use hardening::{HARDENING_POINTS, Hardening};
pub use hencky::Hencky;
pub use law::{
    Elastic, Inelastic, InvariantKinematics, Invariants, Isochoric, OfInvariants, PointLaw, WithState,
};
pub use laws::{LAWS, law_from_name, register_law, unchecked_law};
pub use mapped::map_law;
pub use mooney_rivlin::MooneyRivlin;
pub use neo_hookean::NeoHookean;
pub use ogden::{OGDEN_TERMS, Ogden};
pub use own::{LawFunction, OWN_NUMBERS, OwnFunction, registered};
pub use plane_stress::{PlaneState, PlaneStress};
pub use point::MaterialPoint;
pub use stage::{EnergyPoints, PointEnergy, Points, StressStage};
pub use state_variables::{Numbers, StateVariables, Update, Updates, eight_alike};
pub use step::MaterialStep;
pub use symmetric::{Symmetric, times};
pub(crate) use symmetric::{cross, dot};
pub use table::{Number, Staged, build, entry, entry_from_name, from_table};
pub use viscous::{Branches, Decay, MAX_TERMS, Maxwell};
pub use von_mises::{PlasticState, VonMises};
