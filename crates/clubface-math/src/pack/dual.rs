//! Packs of numbers with derivatives: a pack of values, and one of each derivative.

use super::dispatch::dispatch_narrow;
use super::row::Row;
use super::traits::{single_quad, Kernel, Lanes, Pack, PackKernel, Real};
use crate::{Dual, Scalar, Vec3};

impl<const N: usize> Real for Dual<f64, N> {
    fn derivatives(&self) -> &[f64] {
        &self.tangent
    }
    // Large kernels are compiled once, however many places call them.
    #[inline(never)]
    fn dispatch<K: PackKernel<Self>>(kernel: K) -> K::Output {
        struct Derived<K, const N: usize>(K);
        impl<K: PackKernel<Dual<f64, N>>, const N: usize> Kernel for Derived<K, N> {
            type Output = K::Output;
            #[inline(always)]
            fn run<S: Lanes>(self) -> K::Output {
                self.0.run::<Dual<S, N>>()
            }
        }
        dispatch_narrow(Derived(kernel))
    }
    fn singly<K: PackKernel<Self>>(kernel: K) -> K::Output {
        kernel.run::<Self>()
    }
}

/// A number with derivatives in each lane: a pack of values and one of every derivative.
impl<S: Lanes, const N: usize> Pack for Dual<S, N> {
    type Real = Dual<f64, N>;
    single_quad!();
    #[inline(always)]
    fn splat(value: Self::Real) -> Self {
        let mut pack = Self::constant(S::splat(value.value));
        for i in 0..N {
            pack.tangent[i] = S::splat(value.tangent[i]);
        }
        pack
    }
    #[inline(always)]
    unsafe fn read(at: *const Self::Real) -> Self {
        // SAFETY: the caller's promise.
        unsafe { Self::each(|lane| at.add(lane)) }
    }
    #[inline(always)]
    unsafe fn write(self, at: *mut Self::Real) {
        for lane in 0..Self::LANES {
            // SAFETY: the caller's promise.
            unsafe { *at.add(lane) = self.real(lane) };
        }
    }
    #[inline(always)]
    fn after(self, before: Self) -> Self {
        let mut tangent = self.tangent;
        for i in 0..N {
            tangent[i] = tangent[i].after(before.tangent[i]);
        }
        Self { value: self.value.after(before.value), tangent }
    }
    #[inline(always)]
    fn real(self, lane: usize) -> Self::Real {
        // No closures over arrays: they would not be compiled with the features of the CPU.
        let mut real = Dual::constant(self.value.lane(lane));
        for i in 0..N {
            real.tangent[i] = self.tangent[i].lane(lane);
        }
        real
    }
    #[inline(always)]
    unsafe fn gather(rows: &[Row<Self::Real>], index: &[u32]) -> Vec3<Self> {
        // SAFETY: the caller's promise.
        let row = |lane: usize| unsafe { rows.get_unchecked(*index.get_unchecked(lane) as usize) };
        let component = |c: usize| unsafe { Self::each(|lane| &raw const row(lane).0[c]) };
        Vec3::new(component(0), component(1), component(2))
    }
    #[inline(always)]
    unsafe fn scatter_add(rows: &mut [Row<Self::Real>], index: &[u32], value: Vec3<Self>) {
        for lane in 0..Self::LANES {
            // SAFETY: the caller's promise.
            unsafe { rows.get_unchecked_mut(*index.get_unchecked(lane) as usize) }.add(value.real(lane));
        }
    }
    #[inline(always)]
    fn put_rows(rows: &mut [Row<Self::Real>], value: Vec3<Self>) {
        let rows = &mut rows[..Self::LANES];
        for lane in 0..Self::LANES {
            rows[lane] = Row::from_vec(value.real(lane));
        }
    }
}

impl<S: Lanes, const N: usize> Dual<S, N> {
    /// From the numbers that stand where `at` says, lane by lane.
    ///
    /// # Safety
    /// They can be read.
    #[inline(always)]
    unsafe fn each(at: impl Fn(usize) -> *const Dual<f64, N>) -> Self {
        let mut tangent = [S::zero(); N];
        for i in 0..N {
            // SAFETY: the caller's promise.
            tangent[i] = S::from_fn(|lane| unsafe { (*at(lane)).tangent[i] });
        }
        // SAFETY: as above.
        Self { value: S::from_fn(|lane| unsafe { (*at(lane)).value }), tangent }
    }
}

impl<P: Pack> Vec3<P> {
    /// The vector of one lane.
    #[inline(always)]
    fn real(self, lane: usize) -> Vec3<P::Real> {
        Vec3::new(self.x.real(lane), self.y.real(lane), self.z.real(lane))
    }
}
