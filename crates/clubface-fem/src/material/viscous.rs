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
    // One branch is the usual case, and then nothing needs counting.
    let (relaxed, power) = if let [only] = decays {
        relax(&driving, &at.c, &[*only], memory)
    } else {
        relax(&driving, &at.c, decays, memory)
    };
    let done: P = work(memory);
    memory.store(WORK, [power.mul_add(P::from_f64(0.25), done)]);
    stress.plus(P::one(), &relaxed)
}

/// Stress of the branches at the end of a step, and four times its mean over the step times the strain; the memory moves on.
#[inline(always)]
fn relax<P: Pack>(
    driving: &Symmetric<P>,
    deformation: &Symmetric<P>,
    decays: &[Decay<P>],
    memory: &mut Memory<P::Real>,
) -> (Symmetric<P>, P) {
    // Component by component, since there are not registers enough for whole tensors; spelt out, since no compiler unrolls so much by itself.
    let (d, c) = (&driving.0, &deformation.0);
    let (xx, power_xx) = relax_component(0, d[0], c[0], decays, memory);
    let (yy, power_yy) = relax_component(1, d[1], c[1], decays, memory);
    let (zz, power_zz) = relax_component(2, d[2], c[2], decays, memory);
    let (xy, power_xy) = relax_component(3, d[3], c[3], decays, memory);
    let (xz, power_xz) = relax_component(4, d[4], c[4], decays, memory);
    let (yz, power_yz) = relax_component(5, d[5], c[5], decays, memory);
    let shear = power_xy + power_xz + power_yz;
    (Symmetric([xx, yy, zz, xy, xz, yz]), power_xx + power_yy + power_zz + (shear + shear))
}

/// The same of one component.
#[inline(always)]
fn relax_component<P: Pack>(
    component: usize,
    driving: P,
    deformation: P,
    decays: &[Decay<P>],
    memory: &mut Memory<P::Real>,
) -> (P, P) {
    let [[last], [before]]: [[P; 1]; 2] = [memory.load(component), memory.load(DEFORMATION + component)];
    let growth = driving - last;
    memory.store(component, [driving]);
    memory.store(DEFORMATION + component, [deformation]);
    let (mut stress, mut both) = (P::zero(), P::zero());
    for (term, decay) in decays.iter().enumerate() {
        let place = BRANCHES + 6 * term + component;
        let [old]: [P; 1] = memory.load(place);
        let new = old.mul_add(decay.whole, growth * decay.half);
        memory.store(place, [new]);
        stress += new;
        both += old + new;
    }
    (stress, both * (deformation - before))
}
