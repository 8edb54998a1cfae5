//! Heads of shells.

use super::DeformableHead;
use super::deformable::add_masses;
use crate::element::{Kernels, Patch, SHELL_PATCH, ShellMaterial, ShellRows, parts};
use crate::error::FemError;
use crate::mesh::{ShellMasses, ShellMesh, check_wall};
use clubface_math::Vec3;
use std::ops::Range;

/// Consecutive shells of a head.
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

/// A head of shells. Axes: x towards the target, y up, z to the toe, as the club is soled; the origin is the face
/// centre.
#[derive(Clone, Debug)]
pub struct ShellHead<R> {
    /// Middle surface.
    pub shells: ShellMesh<R>,
    /// The parts, which have all elements in their order.
    pub parts: Vec<ShellPart<R>>,
    /// Mass added to each node, kg.
    pub added: Vec<f64>,
    /// Elevation of the face normal at the face centre, rad.
    pub loft: f64,
}

impl<R: Kernels> DeformableHead<R> for ShellHead<R> {
    fn check(&self) -> Result<(), FemError> {
        for part in &self.parts {
            part.material.check(&part.name)?;
            for element in part.elements.clone() {
                let (name, place) = (format!("thickness of {}", part.name), format!(" in element {element}"));
                check_wall(&name, self.shells.thickness[element].re(), &place)?;
                self.shells.check_shape(element, &part.name)?;
            }
        }
        if !self.parts.iter().any(|part| part.face && !part.elements.is_empty()) {
            let allowed = "at least one element must belong to the face, which the ball touches";
            return Err(FemError::input("face", "empty", allowed));
        }
        self.shells.check_size()?;
        self.shells.check_edges()?;
        self.check_face()?;
        self.shells.check_connected()
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
        add_masses(&mut masses.translation, &self.added);
        masses
    }
    fn patches(&self, _positions: &[Vec3<R>], first: u32) -> Vec<(String, Box<dyn Patch<R>>)> {
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
