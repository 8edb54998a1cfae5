//! Exact derivatives of a flight with respect to every input, by dual numbers through the same code.

use super::check::{check, never_lands};
use super::shot::{FlightShot, INPUT_COUNT, OUTPUT_COUNT, fly};
use super::trajectory::TOLERANCE;
use crate::error::ImpactError;
use clubface_math::pack::ONE_WIDTH;
use clubface_math::{Dual, Kernel, Lanes, Mask, Scalar, dispatch};

/// Outputs of one shot and their derivatives.
#[derive(Clone, Debug)]
pub struct FlightSensitivity {
    /// Values in the order of [`super::OUTPUTS`].
    pub values: [f64; OUTPUT_COUNT],
    /// Derivative of output i with respect to input j, in SI units.
    pub jacobian: [[f64; INPUT_COUNT]; OUTPUT_COUNT],
}

/// Outputs of one shot with their exact derivatives with respect to every input.
///
/// They go through the landing exactly. Where one has a kink (a held spin parameter, a ball that begins to
/// slide as it bounces), it has the derivative of the side the shot is on.
///
/// # Errors
/// An input that is not allowed, or a ball that does not come down.
pub fn sensitivity(inputs: &[f64; INPUT_COUNT]) -> Result<FlightSensitivity, ImpactError> {
    check(inputs)?;
    dispatch(Directions(inputs)).ok_or_else(never_lands)
}

struct Directions<'a>(&'a [f64; INPUT_COUNT]);

/// Derivatives a lane carries: with eight lanes one pass takes all inputs. In browsers more passes, of less code.
const WIDTH: usize = if ONE_WIDTH { 1 } else { 3 };

impl Kernel for Directions<'_> {
    type Output = Option<FlightSensitivity>;

    /// All lanes hold the same shot; lane l of tangent i is the derivative by input i * lanes + l of the pass.
    #[inline(always)]
    fn run<S: Lanes>(self) -> Self::Output {
        let mut values = [0.0; OUTPUT_COUNT];
        let mut jacobian = [[0.0; INPUT_COUNT]; OUTPUT_COUNT];
        let pass = S::LANES * WIDTH;
        for first in (0..INPUT_COUNT).step_by(pass) {
            let mut inputs = [Dual::<S, WIDTH>::zero(); INPUT_COUNT];
            for (index, input) in inputs.iter_mut().enumerate() {
                *input = Dual::from_f64(self.0[index]);
                for i in 0..WIDTH {
                    let here = |lane: usize| index == first + i * S::LANES + lane;
                    input.tangent[i] = S::from_fn(|lane| f64::from(u8::from(here(lane))));
                }
            }
            let flown = fly(&FlightShot::from_inputs(&inputs), TOLERANCE);
            if !flown.landing.landed.all() {
                return None;
            }
            for (output, value) in flown.outputs().into_iter().enumerate() {
                values[output] = value.re();
                for index in first..INPUT_COUNT.min(first + pass) {
                    let place = index - first;
                    jacobian[output][index] = value.tangent[place / S::LANES].lane(place % S::LANES);
                }
            }
        }
        Some(FlightSensitivity { values, jacobian })
    }
}
