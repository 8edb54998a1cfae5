//! FMI 3.0 for co-simulation.

use crate::fmi2::{ERROR, OK, c_text, path_of, refused};
use crate::unit::{Outcome, Unit};
use std::ffi::{CStr, c_char, c_void};

type Logger = unsafe extern "C" fn(*mut c_void, i32, *const c_char, *const c_char);

/// One instance and where it writes its messages.
struct Instance {
    unit: Unit,
    logger: Option<Logger>,
    environment: *mut c_void,
    start_time: f64,
}

unsafe fn log(logger: Option<Logger>, environment: *mut c_void, message: &str) {
    if let Some(logger) = logger {
        // SAFETY: the master's function.
        unsafe { logger(environment, ERROR, c"logStatusError".as_ptr(), c_text(message).as_ptr()) };
    }
}

/// Runs an operation of an instance; an error goes to the master's log.
unsafe fn with(instance: *mut c_void, work: impl FnOnce(&mut Instance) -> Outcome<()>) -> i32 {
    if instance.is_null() {
        return ERROR;
    }
    // SAFETY: the master passes what it was given.
    let instance = unsafe { &mut *instance.cast::<Instance>() };
    match work(instance) {
        Ok(()) => OK,
        Err(message) => {
            // SAFETY: as above.
            unsafe { log(instance.logger, instance.environment, &message) };
            ERROR
        }
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    _: *mut c_void,
    _: bool,
    _: usize,
    _: *const *const c_char,
) -> i32 {
    OK
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    _token: *const c_char,
    resources: *const c_char,
    _visible: bool,
    _logging: bool,
    _event_mode: bool,
    _early_return: bool,
    _intermediate: *const u32,
    _intermediate_count: usize,
    environment: *mut c_void,
    logger: Option<Logger>,
    _intermediate_update: *const c_void,
) -> *mut c_void {
    if resources.is_null() {
        return std::ptr::null_mut();
    }
    // SAFETY: the master's argument; a path, which some masters write as a URI as version 2 has it.
    let resources = unsafe { CStr::from_ptr(resources) }.to_string_lossy();
    let folder = if resources.starts_with("file:") { path_of(&resources) } else { resources.as_ref().into() };
    match Unit::from_resources(&folder) {
        Ok(unit) => Box::into_raw(Box::new(Instance { unit, logger, environment, start_time: 0.0 })).cast(),
        Err(message) => {
            // SAFETY: the master's function.
            unsafe { log(logger, environment, &message) };
            std::ptr::null_mut()
        }
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateModelExchange() -> *mut c_void {
    std::ptr::null_mut()
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateScheduledExecution() -> *mut c_void {
    std::ptr::null_mut()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: *mut c_void) {
    if !instance.is_null() {
        // SAFETY: the master passes what it was given.
        drop(unsafe { Box::from_raw(instance.cast::<Instance>()) });
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    instance: *mut c_void,
    _has_tolerance: bool,
    _tolerance: f64,
    start_time: f64,
    _has_stop_time: bool,
    _stop_time: f64,
) -> i32 {
    // SAFETY: the master's arguments, here and below.
    unsafe {
        with(instance, |i| {
            i.start_time = start_time;
            Ok(())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ExitInitializationMode(instance: *mut c_void) -> i32 {
    unsafe { with(instance, |i| i.unit.begin(i.start_time)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Terminate(instance: *mut c_void) -> i32 {
    unsafe { with(instance, |_| Ok(())) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(instance: *mut c_void) -> i32 {
    unsafe { with(instance, |i| i.unit.reset()) }
}

/// Declares how values of one kind are read and written; every variable is a scalar.
macro_rules! values {
    ($get:ident $set:ident $kind:ty, $from:expr, $into:expr) => {
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            instance: *mut c_void,
            references: *const u32,
            count: usize,
            values: *mut $kind,
            room: usize,
        ) -> i32 {
            unsafe {
                with(instance, |i| {
                    for each in 0..count.min(room) {
                        *values.add(each) = $into(i.unit.get(*references.add(each))?);
                    }
                    Ok(())
                })
            }
        }

        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(
            instance: *mut c_void,
            references: *const u32,
            count: usize,
            values: *const $kind,
            given: usize,
        ) -> i32 {
            unsafe {
                with(instance, |i| {
                    (0..count.min(given))
                        .try_for_each(|each| i.unit.set(*references.add(each), $from(*values.add(each))))
                })
            }
        }
    };
}

values!(fmi3GetFloat64 fmi3SetFloat64 f64, |v| v, |v| v);
values!(fmi3GetInt32 fmi3SetInt32 i32, f64::from, |v: f64| v as i32);
values!(fmi3GetBoolean fmi3SetBoolean bool, |v| f64::from(u8::from(v)), |v: f64| v != 0.0);

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    instance: *mut c_void,
    _time: f64,
    duration: f64,
    _no_state_before: bool,
    event_needed: *mut bool,
    terminate: *mut bool,
    early_return: *mut bool,
    last_time: *mut f64,
) -> i32 {
    unsafe {
        with(instance, |i| {
            let done = i.unit.step(duration);
            for flag in [event_needed, terminate, early_return] {
                if let Some(flag) = flag.as_mut() {
                    *flag = false;
                }
            }
            if let Some(last) = last_time.as_mut() {
                *last = i.unit.time();
            }
            done
        })
    }
}

refused! {
    fmi3EnterEventMode fmi3EnterStepMode fmi3EnterConfigurationMode fmi3ExitConfigurationMode fmi3GetFloat32 fmi3SetFloat32
    fmi3GetInt8 fmi3SetInt8 fmi3GetUInt8 fmi3SetUInt8 fmi3GetInt16 fmi3SetInt16 fmi3GetUInt16 fmi3SetUInt16 fmi3GetUInt32
    fmi3SetUInt32 fmi3GetInt64 fmi3SetInt64 fmi3GetUInt64 fmi3SetUInt64 fmi3GetString fmi3SetString fmi3GetBinary
    fmi3SetBinary fmi3GetClock fmi3SetClock fmi3GetNumberOfVariableDependencies fmi3GetVariableDependencies
    fmi3GetFMUState fmi3SetFMUState fmi3FreeFMUState fmi3SerializedFMUStateSize fmi3SerializeFMUState
    fmi3DeserializeFMUState fmi3GetDirectionalDerivative fmi3GetAdjointDerivative fmi3GetIntervalDecimal
    fmi3GetIntervalFraction fmi3GetShiftDecimal fmi3GetShiftFraction fmi3SetIntervalDecimal fmi3SetIntervalFraction
    fmi3SetShiftDecimal fmi3SetShiftFraction fmi3EvaluateDiscreteStates fmi3UpdateDiscreteStates
    fmi3EnterContinuousTimeMode fmi3CompletedIntegratorStep fmi3SetTime fmi3SetContinuousStates
    fmi3GetContinuousStateDerivatives fmi3GetEventIndicators fmi3GetContinuousStates fmi3GetNominalsOfContinuousStates
    fmi3GetNumberOfEventIndicators fmi3GetNumberOfContinuousStates fmi3GetOutputDerivatives fmi3ActivateModelPartition
}
