//! Arithmetic of four numbers (AVX2) and of eight (AVX-512).

use super::masks::{Mask4, Mask8};
use crate::elementary::{self, Primal};
use crate::pack::operators::primal_operators;
use crate::pack::traits::Lanes;
use crate::scalar::{Computation, Scalar};
use core::arch::x86_64::*;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

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

/// Four numbers (AVX2). Only for use below [`dispatch`](super::dispatch) or after [`has_four`].
#[derive(Clone, Copy, Debug)]
pub struct F64x4(pub(super) __m256d);
/// Eight numbers (AVX-512). Only for use below [`dispatch`](super::dispatch) or after [`has_eight`].
#[derive(Clone, Copy, Debug)]
pub struct F64x8(pub(super) __m512d);
macro_rules! binary {
    ($type:ident, $trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: packs exist only where the CPU has the feature (see the type).
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    };
}

macro_rules! pack {
    ($type:ident, $mask:ident, $lanes:literal, $load:ident, $store:ident, $set:ident, $sqrt:ident,
     $add:ident, $sub:ident, $mul:ident, $div:ident, $min:ident, $max:ident, $fused:ident,
     $outline:ident) => {
        binary!($type, Add, add, $add);
        binary!($type, Sub, sub, $sub);
        binary!($type, Mul, mul, $mul);
        binary!($type, Div, div, $div);
        primal_operators!($type);

        impl Neg for $type {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.negated()
            }
        }
        impl $type {
            #[inline(always)]
            fn to_array(self) -> [f64; $lanes] {
                let mut values = [0.0; $lanes];
                // SAFETY: the array holds exactly one pack; see the type for the feature.
                unsafe { $store(values.as_mut_ptr(), self.0) };
                values
            }
            #[inline(always)]
            fn from_array(values: [f64; $lanes]) -> Self {
                // SAFETY: as above.
                Self(unsafe { $load(values.as_ptr()) })
            }
        }
        impl Lanes for $type {
            #[inline(always)]
            fn from_fn(mut value: impl FnMut(usize) -> f64) -> Self {
                let mut values = [0.0; $lanes];
                for i in 0..$lanes {
                    values[i] = value(i);
                }
                Self::from_array(values)
            }
        }
        impl Scalar for $type {
            type Mask = $mask;
            const LANES: usize = $lanes;
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                // SAFETY: see the type for the feature.
                Self(unsafe { $set(value) })
            }
            #[inline(always)]
            fn lane(self, index: usize) -> f64 {
                self.to_array()[index]
            }
            #[inline(always)]
            fn primal(self) -> Self {
                self
            }
            #[inline(always)]
            fn outline<C: Computation>(computation: C) -> C::Output {
                // SAFETY: a computation with this type runs only where the CPU has the feature.
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
                Self::blend(mask, a, b)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: see the type for the feature.
                Self(unsafe { $sqrt(self.0) })
            }
            // The instructions give the second operand for NaN and for equal zeros, as the comparisons of the
            // trait's own definitions do.
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                // SAFETY: see the type for the feature.
                Self(unsafe { $max(self.0, other.0) })
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                // SAFETY: see the type for the feature.
                Self(unsafe { $min(self.0, other.0) })
            }
            #[inline(always)]
            fn abs(self) -> Self {
                self.absolute()
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                // SAFETY: see the type for the feature.
                Self(unsafe { $fused(self.0, factor.0, term.0) })
            }
            #[inline(always)]
            fn exp(self) -> Self {
                elementary::exp(self)
            }
            #[inline(always)]
            fn ln(self) -> Self {
                Self::from_array(self.to_array().map(f64::ln))
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                elementary::sin_cos(self)
            }
            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                elementary::atan2(self, x)
            }
        }
    };
}

pack!(
    F64x4,
    Mask4,
    4,
    _mm256_loadu_pd,
    _mm256_storeu_pd,
    _mm256_set1_pd,
    _mm256_sqrt_pd,
    _mm256_add_pd,
    _mm256_sub_pd,
    _mm256_mul_pd,
    _mm256_div_pd,
    _mm256_min_pd,
    _mm256_max_pd,
    _mm256_fmadd_pd,
    outline_four
);
pack!(
    F64x8,
    Mask8,
    8,
    _mm512_loadu_pd,
    _mm512_storeu_pd,
    _mm512_set1_pd,
    _mm512_sqrt_pd,
    _mm512_add_pd,
    _mm512_sub_pd,
    _mm512_mul_pd,
    _mm512_div_pd,
    _mm512_min_pd,
    _mm512_max_pd,
    _mm512_fmadd_pd,
    outline_eight
);

// SAFETY of every block below: packs exist only where the CPU has the feature (see the types).
impl F64x4 {
    #[inline(always)]
    fn negated(self) -> Self {
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
    #[inline(always)]
    fn absolute(self) -> Self {
        Self(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn less<const OP: i32>(self, other: Self) -> Mask4 {
        Mask4(unsafe { _mm256_cmp_pd::<OP>(self.0, other.0) })
    }
    #[inline(always)]
    fn blend(mask: Mask4, a: Self, b: Self) -> Self {
        Self(unsafe { _mm256_blendv_pd(b.0, a.0, mask.0) })
    }
}
impl F64x8 {
    #[inline(always)]
    fn negated(self) -> Self {
        Self(unsafe { _mm512_xor_pd(self.0, _mm512_set1_pd(-0.0)) })
    }
    #[inline(always)]
    fn absolute(self) -> Self {
        Self(unsafe { _mm512_andnot_pd(_mm512_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn less<const OP: i32>(self, other: Self) -> Mask8 {
        Mask8(unsafe { _mm512_cmp_pd_mask::<OP>(self.0, other.0) })
    }
    #[inline(always)]
    fn blend(mask: Mask8, a: Self, b: Self) -> Self {
        Self(unsafe { _mm512_mask_blend_pd(mask.0, b.0, a.0) })
    }
}
impl Primal for F64x4 {
    #[inline(always)]
    fn pow2_shifted(shifted: Self) -> Self {
        unsafe {
            let bits = _mm256_add_epi64(_mm256_castpd_si256(shifted.0), _mm256_set1_epi64x(1023));
            Self(_mm256_castsi256_pd(_mm256_slli_epi64::<52>(bits)))
        }
    }
}
impl Primal for F64x8 {
    #[inline(always)]
    fn pow2_shifted(shifted: Self) -> Self {
        unsafe {
            let bits = _mm512_add_epi64(_mm512_castpd_si512(shifted.0), _mm512_set1_epi64(1023));
            Self(_mm512_castsi512_pd(_mm512_slli_epi64::<52>(bits)))
        }
    }
}
