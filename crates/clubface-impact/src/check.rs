//! Checks of one shot, before any physics: each fault names the input, its value and what is allowed.

use crate::club::Club;
use crate::description::ModelInfo;
use crate::error::ImpactError;
use crate::face_spring::{CHARACTERISTIC_TIMES, GUIDED_MASS};
use crate::fault::{angle_fault, fault, shown};
use crate::inertia_check::{ROUNDING, check_added_inertia, check_inertia};
use crate::quantity::quantity;
use crate::shot::{
    DELIVERY_COUNT, HIGHEST_SPEED, INPUT_COUNT, INPUTS, LARGEST, LARGEST_LOFT, LARGEST_RATE, LARGEST_SPIN,
    SMALLEST, Shot,
};
use clubface_math::{Mask, Scalar};
use core::f64::consts::FRAC_PI_2;

/// Checks the values of a shot, in the order of [`INPUTS`].
///
/// # Errors
/// The first fault found.
pub fn check(values: &[f64; INPUT_COUNT]) -> Result<(), ImpactError> {
    check_equipment(values)?;
    check_delivery(values)
}

/// Checks club and ball of a shot.
///
/// # Errors
/// The first fault found.
pub fn check_equipment(values: &[f64; INPUT_COUNT]) -> Result<(), ImpactError> {
    check_club(values)?;
    check_ball(values)
}

/// Checks the ball of a shot.
///
/// # Errors
/// The first fault found.
pub fn check_ball(values: &[f64; INPUT_COUNT]) -> Result<(), ImpactError> {
    check_finite(values, "ball")?;
    let shot = Shot::from_inputs(values);
    for (name, value) in [
        ("ball_mass", shot.ball.mass),
        ("ball_radius", shot.ball.radius),
        ("ball_inertia", shot.ball.inertia),
    ] {
        positive(name, value)?;
    }
    if shot.ball.inertia > 2.0 / 3.0 * shot.ball.mass * shot.ball.radius.powi(2) * ROUNDING {
        let allowed = "kg m2 must not exceed 2/3 m R^2, that of a thin shell";
        return Err(fault("ball_inertia", shot.ball.inertia, allowed));
    }
    Ok(())
}

fn check_finite(values: &[f64; INPUT_COUNT], group: &str) -> Result<(), ImpactError> {
    for (value, input) in values.iter().zip(&INPUTS) {
        let flat =
            (input.quantity.name == "bulge" || input.quantity.name == "roll") && *value == f64::INFINITY;
        if input.group != group || flat {
            continue;
        }
        if !value.is_finite() {
            return Err(fault(input.quantity.name, *value, "must be a finite number"));
        }
        if value.abs() > LARGEST {
            return Err(fault(input.quantity.name, *value, "must be within +-1e12; is the unit right?"));
        }
    }
    Ok(())
}

/// Checks the club of a shot.
///
/// # Errors
/// The first fault found.
pub fn check_club(values: &[f64; INPUT_COUNT]) -> Result<(), ImpactError> {
    check_finite(values, "club")?;
    check_finite(values, "parameters")?;
    check_finite(values, "attachment")?;
    let shot = Shot::from_inputs(values);
    let club = shot.club;
    positive("club_mass", club.mass)?;
    check_inertia(&club.inertia)?;
    if club.static_loft.abs() > LARGEST_LOFT {
        return Err(angle_fault("static_loft", club.static_loft, "must be within +-80 deg"));
    }
    for (name, value) in [
        ("bulge", club.bulge),
        ("roll", club.roll),
        ("face_width", club.face_width),
        ("face_height", club.face_height),
    ] {
        positive(name, value)?;
    }
    let corner = club.face().point(club.face_width / 2.0, club.face_height / 2.0);
    if !corner.x.is_finite() {
        let message = format!(
            "{} m with a roll of {} m does not reach the corners of the face outline, {} m x {} m; allowed: larger \
             radii or a smaller outline",
            shown(club.bulge),
            shown(club.roll),
            shown(club.face_width),
            shown(club.face_height)
        );
        return Err(ImpactError::new("bulge", message));
    }
    check_face_spring(&club, shot.included_time)?;
    check_added_inertia(&club)?;
    if club.hand.abs() != 1.0 {
        return Err(fault("hand", club.hand, "must be 1 (right-handed) or -1 (left-handed)"));
    }
    Ok(())
}

/// Checks the characteristic times of a club and of the face that parameters include: within the range of the spring,
/// and of a head heavy enough for the mass that its face moves with.
fn check_face_spring(club: &Club<f64>, included: f64) -> Result<(), ImpactError> {
    let time = club.characteristic_time;
    let [shortest, longest] = CHARACTERISTIC_TIMES;
    for (name, time) in [("characteristic_time", time), ("included_time", included)] {
        if time != 0.0 && !(shortest / ROUNDING..=longest * ROUNDING).contains(&time) {
            return Err(fault(name, time, "s must be 0 (a rigid face) or from 20e-6 to 600e-6 s"));
        }
    }
    if time == included {
        return Ok(());
    }
    // The head resists a push on its face least in a corner.
    let (face, lever, head) = (club.face(), club.lever(), club.head_inertia().mobility());
    let least = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(toe, high)| {
        let point = face.point(toe * club.face_width / 2.0, high * club.face_height / 2.0);
        head.along(lever + point, face.nearest(point).normal).recip()
    });
    let least = least.into_iter().fold(f64::INFINITY, f64::min);
    if least <= GUIDED_MASS {
        let allowed = format!(
            "s needs a heavier head or a smaller face: in a corner of this one the head acts like {:.1} g, and must \
             act like more than the {:.0} g that move with a face that gives; 0 is a rigid face",
            least * 1e3,
            GUIDED_MASS * 1e3
        );
        return Err(fault("characteristic_time", time, &allowed));
    }
    Ok(())
}

/// The lanes whose delivery [`check_delivery`] lets pass: packs of good shots need no look at each.
#[inline(always)]
pub fn good_delivery<S: Scalar>(values: &[S; INPUT_COUNT]) -> S::Mask {
    let Shot { delivery: d, club, .. } = Shot::from_inputs(values);
    let mut good = d.speed.ge(S::from_f64(SMALLEST)).and(d.speed.le(S::from_f64(HIGHEST_SPEED)));
    good = good.and(d.loft.abs().le(S::from_f64(LARGEST_LOFT)));
    for angle in [d.attack, d.path, d.face, d.lie] {
        good = good.and(angle.abs().lt(S::from_f64(FRAC_PI_2)));
    }
    for rate in [d.closure, d.pitch_rate, d.lie_rate] {
        good = good.and(rate.abs().le(S::from_f64(LARGEST_RATE)));
    }
    for spin in [d.ball_backspin, d.ball_sidespin, d.ball_riflespin] {
        good = good.and(spin.abs().le(S::from_f64(LARGEST_SPIN)));
    }
    good.and(d.toe.abs().le(club.face_width * 0.5)).and(d.high.abs().le(club.face_height * 0.5))
}

/// The lanes whose parameters [`check_parameters`] lets pass.
#[inline(always)]
pub fn good_parameters<S: Scalar>(info: &ModelInfo, values: &[S]) -> S::Mask {
    let mut good = S::Mask::splat(true);
    for (parameter, &value) in info.parameters.iter().zip(values) {
        good = good.and(value.ge(S::from_f64(parameter.lower))).and(value.le(S::from_f64(parameter.upper)));
    }
    good
}

/// Checks the delivery of a shot.
///
/// # Errors
/// The first fault found.
pub fn check_delivery(values: &[f64; INPUT_COUNT]) -> Result<(), ImpactError> {
    let Shot { delivery, club, .. } = Shot::from_inputs(values);
    if !values[..DELIVERY_COUNT].iter().all(|value| value.is_finite()) {
        check_finite(values, "delivery")?;
    }
    positive("speed", delivery.speed)?;
    if delivery.speed > HIGHEST_SPEED {
        return Err(fault("speed", delivery.speed, "must be at most 150 m/s; is the unit right?"));
    }
    if delivery.loft.abs() > LARGEST_LOFT {
        return Err(angle_fault("loft", delivery.loft, "dynamic loft must be within +-80 deg"));
    }
    for (name, value) in
        [("attack", delivery.attack), ("path", delivery.path), ("face", delivery.face), ("lie", delivery.lie)]
    {
        if value.abs() >= FRAC_PI_2 {
            return Err(angle_fault(name, value, "must be within +-90 deg"));
        }
    }
    for (name, value) in
        [("closure", delivery.closure), ("pitch_rate", delivery.pitch_rate), ("lie_rate", delivery.lie_rate)]
    {
        if value.abs() > LARGEST_RATE {
            return Err(fault(name, value, "must be within +-1000 rad/s; is the unit right?"));
        }
    }
    for (name, value) in [
        ("ball_backspin", delivery.ball_backspin),
        ("ball_sidespin", delivery.ball_sidespin),
        ("ball_riflespin", delivery.ball_riflespin),
    ] {
        if value.abs() > LARGEST_SPIN {
            return Err(fault(name, value, "must be within +-2000 rad/s (19099 rpm); is the unit right?"));
        }
    }
    let (width, height) = (club.face_width / 2.0, club.face_height / 2.0);
    for (name, value, limit) in [("toe", delivery.toe, width), ("high", delivery.high, height)] {
        if value.abs() > limit {
            let message = format!(
                "impact at {:.1} mm is outside the face outline; allowed: +-{:.1} mm",
                value * 1e3,
                limit * 1e3
            );
            return Err(ImpactError::new(name, message));
        }
    }
    Ok(())
}

/// Checks that the face approaches the ball: the normal speed at the impact point, m/s.
///
/// # Errors
/// A face that does not.
pub fn check_approach(approach: f64) -> Result<(), ImpactError> {
    if approach > 0.0 {
        return Ok(());
    }
    let message = format!(
        "the face moves away from the ball at the impact point (approach speed {approach:.3} m/s along the face \
         normal); allowed: above 0. Check attack angle, path, loft and face angle"
    );
    Err(ImpactError::new("speed", message))
}

/// A contact that did not end.
#[must_use]
pub fn unseparated() -> ImpactError {
    let message = "club and ball did not separate within the steps allowed, or the face is so much stiffer than the \
                   one that the parameters include that they tell nothing of this impact; check the model's \
                   stiffness and damping and the characteristic times, or set another accuracy";
    ImpactError::new("model", message)
}

/// Checks the parameter values of a model against its bounds.
///
/// # Errors
/// The first value outside its bounds.
pub fn check_parameters(info: &ModelInfo, values: &[f64]) -> Result<(), ImpactError> {
    for (parameter, &value) in info.parameters.iter().zip(values) {
        if !(parameter.lower..=parameter.upper).contains(&value) {
            let message = format!(
                "parameter of {} is {}; allowed: {} to {} {}",
                info.name,
                shown(value),
                parameter.lower,
                parameter.upper,
                parameter.unit
            );
            return Err(ImpactError::new(parameter.name, message));
        }
    }
    Ok(())
}

fn positive(name: &'static str, value: f64) -> Result<(), ImpactError> {
    if value >= SMALLEST {
        Ok(())
    } else if value > 0.0 {
        Err(fault(name, value, "must be at least 1e-12; is the unit right?"))
    } else {
        let unit = quantity(name).map_or("", |quantity| quantity.unit);
        Err(fault(name, value, &format!("must be above 0 {unit}")))
    }
}
