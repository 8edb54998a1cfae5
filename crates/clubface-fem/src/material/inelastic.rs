//! Laws with what they remember at a point: viscoelastic branches, plastic flow.

use super::viscous::{undeformed, work};
use super::{
    add_branches, Branches, Decay, Isochoric, Kinematics, Material, PlasticState, Shape, State, Symmetric,
    Update, UseLaw, VonMises, MAX_TERMS,
};
use clubface_math::{Computation, Pack, Real};

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

/// A law for the change of shape with a state, some numbers a point.
pub trait InelasticLaw<S: Pack> {
    /// `2 dW/dC̄` (Pa), but for a multiple of `C̄^-1`, at the end of a step; the state moves on.
    fn advance(&self, at: &Kinematics<S>, state: &mut State<S::Real>) -> Symmetric<S>;
    /// Equivalent plastic strain.
    fn plastic_strain(&self, _memory: &State<S::Real>) -> S {
        S::zero()
    }
    /// Energies at `C̄`.
    fn energy(&self, c: &Symmetric<S>, state: &State<S::Real>) -> PointEnergy<S>;
}

/// An elastic law with viscoelastic branches, or none.
#[derive(Clone, Copy, Debug)]
pub struct Branched<'a, S, L> {
    law: L,
    branches: Branches<'a, S>,
}

impl<S: Pack, L: Isochoric<S>> InelasticLaw<S> for Branched<'_, S, L> {
    #[inline(always)]
    fn advance(&self, at: &Kinematics<S>, state: &mut State<S::Real>) -> Symmetric<S> {
        let stress = self.law.stress(&at.c);
        if self.branches.decays.is_empty() {
            return stress;
        }
        add_branches(at, stress, &self.branches, state)
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>, state: &State<S::Real>) -> PointEnergy<S> {
        let viscous = if self.branches.decays.is_empty() { S::zero() } else { work(state) };
        PointEnergy { strain: self.law.energy(c), viscous, plastic: S::zero() }
    }
}

impl<S: Pack> InelasticLaw<S> for VonMises<S> {
    #[inline(always)]
    fn advance(&self, at: &Kinematics<S>, state: &mut State<S::Real>) -> Symmetric<S> {
        let mut plastic = PlasticState::from_numbers(state.every_step.load(0));
        let stress = VonMises::advance(self, &at.c, &mut plastic);
        state.every_step.store(0, plastic.numbers());
        stress
    }
    #[inline(always)]
    fn plastic_strain(&self, state: &State<S::Real>) -> S {
        PlasticState::from_numbers(state.every_step.load(0)).plastic_strain
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>, state: &State<S::Real>) -> PointEnergy<S> {
        let state = PlasticState::from_numbers(state.every_step.load(0));
        PointEnergy { strain: self.stored(c, &state), viscous: S::zero(), plastic: state.heat }
    }
}

/// A computation for [`Material::with_inelastic`].
pub trait UseInelastic<S: Pack> {
    /// What it returns.
    type Output;
    /// Runs it; implement with `#[inline(always)]`.
    fn with<M: InelasticLaw<S>>(self, law: M) -> Self::Output;
}

/// Gives a law its branches.
struct Branching<'a, S, U> {
    branches: Branches<'a, S>,
    computation: U,
}

impl<S: Pack, U: UseInelastic<S>> UseLaw<S> for Branching<'_, S, U> {
    type Output = U::Output;
    #[inline(always)]
    fn with<L: Isochoric<S>>(self, law: L) -> U::Output {
        self.computation.with(Branched { law, branches: self.branches })
    }
}

/// A computation for a metal that yields, as a function of its own.
struct Yielding<P, U> {
    computation: U,
    metal: VonMises<P>,
}

impl<P: Pack, U: UseInelastic<P>> Computation for Yielding<P, U> {
    type Output = U::Output;
    #[inline(always)]
    fn run(self) -> U::Output {
        self.computation.with(self.metal)
    }
}

impl<R: Real> Material<R> {
    /// What a point remembers before any deformation, for every step and for some only: nothing in an elastic material.
    #[must_use]
    pub fn state(&self) -> [Vec<R>; 2] {
        let terms = self.maxwell.len();
        assert!(terms <= MAX_TERMS, "at most {MAX_TERMS} viscoelastic terms");
        if let Shape::VonMises(_) = self.shape {
            return [PlasticState::start().numbers().to_vec(), vec![]];
        }
        if terms == 0 {
            return [vec![], vec![]];
        }
        undeformed(terms)
    }

    /// Runs a computation with the law and its state spread over packs, in a step.
    #[inline(always)]
    pub fn with_inelastic<P: Pack<Real = R>, U: UseInelastic<P>>(
        &self,
        step: Update,
        computation: U,
    ) -> U::Output {
        if let Shape::VonMises(law) = &self.shape {
            return P::outline(Yielding { computation, metal: law.splat::<P>() });
        }
        let mut decays = [Decay { way: P::zero(), half: P::zero() }; MAX_TERMS];
        for (decay, term) in decays.iter_mut().zip(&self.maxwell) {
            let Decay { way, half } = term.decay(step.dt);
            *decay = Decay { way: P::splat(way), half: P::splat(half) };
        }
        let branches = Branches { decays: &decays[..self.maxwell.len()], add_work: step.add_work };
        self.with_law::<P, _>(Branching { branches, computation })
    }
}
