//! Fields on the nodes of a mesh.

use super::traits::Real;
use crate::Vec3;

/// Numbers of a row.
const WIDTH: usize = 4;

/// A vector at a node, padded to four numbers: their values, then each of their derivatives.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct Row<R: Real>(pub R::Parts<[f64; WIDTH]>);

impl<R: Real> Row<R> {
    /// From its numbers.
    #[inline(always)]
    pub fn new(numbers: [R; WIDTH]) -> Self {
        let mut row = core::mem::MaybeUninit::<Self>::uninit();
        for (c, number) in numbers.into_iter().enumerate() {
            // SAFETY: a row is as many times four numbers as one has parts, and all are written.
            unsafe { number.put_parts(row.as_mut_ptr().cast::<f64>().add(c), WIDTH) };
        }
        // SAFETY: as above.
        unsafe { row.assume_init() }
    }
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new([R::zero(); WIDTH])
    }
    /// From a vector.
    #[inline(always)]
    pub fn from_vec(v: Vec3<R>) -> Self {
        Self::new([v.x, v.y, v.z, R::zero()])
    }
    /// As a vector.
    #[inline(always)]
    pub fn vec(&self) -> Vec3<R> {
        Vec3::new(self.get(0), self.get(1), self.get(2))
    }
    /// One of the numbers.
    #[inline(always)]
    pub fn get(&self, which: usize) -> R {
        assert!(which < WIDTH);
        // SAFETY: a row is as many times four numbers as one has parts.
        unsafe { R::from_parts(core::ptr::from_ref(self).cast::<f64>().add(which), WIDTH) }
    }
    /// Sets one of the numbers.
    #[inline(always)]
    pub fn set(&mut self, which: usize, number: R) {
        assert!(which < WIDTH);
        // SAFETY: as above.
        unsafe { number.put_parts(core::ptr::from_mut(self).cast::<f64>().add(which), WIDTH) };
    }
    /// Adds a vector.
    #[inline(always)]
    pub fn add(&mut self, v: Vec3<R>) {
        self.set(0, self.get(0) + v.x);
        self.set(1, self.get(1) + v.y);
        self.set(2, self.get(2) + v.z);
    }
    /// Adds a row times a number that depends on no variable, all four numbers at once.
    #[inline(always)]
    pub fn add_times(&mut self, row: &Self, by: f64) {
        R::add_times(&mut self.0, &row.0, by);
    }
    /// Adds a row times a number, all four numbers at once.
    #[inline(always)]
    pub fn add_scaled(&mut self, row: &Self, by: R) {
        R::add_scaled(&mut self.0, &row.0, by);
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
