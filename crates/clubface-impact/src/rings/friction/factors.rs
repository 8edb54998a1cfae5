//! Factors of the Jacobian of the slip directions.

use clubface_math::Scalar;

/// LU factors of the Jacobian of the slip directions, by columns of the ring stride; slipping rings are numbered from
/// 0. Zeros elsewhere, so that whole blocks of eight rows can be handled in registers.
#[derive(Clone, Debug)]
pub(super) struct Factors {
    /// U above the diagonal.
    pub(super) upper: Vec<f64>,
    /// L below the diagonal, where it is one.
    lower: Vec<f64>,
    /// Inverse of the diagonal of U.
    inverse: Vec<f64>,
    /// Directions of the slipping rings.
    pub(super) direction: [Vec<f64>; 2],
}

impl Factors {
    pub(super) fn new(rings: usize, stride: usize) -> Self {
        let matrix = || vec![0.0; rings * stride];
        let row = || vec![0.0; stride];
        Self { upper: matrix(), lower: matrix(), inverse: row(), direction: [row(), row()] }
    }

    /// Replaces the matrix in `upper` by its factors. `BLOCKS`: the number of blocks of eight rows, or 0 for any.
    #[inline(always)]
    pub(super) fn eliminate<const BLOCKS: usize>(&mut self, count: usize) {
        let stride = self.inverse.len();
        let blocks = if BLOCKS == 0 { count.div_ceil(8) } else { BLOCKS };
        for pivot in 0..count {
            let (before, after) = self.upper.split_at_mut((pivot + 1) * stride);
            let column = &mut before[pivot * stride..].as_chunks_mut::<8>().0[..blocks];
            let lower = &mut self.lower[pivot * stride..].as_chunks_mut::<8>().0[..blocks];
            let inverse = column[pivot / 8][pivot % 8].recip();
            self.inverse[pivot] = inverse;
            for block in 0..blocks {
                let (mut below, mut above) = (column[block], column[block]);
                for lane in 0..8 {
                    let row = block * 8 + lane;
                    below[lane] = if row > pivot { below[lane] * inverse } else { 0.0 };
                    above[lane] = if row < pivot { above[lane] } else { 0.0 };
                }
                (lower[block], column[block]) = (below, above);
            }
            for column in after.chunks_exact_mut(stride).take(count - pivot - 1) {
                let column = &mut column.as_chunks_mut::<8>().0[..blocks];
                let factor = column[pivot / 8][pivot % 8];
                for block in 0..blocks {
                    subtract(&mut column[block], &lower[block], factor);
                }
            }
        }
    }

    /// Solves for `count` slipping rings in place.
    #[inline(always)]
    pub(super) fn solve<S: Scalar>(&self, count: usize, right: &mut [S]) {
        let stride = self.inverse.len();
        let padded = right.len().min(count.next_multiple_of(8));
        let right = &mut right[..padded];
        for pivot in 0..count {
            let value = right[pivot];
            let start = pivot / 8 * 8;
            for (entry, l) in right[start..].iter_mut().zip(&self.lower[pivot * stride + start..]) {
                *entry -= value * *l;
            }
        }
        for pivot in (0..count).rev() {
            let value = right[pivot] * self.inverse[pivot];
            let end = padded.min(pivot / 8 * 8 + 8);
            for (entry, u) in right[..end].iter_mut().zip(&self.upper[pivot * stride..]) {
                *entry -= value * *u;
            }
            right[pivot] = value;
        }
    }
}

/// `from` -= `what` times `factor`, by way of a copy that the compiler keeps in a register.
#[inline(always)]
fn subtract(from: &mut [f64; 8], what: &[f64; 8], factor: f64) {
    let mut rest = *from;
    for lane in 0..8 {
        rest[lane] -= what[lane] * factor;
    }
    *from = rest;
}
