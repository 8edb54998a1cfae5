//! What can be seen of a patch of shells between steps: energies, stress and strain.

use super::gauge::{Felt, Tell};
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
        let histories = patch.history.chunks_exact_mut(patch.history_length);
        for ((block, rows), history) in patch.rows.iter().enumerate().zip(histories) {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = block * BLOCK + first;
                // SAFETY: the caller has checked the rows.
                let shape = Quadrilateral::<P>::new(&unsafe { gather(self.positions, rows, first) });
                let section = Section::new(elastic, plate, shear, P::load(&patch.thickness[at..]));
                let hourglass = section.hourglass(shape.area, shape.aspect());
                let memory = Numbers::new(history, first);
                let (strain, plastic) = law.energy(&section, shape.area, &memory);
                let (shear, hourglass) =
                    section.energy_across(&Across::load(&memory), shape.area, &hourglass);
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
pub struct Feel<'a, 'b, R> {
    /// As of [`Energies`].
    pub patch: &'a mut ShellPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// Who is told.
    pub tell: &'a mut Tell<'b>,
}

impl<R: Real> PackKernel<R> for Feel<'_, '_, R> {
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

impl<R: Real> Feel<'_, '_, R> {
    #[inline(always)]
    fn with<P: Pack<Real = R>>(&mut self, law: &impl Response<P>) {
        let patch = &mut *self.patch;
        let elastic = patch.material.elastic.splat::<P>();
        let (plate, shear) = (elastic.plate(), elastic.shear());
        let histories = patch.history.chunks_exact_mut(patch.history_length);
        for ((block, rows), history) in patch.rows.iter().enumerate().zip(histories) {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = block * BLOCK + first;
                // SAFETY: the caller has checked the rows.
                let shape = Quadrilateral::<P>::new(&unsafe { gather(self.positions, rows, first) });
                let section = Section::new(elastic, plate, shear, P::load(&patch.thickness[at..]));
                let (sides, plastic) = law.sides(&section, &Numbers::new(history, first));
                let stress = sides.map(|[x, y, xy]| shape.turned_out([x, y, xy, P::zero()]));
                let strain = sides.map(|side| shape.turned_out(section.strain(&side)));
                for lane in 0..P::LANES.min(patch.elements.saturating_sub(at)) {
                    let (stress, strain) = (stress.each_ref(), strain.each_ref());
                    let felt = Felt::of(stress, strain, plastic, lane);
                    (self.tell)(patch.first + at + lane, &felt);
                }
            }
        }
    }
}
