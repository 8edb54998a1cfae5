//! Exact derivatives of a launch with respect to every input and parameter, by dual numbers through the same code.

use crate::batch::MOST_PARAMETERS;
use crate::check::{check, check_approach, check_parameters, unseparated};
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::history::Unrecorded;
use crate::launch::OUTPUT_COUNT;
use crate::model::Accuracy;
use crate::registry::ModelKind;
use crate::shot::INPUT_COUNT;
use clubface_math::lanes::{dispatch, Kernel, Lanes};
use clubface_math::{Dual, Mask, Scalar};

/// A launch and its derivatives.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// Outputs, in their order.
    pub values: [f64; OUTPUT_COUNT],
    /// One row an output: derivatives by the requested variables.
    pub jacobian: Vec<Vec<f64>>,
}

/// Derivatives of a launch by the chosen `variables`: indices into the inputs followed by the model's parameters.
///
/// # Errors
/// A faulty input, a club that moves away from the ball, or a contact that does not end.
pub fn sensitivity(
    model: ModelKind,
    inputs: &[f64; INPUT_COUNT],
    parameters: &[f64],
    variables: &[usize],
    accuracy: Accuracy,
) -> Result<Sensitivity, ImpactError> {
    check(inputs)?;
    check_parameters(model.info(), parameters)?;
    dispatch(Directions { model, inputs, parameters, variables, accuracy })
}

struct Directions<'a> {
    model: ModelKind,
    inputs: &'a [f64; INPUT_COUNT],
    parameters: &'a [f64],
    variables: &'a [usize],
    accuracy: Accuracy,
}

/// Derivatives a lane carries: with eight lanes one pass takes 8 variables.
const WIDTH: usize = 1;

impl Kernel for Directions<'_> {
    type Output = Result<Sensitivity, ImpactError>;

    /// All lanes hold the same shot; lane l of tangent i is the derivative by variable i * lanes + l of the pass.
    #[inline(always)]
    fn run<S: Lanes>(self) -> Self::Output {
        let mut values = [f64::NAN; OUTPUT_COUNT];
        let mut jacobian = vec![Vec::new(); OUTPUT_COUNT];
        let pass = S::LANES * WIDTH;
        for start in (0..self.variables.len().max(1)).step_by(pass) {
            let chosen = &self.variables[start.min(self.variables.len())..];
            let chosen = &chosen[..chosen.len().min(pass)];
            let seed = |index: usize, value: f64| {
                let mut dual: Dual<S, WIDTH> = Dual::from_f64(value);
                for i in 0..WIDTH {
                    let hit = |lane: usize| chosen.get(i * S::LANES + lane) == Some(&index);
                    dual.tangent[i] = S::from_fn(|lane| f64::from(u8::from(hit(lane))));
                }
                dual
            };
            let mut inputs = [Dual::<S, WIDTH>::zero(); INPUT_COUNT];
            for i in 0..INPUT_COUNT {
                inputs[i] = seed(i, self.inputs[i]);
            }
            let mut parameters = [Dual::<S, WIDTH>::zero(); MOST_PARAMETERS];
            for i in 0..self.parameters.len() {
                parameters[i] = seed(INPUT_COUNT + i, self.parameters[i]);
            }
            let touch = FirstTouch::of_inputs(&inputs);
            check_approach(touch.approach().re())?;
            let parameters = &parameters[..self.parameters.len()];
            let impact = self.model.impact(&touch, parameters, self.accuracy, &mut Unrecorded);
            if !impact.separated.all() {
                return Err(unseparated());
            }
            for (output, value) in impact.launch.outputs().iter().enumerate() {
                values[output] = value.re();
                for i in 0..chosen.len() {
                    jacobian[output].push(value.tangent[i / S::LANES].lane(i % S::LANES));
                }
            }
        }
        Ok(Sensitivity { values, jacobian })
    }
}
