//! Stress as a stage of the elements' loops: one call for a run of packs, through a table of functions that is chosen
//! once a patch and step, so that the loops are compiled once for each kind of pack and not for each law.
//!
//! Packs pass these calls by reference: the callers on both sides are compiled with features of the CPU that the call
//! itself knows nothing of.

use super::deformation::{Deformation, Kinematics};
use super::law::PointLaw;
use super::state_variables::StateVariables;
use super::symmetric::Symmetric;
use super::viscous::{Branches, Decay, MAX_TERMS, add_branches, work};
use clubface_math::{Computation, Pack, Scalar};

/// Points one after the other, each with as many lanes as a pack: where they stand, and what their stress follows from.
pub struct Points<'a, P: Pack> {
    /// First lane of the first pack, counted over all blocks, and how many lanes further the next one begins.
    pub lane: usize,
    /// See [`Points::lane`].
    pub step: usize,
    /// State variables of all blocks.
    pub state: &'a mut StateVariables<P::Real>,
    /// Deformations.
    pub deformations: &'a [Deformation<P>],
    /// `dW/dJ`, Pa.
    pub pressures: &'a [P],
    /// Factors of the stresses.
    pub weights: &'a [P],
    /// Second Piola-Kirchhoff stresses, Pa, times the weights: what is asked for.
    pub stresses: &'a mut [Symmetric<P>],
}

/// Energies at a point without that of the change of volume, J/m3.
#[derive(Clone, Copy, Debug)]
pub struct PointEnergy<S> {
    /// Elastic.
    pub strain: S,
    /// Done on viscoelastic branches.
    pub viscous: S,
    /// Turned into heat by plastic flow.
    pub plastic: S,
}

impl<S: Scalar> PointEnergy<S> {
    /// None.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { strain: S::zero(), viscous: S::zero(), plastic: S::zero() }
    }
}

/// Points as in [`Points`] whose energies are computed.
pub struct EnergyPoints<'a, P: Pack> {
    /// See [`Points::lane`].
    pub lane: usize,
    /// See [`Points::step`].
    pub step: usize,
    /// State variables of all blocks.
    pub state: &'a mut StateVariables<P::Real>,
    /// `C̄`.
    pub c: &'a [Symmetric<P>],
    /// Determinants of the gradients.
    pub volumes: &'a [P],
    /// What is asked for.
    pub energies: &'a mut [PointEnergy<P>],
}

/// A law with its viscoelastic branches in one step, spread over packs.
pub trait StressStage<P: Pack> {
    /// Stresses of some points; their state variables move on by the step.
    fn stress(&self, points: &mut Points<P>);
    /// Energies of some points.
    fn energy(&self, points: &mut EnergyPoints<P>);
    /// Equivalent plastic strain of the points of a pack.
    fn plastic_strain(&self, state: &mut StateVariables<P::Real>, lane: usize, strain: &mut P);
}

/// Where a law puts its stage for packs of type P, since a trait object cannot return what depends on that type.
pub type Slot<P> = Option<Box<dyn StressStage<P>>>;

/// Viscoelastic branches of a stage, none for an elastic material.
#[derive(Clone, Copy)]
pub(super) struct Branching<P> {
    decays: [Decay<P>; MAX_TERMS],
    count: usize,
    add_work: bool,
}

impl<P: Pack> Branching<P> {
    #[inline(always)]
    pub(super) fn new(branches: &Branches<P::Real>) -> Self {
        let nothing = Decay { way: P::zero(), half: P::zero() };
        let (mut decays, count) = ([nothing; MAX_TERMS], branches.decays.len());
        for i in 0..count {
            let Decay { way, half } = branches.decays[i];
            decays[i] = Decay { way: P::splat(way), half: P::splat(half) };
        }
        Self { decays, count, add_work: branches.add_work }
    }
    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }
    #[inline(always)]
    pub(super) fn branches(&self) -> Branches<'_, P> {
        Branches { decays: &self.decays[..self.count], add_work: self.add_work }
    }
}

/// The stage of a law.
#[derive(Clone, Copy)]
pub(super) struct Stage<P, L> {
    law: L,
    branching: Branching<P>,
}

impl<P: Pack, L: PointLaw<P>> Stage<P, L> {
    #[inline(always)]
    pub(super) fn new(law: L, branches: &Branches<P::Real>) -> Self {
        Self { law, branching: Branching::new(branches) }
    }
}

impl<P: Pack, L: PointLaw<P>> StressStage<P> for Stage<P, L> {
    fn stress(&self, points: &mut Points<P>) {
        if self.branching.is_empty() {
            P::outline(Stress(&Unbranched(self), points));
        } else {
            P::outline(Stress(self, points));
        }
    }
    fn energy(&self, points: &mut EnergyPoints<P>) {
        P::outline(Energy(self, points));
    }
    fn plastic_strain(&self, state: &mut StateVariables<P::Real>, lane: usize, strain: &mut P) {
        // Asked for seldom, of single numbers: no features of the CPU are needed.
        *strain = self.law.plastic_strain(state, lane);
    }
}

/// Second Piola-Kirchhoff stress at a point, as in [`PointLaw::second_piola`].
trait PointStress<P: Pack> {
    fn at(
        &self,
        at: &Deformation<P>,
        pressure: P,
        weight: P,
        state: &mut StateVariables<P::Real>,
        lane: usize,
    ) -> Symmetric<P>;
}

impl<P: Pack, L: PointLaw<P>> PointStress<P> for Stage<P, L> {
    #[inline(always)]
    fn at(
        &self,
        at: &Deformation<P>,
        pressure: P,
        weight: P,
        state: &mut StateVariables<P::Real>,
        lane: usize,
    ) -> Symmetric<P> {
        let kinematics = Kinematics::from_deformation(*at);
        let elastic = self.law.update(&kinematics.c, state, lane);
        let stress = add_branches(&kinematics, elastic, &self.branching.branches(), state, lane);
        kinematics.second_piola(&stress, pressure, weight)
    }
}

/// A stage without branches.
struct Unbranched<'a, P, L>(&'a Stage<P, L>);

impl<P: Pack, L: PointLaw<P>> PointStress<P> for Unbranched<'_, P, L> {
    #[inline(always)]
    fn at(
        &self,
        at: &Deformation<P>,
        pressure: P,
        weight: P,
        state: &mut StateVariables<P::Real>,
        lane: usize,
    ) -> Symmetric<P> {
        self.0.law.second_piola(at, pressure, weight, state, lane)
    }
}

// Two references each, so that they travel in registers.

/// [`StressStage::stress`].
struct Stress<'a, 'b, P: Pack, L>(&'a L, &'a mut Points<'b, P>);

impl<P: Pack, L: PointStress<P>> Computation for Stress<'_, '_, P, L> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Points { lane, step, state, deformations, pressures, weights, stresses } = self.1;
        stresses_of(self.0, *lane, *step, state, deformations, pressures, weights, stresses);
    }
}

/// Stresses of some [`Points`]: as arguments, lists are known not to overlap, so that nothing is read twice.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn stresses_of<P: Pack>(
    law: &impl PointStress<P>,
    lane: usize,
    step: usize,
    state: &mut StateVariables<P::Real>,
    deformations: &[Deformation<P>],
    pressures: &[P],
    weights: &[P],
    stresses: &mut [Symmetric<P>],
) {
    let count = stresses.len();
    assert!(deformations.len() == count && pressures.len() == count && weights.len() == count);
    for i in 0..count {
        stresses[i] = law.at(&deformations[i], pressures[i], weights[i], state, lane + i * step);
    }
}

/// [`StressStage::energy`].
struct Energy<'a, 'b, P: Pack, L>(&'a Stage<P, L>, &'a mut EnergyPoints<'b, P>);

impl<P: Pack, L: PointLaw<P>> Computation for Energy<'_, '_, P, L> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let EnergyPoints { lane, step, state, c, energies, .. } = self.1;
        let Stage { law, branching } = self.0;
        assert!(c.len() == energies.len());
        for i in 0..c.len() {
            let at = *lane + i * *step;
            let [strain, plastic] = law.energy(&c[i], state, at);
            let viscous = if branching.is_empty() { P::zero() } else { work(state, at) };
            energies[i] = PointEnergy { strain, viscous, plastic };
        }
    }
}
