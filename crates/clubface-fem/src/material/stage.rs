//! Stress as a stage of the elements' loops: one call for a run of packs, through a table of functions that is chosen
//! once a patch and step, so that the loops are compiled once for each kind of pack and not for each law.
//!
//! Packs pass these calls by reference: the callers on both sides are compiled with features of the CPU that the call
//! itself knows nothing of.

use super::deformation::{Deformation, Kinematics};
use super::law::PointLaw;
use super::state_variables::StateVariables;
use super::symmetric::Symmetric;
use super::viscous::{add_branches, work, Branches, Decay, MAX_TERMS};
use clubface_math::{Computation, Pack};

/// Points one after the other, each with as many lanes as a pack: where they stand, and what their stress follows from.
pub struct Points<'a, P: Pack> {
    /// Number of the first block of eight points; the others follow.
    pub block: usize,
    /// First lane of the pack in its block.
    pub first: usize,
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

/// A law with its viscoelastic branches in one step, spread over packs.
pub trait StressStage<P: Pack> {
    /// Stresses of some points; their state variables move on by the step.
    fn stress(&self, points: &mut Points<P>, state: &mut StateVariables<P::Real>);
    /// Energies at `C̄` of the points of a pack, which begins with the point `first` of a block.
    fn energy(
        &self,
        c: &Symmetric<P>,
        state: &mut StateVariables<P::Real>,
        block: usize,
        first: usize,
        energy: &mut PointEnergy<P>,
    );
    /// Equivalent plastic strain of such points.
    fn plastic_strain(&self, state: &mut StateVariables<P::Real>, block: usize, first: usize, strain: &mut P);
}

/// Where a law puts its stage for packs of type P, since a trait object cannot return what depends on that type.
pub type Slot<P> = Option<Box<dyn StressStage<P>>>;

/// Viscoelastic branches of a stage, none for an elastic material.
#[derive(Clone, Copy)]
struct Branching<P> {
    decays: [Decay<P>; MAX_TERMS],
    count: usize,
    add_work: bool,
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
        let nothing = Decay { way: P::zero(), half: P::zero() };
        let (mut decays, count) = ([nothing; MAX_TERMS], branches.decays.len());
        for i in 0..count {
            let Decay { way, half } = branches.decays[i];
            decays[i] = Decay { way: P::splat(way), half: P::splat(half) };
        }
        Self { law, branching: Branching { decays, count, add_work: branches.add_work } }
    }
}

impl<P: Pack, L: PointLaw<P>> StressStage<P> for Stage<P, L> {
    fn stress(&self, points: &mut Points<P>, state: &mut StateVariables<P::Real>) {
        if self.branching.count == 0 {
            P::outline(Stress { law: &self.law, points, state });
        } else {
            P::outline(BranchedStress { stage: self, points, state });
        }
    }
    fn energy(
        &self,
        c: &Symmetric<P>,
        state: &mut StateVariables<P::Real>,
        block: usize,
        first: usize,
        energy: &mut PointEnergy<P>,
    ) {
        P::outline(Energy { stage: self, c, state, block, first, energy });
    }
    fn plastic_strain(
        &self,
        state: &mut StateVariables<P::Real>,
        block: usize,
        first: usize,
        strain: &mut P,
    ) {
        // Asked for seldom, of single numbers: no features of the CPU are needed.
        *strain = self.law.plastic_strain(&state.of(block, first).every_step);
    }
}

/// [`StressStage::stress`] of a law without branches.
struct Stress<'a, 'b, P: Pack, L> {
    law: &'a L,
    points: &'a mut Points<'b, P>,
    state: &'a mut StateVariables<P::Real>,
}

impl<P: Pack, L: PointLaw<P>> Computation for Stress<'_, '_, P, L> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Points { block, first, deformations, pressures, weights, stresses } = self.points;
        let law = *self.law;
        let count = stresses.len();
        assert!(deformations.len() == count && pressures.len() == count && weights.len() == count);
        for i in 0..count {
            let mut state = self.state.of(*block + i, *first);
            stresses[i] = law.second_piola(&deformations[i], pressures[i], weights[i], &mut state.every_step);
        }
    }
}

/// The same of one with branches.
struct BranchedStress<'a, 'b, P: Pack, L> {
    stage: &'a Stage<P, L>,
    points: &'a mut Points<'b, P>,
    state: &'a mut StateVariables<P::Real>,
}

impl<P: Pack, L: PointLaw<P>> Computation for BranchedStress<'_, '_, P, L> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Points { block, first, deformations, pressures, weights, stresses } = self.points;
        let Stage { law, branching } = *self.stage;
        let branches =
            Branches { decays: &branching.decays[..branching.count], add_work: branching.add_work };
        let count = stresses.len();
        assert!(deformations.len() == count && pressures.len() == count && weights.len() == count);
        for i in 0..count {
            let mut state = self.state.of(*block + i, *first);
            let kinematics = Kinematics::of(deformations[i]);
            let elastic = law.update(&kinematics.c, &mut state.every_step);
            let stress = add_branches(&kinematics, elastic, &branches, &mut state);
            stresses[i] = kinematics.second_piola(&stress, pressures[i], weights[i]);
        }
    }
}

struct Energy<'a, P: Pack, L> {
    stage: &'a Stage<P, L>,
    c: &'a Symmetric<P>,
    state: &'a mut StateVariables<P::Real>,
    block: usize,
    first: usize,
    energy: &'a mut PointEnergy<P>,
}

impl<P: Pack, L: PointLaw<P>> Computation for Energy<'_, P, L> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let state = self.state.of(self.block, self.first);
        let viscous = if self.stage.branching.count == 0 { P::zero() } else { work(&state) };
        let [strain, plastic] = self.stage.law.energy(self.c, &state.every_step);
        *self.energy = PointEnergy { strain, viscous, plastic };
    }
}
