//! Metal after von Mises in a thin wall: elastic until it yields, then flowing with its volume kept, free of stress
//! across the wall.
//!
//! A step is tried elastically; where that leaves the yield surface, it is brought back along the flow at its end. In
//! plane stress the mean and the deviating parts of the stress shrink by factors of their own, and one equation for
//! the amount of flow remains (Simo and Taylor, Int. J. Numer. Methods Eng. 22, 1986; de Souza Neto, Peric and Owen,
//! Computational Methods for Plasticity, 2008, section 9.4).

use super::hardening::Hardening;
use clubface_math::{Mask, Scalar};

/// Error of the yield condition, over the yield stress, below which one more Newton step is exact to rounding.
const CLOSE: f64 = 1e-8;
/// Newton steps at most: a few are needed.
const NEWTON: usize = 40;

/// Stress and state variables of a point.
#[derive(Clone, Copy, Debug)]
pub struct PlaneState<S> {
    /// Stress, Pa: xx, yy, xy.
    pub stress: [S; 3],
    /// Equivalent plastic strain.
    pub plastic_strain: S,
    /// Yield stress at that strain, Pa.
    pub yield_stress: S,
}

/// A metal in plane stress.
#[derive(Clone, Copy, Debug)]
pub struct PlaneStress<S> {
    young: S,
    poisson: S,
    hardening: Hardening<S>,
}

impl<S: Scalar> PlaneStress<S> {
    /// From Young's modulus (Pa), Poisson's ratio and the yield stress.
    #[inline(always)]
    pub fn new(young: S, poisson: S, hardening: Hardening<S>) -> Self {
        Self { young, poisson, hardening }
    }

    /// Twice the shear modulus, Pa.
    #[inline(always)]
    fn twice_shear(&self) -> S {
        self.young / (self.poisson + 1.0)
    }

    /// Moves on by a strain increment (xx, yy, twice xy); returns the work that became heat, J/m3, which with the
    /// elastic energies before and after makes up the mean stress times the strain.
    #[inline(always)]
    pub fn advance(&self, increment: &[S; 3], state: &mut PlaneState<S>) -> S {
        let twice_shear = self.twice_shear();
        let plate = self.young / (S::one() - self.poisson * self.poisson);
        let [x, y, xy] = state.stress;
        let trial = [
            plate.mul_add(self.poisson.mul_add(increment[1], increment[0]), x),
            plate.mul_add(self.poisson.mul_add(increment[0], increment[1]), y),
            (twice_shear * 0.5).mul_add(increment[2], xy),
        ];
        let (sum, difference) = (trial[0] + trial[1], trial[1] - trial[0]);
        let (mean, deviating) =
            (sum * sum * 0.25, (difference * difference * 0.25 + trial[2] * trial[2]) * 3.0);
        let yields = (mean + deviating).gt(state.yield_stress * state.yield_stress);
        if !yields.any() {
            state.stress = trial;
            return S::zero();
        }
        let flow = self.flow(mean, deviating, state, yields);
        let (a, b) = self.shrink(flow.amount);
        let (sum, difference) = (sum / a, difference / b);
        let after = [(sum - difference) * 0.5, (sum + difference) * 0.5, trial[2] / b];
        let after = [
            S::select(yields, after[0], trial[0]),
            S::select(yields, after[1], trial[1]),
            S::select(yields, after[2], trial[2]),
        ];
        // Plastic strains: the amount of flow times twice the deviator over three.
        let third = flow.amount * (1.0 / 3.0);
        let work = (x + after[0]) * third * (after[0] + after[0] - after[1])
            + (y + after[1]) * third * (after[1] + after[1] - after[0])
            + (xy + after[2]) * flow.amount * after[2] * 2.0;
        let plastic_strain = state.plastic_strain + flow.strain;
        let yield_stress = S::select(yields, self.hardening.at(plastic_strain).0, state.yield_stress);
        *state = PlaneState { stress: after, plastic_strain, yield_stress };
        S::select(yields, work * 0.5, S::zero())
    }

    /// Factors by which the mean and the deviating stress are divided.
    #[inline(always)]
    fn shrink(&self, amount: S) -> (S, S) {
        let mean = self.young / (S::one() - self.poisson) * (1.0 / 3.0);
        (amount * mean + 1.0, amount * self.twice_shear() + 1.0)
    }

    /// The flow that leads to the yield surface, zero in lanes that stay inside, from the squares of the trial
    /// stresses.
    #[inline(always)]
    fn flow(&self, mean: S, deviating: S, state: &PlaneState<S>, yields: S::Mask) -> Flow<S> {
        let zero = S::zero();
        let slopes = (self.young / (S::one() - self.poisson) * (1.0 / 3.0), self.twice_shear());
        let mut flow = Flow { amount: zero, strain: zero };
        let mut running = yields;
        for _ in 0..NEWTON {
            let (a, b) = self.shrink(flow.amount);
            let (first, second) = (mean / (a * a), deviating / (b * b));
            let mises = (first + second).sqrt();
            let slope = -(first * slopes.0 / a + second * slopes.1 / b) / mises;
            let strain = flow.amount * mises * (2.0 / 3.0);
            let strain_slope = (mises + flow.amount * slope) * (2.0 / 3.0);
            let (stress, hardening) = self.hardening.at(state.plastic_strain + strain);
            // Convex and falling: the steps rise to the root and never pass it.
            let error = mises - stress;
            let next = flow.amount - error / (slope - hardening * strain_slope);
            flow.amount = S::select(running, next, flow.amount);
            // Lanes that have arrived stay, so that none depends on its neighbours.
            running = running.and((state.yield_stress * CLOSE).lt(error.abs()));
            if !running.any() {
                break;
            }
        }
        let (a, b) = self.shrink(flow.amount);
        let mises = (mean / (a * a) + deviating / (b * b)).sqrt();
        flow.strain = S::select(yields, flow.amount * mises * (2.0 / 3.0), zero);
        flow
    }
}

/// Plastic flow in a step.
struct Flow<S> {
    /// Factor of the flow's direction, 1/Pa.
    amount: S,
    /// Equivalent plastic strain.
    strain: S,
}
