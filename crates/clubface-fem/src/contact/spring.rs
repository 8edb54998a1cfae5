//! The contact law of one node: a damped penalty spring along the normal, and Coulomb friction that sticks; if asked for, a multiplier that takes
//! the load over from the springs.

use super::{ContactEnergy, Resultant};
use crate::error::FemError;
use clubface_math::{Real, Vec3};

/// How contact springs follow from a node's mass and the time step.
#[derive(Clone, Copy, Debug)]
pub struct Springs {
    /// Stiffness over mass over the square of the time step. A node of stiffness `k` and mass `m` alone is stable up to 4.
    pub stiffness: f64,
    /// Damping over critical damping: nodes that arrive one ring after the other at full speed would ring, and the force with them.
    pub damping: f64,
    /// The time step they refer to, s; if there is none, that of the run.
    pub step: Option<f64>,
    /// Time in which a multiplier takes the load over, s (augmented Lagrange method); none for springs alone.
    pub multiplier: Option<f64>,
}

impl Default for Springs {
    /// About the stiffness with which the surface elements hold their nodes. A stiffer spring lets every ring of nodes that arrives ring the
    /// force (peak of the reference case 3% higher at 0.25), a softer one delays the contact (at 0.05 its tangential force turns 3% later, and the peak
    /// is 3% lower). Half or twice the damping changes the peak by 0.3%.
    fn default() -> Self {
        Self { stiffness: 0.127, damping: 0.4, step: None, multiplier: None }
    }
}

/// Tangential stiffness over normal stiffness.
pub const TANGENTIAL_STIFFNESS: f64 = 0.5;

/// How nodes are kept out of the other side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Damped springs: nodes sink in until these carry the load.
    #[default]
    Penalty,
    /// Damped springs, and a multiplier a node that takes the load over from them, so that nodes come out again.
    AugmentedLagrange,
}

impl Method {
    /// Time in which multipliers take over, s: a third of a contact. In 60 us the force of the reference case rings as nodes arrive (peak
    /// 8% higher), and in 30 us its energies no longer close.
    const TAKE_OVER: f64 = 200e-6;

    /// As written in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Penalty => "penalty",
            Self::AugmentedLagrange => "augmented-lagrange",
        }
    }
    /// The inverse of [`Method::name`].
    ///
    /// # Errors
    /// [`FemError::Input`] for an unknown name.
    pub fn from_name(name: &str) -> Result<Self, FemError> {
        let known = [Self::Penalty, Self::AugmentedLagrange];
        known.into_iter().find(|method| method.name() == name).ok_or_else(|| {
            FemError::input("contact", name, format!("known are {}", known.map(Self::name).join(", ")))
        })
    }
    /// Time in which multipliers take over, s, if there are any.
    #[must_use]
    pub fn multiplier(self) -> Option<f64> {
        (self == Self::AugmentedLagrange).then_some(Self::TAKE_OVER)
    }
}

/// What a node in contact remembers.
#[derive(Clone, Copy, Debug)]
pub struct Held<R> {
    /// Force of the tangential spring, N.
    spring: Vec3<R>,
    /// The multiplier: what of its load the node is held against, N.
    multiplier: Vec3<R>,
    /// Force of the last step, N, and velocity before it, m/s; none in the first step.
    last: Option<(Vec3<R>, Vec3<R>)>,
}

impl<R: Real> Held<R> {
    /// Not in contact.
    #[must_use]
    pub fn free() -> Self {
        Self { spring: Vec3::zero(), multiplier: Vec3::zero(), last: None }
    }
    /// Whether it was in contact in the last step.
    #[must_use]
    pub fn touches(&self) -> bool {
        self.last.is_some()
    }
}

/// A node below the surface of the other side.
pub struct Touch<R> {
    /// Mass that the spring moves, kg.
    pub mass: R,
    /// Share of the node in its surface, m2.
    pub area: f64,
    /// Distance from the other side, m: below zero.
    pub gap: R,
    /// Normal of the other side.
    pub normal: Vec3<R>,
    /// Velocity relative to the other side, m/s.
    pub velocity: Vec3<R>,
}

impl<R: Real> Touch<R> {
    /// Force on the node, N; adds to the sum and to the energies, and renews what the node remembers.
    #[inline(always)]
    pub fn force(
        &self,
        springs: Springs,
        coefficient: R,
        held: &mut Held<R>,
        dt: f64,
        sum: &mut Resultant<R>,
        energy: &mut ContactEnergy,
    ) -> Vec3<R> {
        let reference = springs.step.unwrap_or(dt);
        let stiffness = self.mass * (springs.stiffness / (reference * reference));
        let closing = -self.normal.dot(self.velocity);
        let spring = -(stiffness * self.gap);
        let damper = closing * self.mass * (2.0 * springs.damping * springs.stiffness.sqrt() / reference);
        if let Some(time) = springs.multiplier {
            self.take_over(dt / time, held, dt);
        }
        let carried = held.multiplier.dot(self.normal).max(R::zero());
        let bearing = spring + carried;
        // A damper of no more than what bears: one that acted at once would make the launch jump where a node arrives a step sooner.
        let pressing = (bearing + damper.min(bearing)).max(R::zero());
        energy.damping += ((pressing - spring) * closing).re() * dt;
        // Stick: the spring follows the node; slip: it is let out until it carries what friction allows.
        let tangential = stiffness * TANGENTIAL_STIFFNESS;
        let carried = held.multiplier.reject(self.normal);
        let trial = (held.spring - self.velocity * (tangential * dt)).reject(self.normal) + carried;
        let most = coefficient * pressing;
        let size = trial.norm();
        let (mut friction, mut heat) = (trial, 0.0);
        if size.re() > most.re() {
            friction = trial * (most / size);
            heat = (most * (size - most) / tangential).re();
        }
        let before = held.spring.norm_squared();
        held.spring = friction - carried;
        energy.stored += 0.5 * (spring * spring / stiffness + held.spring.norm_squared() / tangential).re();
        let force = self.normal * pressing + friction;
        if springs.multiplier.is_some() {
            // What the multiplier does is heat, too, for better or worse: it comes and goes with the load.
            let stored = (held.spring.norm_squared() - before) / (tangential * 2.0);
            heat = -(friction.dot(self.velocity) * dt + stored).re();
            held.last = Some((force, self.velocity));
        }
        energy.friction += heat;
        sum.force += force;
        sum.normal += pressing;
        if pressing.re() > 0.0 {
            sum.area += self.area;
        }
        force
    }

    /// Lets the multiplier take on some of the load that it does not carry yet: the load of the last step, by what the node did under it.
    #[inline(always)]
    fn take_over(&self, share: f64, held: &mut Held<R>, dt: f64) {
        if let Some((force, velocity)) = held.last {
            let opposed = force - (self.velocity - velocity) * (self.mass * (1.0 / dt));
            held.multiplier += (opposed - held.multiplier) * R::from_f64(share);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Held, Springs, Touch};
    use crate::contact::{ContactEnergy, Resultant};
    use clubface_math::Vec3;

    /// Force along the normal of a node just behind the face that arrives, or leaves, at a speed.
    fn pressing(gap: f64, closing: f64) -> f64 {
        let (normal, velocity) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(-closing, 3.0, 0.0));
        let touch = Touch { mass: 1e-5, area: 1e-6, gap, normal, velocity };
        let mut sum = Resultant::default();
        touch.force(
            Springs::default(),
            0.35,
            &mut Held::free(),
            5e-7,
            &mut sum,
            &mut ContactEnergy::default(),
        );
        sum.normal
    }

    #[test]
    fn force_begins_at_zero_at_any_speed_and_never_pulls() {
        for gap in [-1e-12, -1e-9, -1e-6] {
            let spring = pressing(gap, 0.0);
            assert!(spring > 0.0);
            // Exact but for the rounding of a sum: the damper at most doubles what the spring gives, or takes it away.
            assert!((pressing(gap, 60.0) / spring - 2.0).abs() < 1e-12);
            assert!(pressing(gap, -60.0) == 0.0);
        }
        // Slowly, all of the damper acts: twice the closing speed, twice as much, but for the rounding of a hundredth of the sum.
        let damper = |closing: f64| pressing(-1e-5, closing) - pressing(-1e-5, 0.0);
        assert!((damper(0.2) / damper(0.1) - 2.0).abs() < 1e-9);
    }
}
