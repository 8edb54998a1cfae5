//! A number on its own as a pack of one lane.

use super::operators::primal_functions;
use super::single::{single_four, single_part, single_quad, single_storage};
use super::traits::{Lanes, Numbers, Pack, Part, Row};
use crate::Vec3;
use crate::elementary::Primal;
use crate::scalar::{Computation, Scalar};

impl Primal for f64 {
    #[inline(always)]
    fn pow2_shifted(shifted: Self) -> Self {
        f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52)
    }
}

impl Lanes for f64 {
    single_four!();
}

impl Numbers for f64 {
    #[inline(always)]
    fn from_fn(mut value: impl FnMut(usize) -> f64) -> Self {
        value(0)
    }
    #[inline(always)]
    fn from_slice(values: &[f64]) -> Self {
        values[0]
    }
    #[inline(always)]
    fn write_to(self, values: &mut [f64]) {
        values[0] = self;
    }
}

impl Scalar for f64 {
    type Mask = bool;
    const LANES: usize = 1;
    primal_functions!();
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn lane(self, _index: usize) -> f64 {
        self
    }
    #[inline(never)]
    fn outline<C: Computation>(computation: C) -> C::Output {
        computation.run()
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn le(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        f64::ln(self)
    }
}

single_part!(f64);
impl Pack for f64 {
    type Real = Self;
    single_quad!();
    single_storage!();
    #[inline(always)]
    fn splat(value: Self) -> Self {
        value
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
