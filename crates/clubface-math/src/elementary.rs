//! Elementary functions, each one algorithm for `f64` and for packs, so that both give the same bits.
//!
//! Range reductions are Cody and Waite's (Software Manual for the Elementary Functions, 1980); the sine and cosine
//! kernels are the minimax polynomials of fdlibm, the arc tangent is Cephes' rational approximation. Each is accurate
//! to about one unit in the last place over the range physics uses.

// Constants are quoted with all their published digits.
#![allow(clippy::excessive_precision)]

use crate::scalar::Scalar;

/// A type without derivatives, of which a power of two can be made from an integer.
pub trait Primal: Scalar {
    /// `2^n`, for `shifted` = [`SHIFT`] + n with n a whole number in -1022..=1023.
    #[must_use]
    fn pow2_shifted(shifted: Self) -> Self;
}

/// Adding this pushes the fraction of a `f64` out of its mantissa: the sum holds the rounded number in its low bits.
pub const SHIFT: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52

const LN2_HI: f64 = 6.931_471_803_691_238_16e-1;
const LN2_LO: f64 = 1.908_214_929_270_587_70e-10;

/// Horner's rule, coefficients from the highest power down.
#[inline(always)]
pub fn polynomial<S: Scalar, const N: usize>(x: S, coefficients: [f64; N]) -> S {
    let mut sum = S::from_f64(coefficients[0]);
    for i in 1..N {
        sum = sum * x + coefficients[i];
    }
    sum
}

/// Exponential, argument clamped to +-700.
#[inline(always)]
pub fn exp<S: Primal>(x: S) -> S {
    let x = x.max(S::from_f64(-700.0)).min(S::from_f64(700.0));
    let shifted = x * core::f64::consts::LOG2_E + SHIFT;
    let n = shifted - SHIFT;
    let r = x - n * LN2_HI - n * LN2_LO;
    // Taylor to r^13: |r| <= 0.347, so the first term left out is below 5e-18. In pairs (Estrin), since the time of a
    // pack is that of the longest chain of operations.
    let (r2, r4) = (r * r, (r * r) * (r * r));
    let first = (r * (1.0 / 6.0) + 0.5) * r2 + (r + 1.0);
    let second = (r * (1.0 / 5_040.0) + 1.0 / 720.0) * r2 + (r * (1.0 / 120.0) + 1.0 / 24.0);
    let third =
        (r * (1.0 / 39_916_800.0) + 1.0 / 3_628_800.0) * r2 + (r * (1.0 / 362_880.0) + 1.0 / 40_320.0);
    let fourth = r * (1.0 / 6_227_020_800.0) + 1.0 / 479_001_600.0;
    let sum = ((fourth * r4 + third) * (r4 * r4) + second * r4) + first;
    sum * S::pow2_shifted(shifted)
}

/// Sine and cosine.
#[inline(always)]
pub fn sin_cos<S: Primal>(x: S) -> (S, S) {
    const PIO2_1: f64 = 1.570_796_326_734_125_614_17;
    const PIO2_2: f64 = 6.077_100_506_303_965_976_60e-11;
    const PIO2_3: f64 = 2.022_266_248_795_950_631_54e-21;
    let n = (x * core::f64::consts::FRAC_2_PI + SHIFT) - SHIFT;
    let r = x - n * PIO2_1 - n * PIO2_2 - n * PIO2_3;
    let z = r * r;
    let sine = r + r
        * z
        * polynomial(
            z,
            [
                1.589_690_995_211_550_102_21e-10,
                -2.505_076_025_340_686_341_95e-8,
                2.755_731_370_707_006_767_89e-6,
                -1.984_126_982_985_794_931_34e-4,
                8.333_333_333_322_489_461_24e-3,
                -1.666_666_666_666_663_243_48e-1,
            ],
        );
    let cosine = z
        * z
        * polynomial(
            z,
            [
                -1.135_964_755_778_819_482_65e-11,
                2.087_572_321_298_174_827_90e-9,
                -2.755_731_435_139_066_330_35e-7,
                2.480_158_728_947_672_941_78e-5,
                -1.388_888_888_887_410_957_49e-3,
                4.166_666_666_666_660_190_37e-2,
            ],
        )
        - z * 0.5
        + 1.0;
    // Quarter turn: n modulo 4 as a whole number in -2..=2.
    let quarter = n - ((n * 0.25 + SHIFT) - SHIFT) * 4.0;
    let odd = quarter.abs().lt(S::from_f64(1.5));
    let half = S::from_f64(0.5);
    let is_zero = quarter.abs().lt(half);
    let swapped = (S::select(odd, cosine, -sine), S::select(odd, -sine, -cosine));
    let flip = quarter.lt(S::zero());
    let swapped = (
        S::select(flip, S::select(odd, -cosine, -sine), swapped.0),
        S::select(flip, S::select(odd, sine, -cosine), swapped.1),
    );
    (S::select(is_zero, sine, swapped.0), S::select(is_zero, cosine, swapped.1))
}

/// Angle of the point (x, y) in (-pi, pi], 0 for the origin.
#[inline(always)]
pub fn atan2<S: Primal>(y: S, x: S) -> S {
    let (ax, ay) = (x.abs(), y.abs());
    let steep = ax.lt(ay);
    let large = S::select(steep, ay, ax);
    let small = S::select(steep, ax, ay);
    let t = S::select(large.gt(S::zero()), small / large, S::zero());
    let upper = t.gt(S::from_f64(0.66));
    let reduced = S::select(upper, (t - 1.0) / (t + 1.0), t);
    let z = reduced * reduced;
    let p = polynomial(
        z,
        [
            -8.750_608_600_031_904_122_785e-1,
            -1.615_753_718_733_365_076_637e1,
            -7.500_855_792_314_704_667_340e1,
            -1.228_866_684_490_136_173_410e2,
            -6.485_021_904_942_025_371_773e1,
        ],
    );
    let q = polynomial(
        z,
        [
            1.0,
            2.485_846_490_142_306_297_962e1,
            1.650_270_098_316_988_542_046e2,
            4.328_810_604_912_902_668_951e2,
            4.853_903_996_359_136_964_868e2,
            1.945_506_571_482_613_964_425e2,
        ],
    );
    let base = reduced + reduced * z * (p / q);
    let angle = S::select(upper, base + core::f64::consts::FRAC_PI_4, base);
    let angle = S::select(steep, -angle + core::f64::consts::FRAC_PI_2, angle);
    let angle = S::select(x.lt(S::zero()), -angle + core::f64::consts::PI, angle);
    S::select(y.lt(S::zero()), -angle, angle)
}

/// `tanh(c sqrt(w)) / sqrt(w)` as a smooth function of `w >= 0`: the factor that turns a sliding velocity into its
/// regularised direction, with exact derivatives down to rest.
#[inline(always)]
pub fn tanh_ratio<S: Scalar>(c: S, w: S) -> S {
    let z = c * c * w;
    // Series of tanh(x)/x in z = x^2; below z = 0.01 the first term left out is under 4e-15.
    let near =
        polynomial(z, [-1382.0 / 155_925.0, 62.0 / 2835.0, -17.0 / 315.0, 2.0 / 15.0, -1.0 / 3.0, 1.0]) * c;
    let root = w.safe_sqrt();
    let t = (c * root * -2.0).exp();
    let far = (-t + 1.0) / ((t + 1.0) * root);
    S::select(z.lt(S::from_f64(0.01)), near, far)
}

/// `j^(-1/3)` from a parabola through 0.5, 1, 1.7, within 2% there. With `h = 1 - j y^3` the root is
/// `y (1 - h)^(-1/3)`, whose series to the third order leaves `h^4/7`: two steps are exact there. They lead to the
/// root between 0.3 and 2.5.
#[inline(always)]
pub fn inverse_cube_root<S: Primal>(j: S) -> S {
    let mut y = (j * 0.240_2 - 0.880_1).mul_add(j, S::from_f64(1.639_9));
    for _ in 0..2 {
        let h = (-(y * y)).mul_add(y * j, S::one());
        let series = h.mul_add(S::from_f64(14.0 / 81.0), S::from_f64(2.0 / 9.0));
        let series = series.mul_add(h, S::from_f64(1.0 / 3.0));
        y = (y * h).mul_add(series, y);
    }
    y
}
