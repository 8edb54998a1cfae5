//! Nodes of the ball against a rigid surface: penalty springs, and Coulomb friction that sticks.

use super::search_interval::SearchIntervals;
use super::{
    Contact, ContactEnergy, ContactMethod, NodeState, PenaltyContact, PenaltySprings, Penetration, Resultant,
};
use clubface_impact::first_touch::Motion;
use clubface_math::{Real, Row, Vec3};

/// A rigid surface, at rest or moving.
pub trait RigidSurface<R: Real>: Send {
    /// Signed distance of a point (m, positive outside) and outward unit normal.
    fn nearest(&self, point: Vec3<R>) -> (R, Vec3<R>);
    /// Velocity of the surface's material at a point, m/s.
    fn velocity(&self, point: Vec3<R>) -> Vec3<R>;
    /// Applies a force (N) at a point until the next [`RigidSurface::advance`].
    fn apply_force(&mut self, force: Vec3<R>, point: Vec3<R>);
    /// Moves on by `dt` seconds under the applied forces.
    fn advance(&mut self, dt: f64);
    /// Energy at the last step, J: kinetic, and that of its spring if it gives.
    fn energy(&self) -> f64;
    /// Velocity of the mass centre, m/s, and angular velocity, rad/s; the mean of a body that vibrates.
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
    fn apply_force(&mut self, _force: Vec3<R>, _point: Vec3<R>) {}
    fn advance(&mut self, _dt: f64) {}
    fn energy(&self) -> f64 {
        0.0
    }
    fn motion(&self) -> Motion<R> {
        Motion { velocity: Vec3::zero(), spin: Vec3::zero() }
    }
}

/// A node that may touch the surface: its mass, its part of the ball's surface, and the state of its contact.
struct Candidate<R> {
    mass: R,
    area: f64,
    state: NodeState<R>,
}

/// Contact of some nodes with a rigid surface.
pub struct RigidContact<R: Real, T> {
    /// The surface.
    pub surface: T,
    penalty: PenaltyContact<R>,
    nodes: Vec<u32>,
    candidates: Vec<Candidate<R>>,
    intervals: SearchIntervals,
    forces: Vec<Row<R>>,
}

impl<R: Real, T: RigidSurface<R>> RigidContact<R, T> {
    /// Contact of `nodes` with a coefficient of friction, given the masses of all nodes (kg) and the parts of the
    /// surface that belong to them (m2).
    pub fn new(surface: T, coefficient: R, nodes: Vec<u32>, masses: &[R], areas: &[f64]) -> Self {
        let candidate = |&n: &u32| {
            let (mass, area) = (masses[n as usize], areas[n as usize]);
            Candidate { mass, area, state: NodeState::free() }
        };
        let candidates: Vec<_> = nodes.iter().map(candidate).collect();
        Self {
            surface,
            penalty: PenaltyContact::new(coefficient, PenaltySprings::default()),
            forces: vec![Row::zero(); nodes.len()],
            nodes,
            intervals: SearchIntervals::new(candidates.len()),
            candidates,
        }
    }

    /// The same contact with other springs.
    #[must_use]
    pub fn with_springs(mut self, springs: PenaltySprings) -> Self {
        self.penalty.springs = springs;
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
    fn set_method(&mut self, method: ContactMethod) {
        self.penalty.springs.multiplier = method.multiplier();
    }
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64) {
        self.penalty.begin_step();
        for (index, candidate) in self.candidates.iter_mut().enumerate() {
            if !self.intervals.due(index) {
                continue;
            }
            let (node, force) = (self.nodes[index] as usize, &mut self.forces[index]);
            let x = positions[node].vec();
            let (gap, normal) = self.surface.nearest(x);
            let velocity = velocities[node].vec() - self.surface.velocity(x);
            if !self.penalty.touches(&candidate.state, candidate.mass, gap, normal, dt) {
                self.penalty.release(&mut candidate.state);
                *force = Row::zero();
                self.intervals.skip_gap(index, gap.re(), velocity.norm_squared().re(), dt);
                continue;
            }
            let penetration =
                Penetration { mass: candidate.mass, area: candidate.area, gap, normal, velocity };
            let total = penetration.force(&mut self.penalty, &mut candidate.state, dt);
            *force = Row::from_vec(total);
            self.surface.apply_force(-total, x);
        }
        self.surface.advance(dt);
        self.penalty.energy.bodies = self.surface.energy();
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn resultant(&self) -> Resultant<R> {
        self.penalty.resultant
    }
    fn energy(&self) -> ContactEnergy {
        self.penalty.energy
    }
    fn nearest(&self, _positions: &[Row<R>], point: Vec3<R>) -> (R, Vec3<R>) {
        self.surface.nearest(point)
    }
    fn head_motion(&self) -> Option<Motion<R>> {
        Some(self.surface.motion())
    }
}
