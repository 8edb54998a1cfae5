//! Energies of a patch of one-point hexahedra, and stress and strain in its elements.

use super::constants::Constants;
use super::element::{Hexahedron, Visitor};
use super::patch::SolidPatch;
use super::stress::RUN;
use crate::block::BLOCK;
use crate::element::bulk_viscosity::BulkViscosity;
use crate::element::output::{ElementOutput, OutputSink, logarithmic};
use crate::element::patch::{Energy, Ratios};
use crate::material::{
    EnergyPoints, Kinematics, PointEnergy, Points, StateVariables, StressStage, Symmetric,
};
use clubface_math::{Pack, PackKernel, Real, Row};

/// Adds up energies.
pub struct Energies<'a, R: Real> {
    /// Whose elements they are; the caller has checked that its nodes exist.
    pub patch: &'a mut SolidPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// Whether the positions are those that the last forces were made at, which a lattice that moves its interior
    /// nodes has at hand.
    pub loaded: bool,
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Self::Output {
        let SolidPatch { material, arrangement, nodes, constants, state, updates, viscosity, .. } =
            self.patch;
        let stage = material.stage::<P>(updates.preview());
        let mut sum = EnergySum {
            stage: &*stage,
            bulk: P::splat(material.bulk),
            state,
            viscosity: viscosity.as_ref(),
            energies: [P::zero(); 4],
            ratios: Ratios::new(),
            count: 0,
            lane: 0,
            c: [Symmetric::diagonal(P::one()); RUN],
            volumes: [(P::zero(), P::one()); RUN],
        };
        // SAFETY: the caller has checked the nodes.
        unsafe { arrangement.visit(self.positions, nodes, constants, self.loaded, &mut sum) };
        sum.total()
    }
}

/// Energies and volumes of elements.
struct EnergySum<'a, P: Pack> {
    stage: &'a dyn StressStage<P>,
    /// Bulk modulus, Pa.
    bulk: P,
    /// State variables of all blocks.
    state: &'a mut StateVariables<P::Real>,
    /// Bulk viscosity, if there is any.
    viscosity: Option<&'a BulkViscosity<P::Real>>,
    /// Sums by lane, J: strain, hourglass, viscous and plastic energy.
    energies: [P; 4],
    /// Smallest and largest ratio of current to reference volume, by lane.
    ratios: Ratios<P>,
    /// The run: packs so far, first lane, `C̄`, reference volume and ratio of volumes.
    count: usize,
    lane: usize,
    c: [Symmetric<P>; RUN],
    volumes: [(P, P); RUN],
}

impl<P: Pack> EnergySum<'_, P> {
    /// Energies, J, and the smallest and largest ratio.
    #[inline(always)]
    fn total(self) -> (Energy, (f64, f64)) {
        let [strain, hourglass, viscous, plastic] =
            self.energies.map(|sum| (0..P::LANES).map(|lane| sum.lane(lane)).sum());
        (Energy { strain, hourglass, viscous, plastic }, self.ratios.range())
    }
}

impl<P: Pack> Visitor<P> for EnergySum<'_, P> {
    #[inline(always)]
    fn visit(&mut self, lane: usize, constants: &Constants<P::Real, false>, element: &Hexahedron<P>) {
        let kinematics = Kinematics::new(element.gradient(constants));
        let ratio = kinematics.deformation.volume;
        if self.count == 0 {
            self.lane = lane;
        }
        self.c[self.count] = kinematics.c;
        // Lanes without an element have no volume and no stiffness, and keep their shape.
        self.volumes[self.count] = (constants.volume(), ratio);
        self.count += 1;
        self.energies[1] += element.hourglass_energy(constants);
        self.ratios = self.ratios.and(ratio);
    }
    #[inline(always)]
    fn end_run(&mut self, step: usize) {
        let (lane, count) = (self.lane, std::mem::take(&mut self.count));
        let mut energies = [PointEnergy::zero(); RUN];
        let (c, energies) = (&self.c[..count], &mut energies[..count]);
        let volumes = &self.volumes.map(|(_, ratio)| ratio)[..count];
        self.stage.energy(&mut EnergyPoints { lane, step, state: self.state, c, volumes, energies });
        for i in 0..count {
            let (result, (reference, ratio)) = (energies[i], self.volumes[i]);
            let dilation = ratio - 1.0;
            let strain = result.strain + self.bulk * dilation * dilation * 0.5;
            let damped = self.viscosity.map_or(P::zero(), |viscosity| viscosity.work(lane + i * step));
            self.energies[0] += strain * reference;
            self.energies[2] += (result.viscous + damped) * reference;
            self.energies[3] += result.plastic * reference;
        }
    }
}

/// Gives stress and strain of every element.
pub struct Output<'a, 'b, R: Real> {
    /// Whose elements they are; the caller has checked that its nodes exist.
    pub patch: &'a mut SolidPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// What takes them.
    pub sink: &'a mut OutputSink<'b>,
}

impl<R: Real> PackKernel<R> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let SolidPatch { material, arrangement, nodes, constants, state, updates, numbers, .. } = self.patch;
        let stage = material.stage::<P>(updates.preview());
        let bulk = P::splat(material.bulk);
        let mut visitor = OutputOf { stage: &*stage, bulk, state, numbers, sink: self.sink };
        // SAFETY: the caller has checked the nodes.
        unsafe { arrangement.visit(self.positions, nodes, constants, false, &mut visitor) };
    }
}

/// Visits elements for it.
struct OutputOf<'a, 'b, P: Pack> {
    stage: &'a dyn StressStage<P>,
    /// Bulk modulus, Pa.
    bulk: P,
    /// State variables of all blocks.
    state: &'a StateVariables<P::Real>,
    /// Number of the element in every lane of the blocks, if there is one.
    numbers: &'a [Option<u32>],
    sink: &'a mut OutputSink<'b>,
}

impl<P: Pack> Visitor<P> for OutputOf<'_, '_, P> {
    #[inline(always)]
    fn visit(&mut self, lane: usize, constants: &Constants<P::Real, false>, element: &Hexahedron<P>) {
        let f = &element.gradient(constants);
        let at = Kinematics::new(*f);
        // A copy: output changes nothing.
        let (block, first) = (lane / BLOCK, lane % BLOCK);
        let mut state = self.state.copy(block..block + 1);
        let mut stresses = [Symmetric::diagonal(P::zero())];
        self.stage.stress(&mut Points {
            lane: first,
            step: 0,
            state: &mut state,
            deformations: &[at.deformation],
            pressures: &[self.bulk * (at.deformation.volume - 1.0)],
            // Cauchy's stress is F S F^T / J.
            weights: &[at.inverse_volume],
            stresses: &mut stresses,
        });
        let mut plastic = P::zero();
        self.stage.plastic_strain(&mut state, first, &mut plastic);
        let (stress, strain) = (stresses[0].seen_through(f), logarithmic(f, &at));
        for index in 0..P::LANES {
            let Some(number) = self.numbers[lane + index] else { continue };
            (self.sink)(
                number as usize,
                &ElementOutput::from_lane([&stress; 2], [&strain; 2], plastic, index),
            );
        }
    }
}
