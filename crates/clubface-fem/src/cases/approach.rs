//! What every hit needs: a face that approaches the ball.

use crate::error::FemError;
use clubface_impact::first_touch::FirstTouch;
use clubface_math::Real;

/// Refuses a head that moves away from the ball.
///
/// # Errors
/// [`FemError::Input`] with the speed of approach.
pub(super) fn check_approach<R: Real>(touch: &FirstTouch<R>) -> Result<(), FemError> {
    let approach = touch.approach().re();
    if approach > 0.0 {
        return Ok(());
    }
    let allowed = "it must be above 0, but the face moves away from the ball";
    Err(FemError::input("speed of approach", format!("{approach:.2} m/s"), allowed))
}
