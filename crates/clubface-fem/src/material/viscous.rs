//! Finite-strain viscoelasticity over any law of shape: Maxwell branches whose stress follows that of the law and
//! relaxes (Simo, Comput. Methods Appl. Mech. Eng. 60, 1987; Simo and Hughes, Computational Inelasticity, section
//! 10.3).

use super::deformation::Kinematics;
use super::state_variables::{Numbers, StateVariables};
use super::symmetric::Symmetric;
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

/// A branch in one step.
#[derive(Clone, Copy, Debug)]
pub struct Decay<S> {
    /// Share of the way to the driving stress that the dashpot goes, `1 - exp(-dt / time)`.
    pub way: S,
    /// `modulus exp(-dt / (2 time))`.
    pub half: S,
}

impl<S: Scalar> Maxwell<S> {
    /// Decay over a step of `dt` seconds.
    pub fn decay(&self, dt: f64) -> Decay<S> {
        let half = (self.time.recip() * (-0.5 * dt)).exp();
        Decay { way: S::one() - half * half, half: half * self.modulus }
    }
}

/// Branches of a material in one step.
#[derive(Clone, Copy, Debug)]
pub struct Branches<'a, S> {
    /// Each of them.
    pub decays: &'a [Decay<S>],
    /// Whether the work done on them since it was last added up is added up.
    pub add_work: bool,
}

/// What a point keeps for the energies only: `C̄` and the stress of all branches when their work was last added up,
/// and the work.
const STRESS: usize = 6;
const WORK: usize = 12;
const ACCOUNT: usize = 13;

/// State of a point before any deformation, for every step and for the energies only.
pub(super) fn undeformed<S: Scalar>(terms: usize) -> [Vec<S>; 2] {
    let mut account = vec![S::zero(); ACCOUNT];
    // The undeformed C̄ is the identity; its driving stress has no deviator.
    account[..3].fill(S::one());
    [vec![S::zero(); 6 * terms], account]
}

/// Work done on the branches until it was last added up, J/m3.
#[inline(always)]
pub fn work<P: Pack>(state: &mut StateVariables<P::Real>, lane: usize) -> P {
    let [work] = state.energy_only(lane).load(WORK);
    work
}

/// Stress of the branches added to that of the law; the state moves on by one step.
#[inline(always)]
pub fn add_branches<P: Pack>(
    at: &Kinematics<P>,
    stress: Symmetric<P>,
    branches: &Branches<P>,
    state: &mut StateVariables<P::Real>,
    lane: usize,
) -> Symmetric<P> {
    let driving = at.deviator(&stress);
    let Branches { decays, add_work: due } = *branches;
    // One branch is the usual case, and then nothing needs counting.
    let variables = &mut state.every_step(lane);
    let branched = if let [only] = decays {
        relax(&driving, &[*only], variables)
    } else {
        relax(&driving, decays, variables)
    };
    if due {
        add_work(&at.c, &branched, &mut state.energy_only(lane));
    }
    stress.plus(P::one(), &branched)
}

/// Stress of the branches at the end of a step; the state moves on.
///
/// The convolution of Simo and Hughes (section 10.3), whose stress moves on by
/// `h <- exp(-dt / time) h + half (S - S_last)`, with one variable in the place of two, the driving stress that the
/// dashpot has come to: `h = half (S - H)`, after which `H` goes its way to `S`.
#[inline(always)]
fn relax<P: Pack>(driving: &Symmetric<P>, decays: &[Decay<P>], state: &mut Numbers<P::Real>) -> Symmetric<P> {
    // Spelt out, since no compiler unrolls so much by itself.
    let [xx, yy, zz, xy, xz, yz] = driving.0;
    Symmetric([
        relax_component(0, xx, decays, state),
        relax_component(1, yy, decays, state),
        relax_component(2, zz, decays, state),
        relax_component(3, xy, decays, state),
        relax_component(4, xz, decays, state),
        relax_component(5, yz, decays, state),
    ])
}

/// The same of one component.
#[inline(always)]
fn relax_component<P: Pack>(
    component: usize,
    driving: P,
    decays: &[Decay<P>],
    state: &mut Numbers<P::Real>,
) -> P {
    let mut stress = P::zero();
    for (term, decay) in decays.iter().enumerate() {
        let place = 6 * term + component;
        let [dashpot]: [P; 1] = state.load(place);
        let spring = driving - dashpot;
        state.store(place, [spring.mul_add(decay.way, dashpot)]);
        stress = spring.mul_add(decay.half, stress);
    }
    stress
}

/// Adds the work since it was last added up, by the trapezoidal rule.
#[inline(always)]
fn add_work<P: Pack>(c: &Symmetric<P>, stress: &Symmetric<P>, account: &mut Numbers<P::Real>) {
    let [mut stretch, mut shear] = [P::zero(); 2];
    for component in 0..6 {
        let [c_last]: [P; 1] = account.load(component);
        let [stress_last]: [P; 1] = account.load(STRESS + component);
        let power = (stress.0[component] + stress_last) * (c.0[component] - c_last);
        if component < 3 {
            stretch += power;
        } else {
            shear += power;
        }
        account.store(component, [c.0[component]]);
        account.store(STRESS + component, [stress.0[component]]);
    }
    let [done]: [P; 1] = account.load(WORK);
    account.store(WORK, [(stretch + shear + shear).mul_add(P::from_f64(0.25), done)]);
}
