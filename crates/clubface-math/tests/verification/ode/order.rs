//! Order of convergence: halving the step divides the error by 2^order.

use super::problems::{Curves, Linearization, curves_at, distance, in_equal_steps};
use clubface_math::ode::{BOGACKI_SHAMPINE, DORMAND_PRINCE, Method, RK4, Rosenbrock, System};

const END: f64 = 3.0;

/// Errors at three step lengths and the order between the two shortest.
fn observed_order<M: Method<Curves, f64, 3>>(method: &M, problem: &Curves, steps: usize) -> (f64, [f64; 3]) {
    let errors = [1, 2, 4]
        .map(|factor| distance(&in_equal_steps(method, problem, END, steps * factor), &curves_at(END)));
    ((errors[1] / errors[2]).log2(), errors)
}

/// The next term of the error is a step length smaller: 0.2 in the observed order at these steps. An order condition
/// that fails costs a whole order.
fn assert_order<M: Method<Curves, f64, 3>>(method: &M, problem: &Curves, steps: usize, order: f64) {
    let (result, errors) = observed_order(method, problem, steps);
    assert!((result - order).abs() < 0.2, "order {result} for {order}: {errors:?}");
}

#[test]
fn dormand_prince_converges_with_order_five() {
    assert_order(&DORMAND_PRINCE, &Curves(Linearization::Exact), 40, 5.0);
}

#[test]
fn bogacki_shampine_converges_with_order_three() {
    assert_order(&BOGACKI_SHAMPINE, &Curves(Linearization::Exact), 160, 3.0);
}

#[test]
fn the_classical_runge_kutta_method_converges_with_order_four() {
    assert_order(&RK4, &Curves(Linearization::Exact), 80, 4.0);
}

#[test]
fn rosenbrock_converges_with_order_three_by_the_true_jacobian() {
    assert_order(&Rosenbrock, &Curves(Linearization::Exact), 320, 3.0);
}

/// The W property: the order conditions hold for any matrix in place of the Jacobian. With none they are those of
/// the explicit coefficients alone, with an unrelated one all of them count.
#[test]
fn rosenbrock_keeps_order_three_whatever_stands_for_the_jacobian() {
    assert_order(&Rosenbrock, &Curves(Linearization::Zero), 320, 3.0);
    assert_order(&Rosenbrock, &Curves(Linearization::Unrelated), 320, 3.0);
}

/// The estimate of one step's error is of the order that sizes the steps: what the embedded solution (one order lower)
/// lacks. Its next term is a step length smaller.
#[test]
fn error_estimates_fall_with_the_order_they_declare() {
    fn assert_estimate<M: Method<Curves, f64, 3>>(method: &M, problem: Curves) {
        let y = curves_at(0.4);
        let rate = problem.rhs(&y);
        let estimate = |h: f64| distance(&method.attempt(&problem, &y, &rate, h).error, &[0.0; 3]);
        let result = (estimate(0.02) / estimate(0.01)).log2();
        let order = f64::from(method.error_order());
        assert!((result - order).abs() < 0.2, "estimate of order {result} for {order}");
    }
    assert_estimate(&DORMAND_PRINCE, Curves(Linearization::Exact));
    assert_estimate(&BOGACKI_SHAMPINE, Curves(Linearization::Exact));
    for linearization in [Linearization::Exact, Linearization::Zero, Linearization::Unrelated] {
        assert_estimate(&Rosenbrock, Curves(linearization));
    }
}

/// The last stage is the derivative at the end of the step, which the next step starts from.
#[test]
fn the_rate_an_attempt_returns_belongs_to_its_end() {
    fn assert_rate<M: Method<Curves, f64, 3>>(method: &M) {
        let problem = Curves(Linearization::Exact);
        let y = curves_at(1.0);
        let end = method.attempt(&problem, &y, &problem.rhs(&y), 0.1);
        assert_eq!(end.rate, problem.rhs(&end.y));
    }
    assert_rate(&DORMAND_PRINCE);
    assert_rate(&BOGACKI_SHAMPINE);
    assert_rate(&RK4);
    assert_rate(&Rosenbrock);
}
