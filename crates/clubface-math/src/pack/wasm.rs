//! Packs of two numbers (WebAssembly, simd128).

use super::operators::{primal_functions, primal_operators};
use super::single::{single_four, single_part, single_quad, single_storage};
use super::traits::{Lanes, Numbers, Pack, Part, Row};
use crate::Vec3;
use crate::elementary::Primal;
use crate::scalar::{Computation, Mask, Scalar, operators};
use core::arch::wasm32::*;
use core::ops::Neg;

/// Two numbers.
#[derive(Clone, Copy, Debug)]
pub struct F64x2(v128);

/// Two truth values: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
pub struct Mask2(v128);

operators! { [] F64x2;
    Add add Self => Self, |a, b| Self(f64x2_add(a.0, b.0));
    Sub sub Self => Self, |a, b| Self(f64x2_sub(a.0, b.0));
    Mul mul Self => Self, |a, b| Self(f64x2_mul(a.0, b.0));
    Div div Self => Self, |a, b| Self(f64x2_div(a.0, b.0));
}
primal_operators!([] F64x2);

impl Neg for F64x2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(f64x2_neg(self.0))
    }
}

impl Mask for Mask2 {
    const LANES: usize = 2;
    #[inline(always)]
    fn any(self) -> bool {
        v128_any_true(self.0)
    }
    #[inline(always)]
    fn all(self) -> bool {
        i64x2_all_true(self.0)
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(v128_and(self.0, other.0))
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(v128_or(self.0, other.0))
    }
    #[inline(always)]
    fn not(self) -> Self {
        Self(v128_not(self.0))
    }
    #[inline(always)]
    fn splat(value: bool) -> Self {
        Self(i64x2_splat(-i64::from(value)))
    }
    #[inline(always)]
    fn lane(self, index: usize) -> bool {
        (i64x2_bitmask(self.0) >> index) & 1 == 1
    }
}

impl Primal for F64x2 {
    #[inline(always)]
    fn pow2_shifted(shifted: Self) -> Self {
        Self(i64x2_shl(i64x2_add(shifted.0, i64x2_splat(1023)), 52))
    }
}

impl Lanes for F64x2 {
    single_four!();
}

impl Numbers for F64x2 {
    #[inline(always)]
    fn from_fn(mut value: impl FnMut(usize) -> f64) -> Self {
        let first = value(0);
        Self(f64x2(first, value(1)))
    }
    #[inline(always)]
    fn from_slice(values: &[f64]) -> Self {
        Self::load(values)
    }
    #[inline(always)]
    fn write_to(self, values: &mut [f64]) {
        self.store(values);
    }
}

impl Scalar for F64x2 {
    type Mask = Mask2;
    const LANES: usize = 2;
    primal_functions!();
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(f64x2_splat(value))
    }
    #[inline(always)]
    fn lane(self, index: usize) -> f64 {
        if index == 0 { f64x2_extract_lane::<0>(self.0) } else { f64x2_extract_lane::<1>(self.0) }
    }
    #[inline(never)]
    fn outline<C: Computation>(computation: C) -> C::Output {
        computation.run()
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Mask2 {
        Mask2(f64x2_lt(self.0, other.0))
    }
    #[inline(always)]
    fn le(self, other: Self) -> Mask2 {
        Mask2(f64x2_le(self.0, other.0))
    }
    #[inline(always)]
    fn select(mask: Mask2, a: Self, b: Self) -> Self {
        Self(v128_bitselect(a.0, b.0, mask.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(f64x2_sqrt(self.0))
    }
    // These instructions give their first operand for NaN and for equal zeros, as the comparisons of the trait's own
    // definitions give the second of theirs.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(f64x2_pmax(other.0, self.0))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(f64x2_pmin(other.0, self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(f64x2_abs(self.0))
    }
    #[inline(always)]
    fn ln(self) -> Self {
        Self::from_fn(|lane| self.lane(lane).ln())
    }
}

/// x and y of node `index`, and its z.
///
/// # Safety
/// There is such a node.
#[inline(always)]
unsafe fn row(rows: &[Row<f64>], index: u32) -> (v128, *const u64) {
    // SAFETY: the caller's promise; a row is four numbers.
    unsafe {
        let at = rows.as_ptr().add(index as usize).cast::<f64>();
        (v128_load(at.cast()), at.add(2).cast())
    }
}

single_part!(F64x2);
impl Pack for F64x2 {
    type Real = f64;
    single_quad!();
    single_storage!();
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self::from_f64(value)
    }
    #[inline(always)]
    unsafe fn read(at: *const f64) -> Self {
        // SAFETY: the caller's promise.
        Self(unsafe { v128_load(at.cast()) })
    }
    #[inline(always)]
    unsafe fn write(self, at: *mut f64) {
        // SAFETY: the caller's promise.
        unsafe { v128_store(at.cast(), self.0) };
    }
    #[inline(always)]
    fn after(self, before: Self) -> Self {
        Self(i64x2_shuffle::<1, 2>(before.0, self.0))
    }
    #[inline(always)]
    fn real(self, lane: usize) -> f64 {
        self.lane(lane)
    }
    #[inline(always)]
    unsafe fn gather(rows: &[Row<f64>], index: &[u32]) -> Vec3<Self> {
        // SAFETY: the caller's promise.
        unsafe {
            let (first, z) = row(rows, *index.get_unchecked(0));
            let (second, other_z) = row(rows, *index.get_unchecked(1));
            Vec3 {
                x: Self(i64x2_shuffle::<0, 2>(first, second)),
                y: Self(i64x2_shuffle::<1, 3>(first, second)),
                z: Self(v128_load64_lane::<1>(v128_load64_zero(z), other_z)),
            }
        }
    }
    #[inline(always)]
    unsafe fn scatter_add(rows: &mut [Row<f64>], index: &[u32], value: Vec3<Self>) {
        let level =
            [i64x2_shuffle::<0, 2>(value.x.0, value.y.0), i64x2_shuffle::<1, 3>(value.x.0, value.y.0)];
        for lane in 0..Self::LANES {
            // SAFETY: the caller's promise; a row is four numbers.
            unsafe {
                let at = rows.as_mut_ptr().add(*index.get_unchecked(lane) as usize).cast::<f64>();
                v128_store(at.cast(), f64x2_add(v128_load(at.cast()), level[lane]));
                *at.add(2) += value.z.lane(lane);
            }
        }
    }
    #[inline(always)]
    fn put_rows(rows: &mut [Row<f64>], value: Vec3<Self>) {
        let rows = &mut rows[..Self::LANES];
        for lane in 0..Self::LANES {
            rows[lane] = Row([value.x.lane(lane), value.y.lane(lane), value.z.lane(lane), 0.0]);
        }
    }
}
