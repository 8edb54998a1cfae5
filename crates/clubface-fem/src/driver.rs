//! A driver head of shells: shape, thickness and metal, brought to its mass and inertia, and a ball met by it.

use crate::ball::Ball;
use crate::contact::{BallSide, Contact, FaceContact, FaceSide};
use crate::element::{Isotropic, Patch, ShellMaterial, ShellPatch, ShellRows, SHELL_PATCH};
use crate::error::FemError;
use crate::mesh::{
    tune, DriverFineness, DriverMesh, DriverShape, DriverThickness, MassProperties, Region, Target, Trim,
    Tuned,
};
use crate::solve::{Impact, Structure};
use clubface_math::{Mat3, Real, Row, Vec3};

/// A driver head as designed.
#[derive(Clone, Debug)]
pub struct Driver<R> {
    /// Shape.
    pub shape: DriverShape,
    /// Elements.
    pub fineness: DriverFineness,
    /// Thickness before tuning.
    pub thickness: DriverThickness,
    /// Metal.
    pub metal: ShellMaterial<R>,
    /// Limits of the factor on the thickness of crown, sole and skirt; that of the face stays.
    pub scales: (f64, f64),
    /// Masses that may be added.
    pub trims: Vec<Trim>,
    /// What to reach.
    pub target: Target,
}

/// A driver head as meshed and tuned.
#[derive(Clone, Debug)]
pub struct MeshedDriver<R> {
    /// Mesh with its final thickness.
    pub mesh: DriverMesh<R>,
    /// What tuning did.
    pub tuned: Tuned,
    /// Masses of the nodes with the trim masses, kg.
    pub masses: Vec<R>,
    /// Their rotary inertias, kg m2.
    pub rotary: Vec<R>,
}

impl<R: Real> Driver<R> {
    /// P2's head as far as it says: 210 g, loft 11.5 deg, 3264 shells, moment of inertia 1526 g cm2. P2 does not say about which axis; about the
    /// vertical no head of a driver's size comes down to that, about the axis from heel to toe it is what a driver of its time has, so
    /// that is how it is read. The rest is chosen: titanium, a shape of about 300 cm3, usual walls, and the mass centre on the face normal
    /// through the face centre.
    #[must_use]
    pub fn p2() -> Self {
        let shape = DriverShape {
            loft: 11.5_f64.to_radians(),
            bulge: 0.305,
            roll: 0.305,
            width: 0.105,
            depth: 0.078,
            crown: 0.025,
            sole: 0.023,
            rounding: 0.008,
        };
        let (_, up) = shape.face_axes();
        let trim = |name: &str, at: [f64; 3]| Trim { name: name.into(), at: Vec3::from_f64(at), most: 0.06 };
        Self {
            shape,
            fineness: DriverFineness::default(),
            thickness: DriverThickness {
                face_centre: 3.2e-3,
                face_edge: 2.4e-3,
                crown: 1.3e-3,
                sole: 1.6e-3,
                skirt: 1.4e-3,
            },
            metal: ShellMaterial {
                elastic: Isotropic { young: R::from_f64(114e9), poisson: R::from_f64(0.34) },
                density: R::from_f64(4430.0),
            },
            scales: (0.6, 1.8),
            trims: vec![
                trim("sole", [-0.035, -0.023, 0.0]),
                trim("back", [-0.078, 0.0, 0.0]),
                trim("heel", [-0.02, 0.0, -0.05]),
                trim("toe", [-0.02, 0.0, 0.05]),
                trim("sole front", [-0.008, -0.02, 0.0]),
            ],
            target: Target {
                mass: 0.210,
                centre: [None, None, Some(0.0)],
                above: Some((up, 0.0)),
                inertia: [None, None, Some(1526e-7)],
            },
        }
    }

    /// Checks what no head can be made of.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first value that is not allowed.
    pub fn check(&self) -> Result<(), FemError> {
        let t = &self.thickness;
        let walls = [
            ("thickness.face_centre", t.face_centre),
            ("thickness.face_edge", t.face_edge),
            ("thickness.crown", t.crown),
            ("thickness.sole", t.sole),
            ("thickness.skirt", t.skirt),
        ];
        for (name, value) in walls {
            if !(2e-4..=0.02).contains(&value) {
                let value = format!("{} mm", value * 1e3);
                return Err(FemError::input(name, value, "0.2 to 20 mm is allowed"));
            }
        }
        let young = self.metal.elastic.young.re();
        if young <= 0.0 || young.is_nan() {
            return Err(FemError::input("young", format!("{young} Pa"), "above 0 is allowed"));
        }
        let poisson = self.metal.elastic.poisson.re();
        if !(poisson > -1.0 && poisson < 0.5) {
            return Err(FemError::input("poisson", poisson, "above -1 and below 0.5 is allowed"));
        }
        let density = self.metal.density.re();
        if density <= 0.0 || density.is_nan() {
            return Err(FemError::input("density", format!("{density} kg/m3"), "above 0 is allowed"));
        }
        if self.fineness.0.iter().any(|n| !(4..=400).contains(n)) {
            let value = format!("{:?}", self.fineness.0);
            return Err(FemError::input("head elements", value, "4 to 400 a side are allowed"));
        }
        Ok(())
    }

    /// Meshes and tunes the head.
    ///
    /// # Errors
    /// As [`Driver::check`].
    pub fn mesh(&self) -> Result<MeshedDriver<R>, FemError> {
        self.check()?;
        let mut mesh = self.shape.mesh::<R>(self.fineness, &self.thickness);
        let body: Vec<bool> = mesh.regions.iter().map(|region| *region != Region::Face).collect();
        let density = self.metal.density;
        let tuned = tune(&mut mesh.shells, &body, density.re(), self.scales, &self.trims, &self.target);
        let mut masses = mesh.shells.masses(density);
        for (mass, &added) in masses.translation.iter_mut().zip(&tuned.added) {
            *mass += R::from_f64(added);
        }
        Ok(MeshedDriver { mesh, tuned, masses: masses.translation, rotary: masses.rotation })
    }

    /// A ball at rest, met at the face centre by the head, which moves towards the target at `speed`, m/s.
    ///
    /// # Errors
    /// [`FemError::Input`] for a ball or a head that cannot be meshed.
    pub fn against_ball(&self, ball: &Ball<R>, speed: R, friction: R) -> Result<Impact<R>, FemError> {
        if speed.re() <= 0.0 {
            let value = format!("{:.2} m/s", speed.re());
            return Err(FemError::input("speed", value, "above 0 is allowed: the head must meet the ball"));
        }
        let (normal, up) = self.shape.face_axes();
        let axes = [normal, up, Vec3::new(0.0, 0.0, 1.0)];
        let [x, y, z] = axes.map(|axis| Vec3::from_f64(axis.array()));
        let meshed = ball.mesh(&Mat3::from_columns(x, y, z), x * R::from_f64(ball.radius()))?;
        let head = self.mesh()?;
        let shells = &head.mesh.shells;
        let (balls, count) = (meshed.masses.len(), shells.nodes.len());
        let rows = ShellRows { positions: balls as u32, rotations: (balls + count) as u32 };
        let mut positions = meshed.positions();
        positions.extend(shells.nodes.iter().map(|p| Row::from_vec(Vec3::from_f64(p.array()))));
        positions.extend(vec![Row::zero(); count]);
        let mut masses = meshed.masses;
        masses.extend(&head.masses);
        masses.extend(&head.rotary);
        let (mut patches, mut parts) = (meshed.patches, meshed.parts);
        for start in (0..shells.quads.len()).step_by(SHELL_PATCH) {
            let elements = start..(start + SHELL_PATCH).min(shells.quads.len());
            let patch = ShellPatch::new(shells, elements, self.metal.clone(), rows);
            patches.push(Box::new(patch) as Box<dyn Patch<R>>);
            parts.push("head".into());
        }
        let (quads, thickness) = head.mesh.part(Region::Face, balls as u32);
        let contact = FaceContact::new(
            &BallSide { nodes: &meshed.surface, masses: &masses, areas: &meshed.areas },
            &FaceSide { quads: &quads, thickness: &thickness, rotations: count as u32, masses: &masses },
            friction,
            &positions,
        );
        // Both sides are polyhedra: bring them to touch.
        let gap = R::from_f64(contact.clearance(&positions));
        for row in &mut positions[..balls] {
            row.add(Vec3::from_f64(normal.array()) * -gap);
        }
        let mut structure = Structure::new(positions, masses, patches, contact.nodes());
        structure.translations = balls + count;
        let velocity = Vec3::new(speed, R::zero(), R::zero());
        structure.velocities[balls..balls + count].fill(Row::from_vec(velocity));
        Ok(Impact {
            structure,
            contact: Box::new(contact),
            ball_nodes: balls,
            radius: meshed.radius,
            inertia: meshed.inertia,
            axes,
            head_velocity: velocity,
            parts,
        })
    }
}

impl<R> MeshedDriver<R> {
    /// Mass, mass centre and inertia.
    #[must_use]
    pub fn mass_properties(&self) -> MassProperties {
        self.tuned.reached
    }
}
