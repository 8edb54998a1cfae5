//! An energy of the change of volume that a file writes down, U(J), such as `bulk/4*(J^2 - 1 - 2*log(J))`, in the place
//! of `bulk/2*(J - 1)^2`, with any law of the change of shape.
//!
//! Elements take the pressure `bulk (J - 1)` from the volume that they keep (which is that of the whole element where it
//! has many points). What the energy departs from it is added at the point itself, and vanishes for small changes.

use super::graph::{Graph, Id, MOST_PARTS};
use super::parse::{Names, Parsed, parse};
use super::program::{CHUNK, Program};
use crate::error::FemError;
use crate::material::description::Description;
use crate::material::family::{Law, Origin};
use crate::material::stage::{EnergyPoints, Points, Slot, StressStage};
use crate::material::state_variables::StateVariables;
use crate::material::step::MaterialStep;
use crate::material::table::{Number, Staged};
use clubface_math::{Computation, Pack, Real, Scalar};
use std::any::Any;
use std::cell::RefCell;
use std::sync::Arc;

/// Changes of volume at which the material must resist more of it: elements of a ball stay within them.
pub const VOLUMES: (f64, f64) = (0.8, 1.25);
/// Steps of the scan over them.
const STEPS: usize = 45;
/// What at rest is rounding, over the bulk modulus.
const ROUNDING: f64 = 1e-9;

/// An energy of the change of volume per unit reference volume, U(J), with the bulk modulus `bulk`.
#[derive(Clone, Debug)]
pub struct Volumetric {
    text: String,
    graph: Graph,
    whole: Id,
    slope: Id,
    curvature: Id,
    stress: Program<1>,
    energy: Program<1>,
}

impl Volumetric {
    /// Reads an energy and checks it.
    ///
    /// # Errors
    /// [`FemError::Input`] that says at which character what is wrong, or what it is not at rest.
    pub fn new(text: &str) -> Result<Self, FemError> {
        let Parsed { mut graph, whole, constants: _ } = parse(text, Names::Volume)?;
        let slope = graph.derivative(whole, 0);
        let curvature = graph.derivative(slope, 0);
        if graph.full() {
            let allowed =
                format!("with its derivatives it has more than {MOST_PARTS} parts; write it shorter");
            return Err(FemError::input("volumetric", format!("{text:?}"), allowed));
        }
        let (stress, energy) = (Program::new(&graph, [slope]), Program::new(&graph, [whole]));
        let read = Self { text: text.to_owned(), graph, whole, slope, curvature, stress, energy };
        read.check()?;
        Ok(read)
    }
    /// As it was written.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }
    /// U (J/m3), dU/dJ and its second derivative (Pa) at a ratio of volumes.
    pub fn evaluate<S: Scalar>(&self, bulk: S, ratio: S) -> [S; 3] {
        let values = self.graph.values(self.graph.parts().len() - 1, &[bulk], [ratio; 2]);
        [self.whole, self.slope, self.curvature].map(|part| values[part])
    }

    fn check(&self) -> Result<(), FemError> {
        let refused = |what: String, allowed: &str| {
            Err(FemError::input("volumetric", format!("{:?}{what}", self.text), allowed))
        };
        let [energy, slope, curvature] = self.evaluate(1.0, 1.0);
        if ![energy, slope, curvature].iter().all(|each| each.is_finite()) {
            return refused(
                String::new(),
                "it must be finite at rest, where J is 1, as must its derivatives",
            );
        }
        if energy.abs() > ROUNDING || slope.abs() > ROUNDING {
            let what = format!(", which is {energy:.6} bulk at rest with a pressure of {:.6} bulk", -slope);
            return refused(what, "it must be zero at rest, where J is 1, and without pressure");
        }
        if (curvature - 1.0).abs() > ROUNDING {
            let what = format!(" with a bulk modulus of {curvature:.6} bulk at rest");
            return refused(what, "it must be one whose second derivative at rest is bulk");
        }
        for step in 0..=STEPS {
            let ratio = VOLUMES.0 + (VOLUMES.1 - VOLUMES.0) * step as f64 / STEPS as f64;
            let [at, twice] = [1.0, 2.0].map(|bulk| self.evaluate(bulk, ratio));
            if !(at[2] > 0.0 && at[2].is_finite()) {
                let what = format!(", which loses its stiffness where J is {ratio:.3}");
                return refused(
                    what,
                    "it must be stiff from 0.8 to 1.25, with a second derivative above zero",
                );
            }
            if (twice[1] - 2.0 * at[1]).abs() > ROUNDING {
                return refused(String::new(), "it must be in proportion to bulk");
            }
        }
        Ok(())
    }
}

/// A law of the change of shape with an energy of the change of volume.
#[derive(Clone, Debug)]
pub struct VolumeLaw<R: Real> {
    law: Arc<dyn Law<R>>,
    volumetric: Arc<Volumetric>,
}

impl<R: Number> VolumeLaw<R> {
    /// A law with an energy.
    pub fn over(law: Arc<dyn Law<R>>, volumetric: &Arc<Volumetric>) -> Arc<dyn Law<R>> {
        Arc::new(Self { law, volumetric: Arc::clone(volumetric) })
    }
}

impl<R: Number> Law<R> for VolumeLaw<R> {
    fn origin(&self) -> Origin<'_> {
        self.law.origin()
    }
    fn volumetric(&self) -> Option<&Arc<Volumetric>> {
        Some(&self.volumetric)
    }
    fn description(&self) -> &'static Description {
        self.law.description()
    }
    fn state(&self) -> &[f64] {
        self.law.state()
    }
    fn constants(&self) -> &[R] {
        self.law.constants()
    }
    fn shear(&self) -> R {
        self.law.shear()
    }
    fn check(&self, name: &str) -> Result<(), FemError> {
        self.law.check(name)
    }
    fn stage(&self, step: &MaterialStep<R>, slot: &mut dyn Any) {
        R::stage(self, step, slot);
    }
}

impl<R: Number> Staged<R> for VolumeLaw<R> {
    fn boxed<P: Pack<Real = R>>(&self, step: &MaterialStep<R>) -> Box<dyn StressStage<P>> {
        let mut slot: Slot<P> = None;
        self.law.stage(step, &mut slot);
        let Some(shape) = slot else { unreachable!("a law fills the slot") };
        let Volumetric { graph, stress, energy, .. } = &*self.volumetric;
        let values = graph.values(graph.parts().len() - 1, &[step.bulk], [R::one(); 2]);
        Box::new(VolumeStage {
            shape,
            stress: RefCell::new(stress.registers(&stress.constants(&values))),
            energy: RefCell::new(energy.registers(&energy.constants(&values))),
            volumetric: Arc::clone(&self.volumetric),
            bulk: step.bulk,
        })
    }
}

/// The stage of the change of shape, and what the energy of the volume departs from that of the elements.
struct VolumeStage<P: Pack> {
    shape: Box<dyn StressStage<P>>,
    volumetric: Arc<Volumetric>,
    stress: RefCell<Vec<[P; CHUNK]>>,
    energy: RefCell<Vec<[P; CHUNK]>>,
    bulk: P::Real,
}

impl<P: Pack> StressStage<P> for VolumeStage<P> {
    fn stress(&self, points: &mut Points<P>) {
        P::outline(Stresses(self, points));
    }
    fn energy(&self, points: &mut EnergyPoints<P>) {
        self.shape.energy(points);
        P::outline(Energies(self, points));
    }
    fn plastic_strain(&self, state: &mut StateVariables<P::Real>, lane: usize, strain: &mut P) {
        self.shape.plastic_strain(state, lane, strain);
    }
}

/// Stresses with the pressure of the energy.
struct Stresses<'a, 'b, P: Pack>(&'a VolumeStage<P>, &'a mut Points<'b, P>);

impl<P: Pack> Computation for Stresses<'_, '_, P> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self(stage, points) = self;
        let (program, bulk) = (&stage.volumetric.stress, P::splat(stage.bulk));
        let registers = &mut *stage.stress.borrow_mut();
        let count = points.stresses.len();
        for first in (0..count).step_by(CHUNK) {
            let packs = CHUNK.min(count - first);
            for pack in 0..packs {
                registers[0][pack] = points.deformations[first + pack].volume;
            }
            program.run(registers, packs);
            let mut pressures = [P::zero(); CHUNK];
            for pack in 0..packs {
                let ratio = points.deformations[first + pack].volume;
                let departs = program.result(registers, 0, pack) - bulk * (ratio - 1.0);
                pressures[pack] = points.pressures[first + pack] + departs;
            }
            stage.shape.stress(&mut Points {
                lane: points.lane + first * points.step,
                step: points.step,
                state: points.state,
                deformations: &points.deformations[first..first + packs],
                pressures: &pressures[..packs],
                weights: &points.weights[first..first + packs],
                stresses: &mut points.stresses[first..first + packs],
            });
        }
    }
}

/// Energies with what that of the volume departs by.
struct Energies<'a, 'b, P: Pack>(&'a VolumeStage<P>, &'a mut EnergyPoints<'b, P>);

impl<P: Pack> Computation for Energies<'_, '_, P> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self(stage, points) = self;
        let (program, bulk) = (&stage.volumetric.energy, P::splat(stage.bulk));
        let registers = &mut *stage.energy.borrow_mut();
        for first in (0..points.c.len()).step_by(CHUNK) {
            let packs = CHUNK.min(points.c.len() - first);
            for pack in 0..packs {
                registers[0][pack] = points.volumes[first + pack];
            }
            program.run(registers, packs);
            for pack in 0..packs {
                let dilation = points.volumes[first + pack] - 1.0;
                let departs = program.result(registers, 0, pack) - bulk * dilation * dilation * 0.5;
                points.energies[first + pack].strain += departs;
            }
        }
    }
}
