//! Element packs in the fields of a lattice: where they stand, and how they gather positions and scatter forces.
//!
//! A pack is made of quads, packs of at most four lanes, whose elements follow each other in a row.

use super::arrangement::{QUAD, unbroken};
use super::element::{Face, Sums, spread, sums};
use crate::element::field::Field;
use clubface_math::{Pack, Real, Scalar};

/// Where elements find their first corner in a field's component.
#[derive(Clone, Copy)]
pub struct Places {
    /// Lanes after which a node is left out, the last of a row.
    unbroken: usize,
}

impl Places {
    /// Places in a lattice of the given shape.
    pub fn new(shape: [usize; 3]) -> Self {
        Self { unbroken: unbroken(shape) }
    }
    /// Place of the element in a lane, counted over all columns.
    #[inline(always)]
    pub fn at(self, lane: usize) -> usize {
        lane + lane / self.unbroken
    }
    /// Places of the quads of a pack from a lane on.
    #[inline(always)]
    pub fn quads<P: Pack>(self, lane: usize) -> Quads {
        let quad = const {
            assert!(P::Quad::LANES <= QUAD);
            P::Quad::LANES
        };
        let last = lane + P::LANES - quad;
        let breaks = |lane: usize| (lane + quad).is_multiple_of(self.unbroken);
        Quads { places: [self.at(lane), self.at(last)], breaks: [breaks(lane), breaks(last)] }
    }
}

/// Where the quads of a pack stand; the second is the first where there is only one.
pub struct Quads {
    places: [usize; 2],
    /// Whether a row ends with it.
    breaks: [bool; 2],
}

/// A component of one side of a pack of elements from the given places of plane `k` on: of its parts one and those that
/// follow, as far apart as given.
///
/// # Safety
/// The places are those of lanes within the columns, `k` is a plane, and numbers have all of these parts.
#[inline(always)]
pub unsafe fn gather_side<G: Pack, R: Real>(
    positions: &mut Field<R>,
    k: usize,
    axis: usize,
    [first, apart]: [usize; 2],
    at: &Quads,
) -> Sums<G> {
    let (row, stride) = (positions.row(), positions.stride());
    // SAFETY: the stride has room for a pack of the next row.
    unsafe {
        let from = positions.at(k, axis).add(first * stride);
        let stride = apart * stride;
        let [a, b] = [from.add(at.places[0]), from.add(at.places[1])];
        sums([
            G::read_quads([a, b], stride),
            G::read_quads([a.add(1), b.add(1)], stride),
            G::read_quads([a.add(row), b.add(row)], stride),
            G::read_quads([a.add(row + 1), b.add(row + 1)], stride),
        ])
    }
}

/// All components of it.
///
/// # Safety
/// As for [`gather_side`].
#[inline(always)]
pub unsafe fn gather_face<P: Pack>(positions: &mut Field<P::Real>, k: usize, at: &Quads) -> Face<P> {
    // SAFETY: the caller's promise.
    unsafe {
        [
            gather_side(positions, k, 0, [0, 1], at),
            gather_side(positions, k, 1, [0, 1], at),
            gather_side(positions, k, 2, [0, 1], at),
        ]
    }
}

/// Adds a component of the forces to one side of a pack of elements. Every number is written first from the row
/// before it, then added to from its own row; what belongs to the node after the last lane waits in `carry` for the
/// next pack, or is given to the last node of the row.
///
/// # Safety
/// As for [`gather_side`].
#[inline(always)]
pub unsafe fn scatter_side<G: Pack, R: Real>(
    forces: &mut Field<R>,
    k: usize,
    axis: usize,
    pass: usize,
    at: &Quads,
    force: Sums<G>,
    carry: &mut [G::Quad; 2],
) {
    let corners = spread(force);
    let (row, stride) = (forces.row(), forces.stride());
    let lanes = G::Quad::LANES;
    for quad in 0..G::LANES / lanes {
        let (c0, c1) = (corners[0].quad(quad), corners[1].quad(quad));
        let (c2, c3) = (corners[2].quad(quad), corners[3].quad(quad));
        // SAFETY: as in `gather_side`.
        unsafe {
            let to = forces.at(k, axis).add(pass * stride + at.places[quad]);
            (c2 + c3.after(carry[1])).write_parts(to.add(row), stride);
            (G::Quad::read_parts(to, stride) + (c0 + c1.after(carry[0]))).write_parts(to, stride);
            *carry = [c1, c3];
            if at.breaks[quad] {
                let end = to.add(lanes);
                c3.real(lanes - 1).put_parts(end.add(row), stride);
                (G::Real::from_parts(end, stride) + c1.real(lanes - 1)).put_parts(end, stride);
                *carry = [G::Quad::zero(); 2];
            }
        }
    }
}
