//! What the author of a law writes: its stress and its energy, over any scalar.
//!
//! Every law is for the change of shape alone; that of volume is common to all. A law of the first two invariants
//! implements [`OfInvariants`], any other elastic one [`Isochoric`], one whose stress depends on what has happened
//! before [`Inelastic`]. [`PointLaw`] is what the stages see of all three.

use super::deformation::{Deformation, Kinematics};
use super::state_variables::{Numbers, StateVariables};
use super::symmetric::Symmetric;
use clubface_math::{Pack, Scalar};

/// An elastic law: an energy of the modified right Cauchy-Green tensor `C̄` (determinant one).
pub trait Isochoric<S: Scalar>: Copy {
    /// `2 dW/dC̄`, Pa, but for a multiple of `C̄^-1`, which changes no shape and is taken out of any stress.
    fn stress(&self, c: &Symmetric<S>) -> Symmetric<S>;
    /// W, J/m3.
    fn energy(&self, c: &Symmetric<S>) -> S;
    /// Second Piola-Kirchhoff stress with `pressure`, `dW/dJ`, times a weight.
    #[inline(always)]
    fn second_piola(&self, at: &Deformation<S>, pressure: S, weight: S) -> Symmetric<S> {
        let kinematics = Kinematics::from_deformation(*at);
        kinematics.second_piola(&self.stress(&kinematics.c), pressure, weight)
    }
}

/// An elastic law that is an energy of the first two invariants alone, `tr C̄` and `tr C̄^-1`.
pub trait OfInvariants<S: Scalar>: Copy {
    /// Factors (Pa) of the identity and of `C̄` in `2 dW/dC̄`; what is left goes along `C̄^-1`.
    fn factors(&self, first: S, second: S) -> [S; 2];
    /// W, J/m3.
    fn energy(&self, c: &Symmetric<S>) -> S;
}

/// A law of the invariants as any elastic law, in fewer operations.
#[derive(Clone, Copy, Debug)]
pub struct Invariants<L>(pub L);

impl<S: Scalar, L: OfInvariants<S>> Isochoric<S> for Invariants<L> {
    #[inline(always)]
    fn stress(&self, c: &Symmetric<S>) -> Symmetric<S> {
        let [one, along] = self.0.factors(c.trace(), c.cofactors().trace());
        c.scale(along).plus_diagonal(one)
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<S>) -> S {
        self.0.energy(c)
    }
    #[inline(always)]
    fn second_piola(&self, at: &Deformation<S>, pressure: S, weight: S) -> Symmetric<S> {
        let kinematics = InvariantKinematics::new(at);
        let factors = self.0.factors(kinematics.first, kinematics.second);
        kinematics.second_piola(at, factors, pressure, weight)
    }
}

/// What the stress of a law of the invariants follows from, in fewer operations than of any law.
#[derive(Clone, Copy, Debug)]
pub struct InvariantKinematics<S> {
    cofactors: Symmetric<S>,
    shape: S,
    inverse_volume: S,
    /// `tr C̄`.
    pub first: S,
    /// `tr C̄^-1`.
    pub second: S,
}

impl<S: Scalar> InvariantKinematics<S> {
    /// At a deformation.
    #[inline(always)]
    pub fn new(at: &Deformation<S>) -> Self {
        let cofactors = at.right.cofactors();
        let shape = at.root.product(at.root);
        let inverse_volume = shape.product(at.root);
        let first = at.right.trace().product(shape);
        let second = cofactors.trace().product(shape.product(shape));
        Self { cofactors, shape, inverse_volume, first, second }
    }
    /// Second Piola-Kirchhoff stress with `pressure`, `dW/dJ`, times a weight, from the factors (Pa) of the identity
    /// and of `C̄` in `2 dW/dC̄`.
    #[inline(always)]
    pub fn second_piola(
        &self,
        at: &Deformation<S>,
        [one, along]: [S; 2],
        pressure: S,
        weight: S,
    ) -> Symmetric<S> {
        let Self { cofactors, shape, inverse_volume, first, second } = *self;
        // S : C̄ = one tr C̄ + along tr C̄^2, and J C^-1 = cof C / J.
        let square = first.mul_add(first, -(second + second));
        let mean = along.mul_add(square, one.product(first)).product(inverse_volume * (1.0 / 3.0));
        let weighted = shape.product(weight);
        let sum = cofactors.scale((pressure - mean).product(inverse_volume.product(weight)));
        sum.plus(along.product(shape.product(weighted)), &at.right).plus_diagonal(one.product(weighted))
    }
}

/// A law whose stress depends on state variables, some numbers a point.
pub trait Inelastic<S: Pack>: Copy {
    /// `2 dW/dC̄`, Pa, as in [`Isochoric::stress`], at the end of a step; the state variables move on.
    fn update(&self, c: &Symmetric<S>, state: &mut Numbers<S::Real>) -> Symmetric<S>;
    /// Elastic energy, and work that became heat, J/m3.
    fn energy(&self, c: &Symmetric<S>, state: &Numbers<S::Real>) -> [S; 2];
    /// Equivalent plastic strain.
    fn plastic_strain(&self, _state: &Numbers<S::Real>) -> S {
        S::zero()
    }
}

/// A law of any kind at the points of a pack; the pack begins with a lane, counted over all blocks of state
/// variables.
pub trait PointLaw<P: Pack>: Copy + 'static {
    /// See [`Inelastic::update`].
    fn update(&self, c: &Symmetric<P>, state: &mut StateVariables<P::Real>, lane: usize) -> Symmetric<P>;
    /// Second Piola-Kirchhoff stress with `pressure`, `dW/dJ`, times a weight; the state variables move on.
    #[inline(always)]
    fn second_piola(
        &self,
        at: &Deformation<P>,
        pressure: P,
        weight: P,
        state: &mut StateVariables<P::Real>,
        lane: usize,
    ) -> Symmetric<P> {
        let kinematics = Kinematics::from_deformation(*at);
        kinematics.second_piola(&self.update(&kinematics.c, state, lane), pressure, weight)
    }
    /// See [`Inelastic::energy`].
    fn energy(&self, c: &Symmetric<P>, state: &mut StateVariables<P::Real>, lane: usize) -> [P; 2];
    /// See [`Inelastic::plastic_strain`].
    fn plastic_strain(&self, _state: &mut StateVariables<P::Real>, _lane: usize) -> P {
        P::zero()
    }
}

/// An elastic law at the points of a pack.
#[derive(Clone, Copy, Debug)]
pub struct Elastic<L>(pub L);

impl<P: Pack, L: Isochoric<P> + 'static> PointLaw<P> for Elastic<L> {
    #[inline(always)]
    fn update(&self, c: &Symmetric<P>, _: &mut StateVariables<P::Real>, _: usize) -> Symmetric<P> {
        self.0.stress(c)
    }
    #[inline(always)]
    fn second_piola(
        &self,
        at: &Deformation<P>,
        pressure: P,
        weight: P,
        _: &mut StateVariables<P::Real>,
        _: usize,
    ) -> Symmetric<P> {
        self.0.second_piola(at, pressure, weight)
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<P>, _: &mut StateVariables<P::Real>, _: usize) -> [P; 2] {
        [self.0.energy(c), P::zero()]
    }
}

/// An inelastic law at the points of a pack.
#[derive(Clone, Copy, Debug)]
pub struct WithState<L>(pub L);

impl<P: Pack, L: Inelastic<P> + 'static> PointLaw<P> for WithState<L> {
    #[inline(always)]
    fn update(&self, c: &Symmetric<P>, state: &mut StateVariables<P::Real>, lane: usize) -> Symmetric<P> {
        self.0.update(c, &mut state.every_step(lane))
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<P>, state: &mut StateVariables<P::Real>, lane: usize) -> [P; 2] {
        self.0.energy(c, &state.every_step(lane))
    }
    #[inline(always)]
    fn plastic_strain(&self, state: &mut StateVariables<P::Real>, lane: usize) -> P {
        self.0.plastic_strain(&state.every_step(lane))
    }
}
