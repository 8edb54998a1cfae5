//! Metal after von Mises at finite strain: elastic in logarithmic strain (after Hencky) until it yields, then flowing
//! with its volume kept.
//!
//! The deformation is an elastic one after a plastic one. The state variables of the plastic one are its metric, the
//! inverse of its right Cauchy-Green tensor, of determinant one. In logarithmic strain the return to the yield
//! surface is that of small strains: the deviator shrinks by a factor (Weber and Anand, Comput. Methods Appl. Mech.
//! Eng. 79, 1990; Simo, ibid. 99, 1992). The elastic left Cauchy-Green tensor has the invariants of `C̄` times the
//! metric, and functions of it, pulled back to the undeformed shape, are combinations of the metric, of the metric
//! around `C̄`, and of `C̄^-1`: neither rotations nor principal axes are needed.

use super::hardening::{HARDENING_POINTS, Hardening};
use super::stretch::Stretches;
use super::{Constant, Description, Family, Inelastic, Law, Number, Numbers, Symmetric, WithState, build};
use crate::error::FemError;
use clubface_math::{Mask, Pack, Scalar};
use std::sync::Arc;

/// Error of the yield condition, over the yield stress, below which one more Newton step is exact to rounding.
const CLOSE: f64 = 1e-8;
/// Newton steps at most: linear hardening needs one.
const NEWTON: usize = 40;

/// A metal that yields.
#[derive(Clone, Copy, Debug)]
pub struct VonMises<S> {
    /// Shear modulus, Pa.
    pub shear: S,
    /// Yield stress.
    pub hardening: Hardening<S>,
}

/// State variables of a point.
#[derive(Clone, Copy, Debug)]
pub struct PlasticState<S> {
    /// Inverse of the right Cauchy-Green tensor of the plastic deformation.
    pub metric: Symmetric<S>,
    /// Equivalent plastic strain.
    pub plastic_strain: S,
    /// Von Mises' stress of the last step, over the undeformed volume, Pa.
    pub mises: S,
    /// Work that became heat, J/m3.
    pub heat: S,
}

impl<S: Scalar> PlasticState<S> {
    /// Numbers it takes.
    pub const LENGTH: usize = 9;

    /// Before any deformation.
    #[inline(always)]
    pub fn start() -> Self {
        let zero = S::zero();
        Self { metric: Symmetric::diagonal(S::one()), plastic_strain: zero, mises: zero, heat: zero }
    }
    /// As numbers.
    #[inline(always)]
    pub fn numbers(&self) -> [S; 9] {
        let [a, b, c, d, e, f] = self.metric.0;
        [a, b, c, d, e, f, self.plastic_strain, self.mises, self.heat]
    }
    /// From numbers.
    #[inline(always)]
    pub fn from_numbers([a, b, c, d, e, f, plastic_strain, mises, heat]: [S; 9]) -> Self {
        Self { metric: Symmetric([a, b, c, d, e, f]), plastic_strain, mises, heat }
    }
}

impl<R: Number> VonMises<R> {
    /// As a law of materials.
    pub fn law(&self) -> Arc<dyn Law<R>> {
        let constants: Vec<R> = [self.shear].into_iter().chain(self.hardening.constants()).collect();
        build::<VonMises<()>, R>(&constants)
    }
}

/// Stretches of the elastic deformation.
#[inline(always)]
fn elastic<S: Scalar>(c: &Symmetric<S>, metric: &Symmetric<S>) -> Stretches<S> {
    // Both determinants are one, so cofactors are inverses.
    Stretches::new(c.contract(metric), c.cofactors().contract(&metric.cofactors()))
}

impl<S: Scalar> VonMises<S> {
    /// `2 dW/dC̄` (Pa), but for a multiple of `C̄^-1`, at the `C̄` of the end of a step; the state moves on.
    #[inline(always)]
    pub fn advance(&self, c: &Symmetric<S>, state: &mut PlasticState<S>) -> Symmetric<S> {
        let around = c.sandwich(&state.metric);
        let stretches = elastic(c, &state.metric);
        // Twice the elastic strain; Kirchhoff's stress is the shear modulus times it.
        let logarithm = stretches.logarithm();
        let trial = (stretches.square_trace(&logarithm) * 1.5).safe_sqrt() * self.shear;
        let yields = trial.gt(self.hardening.at(state.plastic_strain).0);
        let mut share = S::one();
        let metric = state.metric;
        if yields.any() {
            let flow = self.flow(trial, state.plastic_strain, yields);
            share = S::select(yields, -(self.shear * 3.0 * flow / trial) + 1.0, share);
            let mises = trial * share;
            state.heat += (state.mises + mises) * flow * 0.5;
            state.plastic_strain += flow;
            // The elastic deformation that is left, as a power of the one tried.
            let left = stretches.exponential(&logarithm.scale(share), S::one());
            let [one, linear, square] = stretches.factors(&left);
            let after = metric.scale(linear).plus(square, &around).plus(one, &c.cofactors());
            for i in 0..6 {
                state.metric.0[i] = S::select(yields, after.0[i], metric.0[i]);
            }
        }
        state.mises = trial * share;
        let [_, linear, square] = stretches.factors(&logarithm);
        metric.scale(linear).plus(square, &around).scale(self.shear * share)
    }

    /// Elastic energy of shape, J/m3.
    #[inline(always)]
    pub fn stored(&self, c: &Symmetric<S>, state: &PlasticState<S>) -> S {
        let stretches = elastic(c, &state.metric);
        stretches.square_trace(&stretches.logarithm()) * self.shear * 0.25
    }

    /// Equivalent plastic strain of a step that leads to the yield surface, zero in lanes that stay inside.
    #[inline(always)]
    fn flow(&self, trial: S, strain: S, yields: S::Mask) -> S {
        let mut flow = S::zero();
        let mut running = yields;
        let slope = self.shear * 3.0;
        for _ in 0..NEWTON {
            let (stress, hardening) = self.hardening.at(strain + flow);
            let error = trial - slope * flow - stress;
            // Convex and falling: the steps rise to the root and never pass it.
            flow = S::select(running, flow + error / (slope + hardening), flow);
            // Lanes that have arrived stay, so that none depends on its neighbours.
            running = running.and((stress * CLOSE).lt(error.abs()));
            if !running.any() {
                break;
            }
        }
        flow
    }
}

impl<P: Pack> Inelastic<P> for VonMises<P> {
    #[inline(always)]
    fn update(&self, c: &Symmetric<P>, state: &mut Numbers<P::Real>) -> Symmetric<P> {
        let mut plastic = PlasticState::from_numbers(state.load(0));
        let stress = self.advance(c, &mut plastic);
        state.store(0, plastic.numbers());
        stress
    }
    #[inline(always)]
    fn energy(&self, c: &Symmetric<P>, state: &Numbers<P::Real>) -> [P; 2] {
        let state = PlasticState::from_numbers(state.load(0));
        [self.stored(c, &state), state.heat]
    }
    #[inline(always)]
    fn plastic_strain(&self, state: &Numbers<P::Real>) -> P {
        PlasticState::from_numbers(state.load(0)).plastic_strain
    }
}

const fn constant(
    name: &'static str,
    dimension: &'static str,
    least: f64,
    most: f64,
    meaning: &'static str,
) -> Constant {
    Constant { name, dimension, meaning, least, most }
}

/// Names of the bends of hardening, in turn the plastic strain from which on it counts and the change of slope.
const BENDS: [[&str; 2]; HARDENING_POINTS] = [
    ["strain1", "slope1"],
    ["strain2", "slope2"],
    ["strain3", "slope3"],
    ["strain4", "slope4"],
    ["strain5", "slope5"],
    ["strain6", "slope6"],
    ["strain7", "slope7"],
    ["strain8", "slope8"],
];

/// Constants: those of every metal, then of the bends.
const CONSTANTS: [Constant; 4 + 2 * HARDENING_POINTS] = {
    let rate = "Inverse of the plastic strain within which 63% of the gain are reached.";
    let mut all = [constant("rate", "dimensionless", 0.0, f64::MAX, rate); 4 + 2 * HARDENING_POINTS];
    all[0] = constant("shear", "pressure", 0.0, 1e13, "Shear modulus, Pa.");
    all[1] = constant("yield", "pressure", 0.0, f64::MAX, "Yield stress in tension, Pa.");
    all[2] = constant("gain", "pressure", 0.0, f64::MAX, "What hardening adds that saturates, Pa.");
    let mut i = 0;
    while i < HARDENING_POINTS {
        let [strain, slope] = BENDS[i];
        let begins = "Plastic strain from which on a change of slope counts.";
        all[4 + 2 * i] = constant(strain, "dimensionless", 0.0, f64::MAX, begins);
        let change = "Change of the slope of the yield stress, Pa.";
        all[5 + 2 * i] = constant(slope, "pressure", f64::MIN, f64::MAX, change);
        i += 1;
    }
    all
};

impl Family for VonMises<()> {
    const DESCRIPTION: Description = Description {
        name: "von-mises",
        summary: "metal, linear in logarithmic strain until it yields",
        source: "J. C. Simo, Comput. Methods Appl. Mech. Eng. 99, 1992",
        constants: &CONSTANTS,
        needed: 4,
        group: 2,
        listed: false,
        state: &[1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        cost: 39,
        example: &[10e6, 0.2e6, 0.1e6, 5.0, 0.0, 1e6],
    };
    type Over<P: Pack> = WithState<VonMises<P>>;
    #[inline(always)]
    fn over<P: Pack>(constants: &[P]) -> Self::Over<P> {
        WithState(VonMises { shear: constants[0], hardening: Hardening::from_slice(&constants[1..]) })
    }
    fn shear<S: Scalar>(constants: &[S]) -> S {
        constants[0]
    }
    fn check(constants: &[f64], name: &str) -> Result<(), FemError> {
        Hardening::from_slice(&constants[1..]).check(name)
    }
}

const _: () = assert!(PlasticState::<f64>::LENGTH == <VonMises<()> as Family>::DESCRIPTION.state.len());
