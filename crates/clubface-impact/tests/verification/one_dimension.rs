//! The exact motion of a mass that a force U'(x) (1 + d xdot) stops and throws back, by quadrature.
//!
//! Dividing m v dv = -U'(x)(1 + d v) dx by 1 + d v: the stiffness enters through U alone, both ways,
//! m (d v - ln(1 + d v))/d^2 + U(x) = constant. On the way out v is negative.

/// A force law with its potential.
pub struct Stop<F, U> {
    /// Force without damping, N, at penetration x, m.
    pub force: F,
    /// Its integral from 0, J.
    pub potential: U,
    /// Damping d, s/m.
    pub damping: f64,
    /// Mass, kg.
    pub mass: f64,
    /// Speed of arrival, m/s.
    pub speed: f64,
}

/// What happens.
#[derive(Clone, Copy, Debug)]
pub struct Bounce {
    /// Speed of leaving over speed of arrival.
    pub restitution: f64,
    /// Time from touch to release, s.
    pub duration: f64,
    /// Greatest penetration, m.
    pub depth: f64,
    /// Largest force, N.
    pub peak_force: f64,
}

/// Root of a function that grows from negative to positive.
fn bisect(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if function(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

impl<F: Fn(f64) -> f64, U: Fn(f64) -> f64> Stop<F, U> {
    /// m (d v - ln(1 + d v))/d^2, which is m v^2/2 without damping; its series where the difference cancels.
    fn kinetic(&self, v: f64) -> f64 {
        let z = self.damping * v;
        if z.abs() > 0.02 {
            self.mass * (z - z.ln_1p()) / self.damping.powi(2)
        } else {
            let series = (0..10).rev().fold(0.0, |sum, k| 1.0 / f64::from(k + 2) - z * sum);
            self.mass * v * v * series
        }
    }

    /// Speed at penetration x on the way in (`side` 1) or out (-1), m/s.
    fn speed_at(&self, x: f64, side: f64) -> f64 {
        let left = self.kinetic(self.speed) - (self.potential)(x);
        bisect(|speed| self.kinetic(side * speed) - left, 0.0, self.speed)
    }

    pub fn bounce(&self) -> Bounce {
        let depth = bisect(|x| (self.potential)(x) - self.kinetic(self.speed), 0.0, 0.02);
        // x = depth (1 - s^2) takes the root singularity of 1/v at the turning point away; midpoints avoid s = 0.
        let count = 4000;
        let (mut duration, mut peak_force) = (0.0, 0.0f64);
        for i in 0..count {
            let s = (f64::from(i) + 0.5) / f64::from(count);
            let x = depth * (1.0 - s * s);
            for side in [1.0, -1.0] {
                let speed = self.speed_at(x, side);
                duration += 2.0 * depth * s / speed / f64::from(count);
                peak_force = peak_force.max((self.force)(x) * (1.0 + self.damping * side * speed));
            }
        }
        Bounce { restitution: self.speed_at(0.0, -1.0) / self.speed, duration, depth, peak_force }
    }
}
