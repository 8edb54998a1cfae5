//! Sides of hexahedra, as sums and differences of their corners.

use clubface_math::Scalar;

/// Four corners of one side along the third reference coordinate, a number each, as sums and differences: sum, along
/// the first coordinate, along the second, along both.
pub type Sums<P> = [P; 4];

/// Positions of such a side, or forces on it, by component. Neighbours across the side share it.
pub type Face<P> = [Sums<P>; 3];

/// The side whose corners stand at zero, or which no force acts on.
#[inline(always)]
pub fn empty<P: Scalar>() -> Face<P> {
    [[P::zero(); 4]; 3]
}

/// Sums and differences of the corners of a side.
#[inline(always)]
pub fn sums<P: Scalar>(corners: [P; 4]) -> Sums<P> {
    let (low, high) = (corners[0] + corners[1], corners[2] + corners[3]);
    let (low_slope, high_slope) = (corners[1] - corners[0], corners[3] - corners[2]);
    [low + high, low_slope + high_slope, high - low, high_slope - low_slope]
}

/// Forces on the corners of a side from forces on sums and differences: the transpose of [`sums`].
#[inline(always)]
pub fn spread<P: Scalar>(forces: Sums<P>) -> [P; 4] {
    let [sum, first, second, both] = forces;
    let (low, high) = (sum - second, sum + second);
    let (low_slope, high_slope) = (first - both, first + both);
    [low - low_slope, low + low_slope, high - high_slope, high + high_slope]
}
