//! Cases: a ball and what it meets.

use crate::ball::Ball;
use crate::contact::{Plane, RigidContact, RigidHead};
use crate::error::FemError;
use crate::solve::{Impact, Structure};
use clubface_impact::first_touch::FirstTouch;
use clubface_math::{Mat3, Real, Row, Vec3};

/// A ball thrown at a rigid plane, at `speed` (m/s) and `angle` (rad) from the normal, up the plane.
///
/// # Errors
/// [`FemError::Input`] for a ball that cannot be meshed.
pub fn against_plane<R: Real>(
    ball: &Ball<R>,
    speed: R,
    angle: R,
    friction: R,
) -> Result<Impact<R>, FemError> {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from_f64);
    let meshed = ball.mesh(&Mat3::diagonal(R::one()), Vec3::new(radius(ball), R::zero(), R::zero()))?;
    let contact = RigidContact::new(Plane, friction, meshed.surface.clone(), &meshed.masses, &meshed.areas);
    let (radius, inertia, parts) = (meshed.radius, meshed.inertia, meshed.parts.clone());
    let mut structure = Structure::new(meshed.positions(), meshed.masses, meshed.patches, &meshed.surface);
    let (sine, cosine) = angle.sin_cos();
    structure.velocities.fill(Row::from_vec(Vec3::new(-(speed * cosine), speed * sine, R::zero())));
    Ok(Impact {
        ball_nodes: structure.positions.len(),
        structure,
        contact: Box::new(contact),
        radius,
        inertia,
        axes,
        head_velocity: Vec3::zero(),
        parts,
    })
}

/// A ball at rest, met by a rigid head, in face axes of first touch with the origin at the head's CG.
///
/// # Errors
/// [`FemError::Input`] for a ball that cannot be meshed, or a head that moves away from it.
pub fn against_head<R: Real>(
    ball: &Ball<R>,
    touch: &FirstTouch<R>,
    friction: R,
) -> Result<Impact<R>, FemError> {
    if touch.approach().re() <= 0.0 {
        let value = format!("{:.2} m/s", touch.approach().re());
        return Err(FemError::input(
            "approach of face and ball",
            value,
            "it must be above zero: the face moves away from the ball",
        ));
    }
    let primal = |v: Vec3<R>| Vec3::new(v.x.re(), v.y.re(), v.z.re());
    let (up, toe) = touch.tangents();
    let centre = touch.contact + touch.normal * radius(ball);
    let meshed = ball.mesh(&Mat3::from_columns(touch.normal, up, toe), centre)?;
    let head = RigidHead::new(touch);
    let contact = RigidContact::new(head, friction, meshed.surface.clone(), &meshed.masses, &meshed.areas);
    let (radius, inertia, parts) = (meshed.radius, meshed.inertia, meshed.parts.clone());
    let structure = Structure::new(meshed.positions(), meshed.masses, meshed.patches, &meshed.surface);
    Ok(Impact {
        ball_nodes: structure.positions.len(),
        structure,
        contact: Box::new(contact),
        radius,
        inertia,
        axes: [touch.normal, up, toe].map(primal),
        head_velocity: touch.club_velocity,
        parts,
    })
}

/// Outer radius of a ball that is not empty, m.
fn radius<R: Real>(ball: &Ball<R>) -> R {
    ball.pieces.last().map_or_else(R::zero, |piece| piece.radius)
}
