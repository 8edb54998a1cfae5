//! Cost of derivatives: a launch with four of them beside the launch alone, the ball called "modern" against a rigid
//! driver.
//!
//! `cargo bench -p clubface-fem --bench derivatives`: the least CPU time of some runs in turn, on one thread, and
//! the least time of a step, which is what the machine does when nobody else uses it.

#![allow(missing_docs)]

use clubface_fem::ball::{BallConstruction, BallPiece};
use clubface_fem::cases::{ball_against_plane, ball_against_rigid_head};
use clubface_fem::element::{Element, Kernels};
use clubface_fem::environment::Environment;
use clubface_fem::material::{law_from_name, map_law, Material, Maxwell};
use clubface_fem::sensitivity::Setting;
use clubface_fem::solve::{Options, Simulation};
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::shot::{Shot, INPUT_COUNT};
use clubface_math::Dual;
use std::time::{Duration, Instant};

/// Runs of which the quickest counts.
const RUNS: usize = 3;
/// Steps at a time.
const MARCH: usize = 8;
const FRICTION: f64 = 0.2;
/// Speed 45 m/s, loft 0.2 rad, the club called "driver", the ball called "modern".
const INPUTS: [f64; INPUT_COUNT] = [
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
];
/// What is differentiated by: the delivery, constants of materials, and the shape of the mesh.
const VARIABLES: [[&str; 4]; 3] = [
    ["speed", "loft", "friction", "characteristic_time"],
    ["core.c10", "core.maxwell.0.modulus", "cover.shear", "cover.density"],
    ["speed", "core.c10", "core.radius", "cover.radius"],
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
    let mut least = Duration::MAX;
    for _ in 0..(0.3e-3 / step) as usize / MARCH {
        let start = Instant::now();
        structure.integrate(contact.as_mut(), step, MARCH, &mut |_, _| true);
        least = least.min(start.elapsed());
    }
    least.as_secs_f64() * 1e6 / MARCH as f64
}

/// Time that the processor spent on something, s: others may use it meanwhile.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    extern "C" {
        fn clock() -> std::ffi::c_long;
    }
    // SAFETY: a function of the C library without arguments. It counts microseconds on every POSIX system.
    let now = || unsafe { clock() } as f64 * 1e-6;
    let start = now();
    let found = work();
    (now() - start, found)
}

fn main() {
    let options = Options { until_separation: true, ..Options::default() };
    let environment = Environment::single_threaded();
    let plain_run = || {
        let touch = FirstTouch::of(&Shot::from_inputs(&INPUTS));
        let mut simulation =
            ball_against_rigid_head(&ball(), &touch, FRICTION, &environment).expect("a shot");
        let found = simulation.run(&options, &mut |_| true).expect("the options are valid");
        touch.launch(found.ball, found.head).outputs()[0]
    };
    let setting = Setting { ball: ball(), head: None, inputs: INPUTS, friction: FRICTION };
    let mut plain = f64::INFINITY;
    let mut derived = [f64::INFINITY; VARIABLES.len()];
    let mut found = vec![String::new(); VARIABLES.len()];
    let only = std::env::args().skip(1).find_map(|given| given.parse::<usize>().ok());
    for _ in 0..RUNS {
        for (which, names) in VARIABLES.iter().enumerate() {
            if only.is_some_and(|only| only != which) {
                continue;
            }
            let (time, speed) = timed(plain_run);
            plain = plain.min(time);
            let directions = names.map(|name| vec![(name.to_owned(), 1.0)]);
            let run = || setting.sensitivity(&directions, &options, &environment, &mut |_, _| true);
            let (time, launch) = timed(run);
            let launch = launch.expect("the variables are known");
            derived[which] = derived[which].min(time);
            found[which] =
                format!("{speed:.12} {:.12} m/s, by them {:.8?}", launch.values[0], launch.jacobian[0]);
        }
    }
    println!("a launch: {plain:.3} s");
    for (which, names) in VARIABLES.iter().enumerate() {
        println!(
            "by {names:?}: {:.3} s, {:.2} launches; {}",
            derived[which],
            derived[which] / plain,
            found[which]
        );
    }
    let plain = least_step(|value| value, 45.0);
    let derived = least_step(Dual::<f64, 4>::constant, Dual::variable(45.0, 0));
    println!("a step: {plain:.1} us, with derivatives {derived:.1} us, {:.2} steps", derived / plain);
}
