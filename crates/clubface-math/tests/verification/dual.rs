//! Dual numbers against an independent implementation (num-dual) and against central differences.

use clubface_math::elementary::tanh_ratio;
use clubface_math::{Dual, Scalar};
use num_dual::{Dual64, DualNum, HyperDual64};
use proptest::prelude::*;

/// One formula, written once, for our scalars and for the oracle's.
macro_rules! formula {
    ($name:ident, $oracle:ident, |$x:ident, $y:ident| $body:expr) => {
        fn $name<T: Scalar>($x: T, $y: T) -> T {
            $body
        }
        fn $oracle<T: DualNum<Primitive = f64> + Copy>($x: T, $y: T) -> T {
            $body
        }
    };
}

formula!(algebra, algebra_oracle, |x, y| ((x * y + 2.5) / (x * x + y * y - 0.25) - y * 3.0) / 7.0 + -x);
formula!(powers, powers_oracle, |x, y| x.sqrt() * y.powf(1.3) + (x * y).recip() - x.powf(-0.7));
formula!(waves, waves_oracle, |x, y| {
    let (sine, cosine) = (x * y).sin_cos();
    sine * (y - x).exp() + cosine * (x + y).ln()
});
formula!(angle, angle_oracle, |x, y| (x - 1.5).atan2(y - 1.5) * (y * 1.1 - x).atan2(x));

type Ours = fn(Dual<f64, 2>, Dual<f64, 2>) -> Dual<f64, 2>;
type Oracle = fn(Dual64, Dual64) -> Dual64;
type OursTwice = fn(Dual<Dual<f64, 1>, 1>, Dual<Dual<f64, 1>, 1>) -> Dual<Dual<f64, 1>, 1>;
type OracleTwice = fn(HyperDual64, HyperDual64) -> HyperDual64;

type Regularised = fn(Dual<f64, 1>) -> Dual<f64, 1>;

const FORMULAS: [(Ours, Oracle); 4] =
    [(algebra, algebra_oracle), (powers, powers_oracle), (waves, waves_oracle), (angle, angle_oracle)];
const FORMULAS_TWICE: [(OursTwice, OracleTwice); 4] =
    [(algebra, algebra_oracle), (powers, powers_oracle), (waves, waves_oracle), (angle, angle_oracle)];

/// Both round each of some ten operations; a derivative may cancel to a hundredth of its terms.
const ROUNDING: f64 = 1e-12;

fn close(result: f64, expected: f64) -> bool {
    (result - expected).abs() <= ROUNDING * (1.0 + expected.abs())
}

/// Away from the origin of the angles, where they jump.
fn regular(x: f64, y: f64) -> bool {
    (x - 1.5).hypot(y - 1.5) > 0.1 && (x * x + y * y - 0.25).abs() > 0.05
}

fn fused<T: Scalar>(factor: T, other: T, term: T) -> (T, T) {
    (factor.mul_add(other, term), factor * other + term)
}

proptest! {
    /// Fused or not, it is a product and a sum, in plain numbers and in their derivatives.
    #[test]
    fn a_product_and_a_sum_at_once_are_both(x in -3.0..3.0f64, y in -3.0..3.0f64, z in -3.0..3.0f64) {
        let (at_once, apart) = fused(x, y, z);
        prop_assert!(close(at_once, x * y + z) && close(apart, x * y + z));
        let duals = fused::<Dual<f64, 3>>(Dual::variable(x, 0), Dual::variable(y, 1), Dual::variable(z, 2));
        prop_assert!(close(duals.0.value, x * y + z));
        for (result, expected) in duals.0.tangent.iter().zip([y, x, 1.0]) {
            prop_assert!(close(*result, expected));
        }
    }

    #[test]
    fn first_derivatives_equal_those_of_an_independent_implementation(x in 0.3..3.0f64, y in 0.3..3.0f64) {
        prop_assume!(regular(x, y));
        for (ours, oracle) in FORMULAS {
            let result = ours(Dual::variable(x, 0), Dual::variable(y, 1));
            let by_x = oracle(Dual64::new(x, 1.0), Dual64::new(y, 0.0));
            let by_y = oracle(Dual64::new(x, 0.0), Dual64::new(y, 1.0));
            prop_assert!(close(result.value, by_x.re));
            prop_assert!(close(result.tangent[0], by_x.eps) && close(result.tangent[1], by_y.eps));
        }
    }

    /// A dual of a dual carries the mixed second derivative.
    #[test]
    fn nested_duals_give_second_derivatives(x in 0.3..3.0f64, y in 0.3..3.0f64) {
        prop_assume!(regular(x, y));
        for (ours, oracle) in FORMULAS_TWICE {
            let inner = |value: f64, seed: f64| Dual { value, tangent: [seed] };
            let result = ours(
                Dual { value: inner(x, 1.0), tangent: [inner(0.0, 0.0)] },
                Dual { value: inner(y, 0.0), tangent: [inner(1.0, 0.0)] },
            );
            let expected = oracle(HyperDual64::new(x, 1.0, 0.0, 0.0), HyperDual64::new(y, 0.0, 1.0, 0.0));
            prop_assert!(close(result.value.tangent[0], expected.eps1));
            prop_assert!(close(result.tangent[0].value, expected.eps2));
            // Second derivatives cancel once more.
            let size = 1e3 * (1.0 + expected.eps1.abs() + expected.eps2.abs());
            prop_assert!((result.tangent[0].tangent[0] - expected.eps1eps2).abs() < ROUNDING * size);
        }
    }

    /// The functions the oracle does not have, by central differences: of step h they err by h^2 f'''/6 + eps f/h.
    #[test]
    fn regularised_functions_have_exact_derivatives(x in -2.0..2.0f64) {
        prop_assume!(x.abs() > 0.01);
        let h = 1e-6;
        let functions: [(&str, Regularised); 6] = [
            ("abs", Dual::abs),
            ("safe_sqrt", Dual::safe_sqrt),
            ("pow_three_halves", Dual::pow_three_halves),
            ("squared", Dual::squared),
            ("max", |x| x.max(x * 2.0)),
            ("tanh_ratio", |x| tanh_ratio(Dual::constant(3.0), x.abs())),
        ];
        for (name, f) in functions {
            let at = |x: f64| f(Dual::variable(x, 0));
            let difference = (at(x + h).value - at(x - h).value) / (2.0 * h);
            let result = at(x).tangent[0];
            // safe_sqrt at 0.01: f''' h^2 / 6 = 6e-8.
            prop_assert!((result - difference).abs() < 1e-6 * (1.0 + result.abs()), "{} {} {}", name, result, difference);
        }
    }
}

#[test]
fn lengths_that_vanish_have_the_derivative_zero() {
    let zero = Dual::<f64, 1>::variable(0.0, 0);
    assert_eq!((zero.safe_sqrt().value, zero.safe_sqrt().tangent[0]), (0.0, 0.0));
    assert_eq!(zero.pow_three_halves().tangent[0], 0.0);
    assert_eq!(zero.atan2(zero).tangent[0], 0.0);
}

#[test]
fn a_constant_and_a_primal_have_no_derivatives() {
    let x = Dual::<f64, 2>::variable(1.5, 1);
    assert_eq!(x.tangent, [0.0, 1.0]);
    assert_eq!((x * 2.0).primal().tangent, [0.0, 0.0]);
    assert_eq!(Dual::<f64, 2>::from_f64(1.5).tangent, [0.0, 0.0]);
    assert_eq!(x.scale(3.0).tangent, [0.0, 3.0]);
}

#[test]
fn comparisons_look_at_the_value_alone() {
    let (small, large) = (Dual::<f64, 1>::variable(1.0, 0), Dual::<f64, 1>::constant(2.0));
    assert!(small.lt(large) && small.le(small) && large.gt(small) && !small.lt(small));
    assert_eq!(Dual::select(small.lt(large), small, large).tangent[0], 1.0);
}
