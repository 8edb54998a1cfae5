//! Where the rings slip to: Newton's method for the slip directions, and derivatives of the solution.

use super::factors::Factors;
use super::given::Given;
use super::state::Friction;
use clubface_math::Scalar;

impl Friction {
    /// Slip of ring j across its traction.
    #[inline(always)]
    fn across(&self, j: usize) -> f64 {
        self.slip[1][j] * self.direction[0][j] - self.slip[0][j] * self.direction[1][j]
    }

    /// LU factors of the Jacobian of the slips across the tractions with respect to the directions of the tractions.
    /// Without pivoting: it is a positive definite matrix, but for a scaling of columns, plus a positive diagonal.
    #[inline(always)]
    pub(super) fn factor(&mut self) {
        self.effort.directions += 1;
        let stride = self.influence.stride();
        let count = self.slipping.len();
        let padded = count.next_multiple_of(8);
        let matrix = self.innermost.map_or(&self.matrix[..], |k| self.influence.exchanged(k));
        let Factors { upper, direction, .. } = &mut self.factors;
        for (a, &j) in self.slipping.iter().enumerate() {
            direction[0][a] = self.direction[0][j];
            direction[1][a] = self.direction[1][j];
        }
        let [direction_y, direction_z] = [&direction[0][..padded], &direction[1][..padded]];
        for (a, &i) in self.slipping.iter().enumerate() {
            let column = &mut upper[a * stride..][..padded];
            let from = &matrix[i * stride..][..stride];
            match self.innermost {
                Some(k) => column[..count].copy_from_slice(&from[k..][..count]),
                None => column.iter_mut().zip(&self.slipping).for_each(|(entry, &j)| *entry = from[j]),
            }
            let [y, z] = [direction_y[a] * self.bound[i], direction_z[a] * self.bound[i]];
            for b in 0..padded {
                column[b] *= direction_y[b] * y + direction_z[b] * z;
            }
            column[count..].fill(0.0);
            column[a] -= self.slip[0][i] * direction_y[a] + self.slip[1][i] * direction_z[a];
        }
        match padded / 8 {
            1 => self.factors.eliminate::<1>(count),
            2 => self.factors.eliminate::<2>(count),
            3 => self.factors.eliminate::<3>(count),
            _ => self.factors.eliminate::<0>(count),
        }
    }

    /// One Newton step of the directions.
    #[inline(always)]
    pub(super) fn turn(&mut self) {
        let mut angle = std::mem::take(&mut self.angle);
        for (a, &j) in self.slipping.iter().enumerate() {
            angle[a] = -self.across(j);
        }
        self.factors.solve(self.slipping.len(), &mut angle);
        for (turn, &j) in angle.iter().zip(&self.slipping) {
            // The angle's tangent: never past a quarter turn.
            let inverse = (1.0 + turn * turn).sqrt().recip();
            let [y, z] = [self.direction[0][j], self.direction[1][j]];
            self.direction[0][j] = (y - turn * z) * inverse;
            self.direction[1][j] = (z + turn * y) * inverse;
        }
        self.angle = angle;
    }

    /// Derivatives of the tractions of the last solve: changes of y for changes of the bounds and of the free slips,
    /// all with value zero, the sets being what they are. Exact: the linearised conditions of the solution.
    #[inline(always)]
    pub fn differentiate<S: Scalar>(&mut self, change: &Given<S>, traction: &mut [Vec<S>; 2]) {
        let m = self.contact;
        self.partition();
        self.factor();
        for j in 0..m {
            for axis in 0..2 {
                traction[axis][j] = if self.sticks[j] {
                    -change.free[axis][j]
                } else {
                    change.bound[j] * self.direction[axis][j]
                };
            }
        }
        let mut angle = Vec::with_capacity(self.slipping.len());
        for &j in &self.slipping {
            let y = self.exchange_row(j, &traction[0]) + change.free[0][j];
            let z = self.exchange_row(j, &traction[1]) + change.free[1][j];
            angle.push(y * self.direction[1][j] - z * self.direction[0][j]);
        }
        self.factors.solve(self.slipping.len(), &mut angle);
        for (turn, &j) in angle.iter().zip(&self.slipping) {
            let turn = *turn * self.bound[j];
            traction[0][j] -= turn * self.direction[1][j];
            traction[1][j] += turn * self.direction[0][j];
        }
        // A sticking ring's traction replaces its known slip only when all of them have been found.
        for axis in 0..2 {
            let sticking = (0..m).filter(|&j| self.sticks[j]);
            let result: Vec<S> = sticking.map(|j| self.exchange_row(j, &traction[axis])).collect();
            let sticking = (0..m).filter(|&j| self.sticks[j]);
            for (j, result) in sticking.zip(result) {
                traction[axis][j] = result;
            }
        }
    }

    /// Row `j` of the exchanged matrix times `known`.
    #[inline(always)]
    fn exchange_row<S: Scalar>(&self, j: usize, known: &[S]) -> S {
        let stride = self.influence.stride();
        let matrix = self.innermost.map_or(&self.matrix[..], |k| self.influence.exchanged(k));
        let mut sum = S::zero();
        for (i, known) in known[..self.contact].iter().enumerate() {
            sum += *known * matrix[i * stride + j];
        }
        sum
    }
}
