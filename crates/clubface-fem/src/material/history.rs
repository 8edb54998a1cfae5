//! What points remember from step to step, and when.

use super::Material;
use crate::block::{Aligned, BLOCK};
use clubface_math::{Pack, Real};

/// One number of eight points.
pub type Eight<R> = Aligned<[R; BLOCK]>;

/// Eight points each with these numbers.
pub fn eight_alike<R: Real>(numbers: &[R]) -> Vec<Eight<R>> {
    numbers.iter().map(|number| Aligned([*number; BLOCK])).collect()
}

/// Numbers of the points of a pack, which begins with the point `first` of eight.
pub struct Numbers<'a, R> {
    all: &'a mut [Eight<R>],
    first: usize,
}

impl<'a, R> Numbers<'a, R> {
    /// Of some of eight points.
    #[inline(always)]
    pub fn new(all: &'a mut [Eight<R>], first: usize) -> Self {
        Self { all, first }
    }
    /// Some consecutive numbers.
    #[inline(always)]
    pub fn load<P: Pack<Real = R>, const N: usize>(&self, from: usize) -> [P; N] {
        let mut values = [P::zero(); N];
        for i in 0..N {
            values[i] = P::load(&self.all[from + i].0[self.first..]);
        }
        values
    }
    /// Writes them.
    #[inline(always)]
    pub fn store<P: Pack<Real = R>, const N: usize>(&mut self, from: usize, values: [P; N]) {
        for i in 0..N {
            values[i].store(&mut self.all[from + i].0[self.first..]);
        }
    }
}

/// What the points of a pack remember.
pub struct Memory<'a, R> {
    /// For every step.
    pub often: Numbers<'a, R>,
    /// For some steps only.
    pub seldom: Numbers<'a, R>,
}

/// What blocks of eight points remember. What few steps need stands apart, so that the caches are full of what all steps do.
#[derive(Clone, Debug)]
pub struct History<R> {
    often: Vec<Eight<R>>,
    seldom: Vec<Eight<R>>,
    /// Numbers a point.
    counts: [usize; 2],
}

impl<R: Real> History<R> {
    /// Undeformed points of a material, in as many blocks.
    pub fn new(material: &Material<R>, blocks: usize) -> Self {
        let memory = material.memory();
        let counts = memory.each_ref().map(Vec::len);
        let [often, seldom] = memory.map(|numbers| eight_alike(&numbers).repeat(blocks));
        Self { often, seldom, counts }
    }
    /// Whether there is nothing to remember.
    pub fn is_empty(&self) -> bool {
        self.often.is_empty()
    }
    /// What the points of a pack remember, which begins with the point `first` of a block.
    #[inline(always)]
    pub fn of(&mut self, block: usize, first: usize) -> Memory<'_, R> {
        let [often, seldom] = self.counts;
        Memory {
            often: Numbers::new(&mut self.often[block * often..(block + 1) * often], first),
            seldom: Numbers::new(&mut self.seldom[block * seldom..(block + 1) * seldom], first),
        }
    }
    /// A copy of one block, to try what comes of a step.
    pub fn copy(&self, block: usize) -> Self {
        let [often, seldom] = self.counts;
        Self {
            often: self.often[block * often..(block + 1) * often].to_vec(),
            seldom: self.seldom[block * seldom..(block + 1) * seldom].to_vec(),
            counts: self.counts,
        }
    }
}

/// Steps after which the work on viscoelastic branches is added up: numbers that are read seldom leave their place in the caches to others. By default energies
/// are recorded after a multiple of so many, and see all of the work.
const TALLY: usize = 4;

/// A step of what points remember.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Its time, s.
    pub(super) dt: f64,
    /// Whether the work on branches is added up.
    pub(super) tally: bool,
}

/// The steps of some points.
#[derive(Clone, Copy, Debug, Default)]
pub struct Clock {
    steps: usize,
    last: f64,
}

impl Clock {
    /// The next step, of `dt` seconds; in no time nothing is remembered.
    pub fn tick(&mut self, dt: f64) -> Step {
        if dt == 0.0 {
            return Step { dt, tally: false };
        }
        (self.steps, self.last) = (self.steps + 1, dt);
        Step { dt, tally: self.steps % TALLY == 1 }
    }
    /// One more step like the last, to see what comes of it.
    #[must_use]
    pub fn ahead(&self) -> Step {
        Step { dt: self.last, tally: false }
    }
}
