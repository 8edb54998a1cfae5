//! Packs of numbers with derivatives: a pack of values, and one of each derivative.

use super::{single_quad, Pack, PackKernel, Real, Row};
use crate::lanes::{dispatch_narrow, Kernel, Lanes};
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
    fn load(values: &[Self::Real]) -> Self {
        let values = &values[..Self::LANES];
        // SAFETY: as many as a pack has lanes.
        unsafe { Self::read(values.as_ptr()) }
    }
    #[inline(always)]
    fn store(self, values: &mut [Self::Real]) {
        let values = &mut values[..Self::LANES];
        // SAFETY: as above.
        unsafe { self.write(values.as_mut_ptr()) };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::with_lanes;

    type Number = Dual<f64, 2>;

    /// Numbers that are all different.
    fn number(i: usize) -> Number {
        let value = i as f64;
        Dual { value, tangent: [100.0 + value, 1000.0 - value] }
    }
    fn plain(numbers: &[Number]) -> Vec<[f64; 3]> {
        numbers.iter().map(|n| [n.value, n.tangent[0], n.tangent[1]]).collect()
    }

    /// Every way in and out of packs, over twelve numbers and as many rows.
    struct Through;
    impl PackKernel<Number> for Through {
        type Output = (usize, Vec<[f64; 3]>);
        fn run<P: Pack<Real = Number>>(self) -> Self::Output {
            let given: Vec<Number> = (0..12).map(number).collect();
            let rows: Vec<Row<Number>> =
                (0..12).map(|i| Row([number(i), number(20 + i), number(40 + i), number(60)])).collect();
            let (mut copied, mut moved) = (vec![Number::zero(); 12], vec![Number::zero(); 12]);
            let (mut put, mut added) = (vec![Row::zero(); 12], vec![Row::zero(); 12]);
            let backwards: Vec<u32> = (0..12).rev().collect();
            let mut before = P::splat(number(99));
            for first in (0..12).step_by(P::LANES) {
                let pack = P::load(&given[first..]);
                (pack + P::splat(number(7))).store(&mut copied[first..]);
                // SAFETY: there are as many numbers and rows, and every index is one of a row.
                unsafe {
                    pack.after(before).write(moved.as_mut_ptr().add(first));
                    let vectors = P::gather(&rows, &backwards[first..]);
                    P::put_rows(&mut put[first..], vectors);
                    P::scatter_add(&mut added, &backwards[first..], vectors * pack);
                }
                before = pack;
            }
            let rows = put.iter().chain(&added).flat_map(|row| &row.0[..3]).copied();
            let all: Vec<Number> = copied.into_iter().chain(moved).chain(rows).collect();
            (P::LANES, plain(&all))
        }
    }

    #[test]
    fn packs_hold_the_numbers_and_their_derivatives_in_their_places() {
        let (wide, found) = Number::dispatch(Through);
        let (narrow, single) = with_lanes(1, || Number::dispatch(Through));
        assert_eq!((narrow, found.len()), (1, 12 + 12 + 36 + 36));
        // Sums and products of whole numbers are exact, fused or not.
        assert_eq!(found, single, "{wide} lanes");
        let first: Vec<Number> = (0..12).map(|i| number(i) + number(7)).collect();
        assert_eq!(single[..12], plain(&first));
        let moved: Vec<Number> = (0..12).map(|i| number(if i == 0 { 99 } else { i - 1 })).collect();
        assert_eq!(single[12..24], plain(&moved));
        assert_eq!(single[24..27], plain(&[number(11), number(31), number(51)]));
    }
}
