//! Launches of many shots, in packs as wide as the CPU has them.

use super::run::{MOST_PARAMETERS, Run};
use crate::check::{
    check_approach, check_delivery, check_equipment, check_parameters, good_delivery, good_parameters,
    unseparated,
};
use crate::columns::{Column, MOST_LANES, Reject, Shots, gather, gather_into};
use crate::contact::Unrecorded;
use crate::description::{FromValues, ModelInfo};
use crate::error::ImpactError;
use crate::first_touch::FirstTouch;
use crate::impact::Impact;
use crate::model::Describe;
use crate::shot::{DELIVERY_COUNT, INPUT_COUNT, with_free_head};
use clubface_math::pack::ONE_WIDTH;
use clubface_math::{Computation, Kernel, Lanes, Mask, Scalar, dispatch};
use core::marker::PhantomData;
use core::ops::Range;

/// Computes `rows` into `outputs`, one slice an output, each as long as `rows`.
pub fn launches<M: Describe>(shots: &Shots, rows: Range<usize>, outputs: &mut [&mut [f64]]) -> Vec<Reject> {
    // A pack costs more than one shot alone.
    let packs = M::INFO.lanes && (ONE_WIDTH || rows.len() > 1);
    let kernel = Launches { model: PhantomData::<M>, shots, rows, outputs };
    if packs { dispatch(kernel) } else { kernel.run::<f64>() }
}

struct Launches<'a, 'b, M> {
    model: PhantomData<M>,
    shots: &'a Shots<'a>,
    rows: Range<usize>,
    outputs: &'a mut [&'b mut [f64]],
}

impl<M: Describe> Kernel for Launches<'_, '_, M> {
    type Output = Vec<Reject>;

    #[inline(always)]
    fn run<S: Lanes>(self) -> Vec<Reject> {
        // Models whose shots must not differ within a pack are not even compiled for packs.
        if const { S::LANES == 1 || M::INFO.lanes } {
            let Self { shots, rows, outputs, .. } = self;
            let mut batch = InPacks::<S> {
                shots,
                info: const { &M::INFO },
                checks: Checks::new(shots, &M::INFO, rows.start),
                inputs: [S::zero(); INPUT_COUNT],
                parameters: [S::zero(); MOST_PARAMETERS],
                good: S::Mask::splat(true),
                faults: [const { None }; MOST_LANES],
                rejects: Vec::new(),
            };
            batch.read_fixed_parameters(rows.start);
            let count = M::INFO.parameters.len();
            let mut model = M::Over::<S>::from_values(&batch.parameters[..count]);
            for first in rows.clone().step_by(S::LANES) {
                let used = S::LANES.min(rows.end - first);
                let touch = S::outline(Prepare { batch: &mut batch, first, used });
                if batch.checks.parameters.is_none() {
                    model = M::Over::<S>::from_values(&batch.parameters[..count]);
                }
                let (model, touch, accuracy) = (&model, &touch, shots.accuracy);
                let impact = S::outline(Run { model, touch, accuracy, recorder: &mut Unrecorded });
                let place = first - rows.start;
                S::outline(Finish { batch: &mut batch, impact: &impact, first, used, place, outputs });
            }
            batch.rejects
        } else {
            unreachable!("this model takes one shot at a time")
        }
    }
}

/// Shots on their way through packs: what does not depend on the model.
struct InPacks<'a, S: Scalar> {
    shots: &'a Shots<'a>,
    info: &'static ModelInfo,
    checks: Checks,
    inputs: [S; INPUT_COUNT],
    parameters: [S; MOST_PARAMETERS],
    /// Lanes of the present pack in which nothing is wrong.
    good: S::Mask,
    faults: [Option<ImpactError>; MOST_LANES],
    rejects: Vec<Reject>,
}

impl<S: Lanes> InPacks<'_, S> {
    /// Reads parameters that are the same for all shots; those that are not good give way to the defaults.
    fn read_fixed_parameters(&mut self, row: usize) {
        if let Some(checked) = &self.checks.parameters {
            let mut values: [f64; MOST_PARAMETERS] = gather(self.shots.parameters, row, 1);
            if checked.is_err() {
                values[..self.info.parameters.len()].copy_from_slice(&self.info.defaults());
            }
            for (parameter, value) in self.parameters.iter_mut().zip(values) {
                *parameter = S::from_f64(value);
            }
        }
    }
}

/// Reads and checks the shots of one pack.
struct Prepare<'a, 'b, S: Scalar> {
    batch: &'a mut InPacks<'b, S>,
    first: usize,
    used: usize,
}

impl<S: Lanes> Computation for Prepare<'_, '_, S> {
    type Output = FirstTouch<S>;
    #[inline(always)]
    fn run(self) -> FirstTouch<S> {
        let Self { batch, first, used } = self;
        let InPacks { shots, info, checks, inputs, parameters, good, faults, .. } = batch;
        *inputs = gather(shots.inputs, first, used);
        let varied = checks.parameters.is_none();
        if varied {
            gather_into(parameters, shots.parameters, first, used);
        }
        let touch = FirstTouch::from_inputs(inputs);
        let approach = touch.approach();
        *good = checks.good(inputs, info, parameters).and(approach.gt(S::zero()));
        if good.all() {
            return touch;
        }
        for lane in 0..used {
            let row = checks.row(shots, info, first + lane);
            faults[lane] = row.and_then(|()| check_approach(approach.lane(lane))).err();
        }
        if faults.iter().all(Option::is_none) {
            return touch;
        }
        // A lane that cannot be computed takes a harmless shot, so that it does not hold up its pack.
        let bad = |lane: usize| faults[lane.min(used - 1)].is_some();
        replace(inputs, &HARMLESS, bad);
        if varied {
            replace(parameters, &info.defaults(), bad);
        }
        FirstTouch::from_inputs(inputs)
    }
}

/// Writes the launches of one pack and says which shots were not computed.
struct Finish<'a, 'b, 'c, S: Scalar> {
    batch: &'a mut InPacks<'b, S>,
    impact: &'a Impact<S>,
    first: usize,
    used: usize,
    /// Place of the first shot in the outputs.
    place: usize,
    outputs: &'a mut [&'c mut [f64]],
}

impl<S: Lanes> Computation for Finish<'_, '_, '_, S> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self { batch, impact, first, used, place, outputs } = self;
        for (output, value) in outputs.iter_mut().zip(&impact.launch.outputs()) {
            if used == S::LANES {
                value.store(&mut output[place..]);
            } else {
                for lane in 0..used {
                    output[place + lane] = value.lane(lane);
                }
            }
        }
        if batch.good.and(impact.separated).all() {
            return;
        }
        for lane in 0..used {
            let fault = batch.faults[lane].take();
            let unseparated = (!impact.separated.lane(lane)).then(unseparated);
            if let Some(error) = fault.or(unseparated) {
                batch.rejects.push(Reject { row: first + lane, error });
                for output in outputs.iter_mut() {
                    output[place + lane] = f64::NAN;
                }
            }
        }
    }
}

/// Puts `other` in the place of the values of some lanes.
fn replace<S: Lanes, const N: usize>(values: &mut [S; N], other: &[f64], lane_is: impl Fn(usize) -> bool) {
    for (value, &other) in values.iter_mut().zip(other) {
        *value = S::from_fn(|lane| if lane_is(lane) { other } else { value.lane(lane) });
    }
}

/// What is known of the rows of a batch: the equipment that was last found good, since it hardly ever varies, and
/// whether parameters that do not vary are good.
struct Checks {
    equipment: Option<[f64; INPUT_COUNT]>,
    parameters: Option<Result<(), ImpactError>>,
}

impl Checks {
    fn new(shots: &Shots, info: &ModelInfo, row: usize) -> Self {
        let fixed = shots.parameters.iter().all(|column| matches!(column, Column::Constant(_)));
        Self { equipment: None, parameters: fixed.then(|| parameters_of(shots, info, row)) }
    }

    /// The lanes that need no further check.
    #[inline(always)]
    fn good<S: Scalar>(&mut self, inputs: &[S; INPUT_COUNT], info: &ModelInfo, parameters: &[S]) -> S::Mask {
        let mut good = good_delivery(inputs);
        if self.equipment.is_none() {
            let mut values = [0.0; INPUT_COUNT];
            for (value, input) in values.iter_mut().zip(inputs) {
                *value = input.re();
            }
            self.equipment = check_equipment(&values).is_ok().then_some(values);
        }
        let Some(equipment) = &self.equipment else { return S::Mask::splat(false) };
        for i in DELIVERY_COUNT..INPUT_COUNT {
            let known = S::from_f64(equipment[i]);
            good = good.and(inputs[i].le(known)).and(inputs[i].ge(known));
        }
        match &self.parameters {
            Some(Ok(())) => good,
            Some(Err(_)) => S::Mask::splat(false),
            None => good.and(good_parameters(info, parameters)),
        }
    }

    fn row(&self, shots: &Shots, info: &ModelInfo, row: usize) -> Result<(), ImpactError> {
        let inputs = gather(shots.inputs, row, 1);
        check_equipment(&inputs)?;
        check_delivery(&inputs)?;
        self.parameters.clone().unwrap_or_else(|| parameters_of(shots, info, row))
    }
}

fn parameters_of(shots: &Shots, info: &ModelInfo, row: usize) -> Result<(), ImpactError> {
    let parameters: [f64; MOST_PARAMETERS] = gather(shots.parameters, row, 1);
    check_parameters(info, &parameters[..info.parameters.len()])
}

/// A plain central impact, in the order of [`INPUTS`](crate::shot::INPUTS).
#[rustfmt::skip]
const HARMLESS: [f64; INPUT_COUNT] = with_free_head(&[
    40.0, 0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.2, 0.04, 0.0, 0.0, 3e-4, 5e-4, 4e-4, 0.0, 0.0, 0.0, 0.2, 0.3, 0.3, 0.1, 0.05, 0.0, 1.0,
    0.0459, 0.0213, 8.336e-6, 0.0,
]);
