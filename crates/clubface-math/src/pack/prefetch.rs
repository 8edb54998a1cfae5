//! Memory fetched ahead of its use.

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
