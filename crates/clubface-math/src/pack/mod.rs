//! Packs of mesh elements: gathering the vectors of nodes into lanes and adding lanes back to nodes.
//!
//! A field on nodes is stored as one [`Row`] a node. A pack reads the rows of as many nodes as it has lanes and transposes them
//! in registers, which costs less than the arithmetic it feeds; eight separate reads a component cost more.

mod dual;
#[cfg(target_arch = "x86_64")]
mod x86;

use crate::lanes::{dispatch, Kernel, Lanes};
use crate::{Scalar, Vec3};

/// A vector at a node, padded to four numbers.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct Row<R>(pub [R; 4]);

impl<R: Scalar> Row<R> {
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self([R::zero(); 4])
    }
    /// From a vector.
    #[inline(always)]
    pub fn from_vec(v: Vec3<R>) -> Self {
        Self([v.x, v.y, v.z, R::zero()])
    }
    /// As a vector.
    #[inline(always)]
    pub fn vec(&self) -> Vec3<R> {
        Vec3::new(self.0[0], self.0[1], self.0[2])
    }
    /// Adds a vector.
    #[inline(always)]
    pub fn add(&mut self, v: Vec3<R>) {
        self.0[0] += v.x;
        self.0[1] += v.y;
        self.0[2] += v.z;
    }
}

/// Asks the CPU to bring the value `ahead` places further into its cache; there need be none.
#[inline(always)]
pub fn prefetch<T>(from: *const T, ahead: usize) {
    #[cfg(target_arch = "x86_64")]
    for line in (0..size_of::<T>()).step_by(64) {
        let at = from.wrapping_add(ahead).cast::<i8>().wrapping_add(line);
        // SAFETY: a prefetch reads nothing and cannot fault, and every CPU of this kind has it.
        unsafe { core::arch::x86_64::_mm_prefetch::<{ core::arch::x86_64::_MM_HINT_T0 }>(at) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (from, ahead);
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
    fn load(values: &[Self::Real]) -> Self;
    /// Writes `LANES` consecutive numbers.
    fn store(self, values: &mut [Self::Real]);
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
use single_quad;

impl Real for f64 {
    fn derivatives(&self) -> &[f64] {
        &[]
    }
    #[inline(always)]
    fn dispatch<K: PackKernel<Self>>(kernel: K) -> K::Output {
        struct Plain<K>(K);
        impl<K: PackKernel<f64>> Kernel for Plain<K> {
            type Output = K::Output;
            #[inline(always)]
            fn run<S: Lanes>(self) -> K::Output {
                self.0.run::<S>()
            }
        }
        dispatch(Plain(kernel))
    }
    fn singly<K: PackKernel<Self>>(kernel: K) -> K::Output {
        kernel.run::<Self>()
    }
}

/// A number on its own as a pack of one lane.
impl Pack for f64 {
    type Real = Self;
    single_quad!();
    #[inline(always)]
    fn splat(value: Self) -> Self {
        value
    }
    #[inline(always)]
    fn load(values: &[Self]) -> Self {
        values[0]
    }
    #[inline(always)]
    fn store(self, values: &mut [Self]) {
        values[0] = self;
    }
    #[inline(always)]
    unsafe fn read(at: *const Self) -> Self {
        // SAFETY: the caller's promise.
        unsafe { *at }
    }
    #[inline(always)]
    unsafe fn write(self, at: *mut Self) {
        // SAFETY: the caller's promise.
        unsafe { *at = self };
    }
    #[inline(always)]
    fn after(self, before: Self) -> Self {
        before
    }
    #[inline(always)]
    fn real(self, _lane: usize) -> Self {
        self
    }
    #[inline(always)]
    unsafe fn gather(rows: &[Row<Self>], index: &[u32]) -> Vec3<Self> {
        // SAFETY: the caller's promise.
        unsafe { rows.get_unchecked(*index.get_unchecked(0) as usize) }.vec()
    }
    #[inline(always)]
    unsafe fn scatter_add(rows: &mut [Row<Self>], index: &[u32], value: Vec3<Self>) {
        // SAFETY: the caller's promise.
        unsafe { rows.get_unchecked_mut(*index.get_unchecked(0) as usize) }.add(value);
    }
    #[inline(always)]
    fn put_rows(rows: &mut [Row<Self>], value: Vec3<Self>) {
        rows[0] = Row::from_vec(value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::with_lanes;

    /// Reads quads that stand apart, and tells the lanes of the whole and of each of its quads.
    struct Apart;
    impl PackKernel<f64> for Apart {
        type Output = (Vec<f64>, Vec<f64>);
        fn run<P: Pack<Real = f64>>(self) -> Self::Output {
            let values: Vec<f64> = (0..24).map(f64::from).collect();
            let quad = P::Quad::LANES;
            // SAFETY: each place is followed by as many numbers as a pack has.
            let pack = unsafe { P::read_quads([&raw const values[3], &raw const values[13]]) };
            let lanes = (0..P::LANES).map(|lane| pack.real(lane)).collect();
            let quads = (0..P::LANES).map(|lane| pack.quad(lane / quad).real(lane % quad)).collect();
            (lanes, quads)
        }
    }

    #[test]
    fn quads_of_a_pack_stand_where_they_are_read() {
        for width in [1, 4, 8] {
            let (lanes, quads) = with_lanes(width, || f64::dispatch(Apart));
            let places = [3.0, 4.0, 5.0, 6.0, 13.0, 14.0, 15.0, 16.0];
            assert_eq!(lanes, places[..lanes.len()]);
            assert_eq!(quads, lanes);
        }
    }
}
