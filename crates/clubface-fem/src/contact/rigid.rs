//! Nodes of the ball against a rigid surface: penalty with Coulomb friction that sticks.

use super::{Contact, ContactEnergy, Resultant};
use clubface_impact::first_touch::Motion;
use clubface_math::{Real, Row, Vec3};

/// Penalty stiffness over node mass over the square of the time step. A node of stiffness `k` and mass `m` alone is stable up to 4; this much is about
/// the stiffness with which the surface elements hold their nodes. A stiffer spring lets every ring of nodes that arrives
/// ring the force (peak 5% higher at 0.25), a softer one delays the contact (reversal of the tangential force 2% later at 0.05).
pub const NORMAL_STIFFNESS: f64 = 0.1;
/// Damping of a node on its normal spring, over critical damping: nodes that arrive one ring after the other at full speed would ring, and the
/// force with them.
pub const DAMPING: f64 = 0.4;
/// Tangential stiffness over normal stiffness.
pub const TANGENTIAL_STIFFNESS: f64 = 0.5;

/// A rigid surface, at rest or moving.
pub trait RigidSurface<R: Real>: Send {
    /// Signed distance of a point (m, positive outside) and outward unit normal.
    fn nearest(&self, point: Vec3<R>) -> (R, Vec3<R>);
    /// Velocity of the surface's material at a point, m/s.
    fn velocity(&self, point: Vec3<R>) -> Vec3<R>;
    /// Takes up a force (N) at a point.
    fn push(&mut self, force: Vec3<R>, point: Vec3<R>);
    /// Moves on by `dt` seconds under the forces taken up.
    fn advance(&mut self, dt: f64);
    /// Kinetic energy, J.
    fn kinetic_energy(&self) -> f64;
    /// Velocity of the mass centre, m/s, and angular velocity, rad/s.
    fn motion(&self) -> Motion<R>;
}

/// A plane that does not move: through the origin with normal +x.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plane;

impl<R: Real> RigidSurface<R> for Plane {
    fn nearest(&self, point: Vec3<R>) -> (R, Vec3<R>) {
        (point.x, Vec3::new(R::one(), R::zero(), R::zero()))
    }
    fn velocity(&self, _point: Vec3<R>) -> Vec3<R> {
        Vec3::zero()
    }
    fn push(&mut self, _force: Vec3<R>, _point: Vec3<R>) {}
    fn advance(&mut self, _dt: f64) {}
    fn kinetic_energy(&self) -> f64 {
        0.0
    }
    fn motion(&self) -> Motion<R> {
        Motion { velocity: Vec3::zero(), spin: Vec3::zero() }
    }
}

/// A node that may touch: its mass, its share of the surface, the friction force on it.
struct Candidate<R> {
    mass: R,
    area: f64,
    friction: Vec3<R>,
}

/// Contact of some nodes with a rigid surface.
pub struct RigidContact<R, T> {
    /// The surface.
    pub surface: T,
    coefficient: R,
    /// Stiffness and damping of the normal springs, in the units of [`NORMAL_STIFFNESS`] and [`DAMPING`].
    springs: (f64, f64),
    nodes: Vec<u32>,
    candidates: Vec<Candidate<R>>,
    forces: Vec<Row<R>>,
    resultant: Resultant<R>,
    energy: ContactEnergy,
}

impl<R: Real, T: RigidSurface<R>> RigidContact<R, T> {
    /// Contact of `nodes`, given with their masses (kg) and shares of the surface (m2), under a coefficient of friction.
    pub fn new(surface: T, coefficient: R, nodes: Vec<u32>, masses: &[R], areas: &[f64]) -> Self {
        let candidates = nodes
            .iter()
            .map(|&n| Candidate { mass: masses[n as usize], area: areas[n as usize], friction: Vec3::zero() })
            .collect();
        Self {
            surface,
            coefficient,
            springs: (NORMAL_STIFFNESS, DAMPING),
            forces: vec![Row::zero(); nodes.len()],
            nodes,
            candidates,
            resultant: Resultant { force: Vec3::zero(), normal: R::zero(), area: 0.0 },
            energy: ContactEnergy::default(),
        }
    }
}

impl<R: Real, T: RigidSurface<R>> RigidContact<R, T> {
    /// With normal springs of other stiffness and damping, in the units of [`NORMAL_STIFFNESS`] and [`DAMPING`].
    #[must_use]
    pub fn with_springs(mut self, stiffness: f64, damping: f64) -> Self {
        self.springs = (stiffness, damping);
        self
    }
}

impl<R: Real, T: RigidSurface<R>> Contact<R> for RigidContact<R, T> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64) {
        let mut sum = Resultant { force: Vec3::zero(), normal: R::zero(), area: 0.0 };
        let mut stored = 0.0;
        for ((&node, candidate), force) in self.nodes.iter().zip(&mut self.candidates).zip(&mut self.forces) {
            let x = positions[node as usize].vec();
            let (gap, normal) = self.surface.nearest(x);
            if gap.re() >= 0.0 {
                if candidate.friction.x.re() != 0.0 || candidate.friction.y.re() != 0.0 {
                    candidate.friction = Vec3::zero();
                }
                *force = Row::zero();
                continue;
            }
            let stiffness = candidate.mass * (self.springs.0 / (dt * dt));
            let relative = velocities[node as usize].vec() - self.surface.velocity(x);
            let closing = -normal.dot(relative);
            let spring = -(stiffness * gap);
            let damper = closing * candidate.mass * (2.0 * self.springs.1 * self.springs.0.sqrt() / dt);
            let pressing = (spring + damper).max(R::zero());
            self.energy.damping += ((pressing - spring) * closing).re() * dt;
            let tangential = stiffness * TANGENTIAL_STIFFNESS;
            // Stick: the spring follows the node; slip: it is let out until it carries what friction allows.
            let sliding = relative.reject(normal);
            let trial = candidate.friction.reject(normal) - sliding * (tangential * dt);
            let most = self.coefficient * pressing;
            let size = trial.norm();
            let mut friction = trial;
            if size.re() > most.re() {
                friction = trial * (most / size);
                self.energy.friction += (most * (size - most) / tangential).re();
            }
            candidate.friction = friction;
            let total = normal * pressing + friction;
            *force = Row::from_vec(total);
            self.surface.push(-total, x);
            sum.force += total;
            sum.normal += pressing;
            sum.area += candidate.area;
            stored += 0.5 * (spring * spring / stiffness + friction.norm_squared() / tangential).re();
        }
        self.resultant = sum;
        self.energy.stored = stored;
        self.surface.advance(dt);
        self.energy.bodies = self.surface.kinetic_energy();
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn resultant(&self) -> Resultant<R> {
        self.resultant
    }
    fn energy(&self) -> ContactEnergy {
        self.energy
    }
    fn nearest(&self, point: Vec3<R>) -> (R, Vec3<R>) {
        self.surface.nearest(point)
    }
    fn head(&self) -> Option<Motion<R>> {
        Some(self.surface.motion())
    }
}
