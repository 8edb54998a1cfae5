//! A ball against a rigid face.

use crate::ball::BallConstruction;
use crate::contact::{Plane, RigidContact, RigidHead, RigidSurface};
use crate::element::Kernels;
use crate::environment::Environment;
use crate::error::FemError;
use crate::solve::{Simulation, Structure, springs_for_stable_step};
use clubface_impact::first_touch::FirstTouch;
use clubface_math::{Mat3, Real, Row, Vec3};

/// A ball thrown at a rigid plane, at `speed` (m/s) and `angle` (rad) from the normal, up the plane.
///
/// # Errors
/// [`FemError::Input`] for a ball that cannot be meshed.
pub fn ball_against_plane<R: Kernels>(
    ball: &BallConstruction<R>,
    speed: R,
    angle: R,
    friction: R,
    environment: &Environment,
) -> Result<Simulation<R>, FemError> {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from_f64);
    let mut simulation = against_rigid(ball, Plane, axes, Vec3::zero(), friction, None, environment)?;
    let (sine, cosine) = angle.sin_cos();
    simulation.structure.velocities.fill(Row::from_vec(Vec3::new(
        -(speed * cosine),
        speed * sine,
        R::zero(),
    )));
    Ok(simulation)
}

/// A ball that flies nowhere, but may spin, hit by a rigid head, in face axes of first touch with the origin at the head's CG.
///
/// # Errors
/// [`FemError::Input`] for a ball that cannot be meshed, or a head that moves away from it.
pub fn ball_against_rigid_head<R: Kernels>(
    ball: &BallConstruction<R>,
    touch: &FirstTouch<R>,
    friction: R,
    environment: &Environment,
) -> Result<Simulation<R>, FemError> {
    rigid_head_in_steps(ball, touch, friction, None, environment)
}

/// The same, given the stable time step of the ball, s, if it is known.
///
/// # Errors
/// As [`ball_against_rigid_head`].
pub(crate) fn rigid_head_in_steps<R: Kernels>(
    ball: &BallConstruction<R>,
    touch: &FirstTouch<R>,
    friction: R,
    stable: Option<f64>,
    environment: &Environment,
) -> Result<Simulation<R>, FemError> {
    check_approach(touch)?;
    let (up, toe) = touch.tangents();
    let axes = [touch.normal, up, toe];
    let mut simulation =
        against_rigid(ball, RigidHead::new(touch), axes, touch.contact, friction, stable, environment)?;
    simulation.head_velocity = touch.club_velocity;
    let centre = touch.contact + touch.normal * R::from_f64(simulation.radius);
    let structure = &mut simulation.structure;
    for (velocity, position) in structure.velocities.iter_mut().zip(&structure.positions) {
        *velocity = Row::from_vec(touch.ball_spin.cross(position.vec() - centre));
    }
    Ok(simulation)
}

/// A ball at rest that touches a rigid surface at a point with the given normal, up and toe directions.
fn against_rigid<R: Kernels, T: RigidSurface<R> + 'static>(
    ball: &BallConstruction<R>,
    surface: T,
    axes: [Vec3<R>; 3],
    point: Vec3<R>,
    friction: R,
    stable: Option<f64>,
    environment: &Environment,
) -> Result<Simulation<R>, FemError> {
    let [normal, up, toe] = axes;
    // A ball without pieces is refused by `mesh`.
    let radius = ball.pieces.last().map_or_else(R::zero, |piece| piece.radius);
    let meshed = ball.mesh(&Mat3::from_columns(normal, up, toe), point + normal * radius)?;
    let (radius, inertia, parts) = (meshed.radius, meshed.inertia, meshed.parts.clone());
    let contact = RigidContact::new(surface, friction, meshed.surface.clone(), &meshed.masses, &meshed.areas);
    let mut structure =
        Structure::new(meshed.positions(), meshed.masses, meshed.patches, &meshed.surface, environment);
    let stable = stable.unwrap_or_else(|| structure.stable_step(40));
    Ok(Simulation {
        ball_nodes: structure.positions.len(),
        structure,
        contact: Box::new(contact.with_springs(springs_for_stable_step(stable))),
        radius,
        inertia,
        axes: axes.map(|v| Vec3::new(v.x.re(), v.y.re(), v.z.re())),
        head_velocity: Vec3::zero(),
        parts,
        ball_stable_step: stable,
        clock: environment.clock,
    })
}

/// Refuses a head that moves away from the ball.
///
/// # Errors
/// [`FemError::Input`] with the speed of approach.
pub(super) fn check_approach<R: Real>(touch: &FirstTouch<R>) -> Result<(), FemError> {
    let approach = touch.approach().re();
    if approach > 0.0 {
        return Ok(());
    }
    let allowed = "it must be above 0, but the face moves away from the ball";
    Err(FemError::input("speed of approach", format!("{approach:.2} m/s"), allowed))
}
