//! Finite elements: impacts of a described ball with a plane, a rigid or a meshed head.

use crate::result::{ClubfaceResult, Computed, Failure, compute, text_from};
use clubface_fem::FemError;
use clubface_fem::description::{BallDescription, CaseDescription, HeadDescription};
use clubface_fem::environment::Environment;
use clubface_fem::material::{OwnFunction, register_law};
use clubface_fem::solve::{ImpactRecord, Progress};
use clubface_math::{Mat3, Vec3};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::json;
use std::ffi::{c_char, c_void};

/// Called by a running simulation with the caller's pointer, the simulated time and the duration, s; `false` stops it.
pub type ClubfaceProgress = Option<extern "C" fn(context: *mut c_void, time: f64, duration: f64) -> bool>;

/// A law of a material's change of shape, called for `count` points at once and by several threads at a time. Rows of
/// `count` numbers, one of each point: `shapes`, the right Cauchy-Green tensor without its change of volume,
/// `J^(-2/3) F^T F`, in the rows xx, yy, zz, xy, xz, yz; `states`, the state variables, zero before any deformation, which
/// the function moves on by `step` seconds, in place; `results`, twice the derivative of the elastic energy by `shapes` (Pa)
/// in such rows, apart from any multiple of the inverse of `shapes`, then the elastic energy (J/m3), then the energy that
/// became heat so far (J/m3), zero unless written. `constants` are those of the material (SI).
pub type ClubfaceLaw = Option<
    unsafe extern "C" fn(
        count: usize,
        shapes: *const f64,
        constants: *const f64,
        step: f64,
        states: *mut f64,
        results: *mut f64,
    ),
>;

/// Constants and state variables of a law.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LawDescription {
    constants: Vec<String>,
    values: Vec<f64>,
    #[serde(default)]
    states: usize,
}

/// Makes a function a law that pieces name by `law`, in place of one of the same name. `description` has the names of its
/// `constants`, `values` of them (SI) to check it with, and its number of state variables, `states`, 0 if left out. The
/// text has its modulus of small strains, `shear` (Pa).
///
/// # Safety
/// The texts end with a null byte; `function` does what [`ClubfaceLaw`] says and is there as long as the program.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_fem_law(
    name: *const c_char,
    function: ClubfaceLaw,
    description: *const c_char,
) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let (name, law) =
            unsafe { (text_from(name, "name")?, described::<LawDescription>(description, "description")?) };
        let function = function.ok_or_else(|| Failure::input("function", "null; a function is needed"))?;
        // SAFETY: the caller's promise.
        let function = unsafe { OwnFunction::new(name, law.constants, law.states, function) }?;
        Computed::from_json(&json!({"shear": register_law(function, &law.values)?}))
    })
}

/// What a caller describes.
///
/// # Safety
/// `text` is null or ends with a null byte.
unsafe fn described<T: DeserializeOwned>(text: *const c_char, name: &str) -> Result<T, Failure> {
    // SAFETY: the caller's promise.
    let text = unsafe { text_from(text, name) }?;
    serde_json::from_str(text).map_err(|error| Failure::input(name, error.to_string()))
}

/// Simulates an impact. `case` describes ball, face, friction and run; see the documentation of the C interface.
///
/// The text has the summary (`peak_force`, `contact_time`, `f_prime`, ...), `launch` in the order of the outputs, `stopped`
/// (why there is no launch, or null), `nodes` of the ball and of all bodies, `steps`, `step`, `wall` (s). Arrays:
/// `contact.time` and other names over the steps, `motion...`, `energy...`, `patch...`, `frame_times`, `frames` (positions
/// by frame, node and axis, m), and if asked for `ball.stress`, `ball.strain`, `ball.plastic_strain`, `head.stress`, ...
/// A run that `progress` stops keeps what it has.
///
/// # Safety
/// `case` ends with a null byte; `progress` may be called with `context` during this call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_fem(
    case: *const c_char,
    progress: ClubfaceProgress,
    context: *mut c_void,
) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let case: CaseDescription = unsafe { described(case, "case") }?;
        let context = Context(context);
        simulate(&case, &mut |at| host::proceed(progress, &context, at))
    })
}

/// Meshes a ball about the origin, its pole of first contact along -x. Arrays: `nodes` by node and axis (m), `elements`
/// by element and corner (in binary order), `piece` of each element.
///
/// # Safety
/// `ball` ends with a null byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_fem_ball(ball: *const c_char) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let ball = unsafe { described::<BallDescription>(ball, "ball") }?.build()?;
        let meshed = ball.mesh(&Mat3::diagonal(1.0), Vec3::zero())?;
        let mut computed = Computed::from_json(&json!({
            "mass": meshed.mass, "inertia": meshed.inertia, "core_density": meshed.core_density,
            "radius": meshed.radius,
        }))?;
        let mesh = &meshed.mesh;
        computed.add_numbers(
            "nodes",
            vec![mesh.nodes.len(), 3],
            mesh.nodes.iter().flat_map(|p| p.array()).collect(),
        );
        computed.add_indices(
            "elements",
            vec![mesh.elements.len(), 8],
            mesh.elements.iter().copied().flatten().collect(),
        );
        computed.add_indices("piece", vec![mesh.layer.len()], mesh.layer.clone());
        Ok(computed)
    })
}

/// Weighs a head that deforms: `mass` (kg), `centre` (m), `inertia` (kg m2, rows), in the axes of its nodes; a driver is
/// meshed and tuned first. Arrays: `nodes` by node and axis (m), `face` by quadrilateral and corner.
///
/// # Safety
/// `head` ends with a null byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clubface_fem_head(head: *const c_char) -> *mut ClubfaceResult {
    compute(|| {
        // SAFETY: the caller's promise.
        let head = unsafe { described::<HeadDescription>(head, "head") }?.build()?;
        head.check()?;
        let weighed = head.mass_properties();
        let mut computed = Computed::from_json(&json!({
            "mass": weighed.mass, "centre": weighed.centre.array(),
            "inertia": weighed.inertia.rows.map(Vec3::array),
        }))?;
        let (nodes, (face, _)) = (head.nodes(), head.face());
        computed.add_numbers("nodes", vec![nodes.len(), 3], nodes.iter().flat_map(|p| p.array()).collect());
        computed.add_indices("face", vec![face.len(), 4], face.iter().copied().flatten().collect());
        Ok(computed)
    })
}

/// The caller's pointer, which goes to the progress function and nowhere else.
struct Context(*mut c_void);

// SAFETY: only the thread that leads a run reports progress, while the caller waits for it.
unsafe impl Send for Context {}
// SAFETY: as above.
unsafe impl Sync for Context {}

fn simulate(
    case: &CaseDescription,
    proceed: &mut (dyn FnMut(&Progress) -> bool + Send),
) -> Result<Computed, Failure> {
    let record = host::with_threads(case.run.threads, |environment| {
        let (mut simulation, touch) = case.simulation(environment)?;
        simulation.record(&case.run.options()?, case.run.recording(), touch.as_ref(), &mut |at| proceed(at))
    })??;
    report(record)
}

fn report(record: ImpactRecord) -> Result<Computed, Failure> {
    let summary = &record.summary;
    let mut computed = Computed::from_json(&json!({
        "peak_force": summary.peak_force, "peak_force_time": summary.peak_force_time,
        "contact_time": summary.contact_time, "tangential_max": summary.tangential_max,
        "tangential_min": summary.tangential_min, "reversal_time": summary.reversal_time,
        "spin_max": summary.spin_max, "contraction": summary.contraction,
        "contraction_time": summary.contraction_time, "f_prime": summary.f_prime, "f": summary.f,
        "energy_error": summary.energy_error, "launch": record.launch,
        "ball_velocity": record.ball.velocity.array(), "ball_spin": record.ball.spin.array(),
        "axes": record.axes.map(Vec3::array), "attitude": record.attitude.rows.map(Vec3::array),
        "nodes": [record.nodes.0, record.nodes.1], "steps": record.steps, "step": record.step,
        "safety": record.safety, "wall": record.wall, "over_edge": record.over_edge,
        "stopped": record.stopped.as_ref().map(FemError::to_string),
    }))?;
    computed.add_series("contact.", record.contact_series());
    computed.add_series("motion.", record.motion_series());
    computed.add_series("energy.", record.energy_series());
    computed.add_series("patch.", record.patch_series());
    let frames = record.frame_times.len();
    computed.add_numbers("frame_times", vec![frames], record.frame_times);
    computed.add_numbers("frames", vec![frames, record.nodes.1, 3], record.frames);
    for (body, field) in ["ball", "head"].into_iter().zip(record.fields) {
        let elements = field.plastic_strain.len() / frames.max(1);
        if elements > 0 {
            computed.add_singles(&format!("{body}.stress"), vec![frames, elements, 2, 6], field.stress);
            computed.add_singles(&format!("{body}.strain"), vec![frames, elements, 2, 6], field.strain);
            computed.add_singles(
                &format!("{body}.plastic_strain"),
                vec![frames, elements],
                field.plastic_strain,
            );
        }
    }
    Ok(computed)
}

/// Clock, threads and progress of an operating system.
#[cfg(feature = "threads")]
mod host {
    use super::{ClubfaceProgress, Context, Environment, Failure, Progress};
    use std::sync::Arc;

    pub(super) fn with_threads<T: Send>(
        threads: usize,
        work: impl FnOnce(&Environment) -> T + Send,
    ) -> Result<T, Failure> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = Arc::new(pool.map_err(|e| Failure::input("threads", e.to_string()))?);
        let environment = Environment::with_pool(&pool);
        Ok(pool.install(|| work(&environment)))
    }

    pub(super) fn proceed(progress: ClubfaceProgress, context: &Context, at: &Progress) -> bool {
        progress.is_none_or(|call| call(context.0, at.time, at.duration))
    }
}

/// Clock and progress of the host of a WebAssembly module, on the calling thread.
#[cfg(all(not(feature = "threads"), target_arch = "wasm32"))]
mod host {
    use super::{ClubfaceProgress, Context, Environment, Failure, Progress};
    use clubface_fem::environment::SingleThread;
    use std::sync::Arc;

    #[link(wasm_import_module = "clubface")]
    unsafe extern "C" {
        fn now() -> f64;
        fn progress(time: f64, duration: f64) -> u32;
    }

    pub(super) fn with_threads<T>(
        _threads: usize,
        work: impl FnOnce(&Environment) -> T,
    ) -> Result<T, Failure> {
        // SAFETY: the host provides the function.
        Ok(work(&Environment { clock: || unsafe { now() }, executor: Arc::new(SingleThread) }))
    }

    pub(super) fn proceed(call: ClubfaceProgress, context: &Context, at: &Progress) -> bool {
        // SAFETY: the host provides the function.
        let host = || unsafe { progress(at.time, at.duration) != 0 };
        call.map_or_else(host, |call| call(context.0, at.time, at.duration))
    }
}

/// The calling thread alone, without a clock.
#[cfg(all(not(feature = "threads"), not(target_arch = "wasm32")))]
mod host {
    use super::{ClubfaceProgress, Context, Environment, Failure, Progress};

    pub(super) fn with_threads<T>(
        _threads: usize,
        work: impl FnOnce(&Environment) -> T,
    ) -> Result<T, Failure> {
        Ok(work(&Environment::single_threaded()))
    }

    pub(super) fn proceed(progress: ClubfaceProgress, context: &Context, at: &Progress) -> bool {
        progress.is_none_or(|call| call(context.0, at.time, at.duration))
    }
}
