//! What packs are: numbers that physics computes on, filled from arrays and from nodes.

use crate::elementary::Primal;
use crate::{Scalar, Vec3};
use core::fmt::Debug;

/// Numbers without derivatives side by side, filled and read lane by lane.
pub trait Numbers: Primal {
    /// Numbers whose lane `i` is `value(i)`.
    fn from_fn(value: impl FnMut(usize) -> f64) -> Self;
    /// As many consecutive numbers as there are lanes.
    fn from_slice(values: &[f64]) -> Self;
    /// Writes as many consecutive numbers.
    fn write_to(self, values: &mut [f64]);
}

/// Numbers that are one pack.
pub trait Lanes: Numbers + Pack<Real = f64> {
    /// Packs of at most four lanes that it is made of: [`Pack::Quad`], known to be plain.
    type Four: Lanes;
    /// See [`Pack::quad`].
    fn four(self, index: usize) -> Self::Four;
}

/// A computation on the rows of a batch that [`dispatch_rows`](crate::dispatch_rows) runs with two packs at a time.
pub trait RowsKernel {
    /// What it returns.
    type Output;
    /// The computation; implement with `#[inline(always)]`.
    fn run<S: Numbers>(self) -> Self::Output;
}

/// A computation that [`dispatch`](crate::dispatch) runs with the widest lanes of this CPU.
pub trait Kernel {
    /// What it returns.
    type Output;
    /// The computation; implement with `#[inline(always)]`.
    fn run<S: Lanes>(self) -> Self::Output;
}

/// A number that is stored in arrays, with the packs that compute on it: `f64`, or `f64` with derivatives.
///
/// It is made of parts: its value, then each derivative. Arrays that packs read keep the parts of several numbers
/// apart, values next to values, so that every part of a pack is one load.
pub trait Real: Scalar + Send + Sync {
    /// Number of parts.
    const PARTS: usize;
    /// Something for each part, one after the other in memory: `A` for `f64`.
    type Parts<A: Copy + Debug + Send + Sync + 'static>: Copy + Debug + Send + Sync + 'static;
    /// Its derivatives.
    fn derivatives(&self) -> &[f64];
    /// The number whose parts stand `stride` numbers apart, the value at an address.
    ///
    /// # Safety
    /// All of them can be read.
    unsafe fn from_parts(at: *const f64, stride: usize) -> Self;
    /// Writes the parts likewise.
    ///
    /// # Safety
    /// All of them can be written.
    unsafe fn put_parts(self, at: *mut f64, stride: usize);
    /// The same for each part.
    fn each_part<A: Copy + Debug + Send + Sync + 'static>(value: A) -> Self::Parts<A>;
    /// What there is for one part.
    fn part_mut<A: Copy + Debug + Send + Sync + 'static>(parts: &mut Self::Parts<A>, part: usize) -> &mut A;
    /// `sum += s v` for four numbers at once, by a number that depends on no variable.
    fn add_times(sum: &mut Self::Parts<[f64; 4]>, v: &Self::Parts<[f64; 4]>, s: f64);
    /// `sum += s v` for four numbers at once.
    fn add_scaled(sum: &mut Self::Parts<[f64; 4]>, v: &Self::Parts<[f64; 4]>, s: Self);
    /// Runs a kernel with the widest packs of this number that the CPU has.
    fn dispatch<K: PackKernel<Self>>(kernel: K) -> K::Output;
    /// Runs a kernel on single numbers: for what is seldom done and would take long to compile in every width.
    fn singly<K: PackKernel<Self>>(kernel: K) -> K::Output;
}

/// A computation on packs of `R`.
pub trait PackKernel<R> {
    /// What it returns.
    type Output;
    /// The computation; implement with `#[inline(always)]`.
    fn run<P: Pack<Real = R>>(self) -> Self::Output;
}

/// Numbers of a row.
const WIDTH: usize = 4;

/// A vector at a node, padded to four numbers: their values, then each of their derivatives.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct Row<R: Real>(pub R::Parts<[f64; WIDTH]>);

impl<R: Real> Row<R> {
    /// From its numbers.
    #[inline(always)]
    pub fn new(numbers: [R; WIDTH]) -> Self {
        let mut row = core::mem::MaybeUninit::<Self>::uninit();
        for (c, number) in numbers.into_iter().enumerate() {
            // SAFETY: a row is as many times four numbers as one has parts, and all are written.
            unsafe { number.put_parts(row.as_mut_ptr().cast::<f64>().add(c), WIDTH) };
        }
        // SAFETY: as above.
        unsafe { row.assume_init() }
    }
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new([R::zero(); WIDTH])
    }
    /// From a vector.
    #[inline(always)]
    pub fn from_vec(v: Vec3<R>) -> Self {
        Self::new([v.x, v.y, v.z, R::zero()])
    }
    /// As a vector.
    #[inline(always)]
    pub fn vec(&self) -> Vec3<R> {
        Vec3::new(self.get(0), self.get(1), self.get(2))
    }
    /// One of the numbers.
    #[inline(always)]
    pub fn get(&self, index: usize) -> R {
        assert!(index < WIDTH);
        // SAFETY: a row is as many times four numbers as one has parts.
        unsafe { R::from_parts(core::ptr::from_ref(self).cast::<f64>().add(index), WIDTH) }
    }
    /// Sets one of the numbers.
    #[inline(always)]
    pub fn set(&mut self, index: usize, number: R) {
        assert!(index < WIDTH);
        // SAFETY: as above.
        unsafe { number.put_parts(core::ptr::from_mut(self).cast::<f64>().add(index), WIDTH) };
    }
    /// Adds a vector.
    #[inline(always)]
    pub fn add(&mut self, v: Vec3<R>) {
        self.set(0, self.get(0) + v.x);
        self.set(1, self.get(1) + v.y);
        self.set(2, self.get(2) + v.z);
    }
    /// Adds a row times a number that depends on no variable, all four numbers at once.
    #[inline(always)]
    pub fn add_times(&mut self, row: &Self, by: f64) {
        R::add_times(&mut self.0, &row.0, by);
    }
    /// Adds a row times a number, all four numbers at once.
    #[inline(always)]
    pub fn add_scaled(&mut self, row: &Self, by: R) {
        R::add_scaled(&mut self.0, &row.0, by);
    }
}

/// A pack of [`Scalar::LANES`] stored numbers.
pub trait Pack: Scalar + Send + Sync {
    /// The number stored in arrays.
    type Real: Real;
    /// A pack of their values.
    type Value: Lanes + Part<Self>;
    /// A pack of pairs of value and derivative; of values where there are no derivatives.
    type Pair: Part<Self>;
    /// What a pack is made of: packs of at most four lanes.
    type Quad: Pack<Real = Self::Real>;
    /// One of the first lanes, the next, and so on.
    fn quad(self, index: usize) -> Self::Quad;
    /// One of the parts: the value, then each derivative.
    fn part(self, index: usize) -> Self::Value;
    /// Sets it.
    fn set_part(&mut self, index: usize, part: Self::Value);
    /// Each quad from an address of its own; those of quads that the pack does not have are not used.
    ///
    /// # Safety
    /// As for [`Pack::read_parts`].
    unsafe fn read_quads(at: [*const f64; 2], stride: usize) -> Self;
    /// `LANES` consecutive numbers whose parts stand `stride` numbers apart, the first value at an address.
    ///
    /// # Safety
    /// All of them can be read.
    unsafe fn read_parts(at: *const f64, stride: usize) -> Self;
    /// Writes `LANES` consecutive numbers likewise.
    ///
    /// # Safety
    /// All of them can be written.
    unsafe fn write_parts(self, at: *mut f64, stride: usize);
    /// The same number in every lane.
    fn splat(value: Self::Real) -> Self;
    /// `LANES` consecutive numbers.
    #[inline(always)]
    fn load(values: &[Self::Real]) -> Self {
        let values = &values[..Self::LANES];
        // SAFETY: as many as a pack has lanes.
        unsafe { Self::read(values.as_ptr()) }
    }
    /// Writes `LANES` consecutive numbers.
    #[inline(always)]
    fn store(self, values: &mut [Self::Real]) {
        let values = &mut values[..Self::LANES];
        // SAFETY: as above.
        unsafe { self.write(values.as_mut_ptr()) };
    }
    /// `LANES` consecutive numbers from an address, of any alignment that the number itself may have.
    ///
    /// # Safety
    /// All of them can be read.
    unsafe fn read(at: *const Self::Real) -> Self;
    /// Writes `LANES` consecutive numbers to an address.
    ///
    /// # Safety
    /// All of them can be written.
    unsafe fn write(self, at: *mut Self::Real);
    /// Lanes moved up by one, the first filled with the last of the pack that stands before this one.
    #[must_use]
    fn after(self, before: Self) -> Self;
    /// Number of one lane.
    fn real(self, lane: usize) -> Self::Real;
    /// Vectors of the nodes `index[..LANES]`, one a lane.
    ///
    /// # Safety
    /// `index` holds at least `LANES` entries, each below `rows.len()`.
    unsafe fn gather(rows: &[Row<Self::Real>], index: &[u32]) -> Vec3<Self>;
    /// Adds lane `i` to node `index[i]`, in the order of the lanes.
    ///
    /// # Safety
    /// As for [`Pack::gather`].
    unsafe fn scatter_add(rows: &mut [Row<Self::Real>], index: &[u32], value: Vec3<Self>);
    /// Writes one row a lane, the lanes of the first pack to the first rows.
    fn put_rows(rows: &mut [Row<Self::Real>], value: Vec3<Self>);
}

/// What one pass of a linear map acts on. Such a map goes through the parts of a pack `P` one after the other, each in
/// a pass of its own, so that the numbers of one pass fit the registers. Where its coefficients depend on no variable,
/// passes act on plain packs. Where they depend on the variable of a pass, this acts on pairs of value and derivative,
/// and what it finds is the derivative; the value belongs to the first pass.
pub trait Part<P: Pack>: Pack {
    /// What a pass acts on.
    fn from_pack(pack: &P, pass: usize) -> Self;
    /// The first part that a pass reads, and how far apart those are that it reads.
    fn places(pass: usize) -> [usize; 2];
    /// A coefficient from the addresses of its value and of its derivative by the variable of a pass, which a pass
    /// with plain coefficients does not read.
    ///
    /// # Safety
    /// `LANES` consecutive numbers can be read from each.
    unsafe fn coefficient(value: *const f64, derivative: *const f64) -> Self;
    /// Result of a pass.
    fn into_value(self) -> P::Value;
    /// A value to add to a result; with pairs, only the derivative counts.
    fn from_value(value: P::Value) -> Self;
}
