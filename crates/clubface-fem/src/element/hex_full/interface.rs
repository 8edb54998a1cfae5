//! What the solver asks of patches of fully integrated hexahedra: energies, and stress and strain as averages over
//! their points.

use super::element::POINTS;
use super::forces::{AssembleForces, ElementPoints};
use super::patch::FullPatch;
use crate::block::BLOCK;
use crate::element::bulk_viscosity::BulkViscosity;
use crate::element::output::{ElementOutput, OutputSink, logarithmic};
use crate::element::patch::{Energy, Patch};
use crate::element::point::{Point, reference_volume};
use crate::material::{EnergyPoints, Kinematics, PointEnergy, Symmetric};
use clubface_math::{Pack, PackKernel, Real, Row};

impl<R: Real> Patch<R> for FullPatch<R> {
    fn nodes(&self) -> &[u32] {
        self.nodes.nodes()
    }
    fn assemble(&mut self, positions: &[Row<R>], _velocities: &[Row<R>], dt: f64) {
        self.nodes.load(positions);
        self.nodes.clear_forces();
        self.volumes_valid = R::dispatch(AssembleForces { patch: self, dt });
    }
    fn volumes_valid(&self) -> bool {
        self.volumes_valid
    }
    fn set_bulk_viscosity(&mut self, coefficient: f64) {
        let volume = |at: usize| reference_volume(&self.constants[at / BLOCK], at % BLOCK);
        let size = f64::cbrt((0..self.nodes.elements).map(volume).sum::<f64>() / self.nodes.elements as f64);
        self.viscosity = Some(BulkViscosity::new(coefficient, &self.material, size, self.nodes.blocks()));
    }
    fn cost(&self) -> usize {
        self.nodes.elements * 230
    }
    fn forces(&self) -> &[Row<R>] {
        self.nodes.forces()
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.nodes.load(positions);
        R::dispatch(Energies { patch: self })
    }
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>) {
        self.nodes.load(positions);
        R::singly(Output { patch: self, sink });
    }
}

/// Adds up energies.
pub struct Energies<'a, R: Real> {
    /// Whose elements they are, their positions loaded.
    pub patch: &'a mut FullPatch<R>,
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Self::Output {
        let patch = self.patch;
        let stage = patch.material.stage::<P>(patch.updates.preview());
        let bulk = P::splat(patch.material.bulk);
        let mut volumes = [P::zero(); POINTS];
        let mut changes = [P::one(); POINTS];
        let mut c = [Symmetric::diagonal(P::one()); POINTS];
        let mut energies = [PointEnergy::zero(); POINTS];
        let mut energy = Energy::default();
        let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
        for block in 0..patch.nodes.blocks() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let lanes = patch.nodes.lanes::<P>(block, first);
                let element = patch.gather::<P>(block, first);
                let [mut strain, mut viscous, mut plastic, mut volume] = [P::zero(); 4];
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    let at = Kinematics::new(constants.gradient(element.base(point)));
                    (c[point], volumes[point]) = (at.c, constants.volume);
                    changes[point] = at.deformation.volume;
                    volume += constants.volume;
                    for lane in 0..lanes {
                        ratios.0 = ratios.0.min(at.deformation.volume.lane(lane));
                        ratios.1 = ratios.1.max(at.deformation.volume.lane(lane));
                    }
                }
                stage.energy(&mut EnergyPoints {
                    lane: block * POINTS * BLOCK + first,
                    step: BLOCK,
                    state: &mut patch.state,
                    c: &c,
                    volumes: &changes,
                    energies: &mut energies,
                });
                for point in 0..POINTS {
                    strain += energies[point].strain * volumes[point];
                    viscous += energies[point].viscous * volumes[point];
                    plastic += energies[point].plastic * volumes[point];
                }
                let dilation = element.volume() / volume - 1.0;
                strain += bulk * dilation * dilation * volume * 0.5;
                if let Some(viscosity) = &patch.viscosity {
                    viscous += viscosity.work::<P>(block * BLOCK + first) * volume;
                }
                for lane in 0..lanes {
                    energy.strain += strain.lane(lane);
                    energy.viscous += viscous.lane(lane);
                    energy.plastic += plastic.lane(lane);
                }
            }
        }
        (energy, ratios)
    }
}

/// Gives stress and strain of every element.
pub struct Output<'a, 'b, R: Real> {
    /// Whose elements they are, their positions loaded.
    pub patch: &'a mut FullPatch<R>,
    /// What takes them.
    pub sink: &'a mut OutputSink<'b>,
}

impl<R: Real> PackKernel<R> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let patch = self.patch;
        let stage = patch.material.stage::<P>(patch.updates.preview());
        let bulk = P::splat(patch.material.bulk);
        let mut points = ElementPoints::empty();
        for block in 0..patch.nodes.blocks() {
            // A copy: output changes nothing.
            let mut state = patch.state.copy(block * POINTS..(block + 1) * POINTS);
            for first in (0..BLOCK).step_by(P::LANES) {
                let element = patch.gather::<P>(block, first);
                points.set(&element, &patch.constants[block], first);
                points.compute(&*stage, &mut state, first);
                let mut plastic = P::zero();
                let [mut stress, mut strain] = [Symmetric::diagonal(P::zero()); 2];
                for point in 0..POINTS {
                    let (f, volume) = (&points.gradients[point], points.volumes[point]);
                    let at = Kinematics::from_deformation(points.deformations[point]);
                    let cauchy = points.stresses[point].scale(at.inverse_volume).seen_through(f);
                    stress = stress.plus(volume, &cauchy);
                    strain = strain.plus(volume, &logarithmic(f, &at));
                    let mut result = P::zero();
                    stage.plastic_strain(&mut state, point * BLOCK + first, &mut result);
                    plastic = plastic.max(result);
                }
                let share = points.volume.recip();
                let pressure = bulk * (element.volume() * share - 1.0);
                let (stress, strain) = (stress.scale(share).plus_diagonal(pressure), strain.scale(share));
                for index in 0..patch.nodes.lanes::<P>(block, first) {
                    let number = patch.nodes.first + block * BLOCK + first + index;
                    (self.sink)(
                        number,
                        &ElementOutput::from_lane([&stress; 2], [&strain; 2], plastic, index),
                    );
                }
            }
        }
    }
}
