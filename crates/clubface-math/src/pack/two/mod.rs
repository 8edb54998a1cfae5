//! Packs of two numbers: WebAssembly (simd128) and 64-bit Arm (NEON).
//!
//! Both have registers of two numbers and instructions for them that do the same by other names: [`register`] has
//! these, with one set of names, and the packs are written once. Where names do not say it all:
//!
//! * `max(a, b)` is `a` where it is larger, else `b`, also for NaN and for zeros of either sign; so is `min`;
//! * `mul_add(a, b, c)` is `a b + c`, fused on Arm, where it costs what a product does; WebAssembly has none that is the
//!   same everywhere;
//! * `firsts` and `seconds` are the first lanes of two registers, and their second lanes;
//! * `second_and_first` is the second lane of one register and the first of another.

#[cfg_attr(target_arch = "aarch64", path = "neon.rs")]
#[cfg_attr(target_arch = "wasm32", path = "wasm.rs")]
mod register;

use super::operators::{primal_functions, primal_operators};
use super::single::{single_four, single_part, single_quad, single_storage};
use super::traits::{Lanes, Numbers, Pack, Part, Row};
use crate::Vec3;
use crate::elementary::Primal;
use crate::scalar::{Computation, Mask, Scalar, operators};
use core::ops::Neg;
use register::{Pair, Truths};

/// Two numbers.
#[derive(Clone, Copy, Debug)]
pub struct F64x2(Pair);

/// Two truth values: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
pub struct Mask2(Truths);

operators! { [] F64x2;
    Add add Self => Self, |a, b| Self(register::add(a.0, b.0));
    Sub sub Self => Self, |a, b| Self(register::sub(a.0, b.0));
    Mul mul Self => Self, |a, b| Self(register::mul(a.0, b.0));
    Div div Self => Self, |a, b| Self(register::div(a.0, b.0));
}
primal_operators!([] F64x2);

impl Neg for F64x2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(register::neg(self.0))
    }
}

impl Mask for Mask2 {
    const LANES: usize = 2;
    #[inline(always)]
    fn any(self) -> bool {
        register::any(self.0)
    }
    #[inline(always)]
    fn all(self) -> bool {
        register::all(self.0)
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(register::and(self.0, other.0))
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(register::or(self.0, other.0))
    }
    #[inline(always)]
    fn not(self) -> Self {
        Self(register::not(self.0))
    }
    #[inline(always)]
    fn splat(value: bool) -> Self {
        Self(register::truths(value))
    }
    #[inline(always)]
    fn lane(self, index: usize) -> bool {
        register::truth(self.0, index)
    }
}

impl Primal for F64x2 {
    #[inline(always)]
    fn pow2_shifted(shifted: Self) -> Self {
        Self(register::pow2_shifted(shifted.0))
    }
}

impl Lanes for F64x2 {
    single_four!();
}

impl Numbers for F64x2 {
    #[inline(always)]
    fn from_fn(mut value: impl FnMut(usize) -> f64) -> Self {
        let first = value(0);
        Self(register::pair(first, value(1)))
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
        Self(register::splat(value))
    }
    #[inline(always)]
    fn lane(self, index: usize) -> f64 {
        if index == 0 { register::lane::<0>(self.0) } else { register::lane::<1>(self.0) }
    }
    #[inline(never)]
    fn outline<C: Computation>(computation: C) -> C::Output {
        computation.run()
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Mask2 {
        Mask2(register::lt(self.0, other.0))
    }
    #[inline(always)]
    fn le(self, other: Self) -> Mask2 {
        Mask2(register::le(self.0, other.0))
    }
    #[inline(always)]
    fn select(mask: Mask2, a: Self, b: Self) -> Self {
        Self(register::select(mask.0, a.0, b.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(register::sqrt(self.0))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(register::max(self.0, other.0))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(register::min(self.0, other.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(register::abs(self.0))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(register::mul_add(self.0, factor.0, term.0))
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
unsafe fn row(rows: &[Row<f64>], index: u32) -> (Pair, *const f64) {
    // SAFETY: the caller's promise; a row is four numbers.
    unsafe {
        let at = rows.as_ptr().add(index as usize).cast::<f64>();
        (register::load(at), at.add(2))
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
        Self(unsafe { register::load(at) })
    }
    #[inline(always)]
    unsafe fn write(self, at: *mut f64) {
        // SAFETY: the caller's promise.
        unsafe { register::store(at, self.0) };
    }
    #[inline(always)]
    fn after(self, before: Self) -> Self {
        Self(register::second_and_first(before.0, self.0))
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
                x: Self(register::firsts(first, second)),
                y: Self(register::seconds(first, second)),
                z: Self(register::load_both(z, other_z)),
            }
        }
    }
    #[inline(always)]
    unsafe fn scatter_add(rows: &mut [Row<f64>], index: &[u32], value: Vec3<Self>) {
        let level = [register::firsts(value.x.0, value.y.0), register::seconds(value.x.0, value.y.0)];
        for lane in 0..Self::LANES {
            // SAFETY: the caller's promise; a row is four numbers.
            unsafe {
                let at = rows.as_mut_ptr().add(*index.get_unchecked(lane) as usize).cast::<f64>();
                register::store(at, register::add(register::load(at), level[lane]));
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
