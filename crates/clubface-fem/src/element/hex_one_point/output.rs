//! Stress and strain in the elements of a patch of one-point hexahedra.

use super::constants::Constants;
use super::element::Hexahedron;
use super::patch::SolidPatch;
use super::visitor::Visitor;
use crate::block::BLOCK;
use crate::element::output::{logarithmic, ElementOutput, OutputSink};
use crate::material::{Kinematics, Points, StateVariables, StressStage, Symmetric};
use clubface_math::{Pack, PackKernel, Real, Row};

/// Gives stress and strain of every element.
pub struct Output<'a, 'b, R> {
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
    fn visit(&mut self, lane: usize, constants: &Constants<P>, element: &Hexahedron<P>) {
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
        for which in 0..P::LANES {
            let Some(number) = self.numbers[lane + which] else { continue };
            (self.sink)(number as usize, &ElementOutput::of([&stress; 2], [&strain; 2], plastic, which));
        }
    }
}
