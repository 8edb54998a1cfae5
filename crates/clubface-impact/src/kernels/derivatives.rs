//! One shot with exact derivatives, by dual numbers through the same code.

use super::run::{MOST_PARAMETERS, Run};
use crate::check::{check, check_approach, check_parameters, unseparated};
use crate::contact::Unrecorded;
use crate::description::FromValues;
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::impact::{Accuracy, Impact};
use crate::launch::OUTPUT_COUNT;
use crate::model::Describe;
use crate::shot::INPUT_COUNT;
use clubface_math::{Computation, Dual, Kernel, Lanes, Mask, Scalar, dispatch};
use core::marker::PhantomData;

/// A shot and what to differentiate it by.
#[derive(Clone, Copy, Debug)]
pub struct Differentiated<'a> {
    /// Inputs, in their order.
    pub inputs: &'a [f64; INPUT_COUNT],
    /// Parameters of the model, in their order.
    pub parameters: &'a [f64],
    /// Indices of the variables, into the inputs followed by the parameters.
    pub variables: &'a [usize],
    /// Accuracy of contact models.
    pub accuracy: Accuracy,
}

/// Outputs of a shot; their derivatives go into `jacobian`, outputs by variables.
///
/// # Errors
/// A faulty input, a club that moves away from the ball, or a contact that does not end.
pub fn derivatives<M: Describe>(
    shot: &Differentiated,
    jacobian: &mut [f64],
) -> Result<[f64; OUTPUT_COUNT], ImpactError> {
    check(shot.inputs)?;
    check_parameters(&M::INFO, shot.parameters)?;
    dispatch(Directions { model: PhantomData::<M>, shot, jacobian })
}

struct Directions<'a, M> {
    model: PhantomData<M>,
    shot: &'a Differentiated<'a>,
    jacobian: &'a mut [f64],
}

/// Derivatives a lane carries: with eight lanes one pass takes 8 variables.
const WIDTH: usize = 1;

impl<M: Describe> Kernel for Directions<'_, M> {
    type Output = Result<[f64; OUTPUT_COUNT], ImpactError>;

    /// All lanes hold the same shot; lane l of tangent i is the derivative by variable i * lanes + l of the pass.
    #[inline(always)]
    fn run<S: Lanes>(self) -> Self::Output {
        let Self { shot, jacobian, .. } = self;
        let mut values = [f64::NAN; OUTPUT_COUNT];
        let (count, pass) = (shot.variables.len(), S::LANES * WIDTH);
        let mut parameters = [Dual::<S, WIDTH>::zero(); MOST_PARAMETERS];
        let parameters = &mut parameters[..M::INFO.parameters.len()];
        for start in (0..count.max(1)).step_by(pass) {
            let chosen = start..count.min(start + pass);
            let touch = S::outline(Seed { shot, chosen: chosen.clone(), parameters });
            check_approach(touch.approach().re())?;
            let model = M::Over::<Dual<S, WIDTH>>::from_values(parameters);
            let (touch, accuracy) = (&touch, shot.accuracy);
            let impact = S::outline(Run { model: &model, touch, accuracy, recorder: &mut Unrecorded });
            if !impact.separated.all() {
                return Err(unseparated());
            }
            S::outline(Read { impact: &impact, chosen, values: &mut values, jacobian, count });
        }
        Ok(values)
    }
}

/// Sets the scene for the derivatives by the `chosen` of the variables.
struct Seed<'a, S: Scalar> {
    shot: &'a Differentiated<'a>,
    chosen: core::ops::Range<usize>,
    parameters: &'a mut [Dual<S, WIDTH>],
}

impl<S: Lanes> Computation for Seed<'_, S> {
    type Output = FirstTouch<Dual<S, WIDTH>>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let chosen = &self.shot.variables[self.chosen];
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
            inputs[i] = seed(i, self.shot.inputs[i]);
        }
        for i in 0..self.parameters.len() {
            self.parameters[i] = seed(INPUT_COUNT + i, self.shot.parameters[i]);
        }
        FirstTouch::from_inputs(&inputs)
    }
}

/// Reads the outputs and their derivatives by the `chosen` of `count` variables.
struct Read<'a, S: Scalar> {
    impact: &'a Impact<Dual<S, WIDTH>>,
    chosen: core::ops::Range<usize>,
    values: &'a mut [f64; OUTPUT_COUNT],
    jacobian: &'a mut [f64],
    count: usize,
}

impl<S: Lanes> Computation for Read<'_, S> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        for (output, value) in self.impact.launch.outputs().iter().enumerate() {
            self.values[output] = value.re();
            for i in 0..self.chosen.len() {
                self.jacobian[output * self.count + self.chosen.start + i] =
                    value.tangent[i / S::LANES].lane(i % S::LANES);
            }
        }
    }
}
