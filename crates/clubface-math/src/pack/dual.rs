//! Packs of numbers with derivatives: a pack of values, and one of each derivative.

use super::dispatch::dispatch;
use super::traits::{Kernel, Lanes, Pack, PackKernel, Real, Row};
use crate::{Dual, Scalar, Vec3};
use core::fmt::Debug;

/// Most lanes of a pack.
const LANES: usize = 8;

impl<const N: usize> Real for Dual<f64, N> {
    const PARTS: usize = N + 1;
    type Parts<A: Copy + Debug + Send + Sync + 'static> = Dual<A, N>;
    fn derivatives(&self) -> &[f64] {
        &self.tangent
    }
    #[inline(always)]
    unsafe fn from_parts(at: *const f64, stride: usize) -> Self {
        // SAFETY: the caller's promise.
        unsafe {
            let mut number = Self::constant(*at);
            for i in 0..N {
                number.tangent[i] = *at.add((i + 1) * stride);
            }
            number
        }
    }
    #[inline(always)]
    unsafe fn put_parts(self, at: *mut f64, stride: usize) {
        // SAFETY: the caller's promise.
        unsafe {
            *at = self.value;
            for i in 0..N {
                *at.add((i + 1) * stride) = self.tangent[i];
            }
        }
    }
    #[inline(always)]
    fn each_part<A: Copy + Debug + Send + Sync + 'static>(value: A) -> Dual<A, N> {
        Dual { value, tangent: [value; N] }
    }
    #[inline(always)]
    fn part_mut<A: Copy + Debug + Send + Sync + 'static>(parts: &mut Dual<A, N>, part: usize) -> &mut A {
        if part == 0 { &mut parts.value } else { &mut parts.tangent[part - 1] }
    }
    #[inline(always)]
    fn add_times(sum: &mut Dual<[f64; 4], N>, v: &Dual<[f64; 4], N>, s: f64) {
        f64::add_scaled(&mut sum.value, &v.value, s);
        for i in 0..N {
            f64::add_scaled(&mut sum.tangent[i], &v.tangent[i], s);
        }
    }
    #[inline(always)]
    fn add_scaled(sum: &mut Dual<[f64; 4], N>, v: &Dual<[f64; 4], N>, s: Self) {
        Self::add_times(sum, v, s.value);
        for i in 0..N {
            f64::add_scaled(&mut sum.tangent[i], &v.value, s.tangent[i]);
        }
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
        dispatch(Derived(kernel))
    }
    fn singly<K: PackKernel<Self>>(kernel: K) -> K::Output {
        kernel.run::<Self>()
    }
}

/// A number with derivatives in each lane: a pack of values and one of every derivative.
impl<S: Lanes, const N: usize> Pack for Dual<S, N> {
    type Real = Dual<f64, N>;
    type Value = S;
    type Pair = Dual<S, 1>;
    type Quad = Dual<S::Four, N>;
    #[inline(always)]
    fn part(self, index: usize) -> S {
        if index == 0 { self.value } else { self.tangent[index - 1] }
    }
    #[inline(always)]
    fn set_part(&mut self, index: usize, part: S) {
        if index == 0 {
            self.value = part;
        } else {
            self.tangent[index - 1] = part;
        }
    }
    #[inline(always)]
    fn quad(self, index: usize) -> Self::Quad {
        let mut quad = Dual::constant(self.value.four(index));
        for i in 0..N {
            quad.tangent[i] = self.tangent[i].four(index);
        }
        quad
    }
    #[inline(always)]
    unsafe fn read_quads(at: [*const f64; 2], stride: usize) -> Self {
        // SAFETY: the caller's promise.
        unsafe {
            let mut pack = Self::constant(S::read_quads(at, stride));
            for i in 0..N {
                let part = (i + 1) * stride;
                pack.tangent[i] = S::read_quads([at[0].add(part), at[1].add(part)], stride);
            }
            pack
        }
    }
    #[inline(always)]
    unsafe fn read_parts(at: *const f64, stride: usize) -> Self {
        // SAFETY: the caller's promise.
        unsafe {
            let mut pack = Self::constant(S::read(at));
            for i in 0..N {
                pack.tangent[i] = S::read(at.add((i + 1) * stride));
            }
            pack
        }
    }
    #[inline(always)]
    unsafe fn write_parts(self, at: *mut f64, stride: usize) {
        // SAFETY: the caller's promise.
        unsafe {
            self.value.write(at);
            for i in 0..N {
                self.tangent[i].write(at.add((i + 1) * stride));
            }
        }
    }
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
        let mut tangent = [S::zero(); N];
        for i in 0..N {
            // SAFETY: the caller's promise.
            tangent[i] = S::from_fn(|lane| unsafe { (*at.add(lane)).tangent[i] });
        }
        // SAFETY: as above.
        Self { value: S::from_fn(|lane| unsafe { (*at.add(lane)).value }), tangent }
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
        // SAFETY of this and what follows: the caller's promise, and the parts of a row are rows of plain numbers.
        unsafe {
            let places = places::<S, N>(index);
            let value = S::gather(parts(rows, 0), &places);
            let mut v = Vec3::new(Self::constant(value.x), Self::constant(value.y), Self::constant(value.z));
            for i in 0..N {
                let slope = S::gather(parts(rows, i + 1), &places);
                (v.x.tangent[i], v.y.tangent[i], v.z.tangent[i]) = (slope.x, slope.y, slope.z);
            }
            v
        }
    }
    #[inline(always)]
    unsafe fn scatter_add(rows: &mut [Row<Self::Real>], index: &[u32], value: Vec3<Self>) {
        let places = places::<S, N>(index);
        for part in 0..=N {
            // SAFETY: as in `gather`.
            unsafe { S::scatter_add(parts_mut(rows, part), &places, part_of(&value, part)) };
        }
    }
    #[inline(always)]
    fn put_rows(rows: &mut [Row<Self::Real>], value: Vec3<Self>) {
        let rows = &mut rows[..Self::LANES];
        for part in 0..=N {
            let mut plain = [Row::zero(); LANES];
            S::put_rows(&mut plain, part_of(&value, part));
            for lane in 0..Self::LANES {
                // SAFETY: a row has as many parts.
                unsafe { *rows.as_mut_ptr().add(lane).cast::<Row<f64>>().add(part) = plain[lane] };
            }
        }
    }
}

/// One part of a vector.
#[inline(always)]
fn part_of<S: Lanes, const N: usize>(vector: &Vec3<Dual<S, N>>, part: usize) -> Vec3<S> {
    Vec3::new(Pack::part(vector.x, part), Pack::part(vector.y, part), Pack::part(vector.z, part))
}

/// Places of the values of some rows among all parts, and so of each other part behind the first of its kind: worked
/// out once for all parts.
#[inline(always)]
fn places<S: Lanes, const N: usize>(index: &[u32]) -> [u32; LANES] {
    let index = &index[..S::LANES];
    let mut places = [0; LANES];
    for lane in 0..S::LANES {
        places[lane] = index[lane] * (N as u32 + 1);
    }
    places
}

/// Parts of rows from one of those of the first row on, one after the other, each a row of plain numbers.
///
/// # Safety
/// There are rows, and a row has this part.
#[inline(always)]
unsafe fn parts<const N: usize>(rows: &[Row<Dual<f64, N>>], from: usize) -> &[Row<f64>] {
    // SAFETY: a row of numbers with derivatives is as many rows of plain numbers as it has parts.
    unsafe {
        let first = rows.as_ptr().cast::<Row<f64>>();
        core::slice::from_raw_parts(first.add(from), rows.len() * (N + 1) - from)
    }
}
/// The same to change them.
///
/// # Safety
/// As for [`parts`].
#[inline(always)]
unsafe fn parts_mut<const N: usize>(rows: &mut [Row<Dual<f64, N>>], from: usize) -> &mut [Row<f64>] {
    // SAFETY: as above.
    unsafe {
        let first = rows.as_mut_ptr().cast::<Row<f64>>();
        core::slice::from_raw_parts_mut(first.add(from), rows.len() * (N + 1) - from)
    }
}
