//! Whether the inputs of a flight make sense.

use super::shot::{FlightInput, INPUT_COUNT, INPUTS};
use crate::error::ImpactError;
use crate::fault::shown;
use clubface_math::{Mask, Scalar};

/// First input of a shot that is not allowed.
///
/// # Errors
/// Names the input, its value and what is allowed.
pub fn check(inputs: &[f64; INPUT_COUNT]) -> Result<(), ImpactError> {
    for (input, &value) in INPUTS.iter().zip(inputs) {
        check_range(input, value)?;
    }
    let [mass, radius, inertia, vx, vy, vz, ..] = *inputs;
    let largest = 2.0 / 3.0 * mass * radius.powi(2);
    if inertia > largest {
        return Err(ImpactError::new(
            "ball_inertia",
            format!(
                "{} kg m2 is more than {largest:.4e}, that of a hollow shell of this mass and radius; \
                 check the units",
                shown(inertia)
            ),
        ));
    }
    if vx == 0.0 && vy == 0.0 && vz == 0.0 {
        let message = "the ball does not move: give it a launch velocity other than (0, 0, 0) m/s";
        return Err(ImpactError::new("velocity_x", message));
    }
    Ok(())
}

/// Lanes in which nothing is wrong: the rules of [`check`] for a whole pack.
#[inline(always)]
pub(super) fn good<S: Scalar>(inputs: &[S; INPUT_COUNT]) -> S::Mask {
    let [mass, radius, inertia, vx, vy, vz, ..] = *inputs;
    let moves = vx.abs().max(vy.abs()).max(vz.abs()).gt(S::zero());
    let mut good = moves.and(inertia.le(mass * (2.0 / 3.0) * radius.squared()));
    for i in 0..INPUT_COUNT {
        let bounds = INPUTS[i].bounds;
        good = good.and(inputs[i].ge(S::from_f64(bounds.lower))).and(inputs[i].le(S::from_f64(bounds.upper)));
    }
    good
}

fn check_range(input: &FlightInput, value: f64) -> Result<(), ImpactError> {
    let (lower, upper) = (input.bounds.lower, input.bounds.upper);
    if input.bounds.contains(value) {
        return Ok(());
    }
    let unit = if input.quantity.unit == "1" { String::new() } else { format!(" {}", input.quantity.unit) };
    let message = if value.is_nan() {
        format!("is not a number; allowed is {lower} to {upper}{unit}")
    } else {
        format!("{}{unit} is not allowed; allowed is {lower} to {upper}{unit}", shown(value))
    };
    Err(ImpactError::new(input.quantity.name, message))
}

/// Error of a ball that is still in the air when the integration gives up.
pub(super) fn never_lands() -> ImpactError {
    let message = "the ball does not come down: the air rises too fast for it; reduce the vertical wind";
    ImpactError::new("wind_y", message)
}
