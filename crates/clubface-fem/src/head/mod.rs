//! Heads of shells: a ball met by one.

mod check;
mod driver;

pub use driver::{Driver, MeshedDriver};

use crate::ball::Ball;
use crate::contact::{BallSide, Contact, FaceContact, FaceSide, Springs};
use crate::element::{Patch, ShellMaterial, ShellPatch, ShellRows, SHELL_PATCH};
use crate::error::FemError;
use crate::mesh::{mass_properties, MassProperties, ShellMasses, ShellMesh};
use crate::solve::{Impact, Options, Structure};
use clubface_impact::first_touch::FirstTouch;
use clubface_math::{Mat3, Real, Row, Vec3};
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

/// Unit normal of a face of the given loft at its centre, the direction up the face, and that to the toe.
#[must_use]
pub fn face_axes(loft: f64) -> [Vec3<f64>; 3] {
    let (s, c) = loft.sin_cos();
    [Vec3::new(c, s, 0.0), Vec3::new(-s, c, 0.0), Vec3::new(0.0, 0.0, 1.0)]
}

impl<R: Real> ShellHead<R> {
    /// Masses of the nodes.
    #[must_use]
    pub fn masses(&self) -> ShellMasses<R> {
        let mut masses =
            self.shells.masses(self.parts.iter().map(|p| (p.elements.clone(), p.material.density)));
        for (mass, &added) in masses.translation.iter_mut().zip(&self.added) {
            *mass += R::from_f64(added);
        }
        masses
    }

    /// Mass, mass centre and inertia.
    #[must_use]
    pub fn mass_properties(&self) -> MassProperties {
        let masses: Vec<f64> = self.masses().translation.iter().map(|m| m.re()).collect();
        mass_properties(&self.shells.nodes, &masses)
    }

    /// A ball at rest, met by the head of a shot, whose mass properties are those of this head; in face axes of first touch with the origin at
    /// the head's CG.
    ///
    /// # Errors
    /// [`FemError::Input`] for a ball or a head that cannot be meshed, or a head that moves away from the ball.
    pub fn against_ball(
        &self,
        ball: &Ball<R>,
        touch: &FirstTouch<R>,
        friction: R,
    ) -> Result<Impact<R>, FemError> {
        self.check()?;
        touch_check(touch)?;
        let (up, toe) = touch.tangents();
        let axes = [touch.normal, up, toe];
        let radius = R::from_f64(ball.radius());
        let meshed =
            ball.mesh(&Mat3::from_columns(axes[0], up, toe), touch.contact + touch.normal * radius)?;
        let (balls, count) = (meshed.masses.len(), self.shells.nodes.len());
        let rows = ShellRows { positions: balls as u32, rotations: (balls + count) as u32 };
        let mut positions = meshed.positions();
        let mut masses = meshed.masses.clone();
        // The springs are those of the ball against a rigid face, though the shells may need shorter steps.
        let mut alone = Structure::new(positions.clone(), meshed.masses, meshed.patches, &[]);
        let springs =
            Springs { step: Some(alone.stable_step(40) * Options::default().safety), ..Springs::default() };
        let (mut patches, mut parts) = (alone.into_patches(), meshed.parts);
        let placed = self.placed(touch.lever);
        let mut velocities = vec![Row::zero(); balls];
        for &place in &placed {
            positions.push(Row::from_vec(place));
            velocities.push(Row::from_vec(touch.club_velocity + touch.club_spin.cross(place)));
        }
        positions.resize(balls + 2 * count, Row::zero());
        velocities.resize(balls + 2 * count, Row::from_vec(touch.club_spin));
        let of_shells = self.masses();
        masses.extend(&of_shells.translation);
        masses.extend(&of_shells.rotation);
        let mut face =
            FaceSide { quads: vec![], thickness: vec![], rotations: count as u32, masses: &masses };
        for part in &self.parts {
            for start in part.elements.clone().step_by(SHELL_PATCH) {
                let elements = start..(start + SHELL_PATCH).min(part.elements.end);
                let patch = ShellPatch::new(&self.shells, elements, part.material.clone(), rows);
                patches.push(Box::new(patch) as Box<dyn Patch<R>>);
                parts.push(part.name.clone());
            }
            for element in part.elements.clone().filter(|_| part.face) {
                face.quads.push(self.shells.quads[element].map(|n| n + rows.positions));
                face.thickness.push(self.shells.thickness[element]);
            }
        }
        let sides = BallSide { nodes: &meshed.surface, masses: &masses, areas: &meshed.areas };
        let contact = FaceContact::new(&sides, &face, friction, springs, &positions);
        // Both sides are polyhedra: bring them to touch.
        let gap = contact.clearance(&positions);
        if !gap.is_finite() {
            let allowed =
                "the face must be there: does the mesh lie at the face centre, its normals outwards?";
            return Err(FemError::input("point of first touch", "beside the face", allowed));
        }
        for row in &mut positions[..balls] {
            row.add(touch.normal * R::from_f64(-gap));
        }
        let mut structure = Structure::new(positions, masses, patches, contact.nodes());
        structure.translations = balls + count;
        structure.velocities = velocities;
        Ok(Impact {
            structure,
            contact: Box::new(contact),
            ball_nodes: balls,
            radius: meshed.radius,
            inertia: meshed.inertia,
            axes: axes.map(|v| Vec3::new(v.x.re(), v.y.re(), v.z.re())),
            head_velocity: touch.club_velocity,
            parts,
        })
    }

    /// Nodes in face axes about the CG, for the place of the face centre there.
    fn placed(&self, face_centre: Vec3<R>) -> Vec<Vec3<R>> {
        let axes = face_axes(self.loft);
        let along = |p: &Vec3<f64>| Vec3::from_f64(axes.map(|axis| p.dot(axis)));
        self.shells.nodes.iter().map(|p| along(p) + face_centre).collect()
    }
}

/// Refuses a head that moves away from the ball.
///
/// # Errors
/// [`FemError::Input`] with the speed of approach.
pub fn touch_check<R: Real>(touch: &FirstTouch<R>) -> Result<(), FemError> {
    let approach = touch.approach().re();
    if approach > 0.0 {
        return Ok(());
    }
    let allowed = "it must be above zero: the face moves away from the ball";
    Err(FemError::input("approach of face and ball", format!("{approach:.2} m/s"), allowed))
}
