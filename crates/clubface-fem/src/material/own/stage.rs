//! The stage of a function of C: its points are taken out of packs, and put back.

use super::function::{ENERGY, SHAPES};
use super::law::OwnLaw;
use super::number::Points;
use crate::material::deformation::Kinematics;
use crate::material::stage::{Branching, EnergyPoints, PointEnergy, Points as PackPoints, StressStage};
use crate::material::state_variables::StateVariables;
use crate::material::step::MaterialStep;
use crate::material::symmetric::Symmetric;
use crate::material::table::{Number, Staged};
use crate::material::viscous::{add_branches, work};
use clubface_math::{Computation, Pack};
use std::cell::RefCell;

/// Most packs of a call: as many as an element of eight points has.
const CHUNK: usize = 8;

impl<R: Number> Staged<R> for OwnLaw<R> {
    fn boxed<P: Pack<Real = R>>(&self, step: &MaterialStep<R>) -> Box<dyn StressStage<P>> {
        Box::new(OwnStage {
            law: self.clone(),
            step: step.time,
            points: RefCell::new(Points { count: 0, shapes: vec![], states: vec![], results: vec![] }),
            branching: Branching::new(&step.branches),
        })
    }
}

struct OwnStage<P: Pack> {
    law: OwnLaw<P::Real>,
    step: f64,
    points: RefCell<Points<P::Real>>,
    branching: Branching<P>,
}

impl<P: Pack<Real: Number>> StressStage<P> for OwnStage<P> {
    fn stress(&self, points: &mut PackPoints<P>) {
        P::outline(Stress(self, points));
    }
    fn energy(&self, points: &mut EnergyPoints<P>) {
        P::outline(Energies(self, points));
    }
    fn plastic_strain(&self, _: &mut StateVariables<P::Real>, _: usize, _: &mut P) {}
}

impl<P: Pack<Real: Number>> OwnStage<P> {
    /// Calls the function for some packs with their state variables, which begin at a lane, each pack `step` lanes
    /// further than the last.
    #[inline(always)]
    fn call(
        &self,
        packs: usize,
        shape: impl Fn(usize) -> Symmetric<P>,
        state: &mut StateVariables<P::Real>,
        (lane, step): (usize, usize),
        time: f64,
    ) {
        let points = &mut *self.points.borrow_mut();
        let (count, states) = (packs * P::LANES, self.law.function.states.len());
        points.resize(count, states, <P::Real as clubface_math::Scalar>::zero());
        for pack in 0..packs {
            let shape = shape(pack);
            for row in 0..SHAPES {
                shape.0[row].store(&mut points.shapes[row * count + pack * P::LANES..]);
            }
            if states > 0 {
                let numbers = state.every_step(lane + pack * step);
                for row in 0..states {
                    let [number]: [P; 1] = numbers.load(row);
                    number.store(&mut points.states[row * count + pack * P::LANES..]);
                }
            }
        }
        Number::call(points, &self.law.function, &self.law.constants, time);
    }
    /// A row of the results, of a pack.
    #[inline(always)]
    fn result(&self, row: usize, pack: usize) -> P {
        let points = self.points.borrow();
        P::load(&points.results[row * points.count + pack * P::LANES..])
    }
}

/// Stresses.
struct Stress<'a, 'b, P: Pack>(&'a OwnStage<P>, &'a mut PackPoints<'b, P>);

impl<P: Pack<Real: Number>> Computation for Stress<'_, '_, P> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self(stage, points) = self;
        let states = stage.law.function.states.len();
        for first in (0..points.stresses.len()).step_by(CHUNK) {
            let packs = CHUNK.min(points.stresses.len() - first);
            let lane = points.lane + first * points.step;
            let deformations = &points.deformations[first..first + packs];
            let shape = |pack: usize| Kinematics::from_deformation(deformations[pack]).c;
            stage.call(packs, shape, points.state, (lane, points.step), stage.step);
            for pack in 0..packs {
                let at = Kinematics::from_deformation(deformations[pack]);
                let lane = lane + pack * points.step;
                let mut stress = Symmetric(std::array::from_fn(|row| stage.result(row, pack)));
                if states > 0 {
                    let called = stage.points.borrow();
                    let mut numbers = points.state.every_step(lane);
                    for row in 0..states {
                        let number = P::load(&called.states[row * called.count + pack * P::LANES..]);
                        numbers.store(row, [number]);
                    }
                }
                if !stage.branching.is_empty() {
                    stress = add_branches(&at, stress, &stage.branching.branches(), points.state, lane);
                }
                let (pressure, weight) = (points.pressures[first + pack], points.weights[first + pack]);
                points.stresses[first + pack] = at.second_piola(&stress, pressure, weight);
            }
        }
    }
}

/// Energies, in no time: nothing moves on.
struct Energies<'a, 'b, P: Pack>(&'a OwnStage<P>, &'a mut EnergyPoints<'b, P>);

impl<P: Pack<Real: Number>> Computation for Energies<'_, '_, P> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self(stage, points) = self;
        for first in (0..points.c.len()).step_by(CHUNK) {
            let packs = CHUNK.min(points.c.len() - first);
            let lane = points.lane + first * points.step;
            let shapes = &points.c[first..first + packs];
            stage.call(packs, |pack| shapes[pack], points.state, (lane, points.step), 0.0);
            for pack in 0..packs {
                let [strain, plastic] = [ENERGY, ENERGY + 1].map(|row| stage.result(row, pack));
                let at = lane + pack * points.step;
                let viscous = if stage.branching.is_empty() { P::zero() } else { work(points.state, at) };
                points.energies[first + pack] = PointEnergy { strain, viscous, plastic };
            }
        }
    }
}
