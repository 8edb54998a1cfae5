//! Points through the thickness of a shell: rules for integrals from -1 to 1 (Abramowitz and Stegun, sections 25.4.29
//! and 25.4.32).

use crate::error::FemError;

/// Most points.
pub const MAX_POINTS: usize = 31;

/// Points through the thickness of a metal that yields, by default.
pub const DEFAULT_POINTS: usize = 5;

/// Where stress is evaluated through the thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Gauss': the most accurate for their number; none on the surfaces.
    Gauss(usize),
    /// Lobatto's: two of them on the surfaces, where bending makes a wall yield first.
    Lobatto(usize),
}

impl Default for Rule {
    fn default() -> Self {
        Self::Gauss(DEFAULT_POINTS)
    }
}

impl Rule {
    /// The rule called `name` ("gauss" or "lobatto") with a number of points.
    ///
    /// # Errors
    /// [`FemError::Input`] for an unknown name or a number that is not allowed.
    pub fn from_name(name: &str, points: usize) -> Result<Self, FemError> {
        let (rule, least) = match name {
            "gauss" => (Self::Gauss(points), 2),
            "lobatto" => (Self::Lobatto(points), 3),
            _ => return Err(FemError::unknown("rule", name, ["gauss", "lobatto"])),
        };
        if (least..=MAX_POINTS).contains(&points) {
            return Ok(rule);
        }
        // Fewer would not resist bending, or too much.
        let allowed = format!("{name} takes {least} to {MAX_POINTS} points through the thickness");
        Err(FemError::input("points", points, allowed))
    }

    /// Places from -1 to 1 and weights, whose sum is 2.
    #[must_use]
    pub fn points(self) -> Vec<(f64, f64)> {
        match self {
            Self::Gauss(n) => {
                let weight = |x: f64| 2.0 / ((1.0 - x * x) * legendre(n, x)[1].powi(2));
                (0..n).map(|i| root(n, guess(n, i), |p| p[0] / p[1])).map(|x| (x, weight(x))).collect()
            }
            Self::Lobatto(n) => {
                let size = 2.0 / (n * (n - 1)) as f64;
                let weight = |x: f64| size / legendre(n - 1, x)[0].powi(2);
                // Inside at the zeros of the slope of the polynomial of one degree less, between its own.
                let middle = |i: usize| 0.5 * (guess(n - 1, i) + guess(n - 1, i + 1));
                let inner = (0..n - 2).map(|i| root(n - 1, middle(i), |p| p[1] / p[2]));
                std::iter::once(-1.0).chain(inner).chain([1.0]).map(|x| (x, weight(x))).collect()
            }
        }
    }
}

/// Near the zero number `i` of Legendre's polynomial of degree n, counted from below.
fn guess(n: usize, i: usize) -> f64 {
    -(std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos()
}

/// Legendre's polynomial and its first two derivatives, |x| < 1; at the ends the value alone.
fn legendre(n: usize, x: f64) -> [f64; 3] {
    let (mut before, mut p) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
    }
    let n = n as f64;
    let slope = n * (x * p - before) / (x * x - 1.0);
    [p, slope, (2.0 * x * slope - n * (n + 1.0) * p) / (1.0 - x * x)]
}

/// A zero near `x` by Newton's steps.
fn root(n: usize, mut x: f64, step: fn([f64; 3]) -> f64) -> f64 {
    for _ in 0..20 {
        x -= step(legendre(n, x));
    }
    // The one in the middle to the last bit.
    if x.abs() < 1e-15 { 0.0 } else { x }
}
