//! The contact law of one node: a damped penalty spring along the normal and Coulomb friction that sticks; optionally a
//! Lagrange multiplier that takes the load over from the springs.

use super::{ContactEnergy, Resultant};
use crate::error::FemError;
use clubface_math::{Real, Vec3};

/// How contact springs follow from a node's mass and the time step.
#[derive(Clone, Copy, Debug)]
pub struct PenaltySprings {
    /// Stiffness over mass over the square of the time step. A node of stiffness `k` and mass `m` alone is stable up to
    /// 4.
    pub stiffness: f64,
    /// Damping over critical damping. Without damping, nodes that arrive at full speed, one circle after the other,
    /// would oscillate, and the force with them.
    pub damping: f64,
    /// The time step to which they refer, s; without one, that of the run.
    pub step: Option<f64>,
    /// Time in which a multiplier takes over the load, s (augmented Lagrangian method); none for springs alone.
    pub multiplier: Option<f64>,
}

impl Default for PenaltySprings {
    /// About the stiffness with which the surface elements hold their nodes. With a stiffer spring the force oscillates
    /// with every circle of nodes that arrives (peak of the reference case 3% higher at 0.25); a softer one delays the
    /// contact (at 0.05 its tangential force reverses 3% later, and the peak is 3% lower). Half or twice the damping
    /// changes the peak by 0.3%.
    fn default() -> Self {
        Self { stiffness: 0.127, damping: 0.4, step: None, multiplier: None }
    }
}

impl PenaltySprings {
    /// Stiffness of the normal spring of a node, N/m, in steps of `dt` seconds.
    #[inline(always)]
    fn normal<R: Real>(&self, mass: R, dt: f64) -> R {
        let reference = self.step.unwrap_or(dt);
        mass * (self.stiffness / (reference * reference))
    }
}

/// Time in which a multiplier lets go where it presses on a node in front of the surface, s: a load that falls is then
/// followed to a fraction of a micrometre, and next to no energy comes from a multiplier that lags.
const RELEASE_TIME: f64 = 10e-6;

/// Tangential stiffness over normal stiffness.
pub const TANGENTIAL_STIFFNESS: f64 = 0.5;

/// How nodes are kept out of the other side of the contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ContactMethod {
    /// Damped springs alone: nodes penetrate until the springs carry the load.
    #[default]
    Penalty,
    /// Damped springs and, for every node, a multiplier that takes the load over from them, so that nodes come out
    /// again.
    AugmentedLagrange,
}

impl ContactMethod {
    /// Time in which multipliers take over, s. With 200 us the springs hold four times the energy, which multipliers
    /// then give back; with 20 us the force of the reference case oscillates as nodes arrive (peak 5% higher), and with
    /// 5 us its energy balance is off.
    const TIME_CONSTANT: f64 = 50e-6;

    /// Its name in files and options.
    pub fn name(self) -> &'static str {
        match self {
            Self::Penalty => "penalty",
            Self::AugmentedLagrange => "augmented-lagrange",
        }
    }
    /// The inverse of [`ContactMethod::name`].
    ///
    /// # Errors
    /// [`FemError::Input`] for an unknown name.
    pub fn from_name(name: &str) -> Result<Self, FemError> {
        let known = [Self::Penalty, Self::AugmentedLagrange];
        known
            .into_iter()
            .find(|method| method.name() == name)
            .ok_or_else(|| FemError::unknown("contact", name, known.map(Self::name)))
    }
    /// Time in which multipliers take over, s, if there are any.
    #[must_use]
    pub fn multiplier(self) -> Option<f64> {
        (self == Self::AugmentedLagrange).then_some(Self::TIME_CONSTANT)
    }
}

/// What a contact by penalty springs has but for its nodes.
#[derive(Clone, Copy, Debug)]
pub struct PenaltyContact<R> {
    /// Coefficient of friction.
    pub coefficient: R,
    /// Springs.
    pub springs: PenaltySprings,
    /// Sum of the forces of the current step.
    pub resultant: Resultant<R>,
    /// Energies.
    pub energy: ContactEnergy,
}

impl<R: Real> PenaltyContact<R> {
    /// Before the first step.
    pub fn new(coefficient: R, springs: PenaltySprings) -> Self {
        Self { coefficient, springs, resultant: Resultant::default(), energy: ContactEnergy::default() }
    }
    /// Begins another step.
    pub fn begin_step(&mut self) {
        self.resultant = Resultant::default();
        self.energy.stored = 0.0;
    }
    /// Whether a node of mass `mass` (kg) touches at a gap (m): behind the surface always, in front of it as long as
    /// its multiplier presses harder than its stretched spring pulls. A node whose multiplier were dropped at the
    /// surface would lose its whole load at once, and a circle of them, which come out together, a part of the contact
    /// force.
    #[inline(always)]
    pub fn touches(&self, state: &NodeState<R>, mass: R, gap: R, normal: Vec3<R>, dt: f64) -> bool {
        if gap.re() < 0.0 || self.springs.multiplier.is_none() {
            return gap.re() < 0.0;
        }
        state.multiplier.dot(normal).re() > (self.springs.normal(mass, dt) * gap).re()
    }
    /// Takes a node out of contact; what its springs still hold becomes heat.
    #[inline(always)]
    pub fn release(&mut self, state: &mut NodeState<R>) {
        self.energy.damping += state.stored;
        *state = NodeState::free();
    }
}

/// State of the contact of one node.
#[derive(Clone, Copy, Debug)]
pub struct NodeState<R> {
    /// Force of the tangential spring, N.
    spring: Vec3<R>,
    /// The multiplier: the part of the load that it carries, N.
    multiplier: Vec3<R>,
    /// Force of the last step, N, and velocity before it, m/s; none in the first step.
    last: Option<(Vec3<R>, Vec3<R>)>,
    /// Energy in its springs after the last step, J; kept where there is a multiplier, under which springs need not be
    /// relaxed when the node leaves.
    stored: f64,
}

impl<R: Real> NodeState<R> {
    /// Not in contact.
    #[must_use]
    pub fn free() -> Self {
        Self { spring: Vec3::zero(), multiplier: Vec3::zero(), last: None, stored: 0.0 }
    }
    /// Whether it was in contact in the last step.
    #[must_use]
    pub fn in_contact(&self) -> bool {
        self.last.is_some()
    }
}

/// A node that touches the surface of the other side.
pub struct Penetration<R> {
    /// Mass that the spring moves, kg.
    pub mass: R,
    /// Part of the surface that belongs to the node, m2.
    pub area: f64,
    /// Distance from the other side, m; negative, but for nodes that a multiplier presses on.
    pub gap: R,
    /// Normal of the other side.
    pub normal: Vec3<R>,
    /// Velocity relative to the other side, m/s.
    pub velocity: Vec3<R>,
}

impl<R: Real> Penetration<R> {
    /// Force on the node, N. Adds to the sum and to the energies, and updates the state of the node.
    #[inline(always)]
    pub fn force(&self, contact: &mut PenaltyContact<R>, state: &mut NodeState<R>, dt: f64) -> Vec3<R> {
        let PenaltyContact { coefficient, springs, resultant: sum, energy } = contact;
        let reference = springs.step.unwrap_or(dt);
        let stiffness = springs.normal(self.mass, dt);
        let closing = -self.normal.dot(self.velocity);
        let spring = -(stiffness * self.gap);
        let damper = closing * self.mass * (2.0 * springs.damping * springs.stiffness.sqrt() / reference);
        if let Some(time) = springs.multiplier {
            let time = if self.gap.re() > 0.0 { RELEASE_TIME.min(time) } else { time };
            self.update_multiplier(dt / time, state, dt);
        }
        let carried = state.multiplier.dot(self.normal).max(R::zero());
        let load = spring + carried;
        // The damper is limited by the load: acting at once, it would make the launch jump where a node arrives one
        // step sooner.
        let pressing = (load + damper.min(load)).max(R::zero());
        energy.damping += ((pressing - spring) * closing).re() * dt;
        // Stick: the spring follows the node. Slip: it is shortened until it carries what friction allows.
        let tangential = stiffness * TANGENTIAL_STIFFNESS;
        let carried = state.multiplier.reject(self.normal);
        let trial = (state.spring - self.velocity * (tangential * dt)).reject(self.normal) + carried;
        let most = *coefficient * pressing;
        let size = trial.norm();
        let (mut friction, mut heat) = (trial, 0.0);
        if size.re() > most.re() {
            friction = trial * (most / size);
            heat = (most * (size - most) / tangential).re();
        }
        let before = state.spring.norm_squared();
        state.spring = friction - carried;
        let stored = 0.5 * (spring * spring / stiffness + state.spring.norm_squared() / tangential).re();
        energy.stored += stored;
        let force = self.normal * pressing + friction;
        if springs.multiplier.is_some() {
            // The work of the multiplier counts as heat, too, whatever its sign: it comes and goes with the load.
            let gained = (state.spring.norm_squared() - before) / (tangential * 2.0);
            heat = -(friction.dot(self.velocity) * dt + gained).re();
            state.last = Some((force, self.velocity));
            state.stored = stored;
        }
        energy.friction += heat;
        sum.force += force;
        sum.normal += pressing;
        if pressing.re() > 0.0 {
            sum.area += self.area;
        }
        force
    }

    /// Moves a fraction of the load that the multiplier does not carry yet on to it: the load of the last step, from
    /// the acceleration of the node under it.
    #[inline(always)]
    fn update_multiplier(&self, fraction: f64, state: &mut NodeState<R>, dt: f64) {
        if let Some((force, velocity)) = state.last {
            let opposed = force - (self.velocity - velocity) * (self.mass * (1.0 / dt));
            state.multiplier += (opposed - state.multiplier) * R::from_f64(fraction);
        }
    }
}
