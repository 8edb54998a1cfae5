//! Calls of a function of C with plain numbers, and with numbers that carry derivatives.

use super::function::{OwnFunction, RESULTS, SHAPES};
use clubface_math::Dual;

/// Points of one call, in rows as [`super::function::LawFunction`] has them.
#[derive(Clone, Debug, Default)]
pub struct Points<R> {
    /// How many.
    pub count: usize,
    /// `C̄`.
    pub shapes: Vec<R>,
    /// State variables.
    pub states: Vec<R>,
    /// Stress and energies.
    pub results: Vec<R>,
}

impl<R: Copy> Points<R> {
    /// Room for some points.
    pub fn resize(&mut self, count: usize, states: usize, zero: R) {
        self.count = count;
        self.shapes.resize(SHAPES * count, zero);
        self.states.resize(states * count, zero);
        self.results.resize(RESULTS * count, zero);
    }
}

impl Points<f64> {
    /// Calls a function.
    pub fn call(&mut self, function: &OwnFunction, constants: &[f64], step: f64) {
        let Self { count, shapes, states, results } = self;
        assert!(
            constants.len() == function.constants.len() && states.len() == function.states.len() * *count
        );
        assert!(shapes.len() == SHAPES * *count && results.len() == RESULTS * *count);
        // What it does not write is no number, so that a run stops; heat need not be written.
        let (written, heat) = results.split_at_mut((RESULTS - 1) * *count);
        written.fill(f64::NAN);
        heat.fill(0.0);
        // SAFETY: arrays of the lengths that the function reads and writes, as whoever registered it promised.
        unsafe {
            (function.function)(
                *count,
                shapes.as_ptr(),
                constants.as_ptr(),
                step,
                states.as_mut_ptr(),
                results.as_mut_ptr(),
            );
        }
    }
}

/// Weights of central differences of the fourth order, over 12.
const DIFFERENCES: [(f64, f64); 4] = [(1.0, 8.0), (-1.0, -8.0), (2.0, -1.0), (-2.0, 1.0)];
/// Their step, as a part of what varies: truncation and rounding are both about 1e-12.
const STEP: f64 = 1e-3;

/// How much of a number is its natural size.
fn size(value: f64) -> f64 {
    if value == 0.0 { 1.0 } else { value.abs() }
}

impl<const N: usize> Points<Dual<f64, N>> {
    /// Calls a function, and again in the directions of the derivatives, which are differences.
    pub fn call(&mut self, function: &OwnFunction, constants: &[Dual<f64, N>], step: f64) {
        let value = |numbers: &[Dual<f64, N>]| numbers.iter().map(|each| each.value).collect::<Vec<_>>();
        let mut plain = Points {
            count: self.count,
            shapes: value(&self.shapes),
            states: value(&self.states),
            results: vec![0.0; self.results.len()],
        };
        plain.call(function, &value(constants), step);
        let mut slopes = [(); N].map(|()| [vec![0.0; self.results.len()], vec![0.0; self.states.len()]]);
        for (direction, [of_results, of_states]) in slopes.iter_mut().enumerate() {
            let tangent = |each: &Dual<f64, N>| each.tangent[direction];
            let fastest = self
                .shapes
                .iter()
                .map(|each| tangent(each).abs())
                .chain(
                    constants.iter().chain(&self.states).map(|each| tangent(each).abs() / size(each.value)),
                )
                .fold(0.0, f64::max);
            if fastest == 0.0 || !fastest.is_finite() {
                continue;
            }
            let width = STEP / fastest;
            for (steps, weight) in DIFFERENCES {
                let moved = |numbers: &[Dual<f64, N>]| -> Vec<f64> {
                    numbers.iter().map(|each| each.value + steps * width * tangent(each)).collect()
                };
                let mut there = Points {
                    count: self.count,
                    shapes: moved(&self.shapes),
                    states: moved(&self.states),
                    results: vec![0.0; self.results.len()],
                };
                there.call(function, &moved(constants), step);
                for (slopes, values) in [(&mut *of_results, &there.results), (&mut *of_states, &there.states)]
                {
                    for (slope, value) in slopes.iter_mut().zip(values) {
                        *slope += weight / (12.0 * width) * value;
                    }
                }
            }
        }
        for (place, (result, value)) in self.results.iter_mut().zip(&plain.results).enumerate() {
            *result = Dual { value: *value, tangent: std::array::from_fn(|d| slopes[d][0][place]) };
        }
        for (place, (state, value)) in self.states.iter_mut().zip(&plain.states).enumerate() {
            *state = Dual { value: *value, tangent: std::array::from_fn(|d| slopes[d][1][place]) };
        }
    }
}
