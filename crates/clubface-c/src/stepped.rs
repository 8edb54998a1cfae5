//! Contacts for programs that move the bodies: forces from motion, and a ball that is moved through the contact.
//!
//! World axes: x to the target, y up, z to the right. A head is 18 numbers: the rotation from its axes to those of the world
//! row by row (the identity while the club stands at its static loft with a square face), the position of its CG (m), its
//! velocity (m/s) and its angular velocity (rad/s). A ball is 9: position of the centre, velocity and angular velocity.
//!
//! A contact or a ball may be used by one thread at a time.

use crate::result::{ClubfaceResult, Computed, Failure, compute};
use crate::rows::{numbers, numbers_out};
use crate::shots::model_from;
use clubface_impact::error::all_inputs;
use clubface_impact::impact_model::Tangents;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::multibody::{BODY, Body, HEAD, Head, HeadContact, MOTION, WRENCH, check_motion};
use clubface_impact::shot::INPUT_COUNT;
use clubface_impact::struck_ball::StruckBall;
use serde_json::json;
use std::ffi::c_char;
use std::ptr::null_mut;

/// Numbers of a head.
pub const CLUBFACE_HEAD: usize = HEAD;
/// Numbers of a ball.
pub const CLUBFACE_BALL: usize = BODY;
/// Numbers of what acts between head and ball: force on the ball, whose opposite acts on the head (N), torque on the ball
/// about its centre, torque on the head about its CG (N m), the point at which the force acts (m), each three; normal force
/// (N), penetration (m, negative when apart) and its rate (m/s).
pub const CLUBFACE_WRENCH: usize = WRENCH;
/// Numbers of motion that a wrench is differentiated by: position, small turn about the axes of the world (rad), velocity
/// and angular velocity of the head; position, velocity and angular velocity of the ball.
pub const CLUBFACE_MOTION: usize = MOTION;
/// Numbers of a step of a struck ball: mean force on the head (N) and mean torque on it about its CG (N m), each three,
/// normal force (N) and penetration (m) at the end.
pub const CLUBFACE_STEP: usize = 8;

/// A contact between a head and a ball that the caller moves. End it with [`clubface_contact_end`].
pub struct ClubfaceContact {
    contact: HeadContact<f64>,
    differentiated: HeadContact<Tangents>,
}

/// A ball that is moved through the contact with a head that the caller moves. End it with [`clubface_ball_end`].
pub struct ClubfaceStruckBall {
    ball: StruckBall,
}

/// Numbers of a caller, as many as an array has.
///
/// # Safety
/// `values` is null or holds `N` numbers.
unsafe fn array<'a, const N: usize>(values: *const f64, name: &str) -> Result<&'a [f64; N], Failure> {
    // SAFETY: the caller's promise.
    let values = unsafe { numbers(values, N, name) }?;
    values.try_into().map_err(|_| Failure::input(name, format!("{N} numbers are needed")))
}

/// Begins a contact of a model where head and ball are now, which should be at first touch.
///
/// `inputs` are a shot's, of which those of the delivery have no part; `parameters` are the model's. `contact` takes the
/// contact, null after an error. The text of the result lists the names of the internal states of the law, and the array
/// `internal` their values at first touch. States that belong to a face are in its axes: x along the normal at its centre, y
/// up, z towards the toe.
///
/// # Safety
/// The arrays hold as many numbers as stated; `model` ends with a null byte; `contact` may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_contact_begin(
    model: *const c_char,
    inputs: *const f64,
    parameters: *const f64,
    head: *const f64,
    ball: *const f64,
    contact: *mut *mut ClubfaceContact,
) -> *mut ClubfaceResult {
    compute(|| {
        if contact.is_null() {
            return Err(Failure::input("contact", "null; a place for the contact is needed"));
        }
        // SAFETY: the caller's promise.
        let (model, inputs, head, ball) = unsafe {
            *contact = null_mut();
            let inputs = numbers(inputs, INPUT_COUNT, "inputs")?;
            (model_from(model)?, all_inputs(inputs)?, array(head, "head")?, array(ball, "ball")?)
        };
        // SAFETY: the caller's promise.
        let parameters = unsafe { numbers(parameters, model.info().parameters.len(), "parameters") }?;
        let begun = ClubfaceContact {
            contact: HeadContact::begin(model, inputs, parameters, head, ball)?,
            differentiated: HeadContact::begin(model, inputs, parameters, head, ball)?,
        };
        let mut computed = Computed::from_json(&json!(begun.contact.names()))?;
        let initial = begun.contact.initial().to_vec();
        computed.add_numbers("internal", vec![initial.len()], initial);
        // SAFETY: the caller's promise.
        unsafe { *contact = Box::into_raw(Box::new(begun)) };
        Ok(computed)
    })
}

/// Computes what acts between head and ball: `wrench` takes [`CLUBFACE_WRENCH`] numbers, `rates` those of the internal
/// states. A function of its arguments alone, which are not checked.
///
/// # Safety
/// `contact` comes from [`clubface_contact_begin`] and has not been ended; the arrays hold as many numbers as stated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_contact_evaluate(
    contact: *const ClubfaceContact,
    head: *const f64,
    ball: *const f64,
    internal: *const f64,
    wrench: *mut f64,
    rates: *mut f64,
) {
    // SAFETY: the caller's promise.
    let (contact, head, ball) = unsafe { (&(*contact).contact, &*head.cast(), &*ball.cast::<[f64; BODY]>()) };
    let count = contact.initial().len();
    // SAFETY: the caller's promise.
    let (internal, wrench, rates) = unsafe {
        (
            std::slice::from_raw_parts(internal, count),
            std::slice::from_raw_parts_mut(wrench, WRENCH),
            std::slice::from_raw_parts_mut(rates, count),
        )
    };
    let acting = contact.evaluate(&Head::from_values(head), &Body::from_values(ball), internal, rates);
    wrench.copy_from_slice(&acting.values());
}

/// Computes the derivatives of what acts: `values` takes a row for each of the [`CLUBFACE_WRENCH`] numbers and then for each
/// rate of an internal state, with its value first and then its derivatives by the [`CLUBFACE_MOTION`] numbers of motion and
/// by the internal states.
///
/// # Safety
/// As of [`clubface_contact_evaluate`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_contact_jacobian(
    contact: *const ClubfaceContact,
    head: *const f64,
    ball: *const f64,
    internal: *const f64,
    values: *mut f64,
) {
    // SAFETY: the caller's promise.
    let (contact, head, ball) = unsafe { (&(*contact).differentiated, &*head.cast(), &*ball.cast()) };
    let count = contact.initial().len();
    // SAFETY: the caller's promise.
    let (internal, values) = unsafe {
        let size = (WRENCH + count) * (1 + MOTION + count);
        (std::slice::from_raw_parts(internal, count), std::slice::from_raw_parts_mut(values, size))
    };
    values.copy_from_slice(&contact.jacobian(head, ball, internal).concat());
}

/// Ends a step of the caller's integrator: brings what a law remembers (rings) up to date, in `internal`. The other states
/// are the caller's to integrate. To be called after every step that is accepted, with the motion at its end.
///
/// # Safety
/// As of [`clubface_contact_evaluate`]; `internal` may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_contact_commit(
    contact: *const ClubfaceContact,
    head: *const f64,
    ball: *const f64,
    internal: *mut f64,
) {
    // SAFETY: the caller's promise.
    let (contact, head, ball) = unsafe { (&(*contact).contact, &*head.cast(), &*ball.cast()) };
    // SAFETY: the caller's promise.
    let internal = unsafe { std::slice::from_raw_parts_mut(internal, contact.initial().len()) };
    contact.commit(&Head::from_values(head), &Body::from_values(ball), internal);
}

/// Ends a contact; null is allowed.
///
/// # Safety
/// `contact` comes from [`clubface_contact_begin`] and has not been ended.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_contact_end(contact: *mut ClubfaceContact) {
    if !contact.is_null() {
        // SAFETY: the caller's promise.
        drop(unsafe { Box::from_raw(contact) });
    }
}

/// Places a ball that a head will strike, for programs that exchange forces at steps of their own.
///
/// `gives_way`: 1 for a head that within a step gives way to the ball by the inertia of the inputs, as a body does; 0 for one
/// that moves as prescribed. `struck` takes the ball, null after an error. The rest as for [`clubface_contact_begin`].
///
/// # Safety
/// The arrays hold as many numbers as stated; `model` ends with a null byte; `struck` may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_ball_place(
    model: *const c_char,
    inputs: *const f64,
    parameters: *const f64,
    ball: *const f64,
    gives_way: bool,
    struck: *mut *mut ClubfaceStruckBall,
) -> *mut ClubfaceResult {
    compute(|| {
        if struck.is_null() {
            return Err(Failure::input("struck", "null; a place for the ball is needed"));
        }
        // SAFETY: the caller's promise.
        let (model, inputs, ball) = unsafe {
            *struck = null_mut();
            (model_from(model)?, all_inputs(numbers(inputs, INPUT_COUNT, "inputs")?)?, array(ball, "ball")?)
        };
        // SAFETY: the caller's promise.
        let parameters = unsafe { numbers(parameters, model.info().parameters.len(), "parameters") }?;
        let ball = StruckBall::new(model, inputs, parameters, ball, gives_way)?;
        // SAFETY: the caller's promise.
        unsafe { *struck = Box::into_raw(Box::new(ClubfaceStruckBall { ball })) };
        Ok(Computed::default())
    })
}

/// Moves a ball on by `duration` seconds while the head moves on from where it is now. `loads` takes [`CLUBFACE_STEP`]
/// numbers, to be applied to the head over the step, `ball` takes where the ball is then and how it moves.
///
/// # Safety
/// `struck` comes from [`clubface_ball_place`] and has not been ended; the arrays hold as many numbers as stated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_ball_advance(
    struck: *mut ClubfaceStruckBall,
    head: *const f64,
    duration: f64,
    loads: *mut f64,
    ball: *mut f64,
) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let (struck, head, loads, moved) = unsafe {
            (
                &mut (*struck).ball,
                array(head, "head")?,
                numbers_out(loads, CLUBFACE_STEP, "loads")?,
                numbers_out(ball, BODY, "ball")?,
            )
        };
        check_motion(head, &[0.0; BODY])?;
        let step = struck.advance(head, duration)?;
        step.force.put(loads, 0);
        step.torque.put(loads, 3);
        loads[6..].copy_from_slice(&[step.normal_force, step.depth]);
        moved.copy_from_slice(&struck.ball().values());
        Ok(Computed::default())
    })
}

/// Returns 0 while the head has not reached the ball, 1 while they touch, 2 once the ball has left the face.
///
/// # Safety
/// `struck` comes from [`clubface_ball_place`] and has not been ended.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_ball_phase(struck: *const ClubfaceStruckBall) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { &(*struck).ball }.phase() as i32
}

/// Writes the outputs of the impact once the ball has left the face, and says whether it has.
///
/// # Safety
/// `struck` comes from [`clubface_ball_place`] and has not been ended; `outputs` has room for those of the description.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_ball_launch(struck: *const ClubfaceStruckBall, outputs: *mut f64) -> bool {
    // SAFETY: the caller's promise.
    let Some(launch) = unsafe { &(*struck).ball }.launch() else { return false };
    // SAFETY: the caller's promise.
    unsafe { std::slice::from_raw_parts_mut(outputs, OUTPUT_COUNT) }.copy_from_slice(launch);
    true
}

/// Ends a struck ball; null is allowed.
///
/// # Safety
/// `struck` comes from [`clubface_ball_place`] and has not been ended.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_ball_end(struck: *mut ClubfaceStruckBall) {
    if !struck.is_null() {
        // SAFETY: the caller's promise.
        drop(unsafe { Box::from_raw(struck) });
    }
}
