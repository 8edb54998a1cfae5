//! Forces of a patch of fully integrated hexahedra in a step.

use super::element::{Forces, Point, POINTS};
use super::patch::FullPatch;
use super::stress::ElementPoints;
use crate::block::BLOCK;
use crate::element::ratios::Ratios;
use crate::material::times;
use crate::mesh::CORNERS;
use clubface_math::{Pack, PackKernel, Real};

/// Computes forces.
pub struct AssembleForces<'a, R> {
    /// Whose elements they are, their positions loaded.
    pub patch: &'a mut FullPatch<R>,
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
        let mut points = ElementPoints::empty();
        for block in 0..patch.corners.len() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let element = patch.gather::<P>(block, first);
                points.set(&element, &patch.constants[block], first);
                points.compute(&*stage, &mut patch.state, block * POINTS * BLOCK + first);
                let mut forces = Forces::zero();
                for point in 0..POINTS {
                    let constants = Point::<P>::load(&patch.constants[block], first, point);
                    let stress = times(&points.gradients[point], &points.stresses[point]);
                    forces.add_stress(point, &constants, &stress);
                }
                let ratio = element.volume() / points.volume;
                ratios = ratios.and(ratio);
                let mut pressure = bulk * (ratio - 1.0);
                if let Some(viscosity) = &mut patch.viscosity {
                    pressure += viscosity.pressure(block * BLOCK + first, ratio, self.dt);
                }
                forces.add_pressure(&element, pressure);
                let forces = forces.corners();
                for corner in 0..CORNERS {
                    let places = &patch.corners[block][corner * BLOCK + first..];
                    // SAFETY: as in `FullPatch::gather`; `forces` is as long as `positions`.
                    unsafe { P::scatter_add(&mut patch.forces, places, forces[corner]) };
                }
            }
        }
        ratios.valid()
    }
}
