//! Which rings stick, which slip and where to: Coulomb friction of all rings at once, in the plane of contact.
//!
//! Dimensionless: tractions y_j are in units of mu p0, displacements and slips in units of (2 - nu)/(8 G) a_max mu p0.
//! With M of [`Influence`], bounds b_j = p_j/p0 and g_j the slip of a ring without traction, ring j slips by
//! s_j = g_j + (M y)_j, where either s_j = 0 and |y_j| <= b_j, or y_j = -b_j s_j/|s_j|.
//!
//! Newton's method on the set of sticking rings and the slip directions. Sticking rings are eliminated by the matrix
//! exchanged on them (cached where they are the innermost ones, as they nearly always are); what is left is one
//! unknown angle a slipping ring, and none where all slips are collinear. If the sets do not settle, projected
//! Gauss-Seidel sweeps lead to the neighbourhood of the solution.

mod directions;
mod sweeps;

pub use directions::Given;

use directions::Factors;

use super::influence::{exchange, Influence};
use clubface_math::{dispatch, Kernel, Lanes};
use std::sync::Arc;

/// Largest accepted error of a traction, in units of mu p0: that of y_j against the projection of y_j - s_j/M_jj on the
/// disc of radius b_j, which is zero for the exact solution and for it alone.
pub const TOLERANCE: f64 = 1e-11;
/// Newton steps before the first Gauss-Seidel sweeps: three times what is ever needed from a neighbouring solution.
const NEWTON_STEPS: usize = 16;

/// Two components along y' and z' for every ring.
pub type Plane = [Vec<f64>; 2];

/// Friction of the rings at one instant; keeps the last solution as the start of the next.
#[derive(Clone, Debug)]
pub struct Friction {
    influence: Arc<Influence>,
    /// Rings in contact at the last solve. Rows are padded to blocks of eight: a ring of the last block that is not in
    /// contact slips without traction.
    contact: usize,
    /// Bounds b and free slips g.
    bound: Vec<f64>,
    free: Plane,
    /// Sticking rings.
    sticks: Vec<bool>,
    /// Direction of the traction of every slipping ring, a unit vector.
    direction: Plane,
    /// Tractions y.
    traction: Plane,
    /// Slips s.
    slip: Plane,
    /// What the exchanged matrix is applied to, and its result.
    known: Plane,
    unknown: Plane,
    /// Number of innermost rings, all sticking, whose cached matrix is in use, or none if `matrix` is.
    innermost: Option<usize>,
    matrix: Vec<f64>,
    /// Slipping rings, and the factors of the Jacobian of their slip directions.
    slipping: Vec<usize>,
    factors: Factors,
    angle: Vec<f64>,
    /// Work of the last solve.
    effort: Effort,
}

/// What is wrong with a trial solution.
enum Verdict {
    Solved,
    SetsChange,
    /// With the largest error of a traction from its direction.
    DirectionsTurn(f64),
}

/// Work of one solve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Products with an exchanged matrix.
    pub products: usize,
    /// Linear solves for the slip directions.
    pub directions: usize,
    /// Gauss-Seidel sweeps.
    pub sweeps: usize,
}

impl Friction {
    /// Friction of rings that have not touched yet.
    #[must_use]
    pub fn new(influence: Arc<Influence>) -> Self {
        let (n, stride) = (influence.rings(), influence.stride());
        let plane = || [vec![0.0; stride], vec![0.0; stride]];
        Self {
            influence,
            contact: 0,
            bound: vec![1.0; stride],
            free: plane(),
            sticks: vec![true; stride],
            direction: [vec![1.0; stride], vec![0.0; stride]],
            traction: plane(),
            slip: plane(),
            known: plane(),
            unknown: plane(),
            innermost: Some(0),
            matrix: Vec::new(),
            slipping: Vec::with_capacity(n),
            factors: Factors::new(n, stride),
            angle: vec![0.0; stride],
            effort: Effort::default(),
        }
    }

    /// Tractions, in units of mu p0, two components of [n] and padding; zero outside the contact.
    #[must_use]
    pub fn traction(&self) -> &Plane {
        &self.traction
    }
    /// Slips of the rings in contact; only theirs are meant.
    #[must_use]
    pub fn slip(&self) -> &Plane {
        &self.slip
    }
    /// Sticking rings; only those in contact count.
    #[must_use]
    pub fn sticks(&self) -> &[bool] {
        &self.sticks
    }
    /// Rings in contact at the last solve.
    #[must_use]
    pub fn contact(&self) -> usize {
        self.contact
    }

    /// The matrices of these rings.
    #[must_use]
    pub fn influence(&self) -> &Influence {
        &self.influence
    }

    /// No ring touches any more.
    pub fn lift_off(&mut self) {
        self.start(0);
        self.effort = Effort::default();
    }

    /// Work of the last solve.
    #[must_use]
    pub fn effort(&self) -> Effort {
        self.effort
    }

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

    /// Rings that have just come into contact do at first what their neighbour does.
    fn start(&mut self, contact: usize) {
        if contact == self.contact {
            return;
        }
        for j in self.contact..contact {
            self.sticks[j] = j == 0 || self.sticks[j - 1];
            for axis in 0..2 {
                let neighbour = if j == 0 { [1.0, 0.0][axis] } else { self.direction[axis][j - 1] };
                self.direction[axis][j] = neighbour;
            }
        }
        self.contact = contact;
        self.sticks[contact..].fill(false);
        self.bound[contact..].fill(1.0);
        for axis in 0..2 {
            for row in [&mut self.direction, &mut self.free, &mut self.traction, &mut self.slip] {
                row[axis][contact..].fill(0.0);
            }
        }
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
    fn partition(&mut self) {
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
        if turn > TOLERANCE {
            Verdict::DirectionsTurn(turn)
        } else {
            Verdict::Solved
        }
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

/// The blocks of eight that hold the first m numbers of a padded row.
#[inline(always)]
fn eights<T>(row: &[T], m: usize) -> &[[T; 8]] {
    &row.as_chunks::<8>().0[..m.div_ceil(8)]
}

/// `out` = the leading m x m block of `matrix` times `of`, both components.
#[inline(always)]
fn product(matrix: &[f64], stride: usize, m: usize, of: &Plane, out: &mut Plane) {
    let [of_y, of_z] = [&of[0][..m], &of[1][..m]];
    for start in (0..m).step_by(8) {
        let (mut y, mut z) = ([0.0; 8], [0.0; 8]);
        for ((column, of_y), of_z) in matrix.chunks_exact(stride).zip(of_y).zip(of_z) {
            let column = &column[start..start + 8];
            for lane in 0..8 {
                y[lane] += column[lane] * of_y;
                z[lane] += column[lane] * of_z;
            }
        }
        out[0][start..start + 8].copy_from_slice(&y);
        out[1][start..start + 8].copy_from_slice(&z);
    }
}
