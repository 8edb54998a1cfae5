//! Heads of solid elements, such as irons: hexahedra and tetrahedra, in one piece or in parts that are bonded.

use super::DeformableHead;
use super::deformable::add_masses;
use crate::contact::Grooves;
use crate::element::{BondPatch, Element, Kernels, Patch, Tie, parts};
use crate::error::FemError;
use crate::material::Material;
use crate::mesh::{
    CORNERS, ShellMasses, SolidMesh, TET_NODES, bonded_nodes, check_connected, mass_share, tet_volumes,
};
use clubface_math::{Real, Vec3};
use std::ops::Range;

/// Nodes that a patch of a bond takes.
const BOND_PATCH: usize = 1000;

/// Consecutive elements of a head, of one material.
#[derive(Clone, Debug)]
pub struct SolidPart<R> {
    /// Name, such as "face".
    pub name: String,
    /// Its hexahedra.
    pub hexahedra: Range<usize>,
    /// Kind of the hexahedra.
    pub element: Element,
    /// Its tetrahedra.
    pub tetrahedra: Range<usize>,
    /// What it is made of.
    pub material: Material<R>,
}

/// A surface that is bonded to another one whose nodes are not the same.
#[derive(Clone, Debug)]
pub struct Bond {
    /// Name, such as "face to body".
    pub name: String,
    /// Part whose nodes are bonded.
    pub part: usize,
    /// Triangles of the surface of the part.
    pub surface: Vec<[u32; 3]>,
    /// Triangles of the other surface.
    pub other: Vec<[u32; 3]>,
    /// Largest distance between the two, m.
    pub within: f64,
}

/// A head of solid elements, in the axes of [`DeformableHead`]. In the output, tetrahedra follow hexahedra.
#[derive(Clone, Debug)]
pub struct SolidHead<R> {
    /// Positions of the nodes, m.
    pub nodes: Vec<Vec3<f64>>,
    /// Nodes of the hexahedra, in binary order.
    pub hexahedra: Vec<[u32; CORNERS]>,
    /// Nodes of the tetrahedra: corners, then middles of edges.
    pub tetrahedra: Vec<[u32; TET_NODES]>,
    /// The parts, which have all elements in their order.
    pub parts: Vec<SolidPart<R>>,
    /// Quadrilaterals that the ball may touch, counterclockwise seen from outside; a triangle has its last corner twice.
    pub face: Vec<[u32; 4]>,
    /// Grooves of the face, if it has any. Only the contact knows them; they are not meshed.
    pub grooves: Option<Grooves>,
    /// Mass added to each node, kg.
    pub added: Vec<f64>,
    /// Elevation of the face normal at the face centre, rad.
    pub loft: f64,
    /// Nodes that are bonded to faces of other parts.
    pub ties: Vec<Tie<R>>,
}

impl<R: Real> SolidHead<R> {
    /// Bonds surfaces: their nodes move onto the others, and are held there by springs.
    ///
    /// # Errors
    /// [`FemError::Input`] where the two surfaces are nowhere as near as they should be.
    pub fn bond(&mut self, bonds: &[Bond]) -> Result<(), FemError> {
        let masses = self.metal_masses();
        for bond in bonds {
            let bonded = bonded_nodes(&self.nodes, &bond.surface, &bond.other, bond.within);
            if bonded.is_empty() {
                let value = format!("open: no side of an element is within {:.3} mm", bond.within * 1e3);
                let allowed =
                    "the two surfaces must lie on each other; correct the mesh, or allow a wider gap";
                return Err(FemError::input(format!("bond of {}", bond.name), value, allowed));
            }
            let material = &self.parts[bond.part].material;
            let modulus = material.bulk + material.instantaneous_shear() * (4.0 / 3.0);
            for each in bonded {
                // The mass of a node is that of metal behind its part of the surface, to a depth. Its spring is as stiff
                // as that metal: it gives less than an element, and hardly shortens the stable step.
                let depth = masses[each.node as usize] / (material.density * each.area);
                self.nodes[each.node as usize] = each.place;
                self.ties.push(Tie {
                    node: each.node,
                    face: bond.other[each.triangle],
                    weights: each.weights,
                    stiffness: modulus * each.area / depth,
                });
            }
        }
        Ok(())
    }

    fn tetrahedron(&self, element: usize) -> [Vec3<f64>; TET_NODES] {
        self.tetrahedra[element].map(|n| self.nodes[n as usize])
    }

    fn hexahedra(&self) -> SolidMesh {
        let layer = vec![0; self.hexahedra.len()];
        SolidMesh { nodes: self.nodes.clone(), elements: self.hexahedra.clone(), layer }
    }

    /// Masses of the nodes without those that are added, kg.
    fn metal_masses(&self) -> Vec<R> {
        let mut masses = vec![R::zero(); self.nodes.len()];
        let hexahedra = self.hexahedra();
        for part in &self.parts {
            for e in part.hexahedra.clone() {
                let nodal_mass = part.material.density * (hexahedra.volume(e) / CORNERS as f64);
                for &node in &self.hexahedra[e] {
                    masses[node as usize] += nodal_mass;
                }
            }
            for e in part.tetrahedra.clone() {
                let mass = part.material.density * tet_volumes(&self.tetrahedron(e)).iter().sum::<f64>();
                for (place, &node) in self.tetrahedra[e].iter().enumerate() {
                    masses[node as usize] += mass * mass_share(place);
                }
            }
        }
        masses
    }

    /// Checks that no element is inverted.
    fn check_elements(&self) -> Result<(), FemError> {
        let hexahedra = self.hexahedra();
        let error = |element: usize, part: &str, volume: f64| {
            let name = format!("element {element} of {part}");
            let allowed =
                "its volume must be above 0 everywhere; make the wall thicker or the mesh finer there";
            FemError::input(name, format!("inverted (volume {:.3} mm3)", volume * 1e9), allowed)
        };
        for part in &self.parts {
            for e in part.hexahedra.clone() {
                let volume = hexahedra.volume(e);
                if volume <= 0.0 || volume.is_nan() {
                    return Err(error(e, &part.name, volume));
                }
            }
            for e in part.tetrahedra.clone() {
                let volumes = tet_volumes(&self.tetrahedron(e));
                if volumes.iter().any(|volume| *volume <= 0.0 || volume.is_nan()) {
                    let least = volumes.iter().fold(f64::INFINITY, |least, volume| least.min(4.0 * volume));
                    return Err(error(self.hexahedra.len() + e, &part.name, least));
                }
            }
        }
        Ok(())
    }
}

impl<R: Kernels> DeformableHead<R> for SolidHead<R> {
    fn check(&self) -> Result<(), FemError> {
        for part in &self.parts {
            part.material.check(&part.name)?;
        }
        self.check_elements()?;
        if self.face.is_empty() {
            let allowed = "at least one side of an element must belong to the face, which the ball touches";
            return Err(FemError::input("face", "empty", allowed));
        }
        self.check_face()?;
        let ties: Vec<[u32; 2]> = self.ties.iter().map(|tie| [tie.node, tie.face[0]]).collect();
        let hexahedra = self.hexahedra.iter().map(<[u32; CORNERS]>::as_slice);
        let tetrahedra = self.tetrahedra.iter().map(<[u32; TET_NODES]>::as_slice);
        check_connected(&self.nodes, hexahedra.chain(tetrahedra).chain(ties.iter().map(<[u32; 2]>::as_slice)))
    }
    fn loft(&self) -> f64 {
        self.loft
    }
    fn grooves(&self) -> Option<Grooves> {
        self.grooves
    }
    fn nodes(&self) -> &[Vec3<f64>] {
        &self.nodes
    }
    fn masses(&self) -> ShellMasses<R> {
        let mut translation = self.metal_masses();
        add_masses(&mut translation, &self.added);
        ShellMasses { translation, rotation: Vec::new() }
    }
    fn patches(&self, positions: &[Vec3<R>], first: u32) -> Vec<(String, Box<dyn Patch<R>>)> {
        // Elements number their nodes from the first row of the structure.
        let mut nodes = vec![Vec3::zero(); first as usize];
        nodes.extend(positions);
        let hexahedra = SolidMesh {
            nodes,
            elements: self.hexahedra.iter().map(|element| element.map(|n| n + first)).collect(),
            layer: vec![0; self.hexahedra.len()],
        };
        let tetrahedra: Vec<_> = self.tetrahedra.iter().map(|element| element.map(|n| n + first)).collect();
        let mut patches = Vec::new();
        for part in &self.parts {
            let mut add = |more: Vec<Box<dyn Patch<R>>>| {
                patches.extend(more.into_iter().map(|patch| (part.name.clone(), patch)));
            };
            if !part.hexahedra.is_empty() {
                add(part.element.patches(&hexahedra, part.hexahedra.clone(), &part.material));
            }
            if !part.tetrahedra.is_empty() {
                let (elements, offset) = (part.tetrahedra.clone(), self.hexahedra.len());
                add(R::tetrahedra(&hexahedra.nodes, &tetrahedra, elements, offset, &part.material));
            }
        }
        let ties: Vec<Tie<R>> = (self.ties.iter())
            .map(|tie| Tie { node: tie.node + first, face: tie.face.map(|n| n + first), ..tie.clone() })
            .collect();
        for some in parts(ties.len(), BOND_PATCH) {
            patches.push(("bonds".to_owned(), Box::new(BondPatch::new(&ties[some]))));
        }
        patches
    }
    fn face(&self) -> (Vec<[u32; 4]>, Vec<R>) {
        (self.face.clone(), vec![R::zero(); self.face.len()])
    }
}
