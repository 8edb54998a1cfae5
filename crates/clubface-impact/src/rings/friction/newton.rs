//! Newton's method on the set of sticking rings and the slip directions.

use super::planes::{eights, product};
use super::state::{Effort, Friction};
use crate::rings::influence::exchange;
use clubface_math::{Kernel, Lanes, dispatch};

/// Largest accepted error of a traction, in units of mu p0: that of y_j against the projection of y_j - s_j/M_jj on the
/// disc of radius b_j, which is zero for the exact solution and for it alone.
pub const TOLERANCE: f64 = 1e-11;
/// Newton steps before the first Gauss-Seidel sweeps: three times what is ever needed from a neighbouring solution.
const NEWTON_STEPS: usize = 16;

/// What is wrong with a trial solution.
enum Verdict {
    Solved,
    SetsChange,
    /// With the largest error of a traction from its direction.
    DirectionsTurn(f64),
}

impl Friction {
    /// Solves for the tractions of the first `bound.len()` rings: `bound` > 0 is b_j, `free` is g_j.
    pub fn solve(&mut self, bound: &[f64], free: [&[f64]; 2]) {
        self.start(bound.len());
        self.bound[..bound.len()].copy_from_slice(bound);
        self.free[0][..bound.len()].copy_from_slice(free[0]);
        self.free[1][..bound.len()].copy_from_slice(free[1]);
        self.effort = Effort::default();
        for _ in 0..8 {
            if dispatch(Newton { friction: self }) {
                return;
            }
            self.gauss_seidel(1e-3, 50);
        }
        self.gauss_seidel(TOLERANCE, 100_000);
    }

    /// Newton's method from the present sets and directions; whether it converged.
    #[inline(always)]
    fn newton(&mut self) -> bool {
        self.partition();
        // Residual at the last factorisation: as long as it falls by 100 a step, the factors are good enough.
        let mut falling: f64 = 0.0;
        for _ in 0..NEWTON_STEPS {
            self.apply();
            match self.judge() {
                Verdict::Solved => return true,
                Verdict::SetsChange => {
                    self.change_sets();
                    self.partition();
                    falling = 0.0;
                }
                Verdict::DirectionsTurn(error) => {
                    if error > falling {
                        self.factor();
                    }
                    falling = error * 0.01;
                    self.turn();
                }
            }
        }
        false
    }

    /// Chooses the matrix exchanged on the sticking rings.
    #[inline(always)]
    pub(super) fn partition(&mut self) {
        let m = self.contact;
        let sticks = &self.sticks[..m];
        self.slipping.clear();
        self.slipping.extend((0..m).filter(|&j| !sticks[j]));
        let count = m - self.slipping.len();
        let innermost = sticks.iter().position(|&stick| !stick).unwrap_or(m);
        if innermost == count {
            self.innermost = Some(count);
            return;
        }
        self.innermost = None;
        let stride = self.influence.stride();
        self.matrix.clear();
        self.matrix.extend_from_slice(&self.influence.exchanged(count)[..stride * m]);
        for j in 0..m {
            if sticks[j] != (j < count) {
                exchange(&mut self.matrix, stride, m, j, &mut self.angle);
            }
        }
    }

    /// Tractions and slips for the present sets and directions.
    #[inline(always)]
    fn apply(&mut self) {
        let m = self.contact;
        self.effort.products += 1;
        let sticks = eights(&self.sticks, m);
        let bound = eights(&self.bound, m);
        for axis in 0..2 {
            let (free, direction) = (eights(&self.free[axis], m), eights(&self.direction[axis], m));
            let known = &mut self.known[axis].as_chunks_mut::<8>().0[..sticks.len()];
            for block in 0..sticks.len() {
                let (sticks, bound, direction) = (sticks[block], bound[block], direction[block]);
                let mut row = free[block];
                for lane in 0..8 {
                    row[lane] = if sticks[lane] { -row[lane] } else { bound[lane] * direction[lane] };
                }
                known[block] = row;
            }
        }
        let matrix = self.innermost.map_or(&self.matrix[..], |k| self.influence.exchanged(k));
        product(matrix, self.influence.stride(), m, &self.known, &mut self.unknown);
        for axis in 0..2 {
            let (known, unknown) = (eights(&self.known[axis], m), eights(&self.unknown[axis], m));
            let free = eights(&self.free[axis], m);
            let traction = &mut self.traction[axis].as_chunks_mut::<8>().0[..sticks.len()];
            let slip = &mut self.slip[axis].as_chunks_mut::<8>().0[..sticks.len()];
            for block in 0..sticks.len() {
                let (sticks, unknown) = (sticks[block], unknown[block]);
                let (mut held, mut moved) = (known[block], free[block]);
                for lane in 0..8 {
                    held[lane] = if sticks[lane] { unknown[lane] } else { held[lane] };
                    moved[lane] = if sticks[lane] { 0.0 } else { unknown[lane] + moved[lane] };
                }
                (traction[block], slip[block]) = (held, moved);
            }
        }
    }

    /// What to do about the present tractions and slips.
    #[inline(always)]
    fn judge(&self) -> Verdict {
        let m = self.contact;
        let (sticks, bound) = (eights(&self.sticks, m), eights(&self.bound, m));
        let diagonal = eights(self.influence.diagonal(), m);
        let traction = [eights(&self.traction[0], m), eights(&self.traction[1], m)];
        let slip = [eights(&self.slip[0], m), eights(&self.slip[1], m)];
        // Largest excess of a sticking traction or of a slip along its traction, and largest error of a direction.
        let (mut excess, mut turn) = ([0.0; 8], [0.0; 8]);
        for block in 0..sticks.len() {
            let (sticks, bound, diagonal) = (sticks[block], bound[block], diagonal[block]);
            let [y, z] = [traction[0][block], traction[1][block]];
            let [slip_y, slip_z] = [slip[0][block], slip[1][block]];
            for lane in 0..8 {
                // Slip along and across the traction, times the bound; a sticking ring slips by zero.
                let along = slip_y[lane] * y[lane] + slip_z[lane] * z[lane];
                let across = slip_z[lane] * y[lane] - slip_y[lane] * z[lane];
                let limit = bound[lane] + TOLERANCE;
                let stuck = y[lane] * y[lane] + z[lane] * z[lane] - limit * limit;
                let moving = along - TOLERANCE * diagonal[lane] * bound[lane];
                let over = if sticks[lane] { stuck } else { moving };
                let error =
                    across.abs() * bound[lane] / (diagonal[lane] * bound[lane] * bound[lane] + along.abs());
                excess[lane] = if over > excess[lane] { over } else { excess[lane] };
                turn[lane] = if error > turn[lane] { error } else { turn[lane] };
            }
        }
        if excess.iter().any(|&excess| excess > 0.0) {
            return Verdict::SetsChange;
        }
        let turn = turn.into_iter().fold(0.0, f64::max);
        if turn > TOLERANCE { Verdict::DirectionsTurn(turn) } else { Verdict::Solved }
    }

    /// Lets sticking rings slip whose traction is beyond the bound, and slipping rings stick or turn whose slip
    /// is not opposed.
    fn change_sets(&mut self) {
        let bound = &self.bound;
        for j in 0..self.contact {
            let [y, z] = [self.traction[0][j], self.traction[1][j]];
            let diagonal = self.influence.diagonal()[j];
            let (y, z) = if self.sticks[j] {
                if y * y + z * z <= (bound[j] + TOLERANCE) * (bound[j] + TOLERANCE) {
                    continue;
                }
                (y, z)
            } else {
                let [slip_y, slip_z] = [self.slip[0][j], self.slip[1][j]];
                if slip_y * y + slip_z * z <= TOLERANCE * diagonal * bound[j] {
                    continue;
                }
                (y - slip_y / diagonal, z - slip_z / diagonal)
            };
            let length = (y * y + z * z).sqrt();
            self.sticks[j] = length <= bound[j];
            if !self.sticks[j] {
                self.direction[0][j] = y / length;
                self.direction[1][j] = z / length;
            }
        }
    }
}

/// Newton's method as the CPU runs it best; the same bits on any.
struct Newton<'a> {
    friction: &'a mut Friction,
}

impl Kernel for Newton<'_> {
    type Output = bool;
    #[inline(always)]
    fn run<S: Lanes>(self) -> bool {
        self.friction.newton()
    }
}
