//! What visits packs of elements, one after the other, however the elements find their nodes.

use super::constants::Constants;
use super::element::Hexahedron;
use clubface_math::Pack;

/// A visitor of elements.
pub trait Visitor<P: Pack> {
    /// Visits lanes `first..` of a block.
    fn visit(&mut self, block: usize, first: usize, constants: &Constants<P>, element: &Hexahedron<P>);
}
