//! Influence matrices of the rings: what a traction does to the surface of an elastic half-space.
//!
//! Tractions are sums of discs, q(r) = sum of Q_i sqrt(a_i^2 - r^2) over a_i > r (Maw, Barber and Fawcett 1976), with
//! a_i = a_max i/n, collocated at mid-radii r_j = a_max (j - 1/2)/n. In units of a_max everything here is a constant of
//! n: T (traction of a disc, upper triangular), C (displacement of a disc), M = C T^-1 (displacement of tractions) and
//! the weights w (force of tractions). T and its inverse are triangular, so with m rings in contact, where only discs
//! that end inside the contact carry traction, the leading m x m blocks are the exact matrices of that contact.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Matrices of n rings, dimensionless; columns are contiguous, each padded with zeros to [`Influence::stride`].
#[derive(Debug)]
pub struct Influence {
    rings: usize,
    stride: usize,
    /// `exchanged[k]`: M with the first k rings exchanged (see [`Influence::exchanged`]); made when first asked for.
    exchanged: Vec<OnceLock<Box<[f64]>>>,
    diagonal: Vec<f64>,
    force: Vec<f64>,
    radius: Vec<f64>,
}

impl Influence {
    /// The matrices of `rings` rings, made once and shared by everyone who asks.
    #[must_use]
    pub fn shared(rings: usize) -> Arc<Self> {
        static MADE: Mutex<BTreeMap<usize, Arc<Influence>>> = Mutex::new(BTreeMap::new());
        let mut made = MADE.lock().unwrap_or_else(PoisonError::into_inner);
        Arc::clone(made.entry(rings).or_insert_with(|| Arc::new(Self::new(rings))))
    }

    fn new(rings: usize) -> Self {
        let n = rings as f64;
        let stride = rings.next_multiple_of(8);
        let outer: Vec<f64> = (0..rings).map(|i| (i as f64 + 1.0) / n).collect();
        let radius: Vec<f64> = (0..rings).map(|j| (j as f64 + 0.5) / n).collect();
        // Inverse of T by back substitution, column by column: inverse[i][j], i <= j.
        let traction = |j: usize, i: usize| (outer[i].powi(2) - radius[j].powi(2)).sqrt();
        let mut inverse = vec![vec![0.0; rings]; rings];
        for column in 0..rings {
            inverse[column][column] = traction(column, column).recip();
            for row in (0..column).rev() {
                let sum: f64 = (row + 1..=column).map(|i| traction(row, i) * inverse[i][column]).sum();
                inverse[row][column] = -sum / traction(row, row);
            }
        }
        let mut displacement = vec![0.0; stride * rings].into_boxed_slice();
        let mut force = vec![0.0; rings];
        for column in 0..rings {
            for row in 0..rings {
                displacement[column * stride + row] =
                    (0..=column).map(|i| disc_displacement(outer[i], radius[row]) * inverse[i][column]).sum();
            }
            force[column] =
                (0..=column).map(|i| 2.0 * PI / 3.0 * outer[i].powi(3) * inverse[i][column]).sum();
        }
        let diagonal =
            (0..stride).map(|j| if j < rings { displacement[j * stride + j] } else { 1.0 }).collect();
        let exchanged: Vec<OnceLock<Box<[f64]>>> = (0..=rings).map(|_| OnceLock::new()).collect();
        exchanged[0].get_or_init(|| displacement);
        Self { rings, stride, exchanged, diagonal, force, radius }
    }

    /// Number of rings n.
    #[must_use]
    pub fn rings(&self) -> usize {
        self.rings
    }
    /// Distance in memory between columns.
    #[must_use]
    pub fn stride(&self) -> usize {
        self.stride
    }
    /// Mid-radii r_j / a_max, shape `n`, increasing.
    #[must_use]
    pub fn radius(&self) -> &[f64] {
        &self.radius
    }
    /// Weights w, shape `n`: the force of tractions q is a_max^2 sum of w_j q_j.
    #[must_use]
    pub fn force(&self) -> &[f64] {
        &self.force
    }
    /// M, shape [n, n]: the displacement of tractions q is (2 - nu)/(8 G) a_max M q.
    #[must_use]
    pub fn displacement(&self) -> &[f64] {
        self.exchanged(0)
    }
    /// M_jj, shape `n`, and ones up to [`Self::stride`].
    #[must_use]
    pub fn diagonal(&self) -> &[f64] {
        &self.diagonal
    }
    /// h = M q solved for (q of the first k rings, h of the others), given (h of the first k rings, q of the others):
    /// what a contact needs whose first k rings stick, their displacement being known, and whose others slip, their
    /// traction being known. Its leading m x m block is that of m rings.
    #[must_use]
    pub fn exchanged(&self, k: usize) -> &[f64] {
        self.exchanged[k].get_or_init(|| {
            let mut matrix: Box<[f64]> = self.exchanged(k - 1).into();
            exchange(&mut matrix, self.stride, self.rings, k - 1, &mut vec![0.0; self.stride]);
            matrix
        })
    }
}

/// Exchanges the known and the unknown of one ring (a principal pivot); doing it twice undoes it. Works on the leading
/// `rings` x `rings` block, with `scratch` for a column.
#[inline(always)]
pub fn exchange(matrix: &mut [f64], stride: usize, rings: usize, ring: usize, scratch: &mut [f64]) {
    let padded = rings.next_multiple_of(8);
    let scratch = &mut scratch[..padded];
    scratch.copy_from_slice(&matrix[ring * stride..][..padded]);
    let inverse = scratch[ring].recip();
    scratch[ring] = 0.0;
    for column in matrix.chunks_exact_mut(stride).take(rings) {
        let column = &mut column[..padded];
        let factor = -column[ring] * inverse;
        for (value, pivot) in column.iter_mut().zip(&*scratch) {
            *value += pivot * factor;
        }
        column[ring] = factor;
    }
    let column = &mut matrix[ring * stride..][..padded];
    for (value, pivot) in column.iter_mut().zip(&*scratch) {
        *value = pivot * inverse;
    }
    column[ring] = inverse;
}

/// U(r) of a disc of radius `a` and unit Q: its displacement is (2 - nu)/(8 G) Q U(r).
#[must_use]
pub fn disc_displacement(a: f64, r: f64) -> f64 {
    let twice = 2.0 * a * a - r * r;
    if r <= a { PI / 2.0 * twice } else { twice * (a / r).asin() + a * (r * r - a * a).sqrt() }
}
