//! A pack gives in every lane the bits that the same numbers give alone, for every operation of `Scalar`.

use clubface_math::{
    Dual, Kernel, Lanes, Mask, Mat3, Numbers, Quat, RowsKernel, Scalar, Vec3, dispatch, dispatch_rows,
    with_lanes,
};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// Every operation of two numbers, by name.
fn operations<S: Numbers>(a: S, b: S) -> Vec<(&'static str, S)> {
    let (sine, cosine) = a.sin_cos();
    let mut sum = a;
    sum += b;
    let mut difference = a;
    difference -= b;
    let (less, at_most) = (a.lt(b), a.le(b));
    vec![
        ("+", a + b),
        ("-", a - b),
        ("*", a * b),
        ("/", a / b),
        ("negation", -a),
        ("+=", sum),
        ("-=", difference),
        ("+ f64", a + 0.3),
        ("- f64", a - 0.3),
        ("* f64", a * 0.3),
        ("/ f64", a / 0.3),
        ("constant", S::from_f64(0.1)),
        ("zero", S::zero()),
        ("one", S::one()),
        ("primal", a.primal()),
        ("select <", S::select(less, a, b)),
        ("select <=", S::select(at_most, a, b)),
        ("select >", S::select(a.gt(b), a, b)),
        ("select >=", S::select(a.ge(b), a, b)),
        ("and", S::select(less.and(a.gt(S::zero())), a, b)),
        ("or", S::select(less.or(a.gt(S::zero())), a, b)),
        ("not", S::select(at_most.not(), a, b)),
        ("splat true", S::select(S::Mask::splat(true), a, b)),
        ("splat false", S::select(S::Mask::splat(false), a, b)),
        ("min", a.min(b)),
        ("max", a.max(b)),
        ("abs", a.abs()),
        ("squared", a.squared()),
        ("recip", a.recip()),
        ("sqrt", a.abs().sqrt()),
        ("safe_sqrt", a.safe_sqrt()),
        ("pow_three_halves", a.pow_three_halves()),
        ("powf", b.abs().powf(1.7)),
        ("exp", a.exp()),
        ("ln", a.abs().ln()),
        ("sine", sine),
        ("cosine", cosine),
        ("atan2", a.atan2(b)),
    ]
}

/// The operations on dual numbers and on what is built of them: value and derivative.
fn compositions<S: Numbers>(a: S, b: S) -> Vec<(&'static str, S)> {
    let x: Dual<S, 1> = Dual::variable(a, 0);
    let y: Dual<S, 1> = Dual::constant(b);
    let vector = Vec3::new(x, y, x * y);
    let turned = Mat3::rotation_x(x.sin_cos()) * (Quat { w: y, v: vector }.matrix() * vector);
    let inverse = (Mat3::outer(vector, vector) + Mat3::diagonal(Dual::one())).inverse() * turned;
    vec![
        ("turned vector", turned.x.value),
        ("its derivative", turned.y.tangent[0]),
        ("matrix inverse", inverse.z.value),
        ("its derivative", inverse.x.tangent[0]),
        ("derivative of atan2", x.atan2(y).tangent[0]),
        ("derivative of a norm", vector.norm().tangent[0]),
    ]
}

/// Results of all pairs, one row a pair.
#[derive(Clone, Copy)]
struct Rows<'a>(&'a [(f64, f64)]);

impl Kernel for Rows<'_> {
    type Output = Vec<Vec<(&'static str, f64)>>;
    fn run<S: Lanes>(self) -> Self::Output {
        RowsKernel::run::<S>(self)
    }
}

impl RowsKernel for Rows<'_> {
    type Output = Vec<Vec<(&'static str, f64)>>;
    fn run<S: Numbers>(self) -> Self::Output {
        let mut rows = Vec::new();
        for pack in self.0.chunks(S::LANES) {
            let pair = |lane: usize| pack[lane.min(pack.len() - 1)];
            let (a, b) = (S::from_fn(|lane| pair(lane).0), S::from_fn(|lane| pair(lane).1));
            let mut results = operations(a, b);
            results.extend(compositions(a, b));
            for lane in 0..pack.len() {
                rows.push(results.iter().map(|(name, value)| (*name, value.lane(lane))).collect());
            }
        }
        rows
    }
}

/// Runs a kernel with every width this CPU has, one pack and two at a time.
fn every_width<T, K: Kernel<Output = T> + RowsKernel<Output = T> + Copy>(kernel: K) -> Vec<(usize, T)> {
    let one = [1, 4, 8].map(|width| (width, with_lanes(width, || dispatch(kernel))));
    let two = [8, 16].map(|width| (width, with_lanes(width, || dispatch_rows(width, kernel))));
    one.into_iter().chain(two).collect()
}

fn assert_same_bits(pairs: &[(f64, f64)]) {
    let alone = RowsKernel::run::<f64>(Rows(pairs));
    for (width, rows) in every_width(Rows(pairs)) {
        assert_eq!(rows.len(), alone.len());
        for ((row, reference), pair) in rows.iter().zip(&alone).zip(pairs) {
            for ((name, value), (_, expected)) in row.iter().zip(reference) {
                // The payload of a NaN says nothing.
                let same = value.to_bits() == expected.to_bits() || value.is_nan() && expected.is_nan();
                assert!(same, "{name} of {pair:?} in {width} lanes: {value:e} for {expected:e}");
            }
        }
    }
}

/// `a b + c` of all rows.
#[derive(Clone, Copy)]
struct Fused<'a>(&'a [[f64; 3]]);

impl Kernel for Fused<'_> {
    type Output = Vec<f64>;
    fn run<S: Lanes>(self) -> Vec<f64> {
        RowsKernel::run::<S>(self)
    }
}

impl RowsKernel for Fused<'_> {
    type Output = Vec<f64>;
    fn run<S: Numbers>(self) -> Vec<f64> {
        let rows = self.0.chunks_exact(S::LANES).flat_map(|pack| {
            let [a, b, c] = [0, 1, 2].map(|place| S::from_fn(|lane| pack[lane][place]));
            let result = a.mul_add(b, c);
            (0..S::LANES).map(move |lane| result.lane(lane))
        });
        rows.collect()
    }
}

proptest! {
    /// The only operation whose bits may depend on the width; no third way of rounding it exists.
    #[test]
    fn a_product_and_a_sum_at_once_are_rounded_once_or_twice(
        rows in prop::collection::vec(prop::array::uniform3(-2.0..2.0f64), 16)
    ) {
        for (width, results) in every_width(Fused(&rows)) {
            for (result, &[a, b, c]) in results.iter().zip(&rows) {
                let (once, twice) = (a.mul_add(b, c), a * b + c);
                prop_assert!(*result == once || *result == twice, "{a} {b} {c} in {width} lanes: {result}");
            }
            prop_assert_eq!(results.len(), rows.len());
        }
    }
}

#[test]
fn special_numbers_give_the_same_bits_in_every_lane() {
    let (infinity, small) = (f64::INFINITY, f64::MIN_POSITIVE);
    let finite =
        [0.0, -0.0, 1.0, -1.0, 0.5, small, 5e-324, -5e-324, 1e300, -1e300, FRAC_PI_2, PI, -710.0, 710.0];
    let special: Vec<f64> = finite.into_iter().chain([infinity, -infinity, f64::NAN]).collect();
    let pairs: Vec<_> = special.iter().flat_map(|&a| special.iter().map(move |&b| (a, b))).collect();
    assert_same_bits(&pairs);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn ordinary_numbers_give_the_same_bits_in_every_lane(
        pairs in prop::collection::vec((-30.0..30.0f64, -30.0..30.0f64), 1..20)
    ) {
        assert_same_bits(&pairs);
    }

    #[test]
    fn numbers_of_any_size_give_the_same_bits_in_every_lane(
        pairs in prop::collection::vec((any::<f64>(), any::<f64>()), 1..20)
    ) {
        assert_same_bits(&pairs);
    }
}

/// Truth values, lane by lane and together.
#[derive(Clone, Copy)]
struct Masks;

impl Kernel for Masks {
    type Output = ();
    fn run<S: Lanes>(self) {
        RowsKernel::run::<S>(self);
    }
}

impl RowsKernel for Masks {
    type Output = ();
    fn run<S: Numbers>(self) {
        let index = S::from_fn(|lane| lane as f64);
        for count in 0..=S::LANES {
            let mask = index.lt(S::from_f64(count as f64));
            for lane in 0..S::LANES {
                assert_eq!(mask.lane(lane), lane < count);
                assert_eq!(mask.not().lane(lane), lane >= count);
            }
            assert_eq!((mask.any(), mask.all()), (count > 0, count == S::LANES));
            assert!(!mask.and(mask.not()).any() && mask.or(mask.not()).all());
        }
    }
}

#[test]
fn truth_values_are_kept_lane_by_lane() {
    RowsKernel::run::<f64>(Masks);
    every_width(Masks);
}

/// Lanes of the packs that it runs on.
#[derive(Clone, Copy)]
struct Width;

impl Kernel for Width {
    type Output = usize;
    fn run<S: Lanes>(self) -> usize {
        S::LANES
    }
}

impl RowsKernel for Width {
    type Output = usize;
    fn run<S: Numbers>(self) -> usize {
        S::LANES
    }
}

#[test]
fn packs_are_as_wide_as_the_processor_and_the_thread_allow() {
    for most in [1, 2, 4, 8, 16] {
        let widths = with_lanes(most, || [dispatch(Width), dispatch_rows(most, Width)]);
        assert!(widths.iter().all(|&lanes| lanes <= most), "{widths:?} lanes, {most} allowed");
        // Every processor of this kind has registers of two numbers.
        if cfg!(target_arch = "aarch64") {
            assert_eq!(widths, [most.min(2), if most < 4 { 1 } else { 4 }], "{most} lanes allowed");
        }
    }
}
