//! What a solve is given.

use clubface_math::Scalar;

/// What a solve is given, per ring.
#[derive(Clone, Debug)]
pub struct Given<S> {
    /// Bounds b_j.
    pub bound: Vec<S>,
    /// Free slips g_j.
    pub free: [Vec<S>; 2],
}

impl<S: Scalar> Given<S> {
    /// Zeros for `rings` rings.
    #[must_use]
    pub fn new(rings: usize) -> Self {
        let row = || vec![S::zero(); rings];
        Self { bound: row(), free: [row(), row()] }
    }

    /// Subtracts the values of the first `contact` rings, which leaves derivatives alone.
    #[inline(always)]
    pub fn keep_changes(&mut self, contact: usize) {
        let [free_y, free_z] = &mut self.free;
        for row in [&mut self.bound, free_y, free_z] {
            for entry in &mut row[..contact] {
                *entry -= entry.primal();
            }
        }
    }
}
