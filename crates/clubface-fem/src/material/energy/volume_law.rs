//! A law of the change of shape with an energy of the change of volume, and its stage.
//!
//! Elements take the pressure `bulk (J - 1)` from the volume that they keep (which is that of the whole element where it
//! has many points). What the energy departs from it is added at the point itself, and vanishes for small changes.

use super::program::CHUNK;
use super::volume::Volumetric;
use crate::error::FemError;
use crate::material::description::Description;
use crate::material::family::{Law, Origin};
use crate::material::stage::{EnergyPoints, Points, Slot, StressStage};
use crate::material::state_variables::StateVariables;
use crate::material::step::MaterialStep;
use crate::material::table::{Number, Staged};
use clubface_math::{Computation, Pack, Real};
use std::any::Any;
use std::cell::RefCell;
use std::sync::Arc;

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
