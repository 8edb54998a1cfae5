//! Cases: a ball and what it meets.

use crate::ball::Ball;
use crate::contact::{Plane, RigidContact, RigidHead, RigidSurface};
use crate::environment::Environment;
use crate::error::FemError;
use crate::head::touch_check;
use crate::solve::{springs_of, Impact, Structure};
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
    environment: &Environment,
) -> Result<Impact<R>, FemError> {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from_f64);
    let mut impact = against_rigid(ball, Plane, axes, Vec3::zero(), friction, environment)?;
    let (sine, cosine) = angle.sin_cos();
    impact.structure.velocities.fill(Row::from_vec(Vec3::new(-(speed * cosine), speed * sine, R::zero())));
    Ok(impact)
}

/// A ball at rest, met by a rigid head, in face axes of first touch with the origin at the head's CG.
///
/// # Errors
/// [`FemError::Input`] for a ball that cannot be meshed, or a head that moves away from it.
pub fn against_head<R: Real>(
    ball: &Ball<R>,
    touch: &FirstTouch<R>,
    friction: R,
    environment: &Environment,
) -> Result<Impact<R>, FemError> {
    touch_check(touch)?;
    let (up, toe) = touch.tangents();
    let axes = [touch.normal, up, toe];
    let mut impact = against_rigid(ball, RigidHead::new(touch), axes, touch.contact, friction, environment)?;
    impact.head_velocity = touch.club_velocity;
    Ok(impact)
}

/// A ball at rest that touches a rigid surface at a point with the given normal, up and toe directions.
fn against_rigid<R: Real, T: RigidSurface<R> + 'static>(
    ball: &Ball<R>,
    surface: T,
    axes: [Vec3<R>; 3],
    point: Vec3<R>,
    friction: R,
    environment: &Environment,
) -> Result<Impact<R>, FemError> {
    let [normal, up, toe] = axes;
    // A ball without pieces is refused by `mesh`.
    let radius = ball.pieces.last().map_or_else(R::zero, |piece| piece.radius);
    let meshed = ball.mesh(&Mat3::from_columns(normal, up, toe), point + normal * radius)?;
    let (radius, inertia, parts) = (meshed.radius, meshed.inertia, meshed.parts.clone());
    let contact = RigidContact::new(surface, friction, meshed.surface.clone(), &meshed.masses, &meshed.areas);
    let mut structure =
        Structure::new(meshed.positions(), meshed.masses, meshed.patches, &meshed.surface, environment);
    let limit = structure.stable_step(40);
    Ok(Impact {
        ball_nodes: structure.positions.len(),
        structure,
        contact: Box::new(contact.with_springs(springs_of(limit))),
        radius,
        inertia,
        axes: axes.map(|v| Vec3::new(v.x.re(), v.y.re(), v.z.re())),
        head_velocity: Vec3::zero(),
        parts,
        ball_limit: limit,
        clock: environment.clock,
    })
}
