//! Where the rings slip to: Newton's method for the slip directions, and derivatives of the solution.

use super::Friction;
use clubface_math::Scalar;

/// Changes of what a solve is given, per ring in contact.
#[derive(Clone, Debug)]
pub struct Change<S> {
    /// Of b_j.
    pub bound: Vec<S>,
    /// Of g_j.
    pub free: [Vec<S>; 2],
}

impl Friction {
    /// Slip of ring j across its traction.
    fn across(&self, j: usize) -> f64 {
        self.slip[1][j] * self.direction[0][j] - self.slip[0][j] * self.direction[1][j]
    }

    /// LU factors of the Jacobian of the slips across the tractions with respect to the directions of the tractions.
    /// Without pivoting: it is a positive definite matrix, but for a scaling of columns, plus a positive diagonal.
    #[inline(always)]
    pub(super) fn factor(&mut self, bound: &[f64]) {
        self.effort.directions += 1;
        let stride = self.influence.stride();
        let count = self.slipping.len();
        let matrix = self.innermost.map_or(&self.matrix[..], |k| self.influence.exchanged(k));
        let [direction_y, direction_z] = [&self.direction[0][..], &self.direction[1][..]];
        for (a, &i) in self.slipping.iter().enumerate() {
            let column = &mut self.jacobian[a * stride..][..count];
            let from = &matrix[i * stride..][..stride];
            let [y, z] = [direction_y[i] * bound[i], direction_z[i] * bound[i]];
            for (entry, &j) in column.iter_mut().zip(&self.slipping) {
                *entry = from[j] * (direction_y[j] * y + direction_z[j] * z);
            }
            let along = self.slip[0][i] * direction_y[i] + self.slip[1][i] * direction_z[i];
            column[a] -= along;
        }
        for pivot in 0..count {
            let (before, after) = self.jacobian.split_at_mut((pivot + 1) * stride);
            let lower = &mut before[pivot * stride..][..count];
            let inverse = lower[pivot].recip();
            lower[pivot] = inverse;
            for entry in &mut lower[pivot + 1..] {
                *entry *= inverse;
            }
            for column in after[..(count - pivot - 1) * stride].chunks_exact_mut(stride) {
                let factor = column[pivot];
                for (entry, l) in column[pivot + 1..count].iter_mut().zip(&lower[pivot + 1..]) {
                    *entry -= l * factor;
                }
            }
        }
    }

    /// One Newton step of the directions.
    #[inline(always)]
    pub(super) fn turn(&mut self) {
        let mut angle = std::mem::take(&mut self.angle);
        for (a, &j) in self.slipping.iter().enumerate() {
            angle[a] = -self.across(j);
        }
        self.solve_directions(&mut angle);
        for (turn, &j) in angle.iter().zip(&self.slipping) {
            // The angle's tangent: never past a quarter turn.
            let inverse = (1.0 + turn * turn).sqrt().recip();
            let [y, z] = [self.direction[0][j], self.direction[1][j]];
            self.direction[0][j] = (y - turn * z) * inverse;
            self.direction[1][j] = (z + turn * y) * inverse;
        }
        self.angle = angle;
    }

    /// Solves with the factors of the Jacobian, in place.
    #[inline(always)]
    fn solve_directions<S: Scalar>(&self, right: &mut [S]) {
        let stride = self.influence.stride();
        let right = &mut right[..self.slipping.len()];
        for pivot in 0..right.len() {
            let value = right[pivot];
            for (entry, l) in right[pivot + 1..].iter_mut().zip(&self.jacobian[pivot * stride + pivot + 1..])
            {
                *entry -= value * *l;
            }
        }
        for pivot in (0..right.len()).rev() {
            let value = right[pivot] * self.jacobian[pivot * stride + pivot];
            right[pivot] = value;
            for (entry, u) in right[..pivot].iter_mut().zip(&self.jacobian[pivot * stride..]) {
                *entry -= value * *u;
            }
        }
    }

    /// Derivatives of the tractions of the last solve: changes of y for changes of the bounds and of the free slips,
    /// all with value zero, the sets being what they are. Exact: the linearised conditions of the solution.
    pub fn differentiate<S: Scalar>(
        &mut self,
        bound: &[f64],
        change: &Change<S>,
        traction: &mut [Vec<S>; 2],
    ) {
        let m = self.contact;
        self.partition();
        self.factor(bound);
        for j in 0..m {
            for axis in 0..2 {
                traction[axis][j] = if self.sticks[j] {
                    -change.free[axis][j]
                } else {
                    change.bound[j] * self.direction[axis][j]
                };
            }
        }
        let mut slip = [vec![S::zero(); m], vec![S::zero(); m]];
        self.apply_to(traction, &mut slip);
        let mut angle: Vec<S> = self
            .slipping
            .iter()
            .map(|&j| {
                let y = slip[0][j] + change.free[0][j];
                let z = slip[1][j] + change.free[1][j];
                y * self.direction[1][j] - z * self.direction[0][j]
            })
            .collect();
        self.solve_directions(&mut angle);
        for (turn, &j) in angle.iter().zip(&self.slipping) {
            let turn = *turn * bound[j];
            traction[0][j] -= turn * self.direction[1][j];
            traction[1][j] += turn * self.direction[0][j];
        }
        self.apply_to(traction, &mut slip);
        for j in 0..m {
            if self.sticks[j] {
                traction[0][j] = slip[0][j];
                traction[1][j] = slip[1][j];
            }
        }
    }

    fn apply_to<S: Scalar>(&self, known: &[Vec<S>; 2], unknown: &mut [Vec<S>; 2]) {
        let (m, stride) = (self.contact, self.influence.stride());
        let matrix = self.exchanged();
        for axis in 0..2 {
            unknown[axis][..m].fill(S::zero());
            for (column, value) in matrix.chunks_exact(stride).zip(&known[axis][..m]) {
                for (entry, factor) in unknown[axis][..m].iter_mut().zip(column) {
                    *entry += *value * *factor;
                }
            }
        }
    }
}
