//! Stress and strain on the sides of a patch of shells.

use super::patch::{gather, ShellPatch};
use super::quadrilateral::Quadrilateral;
use super::response::Response;
use super::section::Section;
use crate::block::BLOCK;
use crate::element::output::{ElementOutput, OutputSink};
use crate::material::Numbers;
use clubface_math::{Pack, PackKernel, Real, Row};

/// Gives stress and strain of every element.
pub struct Output<'a, 'b, R> {
    /// Whose elements they are; the caller has checked that its rows exist.
    pub patch: &'a mut ShellPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// What takes them.
    pub sink: &'a mut OutputSink<'b>,
}

impl<R: Real> PackKernel<R> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let patch = self.patch;
        let response = Response::new(&patch.points, &patch.material);
        let elastic = patch.material.elastic.splat::<P>();
        let (plate, shear) = (elastic.plate(), elastic.shear());
        let states = patch.state.chunks_exact_mut(patch.state_length);
        for ((block, rows), state) in patch.rows.iter().enumerate().zip(states) {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = block * BLOCK + first;
                // SAFETY: the caller has checked the rows.
                let shape = Quadrilateral::<P>::new(&unsafe { gather(self.positions, rows, first) });
                let section = Section::new(elastic, plate, shear, P::load(&patch.thickness[at..]));
                let (sides, plastic) = response.sides(&section, &Numbers::new(state, first));
                let stress = sides.map(|[x, y, xy]| shape.turned_out([x, y, xy, P::zero()]));
                let strain = sides.map(|side| shape.turned_out(section.strain(&side)));
                for lane in 0..P::LANES.min(patch.elements.saturating_sub(at)) {
                    let (stress, strain) = (stress.each_ref(), strain.each_ref());
                    let found = ElementOutput::of(stress, strain, plastic, lane);
                    (self.sink)(patch.first + at + lane, &found);
                }
            }
        }
    }
}
