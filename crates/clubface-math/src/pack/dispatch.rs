//! The widest packs that the CPU has, chosen at run time; in WebAssembly, when compiled.
//!
//! [`dispatch`] enters a [`Kernel`] with the widest type there is. Everything below must be `#[inline(always)]`: CPU
//! features hold for the function that enables them and for what is inlined into it, not for what it calls.

use super::traits::{Kernel, Lanes, PackKernel, Real};
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use super::wasm::F64x2;
#[cfg(target_arch = "x86_64")]
use super::x86;
use core::cell::Cell;

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

/// Runs a kernel with four lanes (AVX2), two (simd128) or one: for numbers with derivatives, which need several
/// registers each.
pub fn dispatch_narrow<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if WIDEST.get() >= 4 && x86::has_four() {
        // SAFETY: the features the function enables were found on this CPU.
        return unsafe { x86::run_four(kernel) };
    }
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    return kernel.run::<F64x2>();
    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    kernel.run::<f64>()
}

/// Runs a kernel with eight lanes (AVX-512), four (AVX2), two (WebAssembly's simd128) or one.
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if WIDEST.get() >= 8 && x86::has_eight() {
        // SAFETY: the features the function enables were found on this CPU.
        return unsafe { x86::run_eight(kernel) };
    }
    dispatch_narrow(kernel)
}

impl Real for f64 {
    fn derivatives(&self) -> &[f64] {
        &[]
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
