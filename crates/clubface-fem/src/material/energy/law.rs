//! An energy with its constants, as materials hold it, and its stage.

use super::Energy;
use super::program::CHUNK;
use crate::error::FemError;
use crate::material::deformation::Kinematics;
use crate::material::description::Description;
use crate::material::family::{Law, Origin};
use crate::material::law::InvariantKinematics;
use crate::material::stage::{Branching, EnergyPoints, PointEnergy, Points, StressStage};
use crate::material::state_variables::StateVariables;
use crate::material::step::MaterialStep;
use crate::material::symmetric::Symmetric;
use crate::material::table::{Number, Staged};
use crate::material::viscous::{add_branches, work};
use clubface_math::{Computation, Pack, Scalar};
use std::any::Any;
use std::cell::RefCell;
use std::sync::Arc;

/// What stands in the place of the description of a law of the table.
const DESCRIPTION: Description = Description {
    name: "energy",
    summary: "an energy of the file's own, W(I1, I2)",
    source: "the file",
    constants: &[],
    needed: 0,
    group: 1,
    listed: false,
    state: &[],
    cost: 36,
    example: &[],
};

/// An energy with its constants.
#[derive(Debug)]
pub struct EnergyLaw<R>(Arc<Prepared<R>>);

/// An energy, its constants, and what follows from these alone.
#[derive(Debug)]
struct Prepared<R> {
    energy: Arc<Energy>,
    constants: Vec<R>,
    /// What of the stress does not vary.
    stress: Vec<R>,
    /// What of the energy does not vary.
    strain: Vec<R>,
}

impl Energy {
    /// As a law of materials, with its constants (SI) in the order of [`Energy::constants`].
    ///
    /// # Errors
    /// [`FemError::Input`] for another number of constants.
    pub fn law<R: Number>(self: &Arc<Self>, constants: &[R]) -> Result<Arc<dyn Law<R>>, FemError> {
        if constants.len() != self.constants.len() {
            let names = if self.constants.is_empty() { "none".to_owned() } else { self.constants.join(", ") };
            let allowed = format!("the energy {:?} needs {names}", self.text);
            return Err(FemError::input("constants of the energy", constants.len(), allowed));
        }
        let values = self.graph.values(self.last(), constants, [R::from_f64(3.0); 2]);
        Ok(Arc::new(EnergyLaw(Arc::new(Prepared {
            constants: constants.to_vec(),
            stress: self.stress.constants(&values),
            strain: self.energy.constants(&values),
            energy: Arc::clone(self),
        }))))
    }
}

impl<R: Number> Law<R> for EnergyLaw<R> {
    fn origin(&self) -> Origin<'_> {
        Origin::Energy(&self.0.energy)
    }
    fn description(&self) -> &'static Description {
        const { &DESCRIPTION }
    }
    fn constants(&self) -> &[R] {
        &self.0.constants
    }
    fn shear(&self) -> R {
        self.0.energy.shear(&self.0.constants)
    }
    fn check(&self, name: &str) -> Result<(), FemError> {
        let values: Vec<f64> = self.0.constants.iter().map(|value| value.re()).collect();
        self.0.energy.check(&values, name)
    }
    fn stage(&self, step: &MaterialStep<R>, slot: &mut dyn Any) {
        R::stage(self, step, slot);
    }
}

impl<R: Number> Staged<R> for EnergyLaw<R> {
    fn boxed<P: Pack<Real = R>>(&self, step: &MaterialStep<R>) -> Box<dyn StressStage<P>> {
        Box::new(EnergyStage {
            law: Arc::clone(&self.0),
            registers: RefCell::new(self.0.energy.stress.registers(&self.0.stress)),
            branching: Branching::new(&step.branches),
        })
    }
}

/// The stage of an energy: registers of the program of its stress over packs.
struct EnergyStage<P: Pack> {
    law: Arc<Prepared<P::Real>>,
    registers: RefCell<Vec<[P; CHUNK]>>,
    branching: Branching<P>,
}

impl<P: Pack> StressStage<P> for EnergyStage<P> {
    fn stress(&self, points: &mut Points<P>) {
        if self.branching.is_empty() {
            P::outline(Stress(self, points));
        } else {
            P::outline(BranchedStress(self, points));
        }
    }
    fn energy(&self, points: &mut EnergyPoints<P>) {
        P::outline(Energies(self, points));
    }
    fn plastic_strain(&self, _: &mut StateVariables<P::Real>, _: usize, _: &mut P) {}
}

/// Stresses of an elastic material.
struct Stress<'a, 'b, P: Pack>(&'a EnergyStage<P>, &'a mut Points<'b, P>);

impl<P: Pack> Computation for Stress<'_, '_, P> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self(stage, points) = self;
        let program = &stage.law.energy.stress;
        let registers = &mut *stage.registers.borrow_mut();
        let count = points.stresses.len();
        for first in (0..count).step_by(CHUNK) {
            let packs = CHUNK.min(count - first);
            for pack in 0..packs {
                let at = InvariantKinematics::new(&points.deformations[first + pack]);
                (registers[0][pack], registers[1][pack]) = (at.first, at.second);
            }
            program.run(registers, packs);
            for pack in 0..packs {
                let factors = [0, 1].map(|result| program.result(registers, result, pack));
                let at = &points.deformations[first + pack];
                let (pressure, weight) = (points.pressures[first + pack], points.weights[first + pack]);
                points.stresses[first + pack] =
                    InvariantKinematics::new(at).second_piola(at, factors, pressure, weight);
            }
        }
    }
}

/// Stresses of a material with viscoelastic branches.
struct BranchedStress<'a, 'b, P: Pack>(&'a EnergyStage<P>, &'a mut Points<'b, P>);

impl<P: Pack> Computation for BranchedStress<'_, '_, P> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self(stage, points) = self;
        let program = &stage.law.energy.stress;
        let registers = &mut *stage.registers.borrow_mut();
        let count = points.stresses.len();
        for first in (0..count).step_by(CHUNK) {
            let packs = CHUNK.min(count - first);
            for pack in 0..packs {
                let at = Kinematics::from_deformation(points.deformations[first + pack]);
                (registers[0][pack], registers[1][pack]) = (at.c.trace(), at.inverse.trace());
            }
            program.run(registers, packs);
            for pack in 0..packs {
                let [one, along] = [0, 1].map(|result| program.result(registers, result, pack));
                let at = Kinematics::from_deformation(points.deformations[first + pack]);
                let elastic: Symmetric<P> = at.c.scale(along).plus_diagonal(one);
                let lane = points.lane + (first + pack) * points.step;
                let stress = add_branches(&at, elastic, &stage.branching.branches(), points.state, lane);
                let (pressure, weight) = (points.pressures[first + pack], points.weights[first + pack]);
                points.stresses[first + pack] = at.second_piola(&stress, pressure, weight);
            }
        }
    }
}

/// Energies.
struct Energies<'a, 'b, P: Pack>(&'a EnergyStage<P>, &'a mut EnergyPoints<'b, P>);

impl<P: Pack> Computation for Energies<'_, '_, P> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self(stage, points) = self;
        let Prepared { energy, strain, .. } = &*stage.law;
        let program = &energy.energy;
        let registers = &mut *program.registers::<P>(strain);
        for first in (0..points.c.len()).step_by(CHUNK) {
            let packs = CHUNK.min(points.c.len() - first);
            for pack in 0..packs {
                let c = &points.c[first + pack];
                (registers[0][pack], registers[1][pack]) = (c.trace(), c.second());
            }
            program.run(registers, packs);
            for pack in 0..packs {
                let lane = points.lane + (first + pack) * points.step;
                let viscous = if stage.branching.is_empty() { P::zero() } else { work(points.state, lane) };
                let strain = program.result(registers, 0, pack);
                points.energies[first + pack] = PointEnergy { strain, viscous, plastic: P::zero() };
            }
        }
    }
}

impl Energy {
    /// The last part of the graph that anybody asks for.
    pub(super) fn last(&self) -> usize {
        self.graph.parts().len() - 1
    }
    /// Shear modulus of small deformation, Pa: `2 (W1 + W2)` at rest.
    pub fn shear<S: Scalar>(&self, constants: &[S]) -> S {
        let values = self.graph.values(self.last(), constants, [S::from_f64(3.0); 2]);
        let [first, second] = self.slopes.map(|slope| values[slope]);
        (first + second) * 2.0
    }
}
