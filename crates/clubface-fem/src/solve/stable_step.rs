//! The largest time step with which central differences are stable.

use super::Structure;
use super::shared_slice::SharedSlice;
use super::worker_pool::{Stage, WorkerPool};
use crate::contact::PenaltySprings;
use clubface_math::{Real, Row};

/// Largest displacement of a stiffness probe, m: small compared with an element, large compared with the rounding of
/// positions.
const DISPLACEMENT: f64 = 1e-8;

/// The step (s) rounded down to one of 64 in every factor of two: cases that hardly differ then have the same step, and
/// results that differ smoothly.
pub(super) fn rounded(step: f64) -> f64 {
    ((step.log2() * 64.0).floor() / 64.0).exp2()
}

/// Contact springs for a ball of the given stable step (s). They do not depend on the step of the run.
#[must_use]
pub fn springs_for_stable_step(stable: f64) -> PenaltySprings {
    PenaltySprings { step: Some(rounded(0.9 * stable)), ..PenaltySprings::default() }
}

impl<R: Real> Structure<R> {
    /// The stable step, s: two over the highest angular frequency of the structure in its current state.
    ///
    /// The frequency comes from Lanczos' method on the forces of small displacements (Golub and Van Loan, Matrix
    /// Computations, section 10.1). Its largest value approaches the true one from below; the residual is added to it,
    /// which puts it on the safe side once the highest mode has been found. Positions and state variables stay as they
    /// are.
    pub fn stable_step(&mut self, iterations: usize) -> f64 {
        self.stable_step_of(&vec![true; self.patches.len()], iterations)
    }

    /// The stable step (s) of some patches alone, with the masses of all.
    pub(super) fn stable_step_of(&mut self, chosen: &[bool], iterations: usize) -> f64 {
        let executor = self.executor.clone();
        // One pool for all iterations: its workers stay awake in between.
        WorkerPool::with(&*executor, |pool| self.stable_step_with(pool, chosen, iterations))
    }

    fn stable_step_with(&mut self, pool: &WorkerPool<'_>, chosen: &[bool], iterations: usize) -> f64 {
        self.synchronise();
        let [schedule, _] = self.schedules();
        let initial = self.positions.clone();
        let mut displacements = vec![Row::zero(); initial.len()];
        let masses: Vec<f64> = self.masses.iter().map(|m| m.re()).collect();
        let inverse: Vec<f64> = masses.iter().map(|m| 1.0 / m).collect();
        // A start that is the same every time and has a part along every mode.
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
        };
        let mut current: Vec<_> = masses.iter().map(|_| Row([random(), random(), random(), 0.0])).collect();
        let mut before = vec![Row::zero(); masses.len()];
        let (mut diagonal, mut off_diagonal) = (Vec::new(), Vec::new());
        let mut norm = dot(&current, &current, &masses).sqrt();
        for _ in 0..iterations {
            let scale = DISPLACEMENT / normalise(&mut current, norm);
            for (((x, u), r), v) in
                self.positions.iter_mut().zip(&mut displacements).zip(&initial).zip(&current)
            {
                for c in 0..4 {
                    u.set(c, R::from_f64(v.0[c] * scale));
                    x.set(c, r.get(c) + u.get(c));
                }
            }
            let (positions, patches) = (&self.positions, SharedSlice::new(&mut self.patches));
            // SAFETY: a schedule has every patch once.
            let perturb = |task: usize, _: usize| unsafe {
                if chosen.get(task) == Some(&true) {
                    patches.get(task).perturbed_forces(positions, &displacements);
                }
            };
            pool.run(&Stage { task: &perturb, schedule: &schedule });
            // The next vector: accelerations, without what lies along the last two.
            let last = off_diagonal.last().copied().unwrap_or(0.0);
            before.iter_mut().for_each(|v: &mut Row<f64>| v.0 = v.0.map(|v| -last * v));
            for (patch, _) in self.patches.iter().zip(chosen).filter(|(_, chosen)| **chosen) {
                for (&node, force) in patch.nodes().iter().zip(patch.forces()) {
                    let factor = inverse[node as usize] / scale;
                    for c in 0..3 {
                        before[node as usize].0[c] -= force.get(c).re() * factor;
                    }
                }
            }
            let along = dot(&before, &current, &masses);
            for (v, w) in before.iter_mut().zip(&current) {
                for c in 0..4 {
                    v.0[c] -= along * w.0[c];
                }
            }
            std::mem::swap(&mut before, &mut current);
            norm = dot(&current, &current, &masses).sqrt();
            diagonal.push(along);
            off_diagonal.push(norm);
        }
        self.positions = initial;
        2.0 / largest_eigenvalue(&diagonal, &off_diagonal).sqrt()
    }
}

/// Product of two fields, weighted by mass.
fn dot(a: &[Row<f64>], b: &[Row<f64>], masses: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    for ((a, b), m) in a.iter().zip(b).zip(masses) {
        for c in 0..4 {
            sums[c] += a.0[c] * b.0[c] * m;
        }
    }
    sums.iter().sum()
}

/// Divides a field by its norm; returns its largest component.
fn normalise(field: &mut [Row<f64>], norm: f64) -> f64 {
    let mut most = [0.0_f64; 4];
    for v in field {
        for c in 0..4 {
            v.0[c] /= norm;
            most[c] = if v.0[c].abs() > most[c] { v.0[c].abs() } else { most[c] };
        }
    }
    most.into_iter().fold(0.0, f64::max)
}

/// Largest eigenvalue of a symmetric tridiagonal matrix, plus its residual: the last off-diagonal number, which
/// belongs to the next row, times the last component of the eigenvector.
#[must_use]
pub fn largest_eigenvalue(diagonal: &[f64], off_diagonal: &[f64]) -> f64 {
    let n = diagonal.len();
    let reach = |i: usize| if i == 0 { 0.0 } else { off_diagonal[i - 1].abs() } + off_diagonal[i].abs();
    let mut high = (0..n).fold(0.0_f64, |most, i| most.max(diagonal[i] + reach(i)));
    let mut low = 0.0;
    // All pivots of the matrix less a number are negative if and only if the number exceeds every eigenvalue.
    let exceeds = |value: f64| {
        let mut pivot = -1.0;
        (0..n).all(|i| {
            let square = if i == 0 { 0.0 } else { off_diagonal[i - 1] * off_diagonal[i - 1] };
            pivot = diagonal[i] - value - square / pivot;
            pivot < 0.0
        })
    };
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if exceeds(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    // The eigenvector by its recurrence from the last component back, which is stable for the largest eigenvalue.
    let (mut vector, mut next, mut sum) = (1.0_f64, 0.0, 1.0);
    for i in (1..n).rev() {
        let here = ((high - diagonal[i]) * vector - off_diagonal[i] * next) / off_diagonal[i - 1];
        (next, vector) = (vector, here);
        sum += here * here;
    }
    high + off_diagonal[n - 1] / sum.sqrt()
}
