//! What packs are: numbers that physics computes on, filled from arrays and from nodes.

use super::row::Row;
use crate::elementary::Primal;
use crate::{Scalar, Vec3};

/// A scalar without derivatives that can be filled and read lane by lane.
pub trait Lanes: Primal + Pack<Real = f64> {
    /// A pack whose lane `i` is `value(i)`.
    fn from_fn(value: impl FnMut(usize) -> f64) -> Self;
}

/// A computation that [`dispatch`] runs with the widest lanes of this CPU.
pub trait Kernel {
    /// What it returns.
    type Output;
    /// The computation; implement with `#[inline(always)]`.
    fn run<S: Lanes>(self) -> Self::Output;
}

/// A number that is stored in arrays, with the packs that compute on it: `f64`, or `f64` with derivatives.
pub trait Real: Scalar + Send + Sync {
    /// Its derivatives.
    fn derivatives(&self) -> &[f64];
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

/// A pack of [`Scalar::LANES`] stored numbers.
pub trait Pack: Scalar {
    /// The number stored in arrays.
    type Real: Real;
    /// What a pack is made of: packs of at most four lanes.
    type Quad: Pack<Real = Self::Real>;
    /// One of the first lanes, the next, and so on.
    fn quad(self, which: usize) -> Self::Quad;
    /// Each quad from an address of its own; those of quads that the pack does not have are not used.
    ///
    /// # Safety
    /// As for [`Pack::read`].
    unsafe fn read_quads(at: [*const Self::Real; 2]) -> Self;
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

/// Packs that are themselves a quad.
macro_rules! single_quad {
    () => {
        type Quad = Self;
        #[inline(always)]
        fn quad(self, _which: usize) -> Self {
            self
        }
        #[inline(always)]
        unsafe fn read_quads(at: [*const Self::Real; 2]) -> Self {
            // SAFETY: the caller's promise.
            unsafe { Self::read(at[0]) }
        }
    };
}
pub(super) use single_quad;
