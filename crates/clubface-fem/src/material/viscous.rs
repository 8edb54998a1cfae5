//! Finite-strain viscoelasticity over any law of shape: Maxwell branches whose stress follows that of the law and relaxes
//! (Simo, Comput. Methods Appl. Mech. Eng. 60, 1987; Simo and Hughes, Computational Inelasticity, section 10.3).

use super::{Kinematics, Memory, Symmetric};
use clubface_math::{Pack, Scalar};

/// Most terms a material may have.
pub const MAX_TERMS: usize = 4;

/// One branch: its shear modulus over that of the slow material, and the time in which its stress falls to 1/e.
#[derive(Clone, Copy, Debug)]
pub struct Maxwell<S> {
    /// Relative modulus, above zero.
    pub modulus: S,
    /// Relaxation time, s.
    pub time: S,
}

/// Decay factors of one step.
#[derive(Clone, Copy, Debug)]
pub struct Decay<S> {
    /// `exp(-dt / time)`.
    pub whole: S,
    /// `modulus exp(-dt / (2 time))`.
    pub half: S,
}

impl<S: Scalar> Maxwell<S> {
    /// Decay over a step of `dt` seconds.
    pub fn decay(&self, dt: f64) -> Decay<S> {
        let half = (self.time.recip() * (-0.5 * dt)).exp();
        Decay { whole: half * half, half: half * self.modulus }
    }
}

/// Where things stand in a point's memory: driving stress and `C̄` of the last step, work done on the branches, six stresses a branch.
const DEFORMATION: usize = 6;
const WORK: usize = 12;
const BRANCHES: usize = 13;

/// Memory of a point before any deformation.
pub(super) fn undeformed<S: Scalar>(terms: usize) -> Vec<S> {
    let mut numbers = vec![S::zero(); BRANCHES + 6 * terms];
    // The undeformed C̄ is the identity; its driving stress has no deviator.
    numbers[DEFORMATION..DEFORMATION + 3].fill(S::one());
    numbers
}

/// Work done on the branches so far, J/m3.
#[inline(always)]
pub fn work<P: Pack>(memory: &Memory<P::Real>) -> P {
    let [work] = memory.load(WORK);
    work
}

/// Stress of the branches added to that of the law; the memory moves on by one step.
#[inline(always)]
pub fn add_branches<P: Pack>(
    at: &Kinematics<P>,
    stress: Symmetric<P>,
    decays: &[Decay<P>],
    memory: &mut Memory<P::Real>,
) -> Symmetric<P> {
    let driving = at.deviator(&stress);
    let growth = driving.minus(&Symmetric(memory.load(0)));
    let strain = at.c.minus(&Symmetric(memory.load(DEFORMATION)));
    let mut total = stress;
    let mut power = P::zero();
    for (term, decay) in decays.iter().enumerate() {
        let before = Symmetric(memory.load(BRANCHES + 6 * term));
        let after = growth.scale(decay.half).plus(decay.whole, &before);
        memory.store(BRANCHES + 6 * term, after.0);
        total = total.plus(P::one(), &after);
        power += before.plus(P::one(), &after).contract(&strain);
    }
    memory.store(0, driving.0);
    memory.store(DEFORMATION, at.c.0);
    let done: P = work(memory);
    memory.store(WORK, [power.mul_add(P::from_f64(0.25), done)]);
    total
}
