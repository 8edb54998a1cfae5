//! Response functions as sums of terms: each a coefficient times features of the impact.

/// What the response functions depend on, each near zero in the middle of its range.
#[derive(Clone, Copy, Debug)]
pub struct Features<S> {
    /// Normal approach speed over 40 m/s, less 0.75.
    pub speed: S,
    /// Coefficient of friction less 0.3, times 3.
    pub friction: S,
    /// How much of the friction rolling needs: 0 to 1, less 0.5.
    pub slip: S,
    /// Mobility of a free ball over that of ball and head along the normal, less 0.8, times 5.
    pub mobility: S,
    /// Mean mobility along the face over that along the normal, compared with that of a fixed head.
    pub ratio: S,
    /// How far the normal impulse drives the contact along its own sliding.
    pub coupling: S,
    /// Square of the characteristic time over 250 us.
    pub face: S,
    /// How much faster the normals approach at separation than at first touch, since a face curves and turns: the gain
    /// over the size of both, times 5.
    pub bend: S,
    /// How far the normal impulse drives the contact along the face in any direction: the square, times 10.
    pub offset: S,
}

/// Declares the parameters of a model whose response functions are sums of terms, and a method for each function.
#[macro_export]
macro_rules! response_functions {
    ($(#[$doc:meta])* $model:ident {
        $($field:ident [$unit:literal] = $default:literal in $lower:literal ..= $upper:literal,
            $meaning:literal, $source:expr;)+
    }
    $($function:ident ($term_meaning:literal, $term_source:expr) {
        $($term:ident = $value:literal $(* $feature:ident)*;)+
    })+) => {
        $crate::parameters! {
            $(#[$doc])* $model {
                $($field [$unit] = $default in $lower ..= $upper, $meaning, $source;)+
                $($($term ["1"] = $value in -20.0 ..= 20.0, $term_meaning, $term_source;)+)+
            }
        }
        impl<S: clubface_math::Scalar> $model<S> {
            $(#[doc = $term_meaning]
            #[inline(always)]
            pub(super) fn $function(&self, at: &$crate::models::response::Features<S>) -> S {
                let mut sum = S::zero();
                $(sum += self.$term $(* at.$feature)*;)+
                sum
            })+
        }
    };
}
