//! What can be output of a patch of shells between steps: energies, stress and strain.

use super::gauge::{ElementOutput, OutputSink};
use super::layers::Layers;
use super::quadrilateral::{Across, Quadrilateral};
use super::section::{ElasticSection, Response, Section};
use super::shell::{gather, ShellPatch};
use super::{Energy, BLOCK};
use crate::material::Numbers;
use clubface_math::{Pack, PackKernel, Real, Row};

/// Energies, and smallest and largest ratio of areas.
pub type Found = (Energy, (f64, f64));

/// Adds up energies.
pub struct Energies<'a, R> {
    /// What is looked at; the caller has checked that its rows exist.
    pub patch: &'a mut ShellPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = Found;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(mut self) -> Found {
        if self.patch.points.is_empty() {
            return self.with::<P>(&ElasticSection);
        }
        let points = std::mem::take(&mut self.patch.points);
        let found = self.with::<P>(&Layers::new(&points, &self.patch.material));
        self.patch.points = points;
        found
    }
}

impl<R: Real> Energies<'_, R> {
    #[inline(always)]
    fn with<P: Pack<Real = R>>(&mut self, law: &impl Response<P>) -> Found {
        let patch = &mut *self.patch;
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
                let section = Section::new(elastic, plate, shear, P::load(&patch.thickness[at..]));
                let hourglass = section.hourglass(shape.area, shape.aspect());
                let state = Numbers::new(state, first);
                let (strain, plastic) = law.energy(&section, shape.area, &state);
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

/// Tells stress and strain.
pub struct Output<'a, 'b, R> {
    /// As of [`Energies`].
    pub patch: &'a mut ShellPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// Who is told.
    pub sink: &'a mut OutputSink<'b>,
}

impl<R: Real> PackKernel<R> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(mut self) {
        if self.patch.points.is_empty() {
            return self.with::<P>(&ElasticSection);
        }
        let points = std::mem::take(&mut self.patch.points);
        self.with::<P>(&Layers::new(&points, &self.patch.material));
        self.patch.points = points;
    }
}

impl<R: Real> Output<'_, '_, R> {
    #[inline(always)]
    fn with<P: Pack<Real = R>>(&mut self, law: &impl Response<P>) {
        let patch = &mut *self.patch;
        let elastic = patch.material.elastic.splat::<P>();
        let (plate, shear) = (elastic.plate(), elastic.shear());
        let states = patch.state.chunks_exact_mut(patch.state_length);
        for ((block, rows), state) in patch.rows.iter().enumerate().zip(states) {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = block * BLOCK + first;
                // SAFETY: the caller has checked the rows.
                let shape = Quadrilateral::<P>::new(&unsafe { gather(self.positions, rows, first) });
                let section = Section::new(elastic, plate, shear, P::load(&patch.thickness[at..]));
                let (sides, plastic) = law.sides(&section, &Numbers::new(state, first));
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
