//! Two numbers in a register of NEON, which every processor of 64-bit Arm has.

use core::arch::aarch64::*;
pub use core::arch::aarch64::{
    float64x2_t as Pair, uint64x2_t as Truths, vld1q_f64 as load, vst1q_f64 as store,
};

/// Instructions as functions that are safe to call: packs are compiled only for processors that have them.
macro_rules! instructions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $result:ty { $value:expr })*) => {
        $(#[inline(always)]
        pub fn $name($($argument: $type),*) -> $result {
            // SAFETY: see above.
            unsafe { $value }
        })*
    };
}

instructions! {
    add(a: Pair, b: Pair) -> Pair { vaddq_f64(a, b) }
    sub(a: Pair, b: Pair) -> Pair { vsubq_f64(a, b) }
    mul(a: Pair, b: Pair) -> Pair { vmulq_f64(a, b) }
    div(a: Pair, b: Pair) -> Pair { vdivq_f64(a, b) }
    neg(a: Pair) -> Pair { vnegq_f64(a) }
    abs(a: Pair) -> Pair { vabsq_f64(a) }
    sqrt(a: Pair) -> Pair { vsqrtq_f64(a) }
    mul_add(a: Pair, b: Pair, c: Pair) -> Pair { vfmaq_f64(c, a, b) }
    // Not FMAX or FMAXNM: the first is NaN where either number is, the second the other number, and both take 0 for
    // larger than -0.
    max(a: Pair, b: Pair) -> Pair { vbslq_f64(vcgtq_f64(a, b), a, b) }
    min(a: Pair, b: Pair) -> Pair { vbslq_f64(vcltq_f64(a, b), a, b) }
    pow2_shifted(shifted: Pair) -> Pair {
        vreinterpretq_f64_s64(vshlq_n_s64::<52>(vaddq_s64(vreinterpretq_s64_f64(shifted), vdupq_n_s64(1023))))
    }

    lt(a: Pair, b: Pair) -> Truths { vcltq_f64(a, b) }
    le(a: Pair, b: Pair) -> Truths { vcleq_f64(a, b) }
    select(truths: Truths, a: Pair, b: Pair) -> Pair { vbslq_f64(truths, a, b) }
    and(a: Truths, b: Truths) -> Truths { vandq_u64(a, b) }
    or(a: Truths, b: Truths) -> Truths { vorrq_u64(a, b) }
    not(a: Truths) -> Truths { veorq_u64(a, vdupq_n_u64(u64::MAX)) }
    truths(value: bool) -> Truths { vdupq_n_u64(u64::from(value).wrapping_neg()) }
    half_of_the_bits(truths: Truths) -> u64 { vget_lane_u64::<0>(vreinterpret_u64_u32(vmovn_u64(truths))) }

    splat(value: f64) -> Pair { vdupq_n_f64(value) }
    pair(first: f64, second: f64) -> Pair { vsetq_lane_f64::<1>(second, vdupq_n_f64(first)) }
    firsts(a: Pair, b: Pair) -> Pair { vzip1q_f64(a, b) }
    seconds(a: Pair, b: Pair) -> Pair { vzip2q_f64(a, b) }
    second_and_first(a: Pair, b: Pair) -> Pair { vextq_f64::<1>(a, b) }
}

#[inline(always)]
pub fn any(truths: Truths) -> bool {
    half_of_the_bits(truths) != 0
}
#[inline(always)]
pub fn all(truths: Truths) -> bool {
    half_of_the_bits(truths) == u64::MAX
}
#[inline(always)]
pub fn truth(truths: Truths, index: usize) -> bool {
    (half_of_the_bits(truths) >> (32 * index)) & 1 == 1
}
#[inline(always)]
pub fn lane<const INDEX: i32>(pair: Pair) -> f64 {
    // SAFETY: as for all instructions.
    unsafe { vgetq_lane_f64::<INDEX>(pair) }
}
/// # Safety
/// A number can be read from each address.
#[inline(always)]
pub unsafe fn load_both(first: *const f64, second: *const f64) -> Pair {
    // SAFETY: the caller's promise.
    unsafe { vld1q_lane_f64::<1>(second, vld1q_dup_f64(first)) }
}
