//! Logarithms and powers of stretches without principal axes, so that equal stretches need no special case and
//! derivatives stay exact.
//!
//! By the theorem of Cayley and Hamilton every function of a tensor is a combination of its first three powers: all
//! that is computed here are the three factors, from the tensor's invariants. The invariants of a
//! square root follow from those of its square by Newton's method, and with them it is a rational function of its square (Hoger
//! and Carlson, Q. Appl. Math. 42, 1984). Roots bring the stretches near one, where series converge.

use clubface_math::{Computation, Scalar};

/// Newton steps for the invariants: enough for stretches from 0.13 to 7.6, and one more for derivatives.
const NEWTON: usize = 7;
/// Terms of the logarithm's series: 1e-12 at a stretch of 7.6, rounding up to 5.
const LOGARITHM: usize = 17;
/// Largest stretch for which powers are exact to rounding.
const STRETCH: f64 = 5.0;

/// Factors of 1, x and x^2.
type Factors<S> = [S; 3];

/// A tensor x of determinant one, by its first two invariants.
#[derive(Clone, Copy, Debug)]
struct Ring<S> {
    first: S,
    second: S,
}

impl<S: Scalar> Ring<S> {
    /// Product of two combinations of powers.
    #[inline(always)]
    fn product(&self, a: &Factors<S>, b: &Factors<S>) -> Factors<S> {
        let third = a[1].mul_add(b[2], a[2] * b[1]);
        let fourth = a[2] * b[2];
        // x^3 = I x^2 - II x + 1, and once more for x^4 = I x^3 - II x^2 + x.
        let third = self.first.mul_add(fourth, third);
        [
            a[0].mul_add(b[0], third),
            a[0].mul_add(b[1], a[1].mul_add(b[0], fourth)) - self.second * third,
            a[0].mul_add(b[2], a[1].mul_add(b[1], a[2] * b[0])) + self.first * third - self.second * fourth,
        ]
    }
    #[inline(always)]
    fn trace(&self, a: &Factors<S>) -> S {
        let square = self.first.mul_add(self.first, -(self.second + self.second));
        a[2].mul_add(square, a[1].mul_add(self.first, a[0] * 3.0))
    }
    /// `(x + shift)^-1`.
    #[inline(always)]
    fn inverse_of_sum(&self, shift: S) -> Factors<S> {
        // The characteristic polynomial divided by x + shift.
        let linear = self.first + shift;
        let constant = shift.mul_add(linear, self.second);
        let scale = shift.mul_add(constant, S::one()).recip();
        [constant * scale, -(linear * scale), scale]
    }
    /// The square root's invariants.
    #[inline(always)]
    fn root(&self) -> Self {
        // a^2 - 2 b = I and b^2 - 2 a = II, from above: the steps fall to the root for any stretch.
        let (mut a, mut b) = ((self.first * 3.0).sqrt(), (self.second * 3.0).sqrt());
        for _ in 0..NEWTON {
            let (f, g) = (a.mul_add(a, -(b + b)) - self.first, b.mul_add(b, -(a + a)) - self.second);
            let scale = (a.mul_add(b, -S::one()) * 2.0).recip();
            (a, b) = (a - b.mul_add(f, g) * scale, b - a.mul_add(g, f) * scale);
        }
        Self { first: a, second: b }
    }
    /// A combination of powers of the square root (its invariants are given), as one of powers of x.
    #[inline(always)]
    fn of_root(&self, root: &Self, a: &Factors<S>) -> Factors<S> {
        // The root u solves u^3 - a u^2 + b u - 1 = 0, and u^2 = x: u = (a x + 1) (x + b)^-1.
        let above = [S::one(), root.first, S::zero()];
        let u = self.product(&above, &self.inverse_of_sum(root.second));
        [a[1].mul_add(u[0], a[0]), a[1].mul_add(u[1], a[2]), a[1] * u[2]]
    }
}

/// Polynomial of a tensor with the given invariants, coefficients from the highest power down, as a combination of
/// its first three powers.
#[inline(always)]
fn polynomial<S: Scalar, const N: usize>(
    [first, second, third]: [S; 3],
    coefficients: [f64; N],
) -> Factors<S> {
    let mut p = [S::from_f64(coefficients[0]), S::zero(), S::zero()];
    for i in 1..N {
        p = [
            third.mul_add(p[2], S::from_f64(coefficients[i])),
            p[0] - second * p[2],
            first.mul_add(p[2], p[1]),
        ];
    }
    p
}

/// `a + b x + c y`.
#[inline(always)]
fn combine<S: Scalar>([a, b, c]: Factors<S>, x: &Factors<S>, y: &Factors<S>) -> Factors<S> {
    [c.mul_add(y[0], b.mul_add(x[0], a)), c.mul_add(y[1], b * x[1]), c.mul_add(y[2], b * x[2])]
}

/// A function of a tensor, as a combination of powers of its fourth root.
#[derive(Clone, Copy, Debug)]
pub struct Function<S>(Factors<S>);

impl<S: Scalar> Function<S> {
    /// Nothing.
    #[inline(always)]
    pub fn zero() -> Self {
        Self([S::zero(); 3])
    }
    /// `s` times it.
    #[inline(always)]
    #[must_use]
    pub fn scale(self, s: S) -> Self {
        let [one, linear, square] = self.0;
        Self([one * s, linear * s, square * s])
    }
    /// With `s` times another.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, s: S, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self([b[0].mul_add(s, a[0]), b[1].mul_add(s, a[1]), b[2].mul_add(s, a[2])])
    }
}

/// A positive tensor of determinant one, its root and its fourth root.
#[derive(Clone, Copy, Debug)]
pub struct Stretches<S> {
    whole: Ring<S>,
    root: Ring<S>,
    fourth: Ring<S>,
}

impl<S: Scalar> Stretches<S> {
    /// By the first two invariants.
    #[inline(always)]
    pub fn new(first: S, second: S) -> Self {
        S::outline(Roots { whole: Ring { first, second } })
    }

    /// Natural logarithm.
    #[inline(always)]
    pub fn logarithm(&self) -> Function<S> {
        S::outline(Logarithm(self))
    }

    #[inline(always)]
    fn series_of_logarithm(&self) -> Function<S> {
        let Ring { first: p, second: q } = self.fourth;
        // With v the fourth root, z = (v - 1) (v + 1)^-1: log = 4 log v = 8 artanh z, a series of odd powers.
        // Invariants of z, and of its square.
        let scale = (p + q + 2.0).recip();
        let (first, second) = ((q - p) * scale, (-(p + q) + 6.0) * scale);
        let odd = first * first;
        let square = [odd - second * 2.0, second.mul_add(second, odd * 2.0), odd];
        let mut series = [0.0; LOGARITHM];
        for i in 0..LOGARITHM {
            series[i] = 8.0 / (2 * (LOGARITHM - 1 - i) + 1) as f64;
        }
        let factors = polynomial(square, series);
        let inverse = self.fourth.inverse_of_sum(S::one());
        let z = [-(inverse[0] * 2.0) + 1.0, -(inverse[1] * 2.0), -(inverse[2] * 2.0)];
        let y = self.fourth.product(&z, &z);
        let even = combine(factors, &y, &self.fourth.product(&y, &y));
        Function(self.fourth.product(&even, &z))
    }

    /// `exp(s x)` of a function x without trace whose exponential has stretches up to `STRETCH` squared.
    #[inline(always)]
    pub fn exponential(&self, x: &Function<S>, s: S) -> Function<S> {
        S::outline(Exponential { stretches: self, x, s })
    }

    #[inline(always)]
    fn series_of_exponential(&self, x: &Function<S>, s: S) -> Function<S> {
        // Halved until no principal value exceeds 1/2.
        let largest = 2.0 * STRETCH.ln() * s.re().abs();
        let mut halvings = 0;
        while largest > 0.5 * f64::from(1_u32 << halvings) {
            halvings += 1;
        }
        let s = s * (1.0 / f64::from(1_u32 << halvings));
        let x = [x.0[0] * s, x.0[1] * s, x.0[2] * s];
        let square = self.fourth.product(&x, &x);
        let third = self.fourth.trace(&self.fourth.product(&square, &x)) * (1.0 / 3.0);
        let invariants = [S::zero(), self.fourth.trace(&square) * -0.5, third];
        // The first term left out is below 1e-15.
        let mut series = [1.0; 14];
        for i in (0..13).rev() {
            series[i] = series[i + 1] / (13 - i) as f64;
        }
        let mut power = combine(polynomial(invariants, series), &x, &square);
        for _ in 0..halvings {
            power = self.fourth.product(&power, &power);
        }
        Function(power)
    }

    /// Trace.
    #[inline(always)]
    pub fn trace(&self, function: &Function<S>) -> S {
        self.fourth.trace(&function.0)
    }

    /// Trace of the square.
    #[inline(always)]
    pub fn square_trace(&self, function: &Function<S>) -> S {
        self.fourth.trace(&self.fourth.product(&function.0, &function.0))
    }

    /// Factors of the identity, the tensor and its square.
    #[inline(always)]
    pub fn factors(&self, function: &Function<S>) -> [S; 3] {
        S::outline(WholeFactors { stretches: self, function })
    }
}

// Functions of their own: every law has several of these computations, and takes minutes to compile with copies of
// them.

struct Roots<S> {
    whole: Ring<S>,
}

impl<S: Scalar> Computation for Roots<S> {
    type Output = Stretches<S>;
    #[inline(always)]
    fn run(self) -> Stretches<S> {
        let root = self.whole.root();
        Stretches { whole: self.whole, root, fourth: root.root() }
    }
}

struct Logarithm<'a, S>(&'a Stretches<S>);

impl<S: Scalar> Computation for Logarithm<'_, S> {
    type Output = Function<S>;
    #[inline(always)]
    fn run(self) -> Function<S> {
        self.0.series_of_logarithm()
    }
}

struct Exponential<'a, S> {
    stretches: &'a Stretches<S>,
    x: &'a Function<S>,
    s: S,
}

impl<S: Scalar> Computation for Exponential<'_, S> {
    type Output = Function<S>;
    #[inline(always)]
    fn run(self) -> Function<S> {
        self.stretches.series_of_exponential(self.x, self.s)
    }
}

struct WholeFactors<'a, S> {
    stretches: &'a Stretches<S>,
    function: &'a Function<S>,
}

impl<S: Scalar> Computation for WholeFactors<'_, S> {
    type Output = [S; 3];
    #[inline(always)]
    fn run(self) -> [S; 3] {
        let Stretches { whole, root, fourth } = self.stretches;
        whole.of_root(root, &root.of_root(fourth, &self.function.0))
    }
}
