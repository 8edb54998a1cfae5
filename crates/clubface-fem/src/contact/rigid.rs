//! Nodes of the ball against a rigid surface: penalty with Coulomb friction that sticks.

use super::rests::Rests;
use super::{Contact, ContactEnergy, Held, Method, Resultant, Springs, Touch};
use clubface_impact::first_touch::Motion;
use clubface_math::{Real, Row, Vec3};

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

/// A node that may touch: its mass, its share of the surface, what it remembers of its contact.
struct Candidate<R> {
    mass: R,
    area: f64,
    held: Held<R>,
}

/// Contact of some nodes with a rigid surface.
pub struct RigidContact<R, T> {
    /// The surface.
    pub surface: T,
    coefficient: R,
    springs: Springs,
    nodes: Vec<u32>,
    candidates: Vec<Candidate<R>>,
    rests: Rests,
    forces: Vec<Row<R>>,
    resultant: Resultant<R>,
    energy: ContactEnergy,
}

impl<R: Real, T: RigidSurface<R>> RigidContact<R, T> {
    /// Contact of `nodes`, given with their masses (kg) and shares of the surface (m2), under a coefficient of friction.
    pub fn new(surface: T, coefficient: R, nodes: Vec<u32>, masses: &[R], areas: &[f64]) -> Self {
        let candidates: Vec<_> = nodes
            .iter()
            .map(|&n| Candidate { mass: masses[n as usize], area: areas[n as usize], held: Held::free() })
            .collect();
        Self {
            surface,
            coefficient,
            springs: Springs::default(),
            forces: vec![Row::zero(); nodes.len()],
            nodes,
            rests: Rests::new(candidates.len()),
            candidates,
            resultant: Resultant::default(),
            energy: ContactEnergy::default(),
        }
    }

    /// With other springs.
    #[must_use]
    pub fn with_springs(mut self, springs: Springs) -> Self {
        self.springs = springs;
        self
    }
}

impl<R: Real, T: RigidSurface<R>> Contact<R> for RigidContact<R, T> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn area(&self, index: usize) -> f64 {
        self.candidates.get(index).map_or(0.0, |candidate| candidate.area)
    }
    fn keep_out(&mut self, method: Method) {
        self.springs.multiplier = method.multiplier();
    }
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64) {
        self.resultant = Resultant::default();
        self.energy.stored = 0.0;
        for (index, candidate) in self.candidates.iter_mut().enumerate() {
            if !self.rests.due(index) {
                continue;
            }
            let (node, force) = (self.nodes[index] as usize, &mut self.forces[index]);
            let x = positions[node].vec();
            let (gap, normal) = self.surface.nearest(x);
            let velocity = velocities[node].vec() - self.surface.velocity(x);
            if gap.re() >= 0.0 {
                candidate.held = Held::free();
                *force = Row::zero();
                self.rests.apart(index, gap.re(), velocity.norm_squared().re(), dt);
                continue;
            }
            let touch = Touch { mass: candidate.mass, area: candidate.area, gap, normal, velocity };
            let total = touch.force(
                self.springs,
                self.coefficient,
                &mut candidate.held,
                dt,
                &mut self.resultant,
                &mut self.energy,
            );
            *force = Row::from_vec(total);
            self.surface.push(-total, x);
        }
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
    fn nearest(&self, _positions: &[Row<R>], point: Vec3<R>) -> (R, Vec3<R>) {
        self.surface.nearest(point)
    }
    fn head(&self) -> Option<Motion<R>> {
        Some(self.surface.motion())
    }
}
