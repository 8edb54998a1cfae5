//! Energies of a patch of fully integrated hexahedra.

use super::element::POINTS;
use super::patch::FullPatch;
use super::stress::ElementPoints;
use crate::block::BLOCK;
use crate::element::patch::Energy;
use crate::material::{Kinematics, PointEnergy};
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
        let mut points = ElementPoints::empty();
        let mut energy = Energy::default();
        let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
        for block in 0..patch.corners.len() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let lanes = P::LANES.min(patch.elements.saturating_sub(block * BLOCK + first));
                let element = patch.gather::<P>(block, first);
                points.set(&element, &patch.constants[block], first);
                let [mut strain, mut viscous, mut plastic] = [P::zero(); 3];
                for point in 0..POINTS {
                    let c = Kinematics::of(points.deformations[point]).c;
                    let nothing = P::zero();
                    let mut found = PointEnergy { strain: nothing, viscous: nothing, plastic: nothing };
                    stage.energy(&c, &mut patch.state, block * POINTS + point, first, &mut found);
                    strain += found.strain * points.volumes[point];
                    viscous += found.viscous * points.volumes[point];
                    plastic += found.plastic * points.volumes[point];
                    for lane in 0..lanes {
                        ratios.0 = ratios.0.min(points.deformations[point].volume.lane(lane));
                        ratios.1 = ratios.1.max(points.deformations[point].volume.lane(lane));
                    }
                }
                let dilation = element.volume() / points.volume - 1.0;
                strain += bulk * dilation * dilation * points.volume * 0.5;
                if let Some(viscosity) = &patch.viscosity {
                    viscous += viscosity.work::<P>(block, first) * points.volume;
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
