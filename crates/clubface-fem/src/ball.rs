//! The ball: pieces of material, meshed, with its mass distributed to the nodes.

use crate::element::{Element, Kernels, Patch};
use crate::error::FemError;
use crate::material::Material;
use crate::mesh::{Fineness, SolidMesh, cubed_sphere};
use clubface_math::{Mat3, Real, Row, Vec3};

/// Most pieces a ball may have.
pub const MAX_PIECES: usize = 5;

/// One piece of a ball: the core, or a layer around it.
#[derive(Clone, Debug)]
pub struct BallPiece<R> {
    /// Name, for messages.
    pub name: String,
    /// Outer radius, m.
    pub radius: R,
    /// Element layers through it.
    pub layers: usize,
    /// What it is made of.
    pub material: Material<R>,
}

/// The construction of a ball: its pieces, and how to mesh them.
#[derive(Clone, Debug)]
pub struct BallConstruction<R> {
    /// Pieces from the centre outwards.
    pub pieces: Vec<BallPiece<R>>,
    /// Elements along the edge of the cube inside.
    pub cube: usize,
    /// Kind of elements.
    pub element: Element,
    /// Mass of the ball, kg: the core gets the density that leads to it. Without it, the core has the density of its
    /// own material.
    pub mass: Option<f64>,
}

/// A meshed ball.
pub struct MeshedBall<R> {
    /// The mesh, at its position in space.
    pub mesh: SolidMesh<R>,
    /// Patches of elements, each of one piece.
    pub patches: Vec<Box<dyn Patch<R>>>,
    /// Name of the piece of each patch.
    pub parts: Vec<String>,
    /// Mass of each node, kg.
    pub masses: Vec<R>,
    /// Outer nodes.
    pub surface: Vec<u32>,
    /// Outer quadrilaterals.
    pub sides: Vec<[u32; 4]>,
    /// Part of the surface that belongs to each node, m2.
    pub areas: Vec<f64>,
    /// Radius, m.
    pub radius: f64,
    /// Mass, kg.
    pub mass: R,
    /// Moment of inertia about a diameter, kg m2 (mean of three).
    pub inertia: R,
    /// Density of the core, kg/m3.
    pub core_density: R,
}

impl<R: Kernels> BallConstruction<R> {
    /// Outer radius, m.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.pieces.last().map_or(f64::NAN, |piece| piece.radius.re())
    }

    /// Checks that the ball can be meshed.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first value that is not allowed.
    pub fn check(&self) -> Result<(), FemError> {
        if self.pieces.is_empty() || self.pieces.len() > MAX_PIECES {
            let allowed = format!("it must be from 1 to {MAX_PIECES}");
            return Err(FemError::input("pieces", self.pieces.len(), allowed));
        }
        if !(2..=96).contains(&self.cube) || self.cube % 2 == 1 {
            return Err(FemError::input("ball.cube", self.cube, "it must be an even number from 2 to 96"));
        }
        let mut inside = 0.0;
        for piece in &self.pieces {
            let name = &piece.name;
            let radius = piece.radius.re();
            if !(radius > inside + 1e-5 && radius < 0.1) {
                let allowed =
                    "it must be at least 0.01 mm more than that of the piece inside, and below 100 mm";
                let value = format!("{} mm", radius * 1e3);
                return Err(FemError::input(format!("radius of {name}"), value, allowed));
            }
            if !(1..=48).contains(&piece.layers) {
                let allowed = "it must be from 1 to 48";
                return Err(FemError::input(format!("{name}.layers"), piece.layers, allowed));
            }
            // The mass of the ball decides the density of the core.
            if self.mass.is_some() && inside == 0.0 {
                piece.material.check_law(name)?;
            } else {
                piece.material.check(name)?;
            }
            inside = radius;
        }
        if let Some(mass) = self.mass
            && !(mass > 0.0 && mass < 1.0)
        {
            let allowed = "it must be above 0 and below 1000 g";
            return Err(FemError::input("ball.mass", format!("{} g", mass * 1e3), allowed));
        }
        Ok(())
    }

    /// Meshes the ball about `centre`, with a pole of the mesh along the first column of `rotation`.
    ///
    /// # Errors
    /// As [`BallConstruction::check`], or when the other pieces alone are heavier than the ball.
    pub fn mesh(&self, rotation: &Mat3<R>, centre: Vec3<R>) -> Result<MeshedBall<R>, FemError> {
        self.check()?;
        let radii: Vec<R> = self.pieces.iter().map(|piece| piece.radius).collect();
        let layers = self.pieces.iter().map(|piece| piece.layers).collect();
        let mut mesh = cubed_sphere(&radii, &Fineness { cube: self.cube, layers });
        for node in &mut mesh.nodes {
            *node = *rotation * *node + centre;
        }
        let volumes: Vec<R> = (0..mesh.elements.len()).map(|e| mesh.volume(e)).collect();
        let materials = self.materials(&mesh, &volumes)?;
        let mut masses = vec![R::zero(); mesh.nodes.len()];
        for ((element, &piece), &volume) in mesh.elements.iter().zip(&mesh.layer).zip(&volumes) {
            let nodal_mass = materials[piece as usize].density * (volume / 8.0);
            for &node in element {
                masses[node as usize] += nodal_mass;
            }
        }
        let (mut patches, mut parts) = (Vec::new(), Vec::new());
        let mut start = 0;
        while start < mesh.elements.len() {
            let piece = mesh.layer[start];
            let end = start + mesh.layer[start..].iter().take_while(|&&layer| layer == piece).count();
            for patch in self.element.patches(&mesh, start..end, &materials[piece as usize]) {
                patches.push(patch);
                parts.push(self.pieces[piece as usize].name.clone());
            }
            start = end;
        }
        let sides = mesh.surface();
        let mut areas = vec![0.0; mesh.nodes.len()];
        for side in &sides {
            let [a, b, c, d] = side.map(|n| mesh.nodes[n as usize]);
            let area = (c - a).cross(d - b).norm().re() * 0.5;
            for &node in side {
                areas[node as usize] += area / 4.0;
            }
        }
        let surface = (0..mesh.nodes.len() as u32).filter(|&n| areas[n as usize] > 0.0).collect();
        let (mut mass, mut polar) = (R::zero(), R::zero());
        for (node, &m) in mesh.nodes.iter().zip(&masses) {
            mass += m;
            polar += m * (*node - centre).norm_squared();
        }
        Ok(MeshedBall {
            mesh,
            patches,
            parts,
            masses,
            surface,
            sides,
            areas,
            radius: self.radius(),
            mass,
            inertia: polar * (2.0 / 3.0),
            core_density: materials[0].density,
        })
    }

    /// Materials of the pieces, the core with the density that gives the ball its mass.
    fn materials(&self, mesh: &SolidMesh<R>, volumes: &[R]) -> Result<Vec<Material<R>>, FemError> {
        let mut materials: Vec<_> = self.pieces.iter().map(|piece| piece.material.clone()).collect();
        let Some(target) = self.mass else { return Ok(materials) };
        let mut volume = vec![R::zero(); materials.len()];
        for (&piece, &v) in mesh.layer.iter().zip(volumes) {
            volume[piece as usize] += v;
        }
        let mut core_mass = R::from_f64(target);
        for (material, &v) in materials.iter().zip(&volume).skip(1) {
            core_mass -= material.density * v;
        }
        let density = core_mass / volume[0];
        if density.re() <= 100.0 {
            let allowed = format!(
                "this leaves the core a density of {:.0} kg/m3, and at least 100 is needed; make the pieces around it lighter or thinner",
                density.re()
            );
            return Err(FemError::input("ball.mass", format!("{:.2} g", target * 1e3), allowed));
        }
        materials[0].density = density;
        Ok(materials)
    }
}

impl<R: Real> MeshedBall<R> {
    /// Positions of the nodes as rows.
    #[must_use]
    pub fn positions(&self) -> Vec<Row<R>> {
        self.mesh.nodes.iter().map(|p| Row::from_vec(*p)).collect()
    }
}
