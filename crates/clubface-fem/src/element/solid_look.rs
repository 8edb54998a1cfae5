//! What can be seen of a patch of hexahedra between steps: energies, stress and strain.

use super::gauge::{Gauge, Tell};
use super::point::{Block, Look, Ratios, Tally};
use super::solid::{Layout, SolidPatch};
use super::Energy;
use crate::material::{Remembering, UseMemory};
use clubface_math::{Pack, PackKernel, Real, Row};

impl<R: Real> SolidPatch<R> {
    /// Shows every element to `look`.
    ///
    /// # Safety
    /// The nodes exist.
    #[inline(always)]
    unsafe fn visit<P: Pack<Real = R>>(
        layout: &mut Layout<R>,
        positions: &[Row<R>],
        nodes: &[u32],
        constants: &[Block<R>],
        at_hand: bool,
        look: &mut impl Look<P>,
    ) {
        match layout {
            // SAFETY: the caller's promise.
            Layout::Lattice(lattice) => unsafe { lattice.visit(positions, nodes, constants, at_hand, look) },
            Layout::Indexed(indexed) => indexed.visit(positions, nodes, constants, look),
        }
    }
}

/// Adds up energies.
pub struct Examine<'a, R> {
    /// What is looked at; the caller has checked that its nodes exist.
    pub patch: &'a mut SolidPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// Whether adopted nodes are looked at where they were met in the last step.
    pub at_hand: bool,
}

impl<R: Real> PackKernel<R> for Examine<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Self::Output {
        let material = self.patch.material.clone();
        material.with_memory::<P, _>(self.patch.clock.ahead(), self)
    }
}

impl<R: Real, P: Pack<Real = R>> UseMemory<P> for Examine<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn with<M: Remembering<P>>(self, law: M) -> Self::Output {
        let SolidPatch { material, layout, nodes, constants, history, viscosity, .. } = self.patch;
        let (bulk, viscosity) = (P::splat(material.bulk), viscosity.as_ref());
        let (energies, ratios) = ([P::zero(); 4], Ratios::new());
        let mut tally = Tally { law, bulk, history, viscosity, energies, ratios };
        // SAFETY: the caller has checked the nodes.
        unsafe { SolidPatch::visit(layout, self.positions, nodes, constants, self.at_hand, &mut tally) };
        tally.total()
    }
}

/// Tells stress and strain.
pub struct Feel<'a, 'b, R> {
    /// As of [`Examine`].
    pub patch: &'a mut SolidPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// Who is told.
    pub tell: &'a mut Tell<'b>,
}

impl<R: Real> PackKernel<R> for Feel<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let material = self.patch.material.clone();
        material.with_memory::<P, _>(self.patch.clock.ahead(), self);
    }
}

impl<R: Real, P: Pack<Real = R>> UseMemory<P> for Feel<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn with<M: Remembering<P>>(self, law: M) {
        let SolidPatch { material, layout, nodes, constants, history, numbers, .. } = self.patch;
        let bulk = P::splat(material.bulk);
        let mut gauge = Gauge { law, bulk, history, numbers, tell: self.tell };
        // SAFETY: as above.
        unsafe { SolidPatch::visit(layout, self.positions, nodes, constants, false, &mut gauge) };
    }
}
