//! A ball met by a head that deforms.

use crate::ball::Ball;
use crate::contact::{BallSide, Contact, FaceContact, FaceSide, Grooves};
use crate::element::Patch;
use crate::environment::Environment;
use crate::error::FemError;
use crate::mesh::{mass_properties, MassProperties, ShellMasses};
use crate::solve::{springs_of, Impact, Structure};
use clubface_impact::first_touch::FirstTouch;
use clubface_math::{Mat3, Real, Row, Vec3};

/// A head made of elements. Axes: x towards the target, y up, z to the toe, as the club is soled; the origin is the face centre.
pub trait DeformableHead<R: Real> {
    /// Checks what no head can be made of.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first element, node or value that is not allowed.
    fn check(&self) -> Result<(), FemError>;
    /// Elevation of the face normal at the face centre, rad.
    fn loft(&self) -> f64;
    /// Places of the nodes, m.
    fn nodes(&self) -> &[Vec3<f64>];
    /// Masses of the nodes; no rotary inertias if nodes do not turn.
    fn masses(&self) -> ShellMasses<R>;
    /// Patches of elements with the names of their parts, for the places of the nodes at first touch. Node 0 is row `first` of the structure;
    /// rotations follow behind the places.
    fn patches(&self, placed: &[Vec3<R>], first: u32) -> Vec<(String, Box<dyn Patch<R>>)>;
    /// Quadrilaterals that the ball may touch, counterclockwise seen from outside, and the thickness of which half lies outside them.
    fn face(&self) -> (Vec<[u32; 4]>, Vec<R>);

    /// Grooves of the face.
    fn grooves(&self) -> Option<Grooves> {
        None
    }
    /// Checks that the face looks at the ball.
    ///
    /// # Errors
    /// [`FemError::Input`] where it looks away.
    fn check_face(&self) -> Result<(), FemError> {
        let nodes = self.nodes();
        let mut out = Vec3::zero();
        for quad in self.face().0 {
            let [a, b, c, d] = quad.map(|n| nodes[n as usize]);
            out += (c - a).cross(d - b);
        }
        if out.dot(face_axes(self.loft())[0]) > 0.5 * out.norm() {
            return Ok(());
        }
        let allowed = "it must look at the ball, within 60 degrees of the loft: corners go counterclockwise seen from outside, x is towards the target";
        Err(FemError::input("face", "looks away from the ball", allowed))
    }

    /// Mass, mass centre and inertia.
    fn mass_properties(&self) -> MassProperties {
        let masses: Vec<f64> = self.masses().translation.iter().map(|m| m.re()).collect();
        mass_properties(self.nodes(), &masses)
    }
}

/// Unit normal of a face of the given loft at its centre, the direction up the face, and that to the toe.
#[must_use]
pub fn face_axes(loft: f64) -> [Vec3<f64>; 3] {
    let (s, c) = loft.sin_cos();
    [Vec3::new(c, s, 0.0), Vec3::new(-s, c, 0.0), Vec3::new(0.0, 0.0, 1.0)]
}

/// A ball at rest, met by the head of a shot, whose mass properties are those of this head; in face axes of first touch with the origin at the
/// head's CG.
///
/// # Errors
/// [`FemError::Input`] for a ball or a head that cannot be meshed, or a head that moves away from the ball.
pub fn against_ball<R: Real>(
    head: &dyn DeformableHead<R>,
    ball: &Ball<R>,
    touch: &FirstTouch<R>,
    friction: R,
    environment: &Environment,
) -> Result<Impact<R>, FemError> {
    head.check()?;
    touch_check(touch)?;
    let (up, toe) = touch.tangents();
    let axes = [touch.normal, up, toe];
    let radius = R::from_f64(ball.radius());
    let meshed = ball.mesh(&Mat3::from_columns(axes[0], up, toe), touch.contact + touch.normal * radius)?;
    let (balls, count) = (meshed.masses.len(), head.nodes().len());
    let mut positions = meshed.positions();
    let mut masses = meshed.masses.clone();
    // The springs are those of the ball against a rigid face, though the head may need shorter steps.
    let mut alone = Structure::new(positions.clone(), meshed.masses, meshed.patches, &[], environment);
    let limit = alone.stable_step(40);
    let springs = springs_of(limit);
    let (mut patches, mut parts) = (alone.into_patches(), meshed.parts);
    let frame = face_axes(head.loft());
    let along = |p: &Vec3<f64>| Vec3::from_f64(frame.map(|axis| p.dot(axis))) + touch.lever;
    let placed: Vec<Vec3<R>> = head.nodes().iter().map(along).collect();
    let mut velocities = vec![Row::zero(); balls];
    for &place in &placed {
        positions.push(Row::from_vec(place));
        velocities.push(Row::from_vec(touch.club_velocity + touch.club_spin.cross(place)));
    }
    let of_head = head.masses();
    let turning = of_head.rotation.len();
    positions.resize(balls + count + turning, Row::zero());
    velocities.resize(balls + count + turning, Row::from_vec(touch.club_spin));
    masses.extend(&of_head.translation);
    masses.extend(&of_head.rotation);
    for (part, patch) in head.patches(&placed, balls as u32) {
        patches.push(patch);
        parts.push(part);
    }
    let (quads, thickness) = head.face();
    let face = FaceSide {
        quads: quads.into_iter().map(|quad| quad.map(|n| n + balls as u32)).collect(),
        thickness,
        rotations: (turning > 0).then_some(count as u32),
        masses: &masses,
        grooves: head.grooves().map(|grooves| {
            let heights = head.nodes().iter().map(|place| place.dot(frame[1]));
            (grooves, std::iter::repeat_n(0.0, balls).chain(heights).collect())
        }),
    };
    if let Some(grooves) = head.grooves() {
        grooves.check(meshed.areas.iter().fold(0.0, |most: f64, area| most.max(area.sqrt())))?;
    }
    let sides = BallSide { nodes: &meshed.surface, masses: &masses, areas: &meshed.areas };
    let contact = FaceContact::new(&sides, &face, friction, springs, &positions);
    // Both sides are polyhedra: bring them to touch.
    let gap = contact.clearance(&positions);
    if !gap.re().is_finite() {
        let allowed = "the face must be there: does the mesh lie at the face centre, its normals outwards?";
        return Err(FemError::input("point of first touch", "beside the face", allowed));
    }
    for row in &mut positions[..balls] {
        row.add(touch.normal * -gap);
    }
    let mut structure = Structure::new(positions, masses, patches, contact.nodes(), environment);
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
        ball_limit: limit,
        clock: environment.clock,
    })
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
