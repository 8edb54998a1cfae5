//! What visits packs of elements, one after the other, however the elements find their nodes.

use super::constants::Block;
use super::element::Hexahedron;
use clubface_math::Pack;

/// A visitor of elements.
pub trait Visitor<P: Pack> {
    /// Visits some packs: the first begins with a lane, counted over all blocks, the next ones `step` lanes further. At
    /// most [`super::stress::RUN`].
    fn visit(&mut self, lane: usize, step: usize, constants: &[Block<P::Real>], elements: &[Hexahedron<P>]);
}
