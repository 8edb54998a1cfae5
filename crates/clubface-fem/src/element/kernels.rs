//! The numbers that elements are compiled for: all kernels are made here, once, whoever calls them.
//!
//! Patches are generic over their numbers, and whoever made one of plain numbers would compile its kernels again.
//! These functions are not generic.

use super::hex_full::{full_patches, FullPatch};
use super::hex_one_point::{solid_patches, SolidPatch};
use super::patch::Patch;
use super::shell::{ShellMaterial, ShellPatch, ShellRows};
use crate::material::{Material, Number, DERIVATIVES};
use crate::mesh::{ShellMesh, SolidMesh};
use clubface_math::Dual;
use std::ops::Range;

/// A number that elements are made of.
pub trait Kernels: Number {
    /// Patches of some one-point elements of a mesh, of one material, in their undeformed shape. Where elements
    /// follow each other as in a lattice, the patches are lattices, and those that differ by a rotation share their
    /// constants and follow each other.
    fn hex_one_point(
        mesh: &SolidMesh<Self>,
        elements: Range<usize>,
        material: &Material<Self>,
    ) -> Vec<Box<dyn Patch<Self>>>;
    /// Patches of some fully integrated elements, likewise.
    fn hex_full(
        mesh: &SolidMesh<Self>,
        elements: Range<usize>,
        material: &Material<Self>,
    ) -> Vec<Box<dyn Patch<Self>>>;
    /// A patch of some shells, free of stress.
    fn shell(
        mesh: &ShellMesh<Self>,
        elements: Range<usize>,
        material: ShellMaterial<Self>,
        rows: ShellRows,
    ) -> Box<dyn Patch<Self>>;
}

macro_rules! kernels {
    ($number:ty) => {
        impl Kernels for $number {
            fn hex_one_point(
                mesh: &SolidMesh<Self>,
                elements: Range<usize>,
                material: &Material<Self>,
            ) -> Vec<Box<dyn Patch<Self>>> {
                let boxed = |patch: SolidPatch<Self>| -> Box<dyn Patch<Self>> { Box::new(patch) };
                solid_patches(mesh, elements, material).into_iter().map(boxed).collect()
            }
            fn hex_full(
                mesh: &SolidMesh<Self>,
                elements: Range<usize>,
                material: &Material<Self>,
            ) -> Vec<Box<dyn Patch<Self>>> {
                let boxed = |patch: FullPatch<Self>| -> Box<dyn Patch<Self>> { Box::new(patch) };
                full_patches(mesh, elements, material).into_iter().map(boxed).collect()
            }
            fn shell(
                mesh: &ShellMesh<Self>,
                elements: Range<usize>,
                material: ShellMaterial<Self>,
                rows: ShellRows,
            ) -> Box<dyn Patch<Self>> {
                Box::new(ShellPatch::<Self>::new(mesh, elements, material, rows))
            }
        }
    };
}

kernels!(f64);
kernels!(Dual<f64, DERIVATIVES>);
