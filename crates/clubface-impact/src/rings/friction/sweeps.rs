//! Projected Gauss-Seidel: slow, but it always leads to the solution.

use super::planes::product;
use super::state::Friction;
use std::sync::Arc;

impl Friction {
    /// Sweeps of projected Gauss-Seidel, every ring solved exactly in turn, until no traction changes by more than
    /// `tolerance`; leaves sets and directions.
    pub(super) fn gauss_seidel(&mut self, tolerance: f64, sweeps: usize) {
        let bound = self.bound.clone();
        let (m, stride) = (self.contact, self.influence.stride());
        let influence = Arc::clone(&self.influence);
        let matrix = influence.displacement();
        for j in 0..m {
            let length = self.traction[0][j].hypot(self.traction[1][j]);
            let scale = if length > bound[j] { bound[j] / length } else { 1.0 };
            self.traction[0][j] *= scale;
            self.traction[1][j] *= scale;
        }
        let mut slip = std::mem::take(&mut self.slip);
        product(matrix, stride, m, &self.traction, &mut slip);
        for axis in 0..2 {
            for j in 0..m {
                slip[axis][j] += self.free[axis][j];
            }
        }
        for _ in 0..sweeps {
            self.effort.sweeps += 1;
            let mut largest: f64 = 0.0;
            for j in 0..m {
                let diagonal = matrix[j * stride + j];
                let y = self.traction[0][j] - slip[0][j] / diagonal;
                let z = self.traction[1][j] - slip[1][j] / diagonal;
                let length = y.hypot(z);
                self.sticks[j] = length <= bound[j];
                let scale = if self.sticks[j] { 1.0 } else { bound[j] / length };
                if !self.sticks[j] {
                    self.direction[0][j] = y / length;
                    self.direction[1][j] = z / length;
                }
                for (axis, value) in [y * scale, z * scale].into_iter().enumerate() {
                    let change = value - self.traction[axis][j];
                    self.traction[axis][j] = value;
                    largest = largest.max(change.abs());
                    for i in 0..m {
                        slip[axis][i] += matrix[j * stride + i] * change;
                    }
                }
            }
            if largest <= tolerance {
                break;
            }
        }
        self.slip = slip;
    }
}
