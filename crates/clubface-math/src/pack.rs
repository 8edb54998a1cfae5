//! Packs of mesh elements: gathering the vectors of nodes into lanes and adding lanes back to nodes.
//!
//! A field on nodes is stored as one [`Row`] a node. A pack reads the rows of as many nodes as it has lanes and transposes them
//! in registers, which costs less than the arithmetic it feeds; eight separate reads a component cost more.

use crate::lanes::{dispatch, Kernel, Lanes};
use crate::{Dual, Scalar, Vec3};

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

impl Real for f64 {
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

impl<const N: usize> Real for Dual<f64, N> {
    // Large kernels are compiled once, however many places call them.
    #[inline(never)]
    fn dispatch<K: PackKernel<Self>>(kernel: K) -> K::Output {
        kernel.run::<Self>()
    }
    fn singly<K: PackKernel<Self>>(kernel: K) -> K::Output {
        kernel.run::<Self>()
    }
}

/// A number on its own as a pack of one lane.
macro_rules! single {
    () => {
        type Real = Self;
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
    };
}

impl Pack for f64 {
    single!();
}
/// Derivatives fill the registers by themselves: packs of such numbers would only make more code.
impl<const N: usize> Pack for Dual<f64, N> {
    single!();
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Pack, Row, Vec3};
    use crate::lanes::x86::{F64x4, F64x8};
    use crate::Scalar;
    use core::arch::x86_64::*;

    /// Numbers, loads and stores alike for both widths. SAFETY of all: packs exist only where the CPU has the feature.
    macro_rules! storage {
        ($set:ident, $load:ident, $store:ident) => {
            type Real = f64;
            #[inline(always)]
            fn splat(value: f64) -> Self {
                Self(unsafe { $set(value) })
            }
            #[inline(always)]
            fn load(values: &[f64]) -> Self {
                let values = &values[..Self::LANES];
                Self(unsafe { $load(values.as_ptr()) })
            }
            #[inline(always)]
            fn store(self, values: &mut [f64]) {
                let values = &mut values[..Self::LANES];
                unsafe { $store(values.as_mut_ptr(), self.0) };
            }
            #[inline(always)]
            unsafe fn read(at: *const f64) -> Self {
                // SAFETY: the caller's promise.
                Self(unsafe { $load(at) })
            }
            #[inline(always)]
            unsafe fn write(self, at: *mut f64) {
                // SAFETY: the caller's promise.
                unsafe { $store(at, self.0) };
            }
            #[inline(always)]
            unsafe fn scatter_add(rows: &mut [Row<f64>], index: &[u32], value: Vec3<Self>) {
                let lanes = Self::rows(value);
                for lane in 0..Self::LANES {
                    // SAFETY: the caller's promise.
                    unsafe { add(rows, index, lane, lanes[lane]) };
                }
            }
            #[inline(always)]
            fn put_rows(rows: &mut [Row<f64>], value: Vec3<Self>) {
                let rows = &mut rows[..Self::LANES];
                let lanes = Self::rows(value);
                for lane in 0..Self::LANES {
                    // SAFETY: a row is 32 bytes, aligned to 32.
                    unsafe { _mm256_store_pd(rows[lane].0.as_mut_ptr(), lanes[lane]) };
                }
            }
            #[inline(always)]
            fn real(self, lane: usize) -> f64 {
                self.lane(lane)
            }
        };
    }

    /// Row of node `index[i]`.
    ///
    /// # Safety
    /// As for [`Pack::gather`], with AVX.
    #[inline(always)]
    unsafe fn row(rows: &[Row<f64>], index: &[u32], i: usize) -> __m256d {
        // SAFETY: the caller's promise; a row is 32 bytes, aligned to 32.
        unsafe { _mm256_load_pd(rows.as_ptr().add(*index.get_unchecked(i) as usize).cast::<f64>()) }
    }
    /// Adds to the row of node `index[i]`.
    ///
    /// # Safety
    /// As for [`row`].
    #[inline(always)]
    unsafe fn add(rows: &mut [Row<f64>], index: &[u32], i: usize, value: __m256d) {
        // SAFETY: as above.
        unsafe {
            let row = rows.as_mut_ptr().add(*index.get_unchecked(i) as usize).cast::<f64>();
            _mm256_store_pd(row, _mm256_add_pd(_mm256_load_pd(row), value));
        }
    }
    /// Rows of nodes `index[i]` and `index[j]`.
    ///
    /// # Safety
    /// As for [`row`], with AVX-512.
    #[inline(always)]
    unsafe fn pair(rows: &[Row<f64>], index: &[u32], i: usize, j: usize) -> __m512d {
        // SAFETY: as above.
        unsafe { _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(row(rows, index, i)), row(rows, index, j)) }
    }

    impl Pack for F64x8 {
        storage!(_mm512_set1_pd, _mm512_loadu_pd, _mm512_storeu_pd);
        #[inline(always)]
        unsafe fn gather(rows: &[Row<f64>], index: &[u32]) -> Vec3<Self> {
            // SAFETY: as above.
            unsafe {
                let (a0, a1) = (pair(rows, index, 0, 2), pair(rows, index, 1, 3));
                let (b0, b1) = (pair(rows, index, 4, 6), pair(rows, index, 5, 7));
                let (a_low, b_low) = (_mm512_unpacklo_pd(a0, a1), _mm512_unpacklo_pd(b0, b1));
                let (a_high, b_high) = (_mm512_unpackhi_pd(a0, a1), _mm512_unpackhi_pd(b0, b1));
                Vec3 {
                    x: Self(_mm512_shuffle_f64x2::<0x88>(a_low, b_low)),
                    y: Self(_mm512_shuffle_f64x2::<0x88>(a_high, b_high)),
                    z: Self(_mm512_shuffle_f64x2::<0xdd>(a_low, b_low)),
                }
            }
        }
        #[inline(always)]
        fn after(self, before: Self) -> Self {
            // SAFETY: as above.
            Self(unsafe {
                _mm512_castsi512_pd(_mm512_alignr_epi64::<7>(
                    _mm512_castpd_si512(self.0),
                    _mm512_castpd_si512(before.0),
                ))
            })
        }
    }
    impl F64x8 {
        /// One row a lane.
        #[inline(always)]
        fn rows(v: Vec3<Self>) -> [__m256d; 8] {
            // SAFETY: as above.
            unsafe {
                let zero = _mm512_setzero_pd();
                let (xy_even, xy_odd) = (_mm512_unpacklo_pd(v.x.0, v.y.0), _mm512_unpackhi_pd(v.x.0, v.y.0));
                let (z_even, z_odd) = (_mm512_unpacklo_pd(v.z.0, zero), _mm512_unpackhi_pd(v.z.0, zero));
                let first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
                let second = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
                let r02 = _mm512_permutex2var_pd(xy_even, first, z_even);
                let r46 = _mm512_permutex2var_pd(xy_even, second, z_even);
                let r13 = _mm512_permutex2var_pd(xy_odd, first, z_odd);
                let r57 = _mm512_permutex2var_pd(xy_odd, second, z_odd);
                [
                    _mm512_castpd512_pd256(r02),
                    _mm512_castpd512_pd256(r13),
                    _mm512_extractf64x4_pd::<1>(r02),
                    _mm512_extractf64x4_pd::<1>(r13),
                    _mm512_castpd512_pd256(r46),
                    _mm512_castpd512_pd256(r57),
                    _mm512_extractf64x4_pd::<1>(r46),
                    _mm512_extractf64x4_pd::<1>(r57),
                ]
            }
        }
    }

    impl Pack for F64x4 {
        storage!(_mm256_set1_pd, _mm256_loadu_pd, _mm256_storeu_pd);
        #[inline(always)]
        unsafe fn gather(rows: &[Row<f64>], index: &[u32]) -> Vec3<Self> {
            // SAFETY: as above.
            unsafe {
                let (r0, r1) = (row(rows, index, 0), row(rows, index, 1));
                let (r2, r3) = (row(rows, index, 2), row(rows, index, 3));
                let (low, high) = (_mm256_unpacklo_pd(r0, r1), _mm256_unpacklo_pd(r2, r3));
                let y = (_mm256_unpackhi_pd(r0, r1), _mm256_unpackhi_pd(r2, r3));
                Vec3 {
                    x: Self(_mm256_permute2f128_pd::<0x20>(low, high)),
                    y: Self(_mm256_permute2f128_pd::<0x20>(y.0, y.1)),
                    z: Self(_mm256_permute2f128_pd::<0x31>(low, high)),
                }
            }
        }
        #[inline(always)]
        fn after(self, before: Self) -> Self {
            // SAFETY: as above.
            Self(unsafe {
                let joined = _mm256_permute2f128_pd::<0x21>(before.0, self.0);
                _mm256_shuffle_pd::<0x5>(joined, self.0)
            })
        }
    }
    impl F64x4 {
        /// One row a lane.
        #[inline(always)]
        fn rows(v: Vec3<Self>) -> [__m256d; 4] {
            // SAFETY: as above.
            unsafe {
                let zero = _mm256_setzero_pd();
                let (xy_even, xy_odd) = (_mm256_unpacklo_pd(v.x.0, v.y.0), _mm256_unpackhi_pd(v.x.0, v.y.0));
                let (z_even, z_odd) = (_mm256_unpacklo_pd(v.z.0, zero), _mm256_unpackhi_pd(v.z.0, zero));
                [
                    _mm256_permute2f128_pd::<0x20>(xy_even, z_even),
                    _mm256_permute2f128_pd::<0x20>(xy_odd, z_odd),
                    _mm256_permute2f128_pd::<0x31>(xy_even, z_even),
                    _mm256_permute2f128_pd::<0x31>(xy_odd, z_odd),
                ]
            }
        }
    }
}
