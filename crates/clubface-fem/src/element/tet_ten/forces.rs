//! Stress and forces of a patch of tetrahedra in a step.

use super::element::{Forces, POINTS, base_at_points};
use super::patch::TetrahedronPatch;
use crate::block::BLOCK;
use crate::element::patch::Ratios;
use crate::element::point::Point;
use crate::material::{Deformation, Points, Symmetric, times};
use clubface_math::{Mat3, Pack, PackKernel, Real};

/// Computes forces.
pub struct AssembleForces<'a, R: Real> {
    /// Whose elements they are, their positions loaded.
    pub patch: &'a mut TetrahedronPatch<R>,
    /// The step by which state variables move on, s.
    pub dt: f64,
}

impl<R: Real> PackKernel<R> for AssembleForces<'_, R> {
    type Output = bool;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> bool {
        let mut ratios = Ratios::new();
        let patch = self.patch;
        let stage = patch.material.stage::<P>(patch.updates.next(self.dt));
        let bulk = P::splat(patch.material.bulk);
        let unit = Mat3::diagonal(P::one());
        let mut gradients = [unit; POINTS];
        let mut deformations = [Deformation::new(unit); POINTS];
        let mut stresses = [Symmetric::diagonal(P::zero()); POINTS];
        let [mut pressures, mut volumes] = [[P::zero(); POINTS]; 2];
        for block in 0..patch.nodes.blocks() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let base = base_at_points(&patch.nodes.gather::<P>(block, first));
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    gradients[point] = constants.gradient(base[point]);
                    deformations[point] = Deformation::new(gradients[point]);
                    volumes[point] = constants.volume;
                    let ratio = deformations[point].volume;
                    ratios = ratios.and(ratio);
                    pressures[point] = bulk * (ratio - 1.0);
                    if let Some(viscosity) = &mut patch.viscosity {
                        let lane = (block * POINTS + point) * BLOCK + first;
                        pressures[point] += viscosity.pressure(lane, ratio, self.dt);
                    }
                }
                stage.stress(&mut Points {
                    lane: block * POINTS * BLOCK + first,
                    step: BLOCK,
                    state: &mut patch.state,
                    deformations: &deformations,
                    pressures: &pressures,
                    weights: &volumes,
                    stresses: &mut stresses,
                });
                let mut forces = Forces::zero();
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    forces.add_stress(point, &constants, &times(&gradients[point], &stresses[point]));
                }
                patch.nodes.add_forces(block, first, &forces.nodes());
            }
        }
        ratios.valid()
    }
}
