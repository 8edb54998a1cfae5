//! Logarithms and powers of stretch tensors without principal axes, so that equal stretches need no special case and derivatives stay exact.
//!
//! A square root has the invariants of its square to tell its own, which Newton's method finds, and with them it is a rational function of
//! its square (Hoger and Carlson, Q. Appl. Math. 42, 1984). Roots bring the stretches near one, where series converge; by the theorem of
//! Cayley and Hamilton a series of tensors is one of three numbers.

use super::Symmetric;
use clubface_math::Scalar;

/// Newton steps for the invariants: enough for stretches from 0.13 to 7.6, and one more for derivatives.
const NEWTON: usize = 7;

/// Terms of the logarithm's series: 1e-12 at a stretch of 7.6, rounding up to 5.
const LOGARITHM: usize = 17;

/// Largest stretch for which powers are exact to rounding.
const STRETCH: f64 = 5.0;

/// The first two invariants of the square root of a positive tensor of determinant one, from those of the tensor.
#[inline(always)]
fn root_invariants<S: Scalar>([first, second]: [S; 2]) -> [S; 2] {
    // a^2 - 2 b = I and b^2 - 2 a = II, from above: the steps fall to the root for any stretch.
    let (mut a, mut b) = ((first * 3.0).sqrt(), (second * 3.0).sqrt());
    for _ in 0..NEWTON {
        let (f, g) = (a.mul_add(a, -(b + b)) - first, b.mul_add(b, -(a + a)) - second);
        let scale = (a.mul_add(b, -S::one()) * 2.0).recip();
        (a, b) = (a - b.mul_add(f, g) * scale, b - a.mul_add(g, f) * scale);
    }
    [a, b]
}

/// Polynomial of a tensor with the given invariants, coefficients from the highest power down.
#[inline(always)]
fn polynomial<S: Scalar, const N: usize>(
    x: &Symmetric<S>,
    [first, second, third]: [S; 3],
    coefficients: [f64; N],
) -> Symmetric<S> {
    // p0 + p1 x + p2 x^2 times x, with x^3 = I x^2 - II x + III.
    let mut p = [S::from_f64(coefficients[0]), S::zero(), S::zero()];
    for i in 1..N {
        p = [
            third.mul_add(p[2], S::from_f64(coefficients[i])),
            p[0] - second * p[2],
            first.mul_add(p[2], p[1]),
        ];
    }
    x.coaxial_product(x).scale(p[2]).plus(p[1], x).plus(S::one(), &Symmetric::diagonal(p[0]))
}

/// Natural logarithm of a positive tensor of determinant one.
#[inline(always)]
pub fn logarithm<S: Scalar>(c: &Symmetric<S>) -> Symmetric<S> {
    let one = Symmetric::diagonal(S::one());
    let invariants = c.invariants();
    let [a, b] = root_invariants([invariants[0], invariants[1]]);
    // The root u solves u^3 - a u^2 + b u - 1 = 0, and u^2 = c.
    let root = one.plus(a, c).coaxial_product(&c.plus(b, &one).inverse());
    let [a, b] = root_invariants([a, b]);
    // With v the root of that, z = (v - 1) (v + 1)^-1 and log c = 4 log v = 8 artanh z.
    let above = root.scale(a - 1.0).plus(-(b - 1.0), &one);
    let below = root.scale(a + 1.0).plus(b + 1.0, &one);
    let z = above.coaxial_product(&below.inverse());
    let square = z.coaxial_product(&z);
    let mut series = [0.0; LOGARITHM];
    for i in 0..LOGARITHM {
        series[i] = 8.0 / (2 * (LOGARITHM - 1 - i) + 1) as f64;
    }
    polynomial(&square, square.invariants(), series).coaxial_product(&z)
}

/// `exp(s x)` of a tensor without trace whose exponential has stretches up to [`STRETCH`] squared.
#[inline(always)]
pub fn exponential<S: Scalar>(x: &Symmetric<S>, s: S) -> Symmetric<S> {
    // Halved until no principal value exceeds 1/2.
    let largest = 2.0 * STRETCH.ln() * s.re().abs();
    let mut halvings = 0;
    while largest > 0.5 * f64::from(1_u32 << halvings) {
        halvings += 1;
    }
    let x = x.scale(s * (1.0 / f64::from(1_u32 << halvings)));
    // The first term left out is below 1e-15.
    let mut series = [1.0; 14];
    for i in (0..13).rev() {
        series[i] = series[i + 1] / (13 - i) as f64;
    }
    let mut power = polynomial(&x, x.invariants(), series);
    for _ in 0..halvings {
        power = power.coaxial_product(&power);
    }
    power
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A function of the tensor of determinant one that has two given stretches, about oblique axes.
    fn tensor(first: f64, second: f64, function: fn(f64) -> f64) -> Symmetric<f64> {
        let axes = [[2.0, -3.0, 6.0], [6.0, -2.0, -3.0], [3.0, 6.0, 2.0]].map(|v| v.map(|x: f64| x / 7.0));
        let mut sum = Symmetric::diagonal(0.0);
        for ([x, y, z], square) in
            axes.iter().zip([first * first, second * second, (first * second).powi(-2)])
        {
            sum = sum.plus(function(square), &Symmetric([x * x, y * y, z * z, x * y, x * z, y * z]));
        }
        sum
    }

    fn apart(a: &Symmetric<f64>, b: &Symmetric<f64>) -> f64 {
        a.0.iter().zip(b.0).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
    }

    #[test]
    fn logarithm_and_powers_of_stretches() {
        for (a, b) in
            [(1.0, 1.0), (1.0 + 1e-9, 1.0), (1.3, 1.3), (0.8, 1.1), (2.0, 0.4), (5.0, 1.0), (0.2, 2.2)]
        {
            let log = logarithm(&tensor(a, b, |v| v));
            // Rounding, of the largest stretch.
            let size = a.max(b).max(1.0 / (a * b)).powi(2);
            assert!(apart(&log, &tensor(a, b, f64::ln)) < 1e-14 * size, "{a} {b}");
            let (inverse, square) = (exponential(&log, -1.0), exponential(&log, 2.0));
            assert!(apart(&inverse, &tensor(a, b, f64::recip)) < 2e-14 * size * size, "{a} {b}");
            assert!(apart(&square, &tensor(a, b, |v| v * v)) < 2e-14 * size * size, "{a} {b}");
        }
    }
}
