//! Systems with known solutions.

use clubface_math::ode::{Method, Observer, StiffSystem, System};
use clubface_math::{Dual, Mask, Mat3, Scalar, Vec3};

/// What stands for the Jacobian in the Rosenbrock method.
#[derive(Clone, Copy, Debug)]
pub enum Linearization {
    /// The derivatives of the right-hand side.
    Exact,
    /// Nothing: the method becomes an explicit one.
    Zero,
    /// A matrix that has nothing to do with the system, 1/s.
    Unrelated,
}

/// Two coupled curves with state (t, u, v) and solution u = exp(sin t), v = 1/(2 + cos t):
/// u' = u cos t (v (2 + cos t))^2, v' = v^2 sin t u exp(-sin t).
///
/// Nonlinear, coupled and driven, so that a method meets all its order conditions.
#[derive(Clone, Copy, Debug)]
pub struct Curves(pub Linearization);

/// The solution of [`Curves`] at time `t`.
pub fn curves_at(t: f64) -> [f64; 3] {
    [t, t.sin().exp(), 1.0 / (2.0 + t.cos())]
}

fn curves<S: Scalar>([t, u, v]: [S; 3]) -> [S; 3] {
    let (sine, cosine) = t.sin_cos();
    let on_curve = v * (cosine + 2.0);
    [S::one(), u * cosine * on_curve.squared(), v.squared() * sine * u * (-sine).exp()]
}

impl<S: Scalar> System<S, 3> for Curves {
    fn rhs(&self, y: &[S; 3]) -> [S; 3] {
        curves(*y)
    }
}

impl<S: Scalar> StiffSystem<S, 3> for Curves {
    type Jacobian = Mat3<S>;
    type Solver = Mat3<S>;
    fn linearize(&self, y: &[S; 3]) -> Mat3<S> {
        match self.0 {
            Linearization::Exact => {
                let variables: [Dual<S, 3>; 3] = [0, 1, 2].map(|i| Dual::variable(y[i], i));
                Mat3 { rows: curves(variables).map(|component| Vec3::from_slice(&component.tangent, 0)) }
            }
            Linearization::Zero => Mat3::diagonal(S::zero()),
            Linearization::Unrelated => {
                Mat3 { rows: [[-1.0, 0.5, 2.0], [0.3, -2.0, 1.0], [1.5, -0.7, 0.4]].map(Vec3::from_f64) }
            }
        }
    }
    fn factor(&self, jacobian: &Mat3<S>, g: S) -> Mat3<S> {
        (Mat3::diagonal(S::one()) + jacobian.scale(-g)).inverse()
    }
    fn solve(&self, solver: &Mat3<S>, b: &[S; 3]) -> [S; 3] {
        (*solver * Vec3::from_slice(b, 0)).array()
    }
}

/// y after `count` steps of equal length up to time `end`, from the exact start at time 0.
pub fn in_equal_steps<M: Method<Curves, f64, 3>>(
    method: &M,
    problem: &Curves,
    end: f64,
    count: usize,
) -> [f64; 3] {
    let mut y = curves_at(0.0);
    let mut rate = problem.rhs(&y);
    for _ in 0..count {
        let attempt = method.attempt(problem, &y, &rate, end / count as f64);
        (y, rate) = (attempt.y, attempt.rate);
    }
    y
}

/// Largest difference of two states.
pub fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Runs until the first state component reaches `end`, and keeps the steps that each lane took.
pub struct Until<S: Scalar, const N: usize> {
    /// Where to stop.
    pub end: S,
    /// State after the last accepted step of each lane.
    pub last: [S; N],
    /// Time of that state.
    pub time: S,
    /// Length of every step that was observed, with the lanes that took it.
    pub steps: Vec<(S, S::Mask)>,
}

impl<S: Scalar, const N: usize> Until<S, N> {
    pub fn new(end: S, start: [S; N]) -> Self {
        Self { end, last: start, time: S::zero(), steps: Vec::new() }
    }
    /// Steps taken by one lane.
    pub fn count(&self, lane: usize) -> usize {
        self.steps.iter().filter(|(_, taken)| taken.lane(lane)).count()
    }
}

impl<S: Scalar, const N: usize> Observer<S, N> for Until<S, N> {
    fn observe(
        &mut self,
        accepted: S::Mask,
        time: S,
        h: S,
        _start: (&[S; N], &[S; N]),
        (y, _): (&[S; N], &[S; N]),
    ) -> S::Mask {
        for i in 0..N {
            self.last[i] = S::select(accepted, y[i], self.last[i]);
        }
        self.time = S::select(accepted, time + h, self.time);
        self.steps.push((h, accepted));
        y[0].ge(self.end)
    }
}
