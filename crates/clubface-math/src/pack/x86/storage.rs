//! Four numbers (AVX2) and eight (AVX-512) in and out of arrays and nodes.

use super::arithmetic::{F64x4, F64x8};
use crate::pack::single::{single_part, single_quad, single_storage};
use crate::pack::traits::{Pack, Part, Row};
use crate::{Scalar, Vec3};
use core::arch::x86_64::*;

/// Numbers, loads and stores alike for both widths. SAFETY of all: packs exist only where the CPU has the feature.
macro_rules! storage {
    ($set:ident, $load:ident, $store:ident) => {
        type Real = f64;
        single_storage!();
        #[inline(always)]
        fn splat(value: f64) -> Self {
            Self(unsafe { $set(value) })
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

single_part!(F64x8);
impl Pack for F64x8 {
    storage!(_mm512_set1_pd, _mm512_loadu_pd, _mm512_storeu_pd);
    type Quad = F64x4;
    #[inline(always)]
    fn quad(self, index: usize) -> F64x4 {
        // SAFETY: as above.
        F64x4(unsafe {
            if index == 0 { _mm512_castpd512_pd256(self.0) } else { _mm512_extractf64x4_pd::<1>(self.0) }
        })
    }
    #[inline(always)]
    unsafe fn read_quads(at: [*const f64; 2], _stride: usize) -> Self {
        // SAFETY: the caller's promise.
        Self(unsafe {
            let (low, high) = (_mm256_loadu_pd(at[0]), _mm256_loadu_pd(at[1]));
            _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(low), high)
        })
    }
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

single_part!(F64x4);
impl Pack for F64x4 {
    storage!(_mm256_set1_pd, _mm256_loadu_pd, _mm256_storeu_pd);
    single_quad!();
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
