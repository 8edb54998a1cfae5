//! What the solver asks of patches of tetrahedra: energies, and stress and strain as averages over their points.

use super::element::{POINTS, base_at_points};
use super::forces::AssembleForces;
use super::patch::TetrahedronPatch;
use crate::block::BLOCK;
use crate::element::bulk_viscosity::BulkViscosity;
use crate::element::output::{ElementOutput, OutputSink, logarithmic};
use crate::element::patch::{Energy, Patch, Ratios};
use crate::element::point::{Point, reference_volume};
use crate::material::{EnergyPoints, Kinematics, PointEnergy, Points, Symmetric};
use clubface_math::{Mat3, Pack, PackKernel, Real, Row};

impl<R: Real> Patch<R> for TetrahedronPatch<R> {
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
        let count = self.nodes.elements;
        // A wave crosses a tetrahedron from a corner to the middle of an edge.
        let size = 0.5 * f64::cbrt((0..count).map(volume).sum::<f64>() / count as f64);
        let blocks = self.nodes.blocks() * POINTS;
        self.viscosity = Some(BulkViscosity::new(coefficient, &self.material, size, blocks));
    }
    fn cost(&self) -> usize {
        self.nodes.elements * 150
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
struct Energies<'a, R: Real> {
    patch: &'a mut TetrahedronPatch<R>,
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Self::Output {
        let patch = self.patch;
        let stage = patch.material.stage::<P>(patch.updates.preview());
        let bulk = P::splat(patch.material.bulk);
        let mut c = [Symmetric::diagonal(P::one()); POINTS];
        let mut energies = [PointEnergy::zero(); POINTS];
        let [mut ratios, mut volumes] = [[P::one(); POINTS]; 2];
        let (mut energy, mut range) = (Energy::default(), Ratios::new());
        for block in 0..patch.nodes.blocks() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let base = base_at_points(&patch.nodes.gather::<P>(block, first));
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    let at = Kinematics::new(constants.gradient(base[point]));
                    (c[point], ratios[point], volumes[point]) =
                        (at.c, at.deformation.volume, constants.volume);
                    range = range.and(ratios[point]);
                }
                let lane = block * POINTS * BLOCK + first;
                stage.energy(&mut EnergyPoints {
                    lane,
                    step: BLOCK,
                    state: &mut patch.state,
                    c: &c,
                    volumes: &ratios,
                    energies: &mut energies,
                });
                let [mut strain, mut viscous, mut plastic] = [P::zero(); 3];
                for point in 0..POINTS {
                    let (dilation, volume) = (ratios[point] - 1.0, volumes[point]);
                    strain += (energies[point].strain + bulk * dilation * dilation * 0.5) * volume;
                    viscous += energies[point].viscous * volume;
                    plastic += energies[point].plastic * volume;
                    if let Some(viscosity) = &patch.viscosity {
                        viscous += viscosity.work::<P>(lane + point * BLOCK) * volume;
                    }
                }
                for index in 0..patch.nodes.lanes::<P>(block, first) {
                    energy.strain += strain.lane(index);
                    energy.viscous += viscous.lane(index);
                    energy.plastic += plastic.lane(index);
                }
            }
        }
        (energy, range.range())
    }
}

/// Gives stress and strain of every element.
struct Output<'a, 'b, R: Real> {
    patch: &'a mut TetrahedronPatch<R>,
    sink: &'a mut OutputSink<'b>,
}

impl<R: Real> PackKernel<R> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let patch = self.patch;
        let stage = patch.material.stage::<P>(patch.updates.preview());
        let bulk = P::splat(patch.material.bulk);
        let unit = Mat3::diagonal(P::one());
        let mut gradients = [unit; POINTS];
        let mut at = [Kinematics::new(unit); POINTS];
        let mut stresses = [Symmetric::diagonal(P::zero()); POINTS];
        let mut volumes = [P::zero(); POINTS];
        for block in 0..patch.nodes.blocks() {
            // A copy: output changes nothing.
            let mut state = patch.state.copy(block * POINTS..(block + 1) * POINTS);
            for first in (0..BLOCK).step_by(P::LANES) {
                let base = base_at_points(&patch.nodes.gather::<P>(block, first));
                let mut whole = P::zero();
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    gradients[point] = constants.gradient(base[point]);
                    at[point] = Kinematics::new(gradients[point]);
                    volumes[point] = constants.volume;
                    whole += constants.volume;
                }
                stage.stress(&mut Points {
                    lane: first,
                    step: BLOCK,
                    state: &mut state,
                    deformations: &at.map(|at| at.deformation),
                    pressures: &at.map(|at| bulk * (at.deformation.volume - 1.0)),
                    weights: &[P::one(); POINTS],
                    stresses: &mut stresses,
                });
                let [mut stress, mut strain] = [Symmetric::diagonal(P::zero()); 2];
                let mut plastic = P::zero();
                for point in 0..POINTS {
                    let (f, share) = (&gradients[point], volumes[point] / whole);
                    let cauchy = stresses[point].scale(at[point].inverse_volume).seen_through(f);
                    stress = stress.plus(share, &cauchy);
                    strain = strain.plus(share, &logarithmic(f, &at[point]));
                    let mut result = P::zero();
                    stage.plastic_strain(&mut state, point * BLOCK + first, &mut result);
                    plastic = plastic.max(result);
                }
                for index in 0..patch.nodes.lanes::<P>(block, first) {
                    let number = patch.offset + patch.nodes.first + block * BLOCK + first + index;
                    (self.sink)(
                        number,
                        &ElementOutput::from_lane([&stress; 2], [&strain; 2], plastic, index),
                    );
                }
            }
        }
    }
}
