//! Stress and forces of a patch of fully integrated hexahedra in a step. The change of volume acts on an element as a
//! whole, apart from the stress at its points.

use super::element::{Forces, Hexahedron, POINTS};
use super::patch::FullPatch;
use crate::block::BLOCK;
use crate::element::patch::Ratios;
use crate::element::point::Point;
use crate::material::{Deformation, Points, StateVariables, StressStage, Symmetric, times};
use clubface_math::{Mat3, Pack, PackKernel, Real};

/// Deformation and stress at the points of a pack of elements.
pub struct ElementPoints<P> {
    /// Deformation gradients.
    pub gradients: [Mat3<P>; POINTS],
    /// Deformations.
    pub deformations: [Deformation<P>; POINTS],
    /// Second Piola-Kirchhoff stresses, Pa.
    pub stresses: [Symmetric<P>; POINTS],
    /// Shares of the reference volume, m3.
    pub volumes: [P; POINTS],
    /// Their sum.
    pub volume: P,
}

impl<P: Pack> ElementPoints<P> {
    /// The points before any element is loaded.
    #[inline(always)]
    pub fn empty() -> Self {
        let unit = Mat3::diagonal(P::one());
        Self {
            gradients: [unit; POINTS],
            deformations: [Deformation::new(unit); POINTS],
            stresses: [Symmetric::diagonal(P::zero()); POINTS],
            volumes: [P::zero(); POINTS],
            volume: P::zero(),
        }
    }
    /// Goes to the points of lanes `first..` of a block of constants.
    #[inline(always)]
    pub fn set(&mut self, element: &Hexahedron<P>, constants: &[P::Real], first: usize) {
        self.volume = P::zero();
        for point in 0..POINTS {
            let constants = Point::<P>::load(constants, first, point);
            self.gradients[point] = constants.gradient(element.base(point));
            self.deformations[point] = Deformation::new(self.gradients[point]);
            self.volumes[point] = constants.volume;
            self.volume += constants.volume;
        }
    }
    /// Computes the stresses of elements whose state variables begin with a lane, counted over all blocks; they move on
    /// by the step of the stage.
    #[inline(always)]
    pub fn compute(&mut self, stage: &dyn StressStage<P>, state: &mut StateVariables<P::Real>, lane: usize) {
        stage.stress(&mut Points {
            lane,
            step: BLOCK,
            state,
            deformations: &self.deformations,
            pressures: &[P::zero(); POINTS],
            weights: &[P::one(); POINTS],
            stresses: &mut self.stresses,
        });
    }
}

/// Computes forces.
pub struct AssembleForces<'a, R: Real> {
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
        for block in 0..patch.nodes.blocks() {
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
                patch.nodes.add_forces(block, first, &forces.corners());
            }
        }
        ratios.valid()
    }
}
