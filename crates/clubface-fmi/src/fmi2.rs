//! FMI 2.0.4 for co-simulation.

use crate::unit::{Outcome, Unit};
use std::ffi::{CStr, CString, c_char, c_void};
use std::path::PathBuf;

/// Statuses, alike in both versions of the standard.
pub(crate) const OK: i32 = 0;
pub(crate) const ERROR: i32 = 3;
/// The kind of unit that a master asks for.
const CO_SIMULATION: i32 = 1;

type Logger = unsafe extern "C" fn(*mut c_void, *const c_char, i32, *const c_char, *const c_char, ...);

/// What a master lends.
#[repr(C)]
pub struct Fmi2CallbackFunctions {
    logger: Option<Logger>,
    allocate_memory: *const c_void,
    free_memory: *const c_void,
    step_finished: *const c_void,
    component_environment: *mut c_void,
}

/// One instance and where it writes its messages.
struct Component {
    unit: Unit,
    name: CString,
    logger: Option<Logger>,
    environment: *mut c_void,
    start_time: f64,
}

/// Text without null bytes.
pub(crate) fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', " ")).unwrap_or_default()
}

unsafe fn log(logger: Option<Logger>, environment: *mut c_void, name: &CStr, message: &str) {
    if let Some(logger) = logger {
        let message = c_text(message);
        // SAFETY: the master's function; the message is an argument of "%s".
        unsafe {
            logger(
                environment,
                name.as_ptr(),
                ERROR,
                c"logStatusError".as_ptr(),
                c"%s".as_ptr(),
                message.as_ptr(),
            );
        };
    }
}

/// Runs an operation of an instance; an error goes to the master's log.
unsafe fn with(component: *mut c_void, work: impl FnOnce(&mut Component) -> Outcome<()>) -> i32 {
    if component.is_null() {
        return ERROR;
    }
    // SAFETY: the master passes what it was given.
    let component = unsafe { &mut *component.cast::<Component>() };
    match work(component) {
        Ok(()) => OK,
        Err(message) => {
            // SAFETY: as above.
            unsafe { log(component.logger, component.environment, &component.name, &message) };
            ERROR
        }
    }
}

/// The path of a URI of a file.
pub(crate) fn path_of(uri: &str) -> PathBuf {
    let rest = uri.strip_prefix("file:").map_or(uri, |rest| {
        let local = rest.strip_prefix("//localhost").or_else(|| rest.strip_prefix("//")).unwrap_or(rest);
        // A drive of Windows: /C:/...
        if local.as_bytes().get(2) == Some(&b':') { local.trim_start_matches('/') } else { local }
    });
    let mut bytes = Vec::new();
    let mut left = rest.as_bytes();
    while let Some((&first, more)) = left.split_first() {
        let code = (first == b'%' && more.len() > 1)
            .then(|| std::str::from_utf8(&more[..2]).ok().and_then(|hex| u8::from_str_radix(hex, 16).ok()))
            .flatten();
        bytes.push(code.unwrap_or(first));
        left = if code.is_some() { &more[2..] } else { more };
    }
    PathBuf::from(String::from_utf8_lossy(&bytes).into_owned())
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    name: *const c_char,
    kind: i32,
    _guid: *const c_char,
    resources: *const c_char,
    functions: *const Fmi2CallbackFunctions,
    _visible: i32,
    _logging: i32,
) -> *mut c_void {
    if name.is_null() || resources.is_null() || functions.is_null() {
        return std::ptr::null_mut();
    }
    // SAFETY: the master's arguments.
    let (name, resources, functions) = unsafe {
        (CStr::from_ptr(name).to_owned(), CStr::from_ptr(resources).to_string_lossy(), &*functions)
    };
    let (logger, environment) = (functions.logger, functions.component_environment);
    let made = if kind == CO_SIMULATION {
        Unit::from_resources(&path_of(&resources))
    } else {
        Err("this unit is for co-simulation".into())
    };
    match made {
        Ok(unit) => {
            Box::into_raw(Box::new(Component { unit, name, logger, environment, start_time: 0.0 })).cast()
        }
        Err(message) => {
            // SAFETY: the master's function.
            unsafe { log(logger, environment, &name, &message) };
            std::ptr::null_mut()
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut c_void) {
    if !component.is_null() {
        // SAFETY: the master passes what it was given.
        drop(unsafe { Box::from_raw(component.cast::<Component>()) });
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    _: *mut c_void,
    _: i32,
    _: usize,
    _: *const *const c_char,
) -> i32 {
    OK
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    component: *mut c_void,
    _has_tolerance: i32,
    _tolerance: f64,
    start_time: f64,
    _has_stop_time: i32,
    _stop_time: f64,
) -> i32 {
    // SAFETY: the master's arguments, here and below.
    unsafe {
        with(component, |c| {
            c.start_time = start_time;
            Ok(())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterInitializationMode(component: *mut c_void) -> i32 {
    unsafe { with(component, |_| Ok(())) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2ExitInitializationMode(component: *mut c_void) -> i32 {
    unsafe { with(component, |c| c.unit.begin(c.start_time)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Terminate(component: *mut c_void) -> i32 {
    unsafe { with(component, |_| Ok(())) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Reset(component: *mut c_void) -> i32 {
    unsafe { with(component, |c| c.unit.reset()) }
}

/// Declares how values of one kind are read and written.
macro_rules! values {
    ($get:ident $set:ident $kind:ty, $from:expr, $into:expr) => {
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            component: *mut c_void,
            references: *const u32,
            count: usize,
            values: *mut $kind,
        ) -> i32 {
            unsafe {
                with(component, |c| {
                    for i in 0..count {
                        *values.add(i) = $into(c.unit.get(*references.add(i))?);
                    }
                    Ok(())
                })
            }
        }

        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(
            component: *mut c_void,
            references: *const u32,
            count: usize,
            values: *const $kind,
        ) -> i32 {
            unsafe {
                with(component, |c| {
                    (0..count).try_for_each(|i| c.unit.set(*references.add(i), $from(*values.add(i))))
                })
            }
        }
    };
}

values!(fmi2GetReal fmi2SetReal f64, |v| v, |v| v);
values!(fmi2GetInteger fmi2SetInteger i32, f64::from, |v: f64| v as i32);
values!(fmi2GetBoolean fmi2SetBoolean i32, f64::from, |v: f64| i32::from(v != 0.0));

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(component: *mut c_void, _time: f64, duration: f64, _final: i32) -> i32 {
    unsafe { with(component, |c| c.unit.step(duration)) }
}

/// Declares functions for what units may leave out; the description of the model says that this one does.
macro_rules! refused {
    ($($name:ident)+) => {
        $(
            #[unsafe(no_mangle)]
            pub extern "C" fn $name(_instance: *mut c_void) -> i32 {
                $crate::fmi2::ERROR
            }
        )+
    };
}
pub(crate) use refused;

refused! {
    fmi2GetString fmi2SetString fmi2GetFMUstate fmi2SetFMUstate fmi2FreeFMUstate fmi2SerializedFMUstateSize
    fmi2SerializeFMUstate fmi2DeSerializeFMUstate fmi2GetDirectionalDerivative fmi2SetRealInputDerivatives
    fmi2GetRealOutputDerivatives fmi2CancelStep fmi2GetStatus fmi2GetRealStatus fmi2GetIntegerStatus
    fmi2GetBooleanStatus fmi2GetStringStatus
}
