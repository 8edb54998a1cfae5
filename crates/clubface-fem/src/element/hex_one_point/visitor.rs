//! What visits packs of elements, one after the other, however the elements find their nodes.

use super::constants::Constants;
use super::element::Hexahedron;
use clubface_math::Pack;

/// A visitor of elements.
pub trait Visitor<P: Pack> {
    /// Visits a pack, which begins with a lane, counted over all blocks.
    fn visit(&mut self, lane: usize, constants: &Constants<P>, element: &Hexahedron<P>);
    /// Ends a run of at most [`super::stress::RUN`] packs, each `step` lanes further than the one before.
    fn end_run(&mut self, _step: usize) {}
}
