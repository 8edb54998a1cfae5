//! Forces of a patch of shells in a step.

use super::modes::CORNERS;
use super::patch::{ShellPatch, gather};
use super::quadrilateral::{Across, Quadrilateral, Resultants};
use super::response::Response;
use super::section::{ElasticSection, Section, SectionResponse};
use crate::block::BLOCK;
use crate::material::Numbers;
use clubface_math::pack::prefetch;
use clubface_math::{Pack, PackKernel, Real, Row, Vec3};

/// Adds vectors to the corners of `LANES` elements of a block.
#[inline(always)]
fn scatter<P: Pack>(
    rows: &mut [Row<P::Real>],
    corners: &[u32; CORNERS * BLOCK],
    first: usize,
    values: &[Vec3<P>; CORNERS],
) {
    for corner in 0..CORNERS {
        // SAFETY: `ShellPatch::new` makes every entry a place in the first half of `nodes`; all callers pass that
        // many rows.
        unsafe { P::scatter_add(rows, &corners[corner * BLOCK + first..], values[corner]) };
    }
}

/// Computes forces.
pub struct AssembleForces<'a, R: Real> {
    /// Whose elements they are; the caller has checked that its rows exist.
    pub patch: &'a mut ShellPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// Velocities of all nodes, m/s or rad/s.
    pub velocities: &'a [Row<R>],
    /// The step by which state variables move on, s.
    pub dt: f64,
}

impl<R: Real> PackKernel<R> for AssembleForces<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(mut self) {
        // Chosen once for all elements: most sections are elastic, and the loop over points is large.
        let points = std::mem::take(&mut self.patch.points);
        match Response::<P>::new(&points, &self.patch.material) {
            Response::Elastic => self.assemble::<P>(&ElasticSection),
            Response::Points(layers) => self.assemble::<P>(&layers),
        }
        self.patch.points = points;
    }
}

impl<R: Real> AssembleForces<'_, R> {
    #[inline(always)]
    fn assemble<P: Pack<Real = R>>(&mut self, response: &impl SectionResponse<P>) {
        let patch = &mut *self.patch;
        let elastic = patch.material.elastic.splat::<P>();
        let (plate, shear) = (elastic.plate(), elastic.shear());
        let spins = &self.velocities[patch.behind..];
        let (forces, moments) = patch.forces.split_at_mut(patch.nodes.len() / 2);
        let length = patch.state_length;
        let states = patch.state.chunks_exact_mut(length);
        for ((block, rows), state) in patch.rows.iter().enumerate().zip(states) {
            // An element computes long enough for what the next ones need to come from afar. Plain numbers are so few
            // that most of them are at hand.
            if R::PARTS > 1 {
                state.iter().for_each(|number| prefetch(number, length));
                for &row in patch.rows.get(block + 1).unwrap_or(rows) {
                    let fields = [self.positions, self.velocities, spins];
                    fields.iter().for_each(|field| prefetch(field.as_ptr(), row as usize));
                }
            }
            for first in (0..BLOCK).step_by(P::LANES) {
                // SAFETY: the caller has checked the rows.
                let (places, velocities, spins) = unsafe {
                    (
                        gather(self.positions, rows, first),
                        gather(self.velocities, rows, first),
                        gather(spins, rows, first),
                    )
                };
                let shape = Quadrilateral::<P>::new(&places);
                let increment = shape.increment(&velocities, &spins, self.dt);
                let thickness = patch.thickness[block].load(first);
                let section = Section::new(elastic, plate, shear, thickness);
                let hourglass = section.hourglass(shape.area, shape.aspect());
                let mut state = Numbers::new(state, first);
                let mut across = Across::load(&state);
                section.respond_across(&increment, &hourglass, &mut across);
                across.store(&mut state);
                let [membrane, bending] = response.respond(&section, &increment, shape.area, &mut state);
                let (force, moment) = shape.forces(&Resultants { membrane, bending, across });
                scatter(forces, &patch.corners[block], first, &force);
                scatter(moments, &patch.corners[block], first, &moment);
            }
        }
    }
}
