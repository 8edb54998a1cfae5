//! What the benchmarks share.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::time::Instant;

/// Bulk modulus of an isotropic solid, Pa, from its shear modulus, Pa, and Poisson's ratio.
pub fn bulk_modulus(shear: f64, poisson: f64) -> f64 {
    2.0 * shear * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson))
}

/// The least time that some work takes, s, of as many tries: that of a machine which nobody else uses.
pub fn least_time(tries: usize, mut work: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..tries).map(time).fold(f64::INFINITY, f64::min)
}

/// A pool of as many threads.
///
/// # Panics
///
/// Where the system has no threads left.
pub fn thread_pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(threads).build().expect("threads")
}
