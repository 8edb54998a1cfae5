//! Kinds of solid elements by name, and the numbers that elements are compiled for: all kernels are made here, once,
//! for every caller.
//!
//! Patches are generic over their numbers, so that every user of plain numbers would compile its kernels again. The
//! functions of [`Kernels`] are not generic.

use super::hex_full::full_patches;
use super::hex_one_point::solid_patches;
use super::patch::Patch;
use super::shell::{ShellMaterial, ShellPatch, ShellRows};
use super::tet_ten::tetrahedron_patches;
use crate::error::FemError;
use crate::material::{DERIVATIVES, Material, Number};
use crate::mesh::{ShellMesh, SolidMesh, TET_NODES};
use clubface_math::{Dual, Vec3};
use std::ops::Range;

/// Some patches of elements.
pub type Patches<R> = Vec<Box<dyn Patch<R>>>;

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

    /// Patches of some elements of a mesh, of one material, in their undeformed shape. Where one-point elements follow
    /// each other as in a lattice, the patches are lattices, and those that differ by a rotation share their constants
    /// and follow each other.
    pub fn patches<R: Kernels>(
        self,
        mesh: &SolidMesh<R>,
        elements: Range<usize>,
        material: &Material<R>,
    ) -> Patches<R> {
        R::solid(self, mesh, elements, material)
    }
}

/// A number that elements are made of.
pub trait Kernels: Number {
    /// See [`Element::patches`].
    fn solid(
        kind: Element,
        mesh: &SolidMesh<Self>,
        elements: Range<usize>,
        material: &Material<Self>,
    ) -> Patches<Self>;
    /// Patches of some ten-node tetrahedra of one material in their undeformed shape, given the positions (m) of all
    /// nodes and the nodes of all tetrahedra. In the output the first of all has the number `offset`.
    fn tetrahedra(
        positions: &[Vec3<Self>],
        mesh: &[[u32; TET_NODES]],
        elements: Range<usize>,
        offset: usize,
        material: &Material<Self>,
    ) -> Patches<Self>;
    /// A patch of some shells, free of stress.
    fn shell(
        mesh: &ShellMesh<Self>,
        elements: Range<usize>,
        material: ShellMaterial<Self>,
        rows: ShellRows,
    ) -> Box<dyn Patch<Self>>;
}

fn boxed<R: Number, P: Patch<R> + 'static>(patches: Vec<P>) -> Patches<R> {
    patches.into_iter().map(|patch| -> Box<dyn Patch<R>> { Box::new(patch) }).collect()
}

macro_rules! kernels {
    ($($number:ty),+) => {
        $(impl Kernels for $number {
            fn solid(
                kind: Element,
                mesh: &SolidMesh<Self>,
                elements: Range<usize>,
                material: &Material<Self>,
            ) -> Patches<Self> {
                match kind {
                    Element::OnePoint => boxed(solid_patches(mesh, elements, material)),
                    Element::FullyIntegrated => boxed(full_patches(mesh, elements, material)),
                }
            }
            fn tetrahedra(
                positions: &[Vec3<Self>],
                mesh: &[[u32; TET_NODES]],
                elements: Range<usize>,
                offset: usize,
                material: &Material<Self>,
            ) -> Patches<Self> {
                boxed(tetrahedron_patches(positions, mesh, elements, offset, material))
            }
            fn shell(
                mesh: &ShellMesh<Self>,
                elements: Range<usize>,
                material: ShellMaterial<Self>,
                rows: ShellRows,
            ) -> Box<dyn Patch<Self>> {
                Box::new(ShellPatch::<Self>::new(mesh, elements, material, rows))
            }
        })+
    };
}

kernels!(f64, Dual<f64, DERIVATIVES>);
