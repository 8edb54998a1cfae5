//! Heads that deform: of shells, or solid.

mod check;
mod driver;
mod meet;
mod solid;

pub use driver::{Driver, MeshedDriver};
pub use meet::{against_ball, face_axes, touch_check, DeformableHead};
pub use solid::SolidHead;

use crate::element::{parts, Kernels, Patch, ShellMaterial, ShellRows, SHELL_PATCH};
use crate::error::FemError;
use crate::mesh::{ShellMasses, ShellMesh};
use clubface_math::{Real, Vec3};
use std::ops::Range;

/// Some shells of a head, which follow each other.
#[derive(Clone, Debug)]
pub struct ShellPart<R> {
    /// Name, such as "crown".
    pub name: String,
    /// The elements.
    pub elements: Range<usize>,
    /// What they are made of.
    pub material: ShellMaterial<R>,
    /// Whether the ball may touch them.
    pub face: bool,
}

/// A head of shells. Axes: x towards the target, y up, z to the toe, as the club is soled; the origin is the face centre.
#[derive(Clone, Debug)]
pub struct ShellHead<R> {
    /// Middle surface.
    pub shells: ShellMesh<R>,
    /// The parts, in the order of their elements, of which none is left out.
    pub parts: Vec<ShellPart<R>>,
    /// Mass added to each node, kg.
    pub added: Vec<f64>,
    /// Elevation of the face normal at the face centre, rad.
    pub loft: f64,
}

impl<R: Kernels> DeformableHead<R> for ShellHead<R> {
    fn check(&self) -> Result<(), FemError> {
        self.check_shells()
    }
    fn loft(&self) -> f64 {
        self.loft
    }
    fn nodes(&self) -> &[Vec3<f64>] {
        &self.shells.nodes
    }
    fn masses(&self) -> ShellMasses<R> {
        let mut masses =
            self.shells.masses(self.parts.iter().map(|p| (p.elements.clone(), p.material.density)));
        add(&mut masses.translation, &self.added);
        masses
    }
    fn patches(&self, _placed: &[Vec3<R>], first: u32) -> Vec<(String, Box<dyn Patch<R>>)> {
        let rows = ShellRows { positions: first, rotations: first + self.shells.nodes.len() as u32 };
        let mut patches = Vec::new();
        for part in &self.parts {
            let start = part.elements.start;
            for some in parts(part.elements.len(), SHELL_PATCH) {
                let elements = start + some.start..start + some.end;
                let patch = R::shell(&self.shells, elements, part.material.clone(), rows);
                patches.push((part.name.clone(), patch));
            }
        }
        patches
    }
    fn face(&self) -> (Vec<[u32; 4]>, Vec<R>) {
        let elements = || self.parts.iter().filter(|part| part.face).flat_map(|part| part.elements.clone());
        (
            elements().map(|e| self.shells.quads[e]).collect(),
            elements().map(|e| self.shells.thickness[e]).collect(),
        )
    }
}

/// Adds masses to the nodes that carry them.
fn add<R: Real>(masses: &mut [R], added: &[f64]) {
    for (mass, &more) in masses.iter_mut().zip(added) {
        *mass += R::from_f64(more);
    }
}
