//! Energies of a patch of fully integrated hexahedra.

use super::element::{Point, POINTS};
use super::patch::FullPatch;
use crate::block::BLOCK;
use crate::element::patch::Energy;
use crate::material::{EnergyPoints, Kinematics, PointEnergy, Symmetric};
use clubface_math::{Pack, PackKernel, Real};

/// Adds up energies.
pub struct Energies<'a, R> {
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
        let mut c = [Symmetric::diagonal(P::one()); POINTS];
        let mut energies = [PointEnergy::zero(); POINTS];
        let mut energy = Energy::default();
        let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
        for block in 0..patch.corners.len() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let lanes = P::LANES.min(patch.elements.saturating_sub(block * BLOCK + first));
                let element = patch.gather::<P>(block, first);
                let [mut strain, mut viscous, mut plastic, mut volume] = [P::zero(); 4];
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    let at = Kinematics::new(element.gradient(point, &constants));
                    (c[point], volumes[point]) = (at.c, constants.volume);
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
