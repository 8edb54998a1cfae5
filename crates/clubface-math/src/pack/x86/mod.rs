//! AVX2 and AVX-512 packs.

mod arithmetic;
mod masks;
mod storage;

pub use arithmetic::{F64x4, F64x8};

use super::traits::{Kernel, RowsKernel};
use super::twin::Twin;

/// Whether this CPU runs [`F64x8`].
#[must_use]
pub fn has_eight() -> bool {
    is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq")
}
/// Whether this CPU runs [`F64x4`].
#[must_use]
pub fn has_four() -> bool {
    is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}
/// Runs a kernel with eight lanes.
///
/// # Safety
/// [`has_eight`] must hold.
#[target_feature(enable = "avx2,fma,avx512f,avx512dq")]
pub unsafe fn run_eight<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<F64x8>()
}
/// Runs a kernel with four lanes.
///
/// # Safety
/// [`has_four`] must hold.
#[target_feature(enable = "avx2,fma")]
pub unsafe fn run_four<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<F64x4>()
}
/// Runs a kernel with two packs of eight lanes.
///
/// # Safety
/// [`has_eight`] must hold.
#[target_feature(enable = "avx2,fma,avx512f,avx512dq")]
pub unsafe fn run_rows_by_eight<K: RowsKernel>(kernel: K) -> K::Output {
    kernel.run::<Twin<F64x8>>()
}
/// Runs a kernel with two packs of four lanes.
///
/// # Safety
/// [`has_four`] must hold.
#[target_feature(enable = "avx2,fma")]
pub unsafe fn run_rows_by_four<K: RowsKernel>(kernel: K) -> K::Output {
    kernel.run::<Twin<F64x4>>()
}
