//! What can be output of a patch of fully integrated hexahedra between steps: energies, stress and strain.

use super::full::{Point, POINTS};
use super::full_patch::FullPatch;
use super::gauge::{cauchy, logarithmic, ElementOutput, OutputSink};
use super::{Energy, BLOCK};
use crate::material::{InelasticLaw, Kinematics, Symmetric, UseInelastic};
use clubface_math::{Pack, PackKernel, Real};

/// Adds up energies.
pub struct Energies<'a, R> {
    /// What is looked at, its positions loaded.
    pub patch: &'a mut FullPatch<R>,
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Self::Output {
        let material = self.patch.material.clone();
        material.with_inelastic::<P, _>(self.patch.updates.preview(), self)
    }
}

impl<R: Real, P: Pack<Real = R>> UseInelastic<P> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn with<M: InelasticLaw<P>>(self, law: M) -> Self::Output {
        let patch = self.patch;
        let bulk = P::splat(patch.material.bulk);
        let mut energy = Energy::default();
        let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
        for block in 0..patch.corners.len() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let lanes = P::LANES.min(patch.elements.saturating_sub(block * BLOCK + first));
                let element = patch.gather::<P>(block, first);
                let [mut strain, mut viscous, mut plastic, mut volume] = [P::zero(); 4];
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    let f = element.gradient(point, &constants);
                    let at = Kinematics::new(f);
                    let found = law.energy(&at.c, &patch.state.of(block * POINTS + point, first));
                    strain += found.strain * constants.volume;
                    viscous += found.viscous * constants.volume;
                    plastic += found.plastic * constants.volume;
                    volume += constants.volume;
                    for lane in 0..lanes {
                        ratios.0 = ratios.0.min(at.deformation.volume.lane(lane));
                        ratios.1 = ratios.1.max(at.deformation.volume.lane(lane));
                    }
                }
                let dilation = element.volume() / volume - 1.0;
                strain += bulk * dilation * dilation * volume * 0.5;
                if let Some(viscosity) = &patch.viscosity {
                    viscous += viscosity.work::<P>(block, first) * volume;
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

/// Tells stress and strain.
pub struct Output<'a, 'b, R> {
    /// As of [`Energies`].
    pub patch: &'a mut FullPatch<R>,
    /// Who is told.
    pub sink: &'a mut OutputSink<'b>,
}

impl<R: Real> PackKernel<R> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let material = self.patch.material.clone();
        material.with_inelastic::<P, _>(self.patch.updates.preview(), self);
    }
}

impl<R: Real, P: Pack<Real = R>> UseInelastic<P> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn with<M: InelasticLaw<P>>(self, law: M) {
        let patch = self.patch;
        let bulk = P::splat(patch.material.bulk);
        for block in 0..patch.corners.len() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let element = patch.gather::<P>(block, first);
                // Averages over the points, by their shares of the volume.
                let [mut volume, mut plastic] = [P::zero(); 2];
                let [mut stress, mut strain] = [Symmetric::diagonal(P::zero()); 2];
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    let f = element.gradient(point, &constants);
                    let at = Kinematics::new(f);
                    // A copy: who looks changes nothing.
                    let mut state = patch.state.copy(block * POINTS + point);
                    let mut state = state.of(0, first);
                    let shape = law.advance(&at, &mut state);
                    stress = stress.plus(constants.volume, &cauchy(&f, &at, &shape, P::zero()));
                    strain = strain.plus(constants.volume, &logarithmic(&f, &at));
                    plastic = plastic.max(law.plastic_strain(&state));
                    volume += constants.volume;
                }
                let share = volume.recip();
                let pressure = bulk * (element.volume() * share - 1.0);
                let (stress, strain) = (stress.scale(share).plus_diagonal(pressure), strain.scale(share));
                for which in 0..P::LANES.min(patch.elements.saturating_sub(block * BLOCK + first)) {
                    let number = patch.first + block * BLOCK + first + which;
                    (self.sink)(number, &ElementOutput::of([&stress; 2], [&strain; 2], plastic, which));
                }
            }
        }
    }
}
