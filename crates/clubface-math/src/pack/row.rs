//! Fields on the nodes of a mesh.

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
