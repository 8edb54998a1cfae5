//! What the solver asks of patches of shells: energies, and stress and strain on their sides.

use super::forces::AssembleForces;
use super::patch::{ShellPatch, gather};
use super::quadrilateral::{Across, Quadrilateral};
use super::response::Response;
use super::section::Section;
use crate::block::BLOCK;
use crate::element::output::{ElementOutput, OutputSink};
use crate::element::patch::{Energy, Patch};
use crate::material::Numbers;
use clubface_math::{Pack, PackKernel, Real, Row};

impl<R: Real> Patch<R> for ShellPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64) {
        self.check(positions);
        self.check(&velocities[self.behind..]);
        self.forces.fill(Row::zero());
        R::dispatch(AssembleForces { patch: self, positions, velocities, dt });
    }
    fn perturbed_forces(&mut self, positions: &[Row<R>], displacements: &[Row<R>]) {
        let state = self.state.clone();
        self.assemble(positions, displacements, 1.0);
        self.state = state;
    }
    fn cost(&self) -> usize {
        self.elements * (45 + 2 * self.points.len())
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.check(positions);
        R::dispatch(Energies { patch: self, positions })
    }
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>) {
        self.check(positions);
        R::singly(Output { patch: self, positions, sink });
    }
}

/// Energies, and smallest and largest ratio of areas.
pub type Found = (Energy, (f64, f64));

/// Adds up energies.
pub struct Energies<'a, R: Real> {
    /// Whose elements they are; the caller has checked that its rows exist.
    pub patch: &'a mut ShellPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = Found;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Found {
        let patch = self.patch;
        let response = Response::new(&patch.points, &patch.material);
        let elastic = patch.material.elastic.splat::<P>();
        let (plate, shear) = (elastic.plate(), elastic.shear());
        let mut energy = Energy::default();
        let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
        let states = patch.state.chunks_exact_mut(patch.state_length);
        for ((block, rows), state) in patch.rows.iter().enumerate().zip(states) {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = block * BLOCK + first;
                // SAFETY: the caller has checked the rows.
                let shape = Quadrilateral::<P>::new(&unsafe { gather(self.positions, rows, first) });
                let section = Section::new(elastic, plate, shear, patch.thickness[block].load::<P>(first));
                let hourglass = section.hourglass(shape.area, shape.aspect());
                let state = Numbers::new(state, first);
                let (strain, plastic) = response.energy(&section, shape.area, &state);
                let (shear, hourglass) = section.energy_across(&Across::load(&state), shape.area, &hourglass);
                let ratio = shape.area / P::load(&patch.areas[at..]);
                for lane in 0..P::LANES.min(patch.elements.saturating_sub(at)) {
                    energy.strain += (strain + shear).lane(lane);
                    energy.hourglass += hourglass.lane(lane);
                    energy.plastic += plastic.lane(lane);
                    ratios.0 = ratios.0.min(ratio.lane(lane));
                    ratios.1 = ratios.1.max(ratio.lane(lane));
                }
            }
        }
        (energy, ratios)
    }
}

/// Gives stress and strain of every element.
pub struct Output<'a, 'b, R: Real> {
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
                let section = Section::new(elastic, plate, shear, patch.thickness[block].load::<P>(first));
                let (sides, plastic) = response.sides(&section, &Numbers::new(state, first));
                let stress = sides.map(|[x, y, xy]| shape.turned_out([x, y, xy, P::zero()]));
                let strain = sides.map(|side| shape.turned_out(section.strain(&side)));
                for lane in 0..P::LANES.min(patch.elements.saturating_sub(at)) {
                    let (stress, strain) = (stress.each_ref(), strain.each_ref());
                    let result = ElementOutput::from_lane(stress, strain, plastic, lane);
                    (self.sink)(patch.first + at + lane, &result);
                }
            }
        }
    }
}
