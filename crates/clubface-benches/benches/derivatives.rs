//! Cost of derivatives: a launch with four of them compared with the launch alone, the ball called "modern" against a
//! rigid driver.
//!
//! `cargo bench -p clubface-benches --bench derivatives`: the least CPU time of some runs in turn, on one thread, and
//! the least time of a step, which is what the machine does when nobody else uses it.

#![allow(missing_docs)]

use clubface_benches::least_time;
use clubface_fem::ball::{BallConstruction, BallPiece};
use clubface_fem::cases::{ball_against_deformable_head, ball_against_plane, ball_against_rigid_head};
use clubface_fem::element::{Element, Kernels};
use clubface_fem::environment::Environment;
use clubface_fem::head::{DeformableHead, Driver, ShellHead};
use clubface_fem::material::{Material, Maxwell, law_from_name, map_law};
use clubface_fem::sensitivity::ImpactSetup;
use clubface_fem::solve::{Options, Simulation};
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::shot::{INPUT_COUNT, Shot, with_free_head};
use clubface_math::Dual;

/// Runs of each kind.
const RUNS: usize = 5;
/// Steps at a time.
const MARCH: usize = 8;
const FRICTION: f64 = 0.2;
/// Speed 45 m/s, loft 0.2 rad, the club called "driver", the ball called "modern".
const INPUTS: [f64; INPUT_COUNT] = with_free_head(&[
    45.0,
    0.0,
    0.0,
    0.2,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.204,
    0.0408,
    0.0114,
    0.001,
    0.000_284_3,
    0.000_567_9,
    0.000_408_5,
    -7.33e-5,
    5.302e-5,
    5e-8,
    0.171_042_266_7,
    0.305,
    0.305,
    0.105,
    0.055,
    0.000_25,
    1.0,
    0.0456,
    0.02135,
    8.105_4e-6,
    0.0,
]);
/// What is differentiated by: the delivery, constants of materials, the shape of the mesh; with a rigid head, and with
/// one of shells, its walls and its metal.
const CASES: [(bool, [&str; 4]); 6] = [
    (false, ["speed", "loft", "friction", "characteristic_time"]),
    (false, ["core.c10", "core.maxwell.0.modulus", "cover.shear", "cover.density"]),
    (false, ["speed", "core.c10", "core.radius", "cover.radius"]),
    (true, ["head.face.thickness", "head.crown.thickness", "head.sole.thickness", "head.skirt.thickness"]),
    (true, ["head.face.thickness", "head.face.youngs", "head.face.poisson", "head.face.density"]),
    (true, ["speed", "loft", "core.radius", "head.face.thickness"]),
];

/// The ball called "modern".
fn ball() -> BallConstruction<f64> {
    let law =
        |name: &str, constants: &[f64]| law_from_name(name, constants).expect("the constants are allowed");
    let core = Material {
        law: law("mooney-rivlin", &[9.53e6, 0.5e6]),
        bulk: 996.313_333e6,
        maxwell: vec![Maxwell { modulus: 0.45, time: 86e-6 }],
        density: 0.0,
    };
    let cover = Material {
        law: law("linear", &[113.636_363e6]),
        bulk: 773.809_523e6,
        maxwell: vec![],
        density: 950.0,
    };
    let piece =
        |name: &str, radius, layers, material| BallPiece { name: name.into(), radius, layers, material };
    let pieces = vec![piece("core", 0.01955, 6, core), piece("cover", 0.02135, 3, cover)];
    BallConstruction { pieces, cube: 12, element: Element::OnePoint, mass: Some(0.0456) }
}

/// The same ball in another number.
fn lifted<R: Kernels>(number: impl Fn(f64) -> R) -> BallConstruction<R> {
    let BallConstruction { pieces, cube, element, mass } = ball();
    let piece = |piece: BallPiece<f64>| {
        let Material { law, bulk, maxwell, density } = piece.material;
        let branch = |b: &Maxwell<f64>| Maxwell { modulus: number(b.modulus), time: number(b.time) };
        let material = Material {
            law: map_law(&*law, &mut |_, value| number(value)),
            bulk: number(bulk),
            maxwell: maxwell.iter().map(branch).collect(),
            density: number(density),
        };
        BallPiece { name: piece.name, radius: number(piece.radius), layers: piece.layers, material }
    };
    BallConstruction { pieces: pieces.into_iter().map(piece).collect(), cube, element, mass }
}

/// The least time of a step of an impact with a plane, us.
fn least_step<R: Kernels>(number: impl Fn(f64) -> R, speed: R) -> f64 {
    let Simulation { mut structure, mut contact, .. } = ball_against_plane(
        &lifted(number),
        speed,
        R::from_f64(0.2),
        R::from_f64(FRICTION),
        &Environment::single_threaded(),
    )
    .expect("the ball can be thrown");
    let step = 0.75 * structure.stable_step(40);
    let least = least_time((0.3e-3 / step) as usize / MARCH, || {
        structure.integrate(contact.as_mut(), step, MARCH, &mut |_, _| true);
    });
    least * 1e6 / MARCH as f64
}

/// Time that the processor spent on something, s: others may use it meanwhile.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    unsafe extern "C" {
        fn clock() -> std::ffi::c_long;
    }
    // SAFETY: a function of the C library without arguments. It counts microseconds on every POSIX system.
    let now = || unsafe { clock() } as f64 * 1e-6;
    let start = now();
    let result = work();
    (now() - start, result)
}

/// The head of Roh and Lee.
fn shells() -> ShellHead<f64> {
    Driver::roh_and_lee().mesh().expect("Roh and Lee's head").head
}

/// A shot with the rigid head, or with a head of shells, whose mass properties are then those of the club.
fn setting(head: Option<ShellHead<f64>>) -> ImpactSetup {
    let mut inputs = INPUTS;
    if let Some(head) = &head {
        let result = head.mass_properties();
        let (centre, [r, s, t]) = (result.centre, result.inertia.rows);
        inputs[14..24].copy_from_slice(&[
            result.mass,
            -centre.x,
            -centre.y,
            -centre.z,
            r.x,
            s.y,
            t.z,
            r.y,
            r.z,
            s.z,
        ]);
        inputs[24] = head.loft;
        inputs[29] = 0.0;
    }
    ImpactSetup { ball: ball(), head, inputs, friction: FRICTION }
}

/// Ball speed of a shot, m/s, computed in plain numbers.
fn ball_speed(setting: &ImpactSetup, options: &Options, environment: &Environment) -> f64 {
    let ImpactSetup { ball, head, inputs, friction } = setting;
    let touch = FirstTouch::from_shot(&Shot::from_inputs(inputs));
    let simulation = match head {
        Some(head) => ball_against_deformable_head(head, ball, &touch, *friction, environment),
        None => ball_against_rigid_head(ball, &touch, *friction, environment),
    };
    let result = simulation.expect("a shot").run(options, &mut |_| true).expect("the options are valid");
    touch.launch(result.ball, result.head).outputs()[0]
}

/// The one in the middle.
fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

fn main() {
    let options = Options { until_separation: true, ..Options::default() };
    let environment = Environment::single_threaded();
    let only: Vec<usize> = std::env::args().skip(1).filter_map(|given| given.parse().ok()).collect();
    for (index, (deformable, names)) in CASES.iter().enumerate() {
        if !only.is_empty() && !only.contains(&index) {
            continue;
        }
        let setting = setting(deformable.then(shells));
        let directions = names.map(|name| vec![(name.to_owned(), 1.0)]);
        // In turn, so that what else the machine does slows down both alike.
        let (mut plain, mut derived, mut result) = (Vec::new(), Vec::new(), String::new());
        for _ in 0..RUNS {
            let (time, speed) = timed(|| ball_speed(&setting, &options, &environment));
            plain.push(time);
            let (time, launch) =
                timed(|| setting.sensitivity(&directions, &options, &environment, &mut |_, _| true));
            derived.push(time);
            let launch = launch.expect("the variables are known");
            result = format!("{speed:.12} {:.12} m/s, by them {:.8?}", launch.values[0], launch.jacobian[0]);
        }
        let ratios = plain.iter().zip(&derived).map(|(plain, derived)| derived / plain).collect();
        println!(
            "{} by {names:?}: {:.3} s, {:.3} s, {:.2} launches; {result}",
            if *deformable { "shells" } else { "rigid" },
            median(plain),
            median(derived),
            median(ratios),
        );
    }
    if !only.is_empty() {
        return;
    }
    let plain = least_step(|value| value, 45.0);
    let derived = least_step(Dual::<f64, 4>::constant, Dual::variable(45.0, 0));
    println!("a step: {plain:.1} us, with derivatives {derived:.1} us, {:.2} steps", derived / plain);
}
