//! What can be output of a patch of hexahedra between steps: energies, stress and strain.

use super::gauge::{OutputSink, OutputVisitor};
use super::point::{Block, EnergyVisitor, Ratios, Visitor};
use super::solid::{Layout, SolidPatch};
use super::Energy;
use crate::material::{InelasticLaw, UseInelastic};
use clubface_math::{Pack, PackKernel, Real, Row};

impl<R: Real> SolidPatch<R> {
    /// Shows every element to `visitor`.
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
        visitor: &mut impl Visitor<P>,
    ) {
        match layout {
            // SAFETY: the caller's promise.
            Layout::Lattice(lattice) => unsafe {
                lattice.visit(positions, nodes, constants, at_hand, visitor)
            },
            Layout::Indexed(indexed) => indexed.visit(positions, nodes, constants, visitor),
        }
    }
}

/// Adds up energies.
pub struct Energies<'a, R> {
    /// What is looked at; the caller has checked that its nodes exist.
    pub patch: &'a mut SolidPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// Whether interior nodes are looked at where they were met in the last step.
    pub at_hand: bool,
}

impl<R: Real> PackKernel<R> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Self::Output {
        let material = self.patch.material.clone();
        material.with_inelastic::<P, _>(self.patch.updates.preview(), self)
    }
}

impl<R: Real, P: Pack<Real = R>> UseInelastic<P> for Energies<'_, R> {
    type Output = (Energy, (f64, f64));
    #[inline(always)]
    fn with<M: InelasticLaw<P>>(self, law: M) -> Self::Output {
        let SolidPatch { material, layout, nodes, constants, state, viscosity, .. } = self.patch;
        let (bulk, viscosity) = (P::splat(material.bulk), viscosity.as_ref());
        let (energies, ratios) = ([P::zero(); 4], Ratios::new());
        let mut tally = EnergyVisitor { law, bulk, state, viscosity, energies, ratios };
        // SAFETY: the caller has checked the nodes.
        unsafe { SolidPatch::visit(layout, self.positions, nodes, constants, self.at_hand, &mut tally) };
        tally.total()
    }
}

/// Tells stress and strain.
pub struct Output<'a, 'b, R> {
    /// As of [`Energies`].
    pub patch: &'a mut SolidPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// Who is told.
    pub sink: &'a mut OutputSink<'b>,
}

impl<R: Real> PackKernel<R> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let material = self.patch.material.clone();
        material.with_inelastic::<P, _>(self.patch.updates.preview(), self);
    }
}

impl<R: Real, P: Pack<Real = R>> UseInelastic<P> for Output<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn with<M: InelasticLaw<P>>(self, law: M) {
        let SolidPatch { material, layout, nodes, constants, state, numbers, .. } = self.patch;
        let bulk = P::splat(material.bulk);
        let mut gauge = OutputVisitor { law, bulk, state, numbers, sink: self.sink };
        // SAFETY: as above.
        unsafe { SolidPatch::visit(layout, self.positions, nodes, constants, false, &mut gauge) };
    }
}
