//! Truth values of four numbers (AVX2) and of eight (AVX-512).

use crate::scalar::Mask;
use core::arch::x86_64::*;

/// Four truth values.
#[derive(Clone, Copy, Debug)]
pub struct Mask4(pub(super) __m256d);
/// Eight truth values.
#[derive(Clone, Copy, Debug)]
pub struct Mask8(pub(super) __mmask8);

// SAFETY of every block below: masks exist only where packs do, and packs only where the CPU has the feature.
impl Mask for Mask4 {
    const LANES: usize = 4;
    #[inline(always)]
    fn any(self) -> bool {
        unsafe { _mm256_movemask_pd(self.0) != 0 }
    }
    #[inline(always)]
    fn all(self) -> bool {
        unsafe { _mm256_movemask_pd(self.0) == 0b1111 }
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(unsafe { _mm256_and_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(unsafe { _mm256_or_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn not(self) -> Self {
        Self(unsafe { _mm256_xor_pd(self.0, Self::splat(true).0) })
    }
    #[inline(always)]
    fn splat(value: bool) -> Self {
        Self(unsafe { _mm256_castsi256_pd(_mm256_set1_epi64x(-i64::from(value))) })
    }
    #[inline(always)]
    fn lane(self, index: usize) -> bool {
        unsafe { (_mm256_movemask_pd(self.0) >> index) & 1 == 1 }
    }
}
impl Mask for Mask8 {
    const LANES: usize = 8;
    #[inline(always)]
    fn any(self) -> bool {
        self.0 != 0
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.0 == 0xff
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
    #[inline(always)]
    fn splat(value: bool) -> Self {
        Self(if value { 0xff } else { 0 })
    }
    #[inline(always)]
    fn lane(self, index: usize) -> bool {
        (self.0 >> index) & 1 == 1
    }
}
