//! Hertz's normal force with Hunt-Crossley damping, which the area and rings models share (Caldwell and McPhee, Eqs.
//! 14-16).

use clubface_math::{Dual, Scalar};

/// Radius of the sphere that touches a plane as ball and face touch each other, m (Caldwell and McPhee, Eq. 16 with the
/// mean curvature).
#[inline(always)]
pub fn equivalent_radius<S: Scalar>(radius: S, curvature: S) -> S {
    (radius.recip() + curvature).recip()
}

/// Stiffness, N/m^1.5, of Caldwell and McPhee's Eq. 15 as printed: Hertz for two bodies of the same shear modulus, Pa.
#[inline(always)]
pub fn stiffness<S: Scalar, const K: usize>(
    shear_modulus: S,
    poisson: S,
    equivalent_radius: Dual<S, K>,
) -> Dual<S, K> {
    equivalent_radius.sqrt().scale(shear_modulus * (4.0 / 3.0) / (-poisson + 1.0))
}

/// Normal force k x^1.5 (1 + d xdot), N, never adhesive (Caldwell and McPhee, Eq. 14, read as in McNally's volumetric
/// law).
#[inline(always)]
pub fn force<S: Scalar, const K: usize>(
    stiffness: Dual<S, K>,
    damping: S,
    depth: Dual<S, K>,
    rate: Dual<S, K>,
) -> Dual<S, K> {
    (depth.pow_three_halves() * stiffness * (rate.scale(damping) + 1.0)).max(Dual::zero())
}
