//! Passes of linear maps of numbers with derivatives, one a part (see [`Part`]).

use clubface_math::{Pack, Part, Scalar};

/// Does something in every pass, `pass` known to the compiler in each, so that no part is looked for at run time.
macro_rules! in_passes {
    ($number:ty, |$pass:ident| $body:expr) => {
        in_passes!($number, |$pass| $body, 0 1 2 3 4)
    };
    ($number:ty, |$pass:ident| $body:expr, $($known:literal)+) => {
        const { assert!(<$number as clubface_math::Real>::PARTS <= [$($known),+].len()) };
        $(if $known < <$number as clubface_math::Real>::PARTS {
            const PASS: usize = $known;
            let $pass = PASS;
            $body;
        })+
    };
}
pub(super) use in_passes;

/// What a pass of a linear map acts on.
#[inline(always)]
pub fn part<P: Pack, G: Part<P>, const N: usize>(packs: &[P; N], pass: usize) -> [G; N] {
    let mut parts = [G::zero(); N];
    for i in 0..N {
        parts[i] = G::from_pack(&packs[i], pass);
    }
    parts
}

/// Stores the result of a pass.
#[inline(always)]
pub fn set_part<P: Pack, G: Part<P>, const N: usize>(packs: &mut [P; N], pass: usize, parts: &[G; N]) {
    for i in 0..N {
        packs[i].set_part(pass, parts[i].into_value());
    }
}

/// Result of a pass.
#[inline(always)]
pub fn into_values<P: Pack, G: Part<P>, const N: usize>(parts: &[G; N]) -> [P::Value; N] {
    let mut packs = [P::Value::zero(); N];
    for i in 0..N {
        packs[i] = parts[i].into_value();
    }
    packs
}

/// What a pass adds to, from values.
#[inline(always)]
pub fn from_values<P: Pack, G: Part<P>, const N: usize>(packs: &[P::Value; N]) -> [G; N] {
    let mut parts = [G::zero(); N];
    for i in 0..N {
        parts[i] = G::from_value(packs[i]);
    }
    parts
}
