//! Laws with what they remember at a point: viscoelastic branches, plastic flow.

use super::viscous::{undeformed, work};
use super::{
    add_branches, Branches, Decay, Isochoric, Kinematics, Material, Memory, PlasticState, Shape, Step,
    Symmetric, UseLaw, VonMises, MAX_TERMS,
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

/// A law for the change of shape with a memory, some numbers a point.
pub trait Remembering<S: Pack> {
    /// `2 dW/dC̄` (Pa), but for a multiple of `C̄^-1`, at the end of a step; the memory moves on.
    fn advance(&self, at: &Kinematics<S>, memory: &mut Memory<S::Real>) -> Symmetric<S>;
    /// Equivalent plastic strain.
    fn plastic_strain(&self, _memory: &Memory<S::Real>) -> S {
        S::zero()
    }
    /// Energies at `C̄`.
    fn energy(&self, c: &Symmetric<S>, memory: &Memory<S::Real>) -> PointEnergy<S>;
}

/// An elastic law with viscoelastic branches, or none.
#[derive(Clone, Copy, Debug)]
pub struct Branched<'a, S, L> {
    law: L,
    branches: Branches<'a, S>,
}

impl<S: Pack, L: Isochoric<S>> Remembering<S> for Branched<'_, S, L> {
    #[inline(always)]
    fn advance(&self, at: &Kinematics<S>, memory: &mut Memory<S::Real>) -> Symmetric<S> {
        let stress = self.law.stress(&at.c);
        if self.branches.decays.is_empty() {
            return stress;
        }
        add_branches(at, stress, &self.branches, memory)
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>, memory: &Memory<S::Real>) -> PointEnergy<S> {
        let viscous = if self.branches.decays.is_empty() { S::zero() } else { work(memory) };
        PointEnergy { strain: self.law.energy(c), viscous, plastic: S::zero() }
    }
}

impl<S: Pack> Remembering<S> for VonMises<S> {
    #[inline(always)]
    fn advance(&self, at: &Kinematics<S>, memory: &mut Memory<S::Real>) -> Symmetric<S> {
        let mut state = PlasticState::from_numbers(memory.often.load(0));
        let stress = VonMises::advance(self, &at.c, &mut state);
        memory.often.store(0, state.numbers());
        stress
    }
    #[inline(always)]
    fn plastic_strain(&self, memory: &Memory<S::Real>) -> S {
        PlasticState::from_numbers(memory.often.load(0)).plastic_strain
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>, memory: &Memory<S::Real>) -> PointEnergy<S> {
        let state = PlasticState::from_numbers(memory.often.load(0));
        PointEnergy { strain: self.stored(c, &state), viscous: S::zero(), plastic: state.heat }
    }
}

/// A computation for [`Material::with_memory`].
pub trait UseMemory<S: Pack> {
    /// What it returns.
    type Output;
    /// Runs it; implement with `#[inline(always)]`.
    fn with<M: Remembering<S>>(self, law: M) -> Self::Output;
}

/// Gives a law its branches.
struct Branching<'a, S, U> {
    branches: Branches<'a, S>,
    computation: U,
}

impl<S: Pack, U: UseMemory<S>> UseLaw<S> for Branching<'_, S, U> {
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

impl<P: Pack, U: UseMemory<P>> Computation for Yielding<P, U> {
    type Output = U::Output;
    #[inline(always)]
    fn run(self) -> U::Output {
        self.computation.with(self.metal)
    }
}

impl<R: Real> Material<R> {
    /// What a point remembers before any deformation, for every step and for some only: nothing in an elastic material.
    #[must_use]
    pub fn memory(&self) -> [Vec<R>; 2] {
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

    /// Runs a computation with the law and its memory spread over packs, in a step.
    #[inline(always)]
    pub fn with_memory<P: Pack<Real = R>, U: UseMemory<P>>(&self, step: Step, computation: U) -> U::Output {
        if let Shape::VonMises(law) = &self.shape {
            return P::outline(Yielding { computation, metal: law.splat::<P>() });
        }
        let mut decays = [Decay { way: P::zero(), half: P::zero() }; MAX_TERMS];
        for (decay, term) in decays.iter_mut().zip(&self.maxwell) {
            let Decay { way, half } = term.decay(step.dt);
            *decay = Decay { way: P::splat(way), half: P::splat(half) };
        }
        let branches = Branches { decays: &decays[..self.maxwell.len()], tally: step.tally };
        self.with_law::<P, _>(Branching { branches, computation })
    }
}
