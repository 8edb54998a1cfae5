//! Two numbers in a register of WebAssembly's simd128.

use core::arch::wasm32::*;
pub use core::arch::wasm32::{
    f64x2 as pair, f64x2_abs as abs, f64x2_add as add, f64x2_div as div, f64x2_extract_lane as lane,
    f64x2_le as le, f64x2_lt as lt, f64x2_mul as mul, f64x2_neg as neg, f64x2_splat as splat,
    f64x2_sqrt as sqrt, f64x2_sub as sub, i64x2_all_true as all, v128 as Pair, v128 as Truths,
    v128_and as and, v128_any_true as any, v128_not as not, v128_or as or,
};

#[inline(always)]
pub fn truths(value: bool) -> Truths {
    i64x2_splat(-i64::from(value))
}
#[inline(always)]
pub fn truth(truths: Truths, index: usize) -> bool {
    (i64x2_bitmask(truths) >> index) & 1 == 1
}
#[inline(always)]
pub fn select(truths: Truths, a: Pair, b: Pair) -> Pair {
    v128_bitselect(a, b, truths)
}
// These two instructions give their first operand for NaN and for equal zeros.
#[inline(always)]
pub fn max(a: Pair, b: Pair) -> Pair {
    f64x2_pmax(b, a)
}
#[inline(always)]
pub fn min(a: Pair, b: Pair) -> Pair {
    f64x2_pmin(b, a)
}
#[inline(always)]
pub fn mul_add(a: Pair, b: Pair, c: Pair) -> Pair {
    add(mul(a, b), c)
}
#[inline(always)]
pub fn pow2_shifted(shifted: Pair) -> Pair {
    i64x2_shl(i64x2_add(shifted, i64x2_splat(1023)), 52)
}
#[inline(always)]
pub fn firsts(a: Pair, b: Pair) -> Pair {
    i64x2_shuffle::<0, 2>(a, b)
}
#[inline(always)]
pub fn seconds(a: Pair, b: Pair) -> Pair {
    i64x2_shuffle::<1, 3>(a, b)
}
#[inline(always)]
pub fn second_and_first(a: Pair, b: Pair) -> Pair {
    i64x2_shuffle::<1, 2>(a, b)
}
/// # Safety
/// Two numbers can be read.
#[inline(always)]
pub unsafe fn load(at: *const f64) -> Pair {
    // SAFETY: the caller's promise.
    unsafe { v128_load(at.cast()) }
}
/// # Safety
/// A number can be read from each address.
#[inline(always)]
pub unsafe fn load_both(first: *const f64, second: *const f64) -> Pair {
    // SAFETY: the caller's promise.
    unsafe { v128_load64_lane::<1>(v128_load64_zero(first.cast()), second.cast()) }
}
/// # Safety
/// Two numbers can be written.
#[inline(always)]
pub unsafe fn store(at: *mut f64, pair: Pair) {
    // SAFETY: the caller's promise.
    unsafe { v128_store(at.cast(), pair) };
}
