//! Laws with what they remember at a point: viscoelastic branches, plastic flow.

use super::viscous::{undeformed, work};
use super::{
    add_branches, Decay, Isochoric, Kinematics, Material, PlasticState, Shape, Symmetric, UseLaw, VonMises,
    MAX_TERMS,
};
use clubface_math::{Computation, Pack, Real};

/// What some points of a group remember, a number after the other: `stride` of them, of which a pack begins with the one at `first`.
pub struct Memory<'a, R> {
    numbers: &'a mut [R],
    first: usize,
    stride: usize,
}

impl<'a, R> Memory<'a, R> {
    /// From the numbers of a group.
    #[inline(always)]
    pub fn new(numbers: &'a mut [R], first: usize, stride: usize) -> Self {
        Self { numbers, first, stride }
    }
    /// Some consecutive numbers.
    #[inline(always)]
    pub fn load<P: Pack<Real = R>, const N: usize>(&self, from: usize) -> [P; N] {
        let mut values = [P::zero(); N];
        for i in 0..N {
            values[i] = P::load(&self.numbers[(from + i) * self.stride + self.first..]);
        }
        values
    }
    /// Writes them.
    #[inline(always)]
    pub fn store<P: Pack<Real = R>, const N: usize>(&mut self, from: usize, values: [P; N]) {
        for i in 0..N {
            values[i].store(&mut self.numbers[(from + i) * self.stride + self.first..]);
        }
    }
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
    decays: &'a [Decay<S>],
}

impl<S: Pack, L: Isochoric<S>> Remembering<S> for Branched<'_, S, L> {
    #[inline(always)]
    fn advance(&self, at: &Kinematics<S>, memory: &mut Memory<S::Real>) -> Symmetric<S> {
        let stress = self.law.stress(&at.c);
        if self.decays.is_empty() {
            return stress;
        }
        add_branches(at, stress, self.decays, memory)
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>, memory: &Memory<S::Real>) -> PointEnergy<S> {
        let viscous = if self.decays.is_empty() { S::zero() } else { work(memory) };
        PointEnergy { strain: self.law.energy(c), viscous, plastic: S::zero() }
    }
}

impl<S: Pack> Remembering<S> for VonMises<S> {
    #[inline(always)]
    fn advance(&self, at: &Kinematics<S>, memory: &mut Memory<S::Real>) -> Symmetric<S> {
        let mut state = PlasticState::from_numbers(memory.load(0));
        let stress = VonMises::advance(self, &at.c, &mut state);
        memory.store(0, state.numbers());
        stress
    }
    #[inline(always)]
    fn plastic_strain(&self, memory: &Memory<S::Real>) -> S {
        PlasticState::from_numbers(memory.load(0)).plastic_strain
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>, memory: &Memory<S::Real>) -> PointEnergy<S> {
        let state = PlasticState::from_numbers(memory.load(0));
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
    decays: &'a [Decay<S>],
    computation: U,
}

impl<S: Pack, U: UseMemory<S>> UseLaw<S> for Branching<'_, S, U> {
    type Output = U::Output;
    #[inline(always)]
    fn with<L: Isochoric<S>>(self, law: L) -> U::Output {
        self.computation.with(Branched { law, decays: self.decays })
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
    /// What a point remembers before any deformation: nothing in an elastic material.
    #[must_use]
    pub fn memory(&self) -> Vec<R> {
        let terms = self.maxwell.len();
        assert!(terms <= MAX_TERMS, "at most {MAX_TERMS} viscoelastic terms");
        if let Shape::VonMises(_) = self.shape {
            return PlasticState::start().numbers().to_vec();
        }
        if terms == 0 {
            return vec![];
        }
        undeformed(terms)
    }

    /// Decay of the branches over a step of `dt` seconds, the first of as many as there are.
    #[inline(always)]
    pub fn decays<P: Pack<Real = R>>(&self, dt: f64) -> [Decay<P>; MAX_TERMS] {
        let mut decays = [Decay { whole: P::zero(), half: P::zero() }; MAX_TERMS];
        for (decay, term) in decays.iter_mut().zip(&self.maxwell) {
            let step = term.decay(dt);
            *decay = Decay { whole: P::splat(step.whole), half: P::splat(step.half) };
        }
        decays
    }

    /// Runs a computation with the law and its memory spread over packs; `decays` are those of a step.
    #[inline(always)]
    pub fn with_memory<P: Pack<Real = R>, U: UseMemory<P>>(
        &self,
        decays: &[Decay<P>; MAX_TERMS],
        computation: U,
    ) -> U::Output {
        if let Shape::VonMises(law) = &self.shape {
            return P::outline(Yielding { computation, metal: law.splat::<P>() });
        }
        self.with_law::<P, _>(Branching { decays: &decays[..self.maxwell.len()], computation })
    }
}
