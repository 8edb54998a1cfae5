//! Heads of hexahedra, such as irons.

use super::DeformableHead;
use super::deformable::add_masses;
use crate::contact::Grooves;
use crate::element::{Element, Kernels, Patch};
use crate::error::FemError;
use crate::material::Material;
use crate::mesh::{ShellMasses, SolidMesh};
use clubface_math::Vec3;

/// A head of hexahedra of one material, in the axes of [`DeformableHead`].
#[derive(Clone, Debug)]
pub struct SolidHead<R> {
    /// The mesh.
    pub solid: SolidMesh,
    /// Quadrilaterals that the ball may touch, counterclockwise seen from outside.
    pub face: Vec<[u32; 4]>,
    /// What it is made of.
    pub material: Material<R>,
    /// Grooves of the face, if it has any. Only the contact knows them; they are not meshed.
    pub grooves: Option<Grooves>,
    /// Kind of elements.
    pub element: Element,
    /// Mass added to each node, kg.
    pub added: Vec<f64>,
    /// Elevation of the face normal at the face centre, rad.
    pub loft: f64,
}

impl<R: Kernels> DeformableHead<R> for SolidHead<R> {
    fn check(&self) -> Result<(), FemError> {
        self.material.check("head")?;
        for element in 0..self.solid.elements.len() {
            let volume = self.solid.volume(element);
            if volume <= 0.0 || volume.is_nan() {
                let name = format!("element {element} of the head");
                let allowed = "its volume must be above 0; make the blade thicker or the mesh finer there";
                let value = format!("inverted (volume {:.3} mm3)", volume * 1e9);
                return Err(FemError::input(name, value, allowed));
            }
        }
        if self.face.is_empty() {
            let allowed = "at least one side of an element must belong to the face, which the ball touches";
            return Err(FemError::input("face", "empty", allowed));
        }
        self.check_face()
    }
    fn loft(&self) -> f64 {
        self.loft
    }
    fn grooves(&self) -> Option<Grooves> {
        self.grooves
    }
    fn nodes(&self) -> &[Vec3<f64>] {
        &self.solid.nodes
    }
    fn masses(&self) -> ShellMasses<R> {
        let mut translation = vec![R::zero(); self.solid.nodes.len()];
        for (e, element) in self.solid.elements.iter().enumerate() {
            let nodal_mass = self.material.density * (self.solid.volume(e) / 8.0);
            for &node in element {
                translation[node as usize] += nodal_mass;
            }
        }
        add_masses(&mut translation, &self.added);
        ShellMasses { translation, rotation: Vec::new() }
    }
    fn patches(&self, positions: &[Vec3<R>], first: u32) -> Vec<(String, Box<dyn Patch<R>>)> {
        // Elements number their nodes from the first row of the structure.
        let mut nodes = vec![Vec3::zero(); first as usize];
        nodes.extend(positions);
        let elements = self.solid.elements.iter().map(|element| element.map(|n| n + first)).collect();
        let mesh = SolidMesh { nodes, elements, layer: self.solid.layer.clone() };
        let patches = self.element.patches(&mesh, 0..mesh.elements.len(), &self.material);
        patches.into_iter().map(|patch| ("head".to_owned(), patch)).collect()
    }
    fn face(&self) -> (Vec<[u32; 4]>, Vec<R>) {
        (self.face.clone(), vec![R::zero(); self.face.len()])
    }
}
