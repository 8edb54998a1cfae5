//! Finite-strain viscoelasticity over any law of shape: Maxwell branches whose stress follows that of the law and relaxes
//! (Simo, Comput. Methods Appl. Mech. Eng. 60, 1987; Simo and Hughes, Computational Inelasticity, section 10.3).

use super::{Kinematics, Symmetric};
use clubface_math::Scalar;

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

/// Stress of the branches added to that of the law; the history moves on by one step.
#[inline(always)]
pub fn add_branches<S: Scalar>(
    at: &Kinematics<S>,
    stress: Symmetric<S>,
    decays: &[Decay<S>],
    history: &mut [S],
) -> Symmetric<S> {
    let (last, branches) = history.split_at_mut(13);
    let driving = at.deviator(&stress);
    let mut total = stress;
    let mut power = S::zero();
    for (decay, branch) in decays.iter().zip(branches.chunks_exact_mut(6)) {
        for i in 0..6 {
            let before = branch[i];
            let after = decay.whole.mul_add(before, decay.half * (driving.0[i] - last[i]));
            branch[i] = after;
            total.0[i] += after;
            let weight = if i < 3 { 0.25 } else { 0.5 };
            power += (before + after) * (at.c.0[i] - last[6 + i]) * weight;
        }
    }
    last[..6].copy_from_slice(&driving.0);
    last[6..12].copy_from_slice(&at.c.0);
    last[12] += power;
    total
}
