//! State variables of points, and when they are updated.

use crate::block::{BLOCK, Eight};
use clubface_math::{Pack, Real};

/// Eight points each with these numbers.
pub fn eight_alike<R: Real>(numbers: &[R]) -> Vec<Eight<R>> {
    numbers.iter().map(|number| Eight::alike(*number)).collect()
}

/// Numbers of the points of a pack, which begins with the point `first` of eight.
pub struct Numbers<'a, R: Real> {
    all: &'a mut [Eight<R>],
    first: usize,
}

impl<'a, R: Real> Numbers<'a, R> {
    /// Numbers of a pack of points, which begins with the point `first` of eight.
    #[inline(always)]
    pub fn new(all: &'a mut [Eight<R>], first: usize) -> Self {
        Self { all, first }
    }
    /// Some consecutive numbers.
    #[inline(always)]
    pub fn load<P: Pack<Real = R>, const N: usize>(&self, from: usize) -> [P; N] {
        let mut values = [P::zero(); N];
        for i in 0..N {
            values[i] = self.all[from + i].load(self.first);
        }
        values
    }
    /// Writes them.
    #[inline(always)]
    pub fn store<P: Pack<Real = R>, const N: usize>(&mut self, from: usize, values: [P; N]) {
        for i in 0..N {
            self.all[from + i].store(self.first, values[i]);
        }
    }
}

/// State variables of blocks of eight points. What few steps need stands apart, so that the caches are full of what
/// all steps do.
#[derive(Clone, Debug)]
pub struct StateVariables<R: Real> {
    every_step: Vec<Eight<R>>,
    energy_only: Vec<Eight<R>>,
    /// Numbers a point.
    counts: [usize; 2],
}

impl<R: Real> StateVariables<R> {
    /// Points in as many blocks, all of the state given: variables for every step, and for the energies only.
    pub fn new([every_step, energy_only]: [Vec<R>; 2], blocks: usize) -> Self {
        let counts = [every_step.len(), energy_only.len()];
        let repeated = |numbers: &[R]| eight_alike(numbers).repeat(blocks);
        Self { every_step: repeated(&every_step), energy_only: repeated(&energy_only), counts }
    }
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.every_step.is_empty()
    }
    /// Those for every step of the points of a pack, which begins with a lane, counted over all blocks.
    #[inline(always)]
    pub fn every_step(&mut self, lane: usize) -> Numbers<'_, R> {
        let (block, count) = (lane / BLOCK, self.counts[0]);
        Numbers::new(&mut self.every_step[block * count..(block + 1) * count], lane % BLOCK)
    }
    /// Those for the energies only, likewise.
    #[inline(always)]
    pub fn energy_only(&mut self, lane: usize) -> Numbers<'_, R> {
        let (block, count) = (lane / BLOCK, self.counts[1]);
        Numbers::new(&mut self.energy_only[block * count..(block + 1) * count], lane % BLOCK)
    }
    /// A copy of some blocks, to try what comes of a step.
    #[must_use]
    pub fn copy(&self, blocks: std::ops::Range<usize>) -> Self {
        let [every_step, energy_only] = self.counts;
        let span = |count: usize| blocks.start * count..blocks.end * count;
        Self {
            every_step: self.every_step[span(every_step)].to_vec(),
            energy_only: self.energy_only[span(energy_only)].to_vec(),
            counts: self.counts,
        }
    }
}

/// Steps after which the work on viscoelastic branches is added up: numbers that are seldom read leave their place in
/// the caches to others. By default energies are recorded after a multiple of so many, and see all of the work.
const WORK_PERIOD: usize = 4;

/// A step of state variables.
#[derive(Clone, Copy, Debug)]
pub struct Update {
    /// Its time, s.
    pub dt: f64,
    /// Whether the work on branches is added up.
    pub add_work: bool,
}

/// The steps of some points.
#[derive(Clone, Copy, Debug, Default)]
pub struct Updates {
    steps: usize,
    last: f64,
}

impl Updates {
    /// The next step, of `dt` seconds; in no time nothing moves on.
    pub fn next(&mut self, dt: f64) -> Update {
        if dt == 0.0 {
            return Update { dt, add_work: false };
        }
        (self.steps, self.last) = (self.steps + 1, dt);
        Update { dt, add_work: self.steps % WORK_PERIOD == 1 }
    }
    /// One more step like the last, to see what comes of it.
    #[must_use]
    pub fn preview(&self) -> Update {
        Update { dt: self.last, add_work: false }
    }
}
