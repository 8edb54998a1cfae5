//! A ball that is hit by a deformable head.

use super::rigid_face::check_approach;
use crate::ball::BallConstruction;
use crate::contact::{BallSide, Contact, DeformableContact, FaceSide};
use crate::element::Kernels;
use crate::environment::Environment;
use crate::error::FemError;
use crate::head::{DeformableHead, face_axes};
use crate::solve::{Simulation, Structure, springs_for_stable_step};
use clubface_impact::first_touch::FirstTouch;
use clubface_math::{Mat3, Row, Vec3};

/// A ball at rest that is hit by the head of a shot, whose mass properties are those of this head; in face axes of
/// first touch with the origin at the head's CG.
///
/// # Errors
/// [`FemError::Input`] for a ball or a head that cannot be meshed, or a head that moves away from the ball.
pub fn ball_against_deformable_head<R: Kernels>(
    head: &dyn DeformableHead<R>,
    ball: &BallConstruction<R>,
    touch: &FirstTouch<R>,
    friction: R,
    environment: &Environment,
) -> Result<Simulation<R>, FemError> {
    deformable_head_in_steps(head, ball, touch, friction, None, environment)
}

/// The same, given the stable time step of the ball, s, if it is known.
///
/// # Errors
/// As [`ball_against_deformable_head`].
pub(crate) fn deformable_head_in_steps<R: Kernels>(
    head: &dyn DeformableHead<R>,
    ball: &BallConstruction<R>,
    touch: &FirstTouch<R>,
    friction: R,
    stable: Option<f64>,
    environment: &Environment,
) -> Result<Simulation<R>, FemError> {
    head.check()?;
    check_approach(touch)?;
    if touch.head.added.is_some() {
        let allowed = "a head of finite elements is free; leave the mesh out for a rigid head on its shaft";
        return Err(FemError::input("attachment", "a spatial inertia that is added to the head", allowed));
    }
    let (up, toe) = touch.tangents();
    let axes = [touch.normal, up, toe];
    let radius = R::from_f64(ball.radius());
    let meshed = ball.mesh(&Mat3::from_columns(axes[0], up, toe), touch.contact + touch.normal * radius)?;
    let (balls, count) = (meshed.masses.len(), head.nodes().len());
    let mut positions = meshed.positions();
    let mut masses = meshed.masses.clone();
    // The springs are those of the ball against a rigid face, though the head may need shorter steps.
    let (stable, mut patches) = if let Some(stable) = stable {
        (stable, meshed.patches)
    } else {
        let mut alone = Structure::new(positions.clone(), meshed.masses, meshed.patches, &[], environment);
        (alone.stable_step(40), alone.into_patches())
    };
    let springs = springs_for_stable_step(stable);
    let mut parts = meshed.parts;
    let frame = face_axes(head.loft());
    let along = |p: &Vec3<f64>| Vec3::from_f64(frame.map(|axis| p.dot(axis))) + touch.lever;
    let positioned: Vec<Vec3<R>> = head.nodes().iter().map(along).collect();
    let centre = touch.contact + touch.normal * radius;
    let mut velocities: Vec<_> =
        positions.iter().map(|p| Row::from_vec(touch.ball_spin.cross(p.vec() - centre))).collect();
    for &position in &positioned {
        positions.push(Row::from_vec(position));
        velocities.push(Row::from_vec(touch.club_velocity + touch.club_spin.cross(position)));
    }
    let of_head = head.masses();
    let turning = of_head.rotation.len();
    positions.resize(balls + count + turning, Row::zero());
    velocities.resize(balls + count + turning, Row::from_vec(touch.club_spin));
    masses.extend(&of_head.translation);
    masses.extend(&of_head.rotation);
    for (part, patch) in head.patches(&positioned, balls as u32) {
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
            let heights = head.nodes().iter().map(|node| node.dot(frame[1]));
            (grooves, std::iter::repeat_n(0.0, balls).chain(heights).collect())
        }),
    };
    if let Some(grooves) = head.grooves() {
        grooves.check(meshed.areas.iter().fold(0.0, |most: f64, area| most.max(area.sqrt())))?;
    }
    let sides = BallSide { nodes: &meshed.surface, masses: &masses, areas: &meshed.areas };
    let contact = DeformableContact::new(&sides, &face, friction, springs, &positions);
    // Both sides are polyhedra: bring them to touch.
    let gap = contact.clearance(&positions);
    if !gap.re().is_finite() {
        let allowed = "it must be on the face; the origin of the mesh must be the face centre, and normals must point outwards";
        return Err(FemError::input("point of first touch", "off the face", allowed));
    }
    for row in &mut positions[..balls] {
        row.add(touch.normal * -gap);
    }
    let mut structure = Structure::new(positions, masses, patches, contact.nodes(), environment);
    structure.translations = balls + count;
    structure.velocities = velocities;
    Ok(Simulation {
        structure,
        contact: Box::new(contact),
        ball_nodes: balls,
        radius: meshed.radius,
        inertia: meshed.inertia,
        axes: axes.map(|v| Vec3::new(v.x.re(), v.y.re(), v.z.re())),
        head_velocity: touch.club_velocity,
        parts,
        ball_stable_step: stable,
        clock: environment.clock,
    })
}
