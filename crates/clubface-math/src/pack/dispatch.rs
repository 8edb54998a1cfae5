//! The widest packs that the CPU has, chosen at run time; in WebAssembly and on 64-bit Arm, when compiled.
//!
//! [`dispatch`] enters a [`Kernel`] with the widest type there is. Everything below must be `#[inline(always)]`: CPU
//! features hold for the function that enables them and for what is inlined into it, not for what it calls.

use super::traits::{Kernel, Lanes, PackKernel, Real, RowsKernel};
#[cfg(target_arch = "aarch64")]
use super::twin::Twin;
#[cfg(any(target_arch = "aarch64", all(target_arch = "wasm32", target_feature = "simd128")))]
use super::two::F64x2;
#[cfg(target_arch = "x86_64")]
use super::x86;
use core::cell::Cell;
use core::fmt::Debug;

thread_local! {
    /// Most lanes that [`dispatch`] may choose on this thread.
    static WIDEST: Cell<usize> = const { Cell::new(usize::MAX) };
}

/// Runs a computation with at most `lanes` lanes in the kernels that it dispatches on its own thread: shows that
/// results do not depend on the width of packs. WebAssembly has one width.
pub fn with_lanes<T>(lanes: usize, computation: impl FnOnce() -> T) -> T {
    let before = WIDEST.replace(lanes);
    let result = computation();
    WIDEST.set(before);
    result
}

/// Whether packs have one width, chosen when compiled, so that rows alone need no code of their own.
pub const ONE_WIDTH: bool = cfg!(all(target_arch = "wasm32", target_feature = "simd128"));

/// Runs a kernel with eight lanes (AVX-512), four (AVX2), two (NEON, WebAssembly's simd128) or one.
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if WIDEST.get() >= 8 && x86::has_eight() {
        // SAFETY: the features the function enables were found on this CPU.
        return unsafe { x86::run_eight(kernel) };
    }
    #[cfg(target_arch = "x86_64")]
    if WIDEST.get() >= 4 && x86::has_four() {
        // SAFETY: the features the function enables were found on this CPU.
        return unsafe { x86::run_four(kernel) };
    }
    #[cfg(target_arch = "aarch64")]
    if WIDEST.get() >= 2 {
        return kernel.run::<F64x2>();
    }
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    return kernel.run::<F64x2>();
    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    kernel.run::<f64>()
}

/// Runs a kernel for `rows` rows with two packs at a time: of eight lanes, or of four where there are no more rows than
/// these have; of two on 64-bit Arm; one pack in WebAssembly; else a row alone, since a pack costs more than one row.
#[cfg_attr(target_arch = "wasm32", allow(unused_variables))]
pub fn dispatch_rows<K: RowsKernel>(rows: usize, kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if rows > 8 && WIDEST.get() >= 16 && x86::has_eight() {
        // SAFETY: the features the function enables were found on this CPU.
        return unsafe { x86::run_rows_by_eight(kernel) };
    }
    #[cfg(target_arch = "x86_64")]
    if rows > 1 && WIDEST.get() >= 8 && x86::has_four() {
        // SAFETY: the features the function enables were found on this CPU.
        return unsafe { x86::run_rows_by_four(kernel) };
    }
    #[cfg(target_arch = "aarch64")]
    if rows > 1 && WIDEST.get() >= 4 {
        return kernel.run::<Twin<F64x2>>();
    }
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    return kernel.run::<F64x2>();
    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    kernel.run::<f64>()
}

impl Real for f64 {
    const PARTS: usize = 1;
    type Parts<A: Copy + Debug + Send + Sync + 'static> = A;
    fn derivatives(&self) -> &[f64] {
        &[]
    }
    #[inline(always)]
    unsafe fn from_parts(at: *const f64, _stride: usize) -> Self {
        // SAFETY: the caller's promise.
        unsafe { *at }
    }
    #[inline(always)]
    unsafe fn put_parts(self, at: *mut f64, _stride: usize) {
        // SAFETY: the caller's promise.
        unsafe { *at = self };
    }
    #[inline(always)]
    fn each_part<A: Copy + Debug + Send + Sync + 'static>(value: A) -> A {
        value
    }
    #[inline(always)]
    fn part_mut<A: Copy + Debug + Send + Sync + 'static>(parts: &mut A, _part: usize) -> &mut A {
        parts
    }
    #[inline(always)]
    fn add_times(sum: &mut [f64; 4], v: &[f64; 4], s: f64) {
        Self::add_scaled(sum, v, s);
    }
    #[inline(always)]
    fn add_scaled(sum: &mut [f64; 4], v: &[f64; 4], s: f64) {
        for c in 0..4 {
            sum[c] += v[c] * s;
        }
    }
    #[inline(always)]
    fn dispatch<K: PackKernel<Self>>(kernel: K) -> K::Output {
        struct Plain<K>(K);
        impl<K: PackKernel<f64>> Kernel for Plain<K> {
            type Output = K::Output;
            #[inline(always)]
            fn run<S: Lanes>(self) -> K::Output {
                self.0.run::<S>()
            }
        }
        dispatch(Plain(kernel))
    }
    fn singly<K: PackKernel<Self>>(kernel: K) -> K::Output {
        kernel.run::<Self>()
    }
}
