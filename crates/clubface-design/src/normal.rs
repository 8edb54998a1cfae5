//! Deviates of the standard normal distribution.

// Constants are quoted with all their published digits.
#![allow(clippy::excessive_precision)]

use clubface_math::{Kernel, Lanes, Mask, Scalar, dispatch};

/// Share away from one half up to which deviates come from the first of three formulas.
const MIDDLE_REACHES: f64 = 0.425;

/// The number below which the share `share` (between 0 and 1) of the standard normal distribution lies: M. J. Wichura,
/// Algorithm AS 241 (PPND16), Appl. Statist. 37, 1988, 477-484; relative error about 1e-16.
#[must_use]
pub fn deviate(share: f64) -> f64 {
    let away = share - 0.5;
    if away.abs() <= MIDDLE_REACHES {
        return middle(away);
    }
    let r = (-share.min(1.0 - share).ln()).sqrt();
    let size = if r <= 5.0 { ratio(r - 1.6, &TAIL) } else { ratio(r - 5.0, &FAR) };
    size.copysign(away)
}

/// Writes the deviates of many shares: most of them, those in the middle, in packs.
pub fn deviates(shares: &[f64], deviates: &mut [f64]) {
    dispatch(Deviates { shares, deviates });
}

struct Deviates<'a> {
    shares: &'a [f64],
    deviates: &'a mut [f64],
}

impl Kernel for Deviates<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Lanes>(self) {
        let Self { shares, deviates } = self;
        let whole = shares.len() / S::LANES * S::LANES;
        for first in (0..whole).step_by(S::LANES) {
            let away = S::from_slice(&shares[first..]) - 0.5;
            middle(away).write_to(&mut deviates[first..]);
            let inside = away.abs().le(S::from_f64(MIDDLE_REACHES));
            if !inside.all() {
                for lane in 0..S::LANES {
                    if !inside.lane(lane) {
                        deviates[first + lane] = deviate(shares[first + lane]);
                    }
                }
            }
        }
        for row in whole..shares.len() {
            deviates[row] = deviate(shares[row]);
        }
    }
}

/// The deviate of a share so far from one half, in the middle of the distribution.
#[inline(always)]
fn middle<S: Scalar>(away: S) -> S {
    away * ratio(S::from_f64(0.180_625) - away * away, &MIDDLE)
}

/// A polynomial over another, coefficients from the constant up.
#[inline(always)]
fn ratio<S: Scalar>(x: S, [over, under]: &[[f64; 8]; 2]) -> S {
    let (mut above, mut below) = (S::zero(), S::zero());
    for i in (0..8).rev() {
        above = above * x + over[i];
        below = below * x + under[i];
    }
    above / below
}

const MIDDLE: [[f64; 8]; 2] = [
    [
        3.387_132_872_796_366_608_0,
        1.331_416_678_917_843_774_5e2,
        1.971_590_950_306_551_442_7e3,
        1.373_169_376_550_946_112_5e4,
        4.592_195_393_154_987_145_7e4,
        6.726_577_092_700_870_085_3e4,
        3.343_057_558_358_812_810_5e4,
        2.509_080_928_730_122_672_7e3,
    ],
    [
        1.0,
        4.231_333_070_160_091_125_2e1,
        6.871_870_074_920_579_083_0e2,
        5.394_196_021_424_751_107_7e3,
        2.121_379_430_158_659_586_7e4,
        3.930_789_580_009_271_061_0e4,
        2.872_908_573_572_194_267_4e4,
        5.226_495_278_852_854_561_0e3,
    ],
];
const TAIL: [[f64; 8]; 2] = [
    [
        1.423_437_110_749_683_577_34,
        4.630_337_846_156_545_295_90,
        5.769_497_221_460_691_405_50,
        3.647_848_324_763_204_605_04,
        1.270_458_252_452_368_382_58,
        2.417_807_251_774_506_117_70e-1,
        2.272_384_498_926_918_458_33e-2,
        7.745_450_142_783_414_076_40e-4,
    ],
    [
        1.0,
        2.053_191_626_637_758_821_87,
        1.676_384_830_183_803_849_40,
        6.897_673_349_851_000_045_50e-1,
        1.481_039_764_274_800_745_90e-1,
        1.519_866_656_361_645_719_66e-2,
        5.475_938_084_995_344_946_00e-4,
        1.050_750_071_644_416_843_24e-9,
    ],
];
const FAR: [[f64; 8]; 2] = [
    [
        6.657_904_643_501_103_777_20,
        5.463_784_911_164_114_369_90,
        1.784_826_539_917_291_335_80,
        2.965_605_718_285_048_912_30e-1,
        2.653_218_952_657_612_309_30e-2,
        1.242_660_947_388_078_438_60e-3,
        2.711_555_568_743_487_578_15e-5,
        2.010_334_399_292_288_132_65e-7,
    ],
    [
        1.0,
        5.998_322_065_558_879_376_90e-1,
        1.369_298_809_227_358_053_10e-1,
        1.487_536_129_085_061_485_25e-2,
        7.868_691_311_456_132_591_00e-4,
        1.846_318_317_510_054_681_80e-5,
        1.421_511_758_316_445_888_70e-7,
        2.044_263_103_389_939_785_64e-15,
    ],
];
