//! Stress and strain in the elements of a patch of fully integrated hexahedra: averages over their points.

use super::element::POINTS;
use super::patch::FullPatch;
use super::stress::ElementPoints;
use crate::block::BLOCK;
use crate::element::output::{logarithmic, ElementOutput, OutputSink};
use crate::material::{Kinematics, Symmetric};
use clubface_math::{Pack, PackKernel, Real};

/// Gives stress and strain of every element.
pub struct Output<'a, 'b, R> {
    /// Whose elements they are, their positions loaded.
    pub patch: &'a mut FullPatch<R>,
    /// What takes them.
    pub sink: &'a mut OutputSink<'b>,
}

impl<R: Real> PackKernel<R> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let patch = self.patch;
        let stage = patch.material.stage::<P>(patch.updates.preview());
        let bulk = P::splat(patch.material.bulk);
        let mut points = ElementPoints::empty();
        for block in 0..patch.corners.len() {
            // A copy: output changes nothing.
            let mut state = patch.state.copy(block * POINTS..(block + 1) * POINTS);
            for first in (0..BLOCK).step_by(P::LANES) {
                let element = patch.gather::<P>(block, first);
                points.set(&element, &patch.constants[block], first);
                points.compute(&*stage, &mut state, first);
                let mut plastic = P::zero();
                let [mut stress, mut strain] = [Symmetric::diagonal(P::zero()); 2];
                for point in 0..POINTS {
                    let (f, volume) = (&points.gradients[point], points.volumes[point]);
                    let at = Kinematics::of(points.deformations[point]);
                    let cauchy = points.stresses[point].scale(at.inverse_volume).seen_through(f);
                    stress = stress.plus(volume, &cauchy);
                    strain = strain.plus(volume, &logarithmic(f, &at));
                    let mut found = P::zero();
                    stage.plastic_strain(&mut state, point * BLOCK + first, &mut found);
                    plastic = plastic.max(found);
                }
                let share = points.volume.recip();
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
