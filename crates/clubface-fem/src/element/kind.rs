//! Kinds of solid elements, by name.

use super::kernels::Kernels;
use super::patch::Patch;
use crate::error::FemError;
use crate::material::Material;
use crate::mesh::SolidMesh;

/// Kinds of solid elements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Element {
    /// One point of integration and hourglass control.
    #[default]
    OnePoint,
    /// Eight points of integration and one pressure.
    FullyIntegrated,
}

impl Element {
    /// Its name in case files and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::OnePoint => "one-point",
            Self::FullyIntegrated => "full",
        }
    }

    /// The kind called `name`.
    ///
    /// # Errors
    /// [`FemError::Input`] for an unknown name.
    pub fn from_name(name: &str) -> Result<Self, FemError> {
        let known = [Self::OnePoint, Self::FullyIntegrated];
        known
            .into_iter()
            .find(|kind| kind.name() == name)
            .ok_or_else(|| FemError::unknown("element", name, known.map(Self::name)))
    }

    /// Patches of some elements of a mesh, of one material, in their undeformed shape.
    pub fn patches<R: Kernels>(
        self,
        mesh: &SolidMesh<R>,
        elements: std::ops::Range<usize>,
        material: &Material<R>,
    ) -> Vec<Box<dyn Patch<R>>> {
        match self {
            Self::OnePoint => R::hex_one_point(mesh, elements, material),
            Self::FullyIntegrated => R::hex_full(mesh, elements, material),
        }
    }
}
