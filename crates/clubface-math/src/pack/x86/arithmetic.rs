//! Arithmetic of four numbers (AVX2) and of eight (AVX-512).

use super::masks::{Mask4, Mask8};
use crate::Pack;
use crate::elementary::Primal;
use crate::pack::operators::{primal_functions, primal_operators};
use crate::pack::single::single_four;
use crate::pack::traits::{Lanes, Numbers};
use crate::scalar::{Computation, Scalar, operators};
use core::arch::x86_64::*;
use core::ops::Neg;

#[inline(never)]
#[target_feature(enable = "avx2,fma,avx512f,avx512dq")]
unsafe fn outline_eight<C: Computation>(computation: C) -> C::Output {
    computation.run()
}
#[inline(never)]
#[target_feature(enable = "avx2,fma")]
unsafe fn outline_four<C: Computation>(computation: C) -> C::Output {
    computation.run()
}

/// Four numbers (AVX2). Only for use below [`dispatch`](crate::dispatch) or after `has_four`.
#[derive(Clone, Copy, Debug)]
pub struct F64x4(pub(super) __m256d);
/// Eight numbers (AVX-512). Only for use below [`dispatch`](crate::dispatch) or after `has_eight`.
#[derive(Clone, Copy, Debug)]
pub struct F64x8(pub(super) __m512d);

// SAFETY of every block of this macro: packs exist only where the CPU has the feature (see the types).
macro_rules! pack {
    (@four itself) => {
        single_four!();
    };
    (@four $four:ident) => {
        type Four = $four;
        #[inline(always)]
        fn four(self, index: usize) -> $four {
            self.quad(index)
        }
    };
    (
        $type:ident $mask:ident $lanes:literal $outline:ident $four:tt;
        $load:ident $store:ident $set:ident;
        $add:ident $sub:ident $mul:ident $div:ident $sqrt:ident $fused:ident $min:ident $max:ident;
        neg |$n:ident| $neg:expr;
        abs |$v:ident| $abs:expr;
        less |$a:ident, $b:ident, $op:ident| $less:expr;
        select |$choice:ident, $one:ident, $other:ident| $select:expr;
        pow2_shifted |$shifted:ident| $pow2:expr;
    ) => {
        operators! { [] $type;
            Add add Self => Self, |a, b| Self(unsafe { $add(a.0, b.0) });
            Sub sub Self => Self, |a, b| Self(unsafe { $sub(a.0, b.0) });
            Mul mul Self => Self, |a, b| Self(unsafe { $mul(a.0, b.0) });
            Div div Self => Self, |a, b| Self(unsafe { $div(a.0, b.0) });
        }
        primal_operators!([] $type);

        impl Neg for $type {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                let $n = self.0;
                Self(unsafe { $neg })
            }
        }
        impl $type {
            #[inline(always)]
            fn to_array(self) -> [f64; $lanes] {
                let mut values = [0.0; $lanes];
                // SAFETY: the array holds exactly one pack.
                unsafe { $store(values.as_mut_ptr(), self.0) };
                values
            }
            #[inline(always)]
            fn from_array(values: [f64; $lanes]) -> Self {
                // SAFETY: as above.
                Self(unsafe { $load(values.as_ptr()) })
            }
            #[inline(always)]
            fn less<const $op: i32>(self, other: Self) -> $mask {
                let ($a, $b) = (self.0, other.0);
                $mask(unsafe { $less })
            }
        }
        impl Primal for $type {
            #[inline(always)]
            fn pow2_shifted(shifted: Self) -> Self {
                let $shifted = shifted.0;
                Self(unsafe { $pow2 })
            }
        }
        impl Lanes for $type {
            pack! { @four $four }
        }
        impl Numbers for $type {
            #[inline(always)]
            fn from_fn(mut value: impl FnMut(usize) -> f64) -> Self {
                let mut values = [0.0; $lanes];
                for i in 0..$lanes {
                    values[i] = value(i);
                }
                Self::from_array(values)
            }
            #[inline(always)]
            fn from_slice(values: &[f64]) -> Self {
                Self::load(values)
            }
            #[inline(always)]
            fn write_to(self, values: &mut [f64]) {
                self.store(values);
            }
        }
        impl Scalar for $type {
            type Mask = $mask;
            const LANES: usize = $lanes;
            primal_functions!();
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                Self(unsafe { $set(value) })
            }
            #[inline(always)]
            fn lane(self, index: usize) -> f64 {
                self.to_array()[index]
            }
            #[inline(always)]
            fn outline<C: Computation>(computation: C) -> C::Output {
                unsafe { $outline(computation) }
            }
            #[inline(always)]
            fn lt(self, other: Self) -> $mask {
                self.less::<_CMP_LT_OQ>(other)
            }
            #[inline(always)]
            fn le(self, other: Self) -> $mask {
                self.less::<_CMP_LE_OQ>(other)
            }
            #[inline(always)]
            fn select(mask: $mask, a: Self, b: Self) -> Self {
                let ($choice, $one, $other) = (mask.0, a.0, b.0);
                Self(unsafe { $select })
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(unsafe { $sqrt(self.0) })
            }
            // The instructions give the second operand for NaN and for equal zeros, as the comparisons of the
            // trait's own definitions do.
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self(unsafe { $max(self.0, other.0) })
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self(unsafe { $min(self.0, other.0) })
            }
            #[inline(always)]
            fn abs(self) -> Self {
                let $v = self.0;
                Self(unsafe { $abs })
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                Self(unsafe { $fused(self.0, factor.0, term.0) })
            }
            #[inline(always)]
            fn ln(self) -> Self {
                Self::from_array(self.to_array().map(f64::ln))
            }
        }
    };
}

pack! {
    F64x4 Mask4 4 outline_four itself;
    _mm256_loadu_pd _mm256_storeu_pd _mm256_set1_pd;
    _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd
    _mm256_sqrt_pd _mm256_fmadd_pd _mm256_min_pd _mm256_max_pd;
    neg |a| _mm256_xor_pd(a, _mm256_set1_pd(-0.0));
    abs |a| _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
    less |a, b, OP| _mm256_cmp_pd::<OP>(a, b);
    select |mask, a, b| _mm256_blendv_pd(b, a, mask);
    pow2_shifted |shifted| {
        let bits = _mm256_add_epi64(_mm256_castpd_si256(shifted), _mm256_set1_epi64x(1023));
        _mm256_castsi256_pd(_mm256_slli_epi64::<52>(bits))
    };
}
pack! {
    F64x8 Mask8 8 outline_eight F64x4;
    _mm512_loadu_pd _mm512_storeu_pd _mm512_set1_pd;
    _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd
    _mm512_sqrt_pd _mm512_fmadd_pd _mm512_min_pd _mm512_max_pd;
    neg |a| _mm512_xor_pd(a, _mm512_set1_pd(-0.0));
    abs |a| _mm512_andnot_pd(_mm512_set1_pd(-0.0), a);
    less |a, b, OP| _mm512_cmp_pd_mask::<OP>(a, b);
    select |mask, a, b| _mm512_mask_blend_pd(mask, b, a);
    pow2_shifted |shifted| {
        let bits = _mm512_add_epi64(_mm512_castpd_si512(shifted), _mm512_set1_epi64(1023));
        _mm512_castsi512_pd(_mm512_slli_epi64::<52>(bits))
    };
}
