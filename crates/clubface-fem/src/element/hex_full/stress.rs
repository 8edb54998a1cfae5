//! Stress at the eight points of packs of elements, without that of the change of volume, which is felt by the
//! element as a whole.

use super::element::{Hexahedron, Point, POINTS};
use crate::block::BLOCK;
use crate::material::{Deformation, Points, StateVariables, StressStage, Symmetric};
use clubface_math::{Mat3, Pack};

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
    /// Of no element yet.
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
            self.gradients[point] = element.gradient(point, &constants);
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
