//! Cost of the case of Roh and Lee as a whole, next to the launch it computes: their ball and head of shells, then the
//! same struck by a rigid head.
//!
//! `cargo bench -p clubface-benches --bench paper`: the least of some runs, which is what the machine does when nobody
//! else uses it; what a step is made of; the memory the process has taken; and two runs side by side against one.

#![allow(missing_docs)]

#[path = "../../clubface-fem/tests/fem/first_touch.rs"]
mod first_touch;

use clubface_benches::{bulk_modulus, least_time, thread_pool};
use clubface_fem::ball::{BallConstruction, BallPiece};
use clubface_fem::cases::{ball_against_deformable_head, ball_against_rigid_head};
use clubface_fem::element::Element;
use clubface_fem::environment::Environment;
use clubface_fem::head::Driver;
use clubface_fem::material::{Hencky, Material, Maxwell, MooneyRivlin};
use clubface_fem::mesh::DriverThickness;
use clubface_fem::solve::{Options, Simulation};
use std::time::Instant;

const RUNS: usize = 5;
const FRICTION: f64 = 0.3;

/// The ball called "paper".
fn ball() -> BallConstruction<f64> {
    let (c10, c01) = (6.44e6, 0.344e6);
    let core = Material {
        law: MooneyRivlin { c10, c01 }.law(),
        bulk: bulk_modulus(2.0 * (c10 + c01), 0.49),
        maxwell: vec![Maxwell { modulus: 5.07, time: 5.02e-6 }],
        density: 1150.0,
    };
    let shear = 200e6 / (2.0 * 1.45);
    let cover = Material {
        law: Hencky { shear }.law(),
        bulk: bulk_modulus(shear, 0.45),
        maxwell: vec![Maxwell { modulus: 4.25, time: 1.68e-6 }],
        density: 950.0,
    };
    let piece =
        |name: &str, radius, layers, material| BallPiece { name: name.into(), radius, layers, material };
    let pieces = vec![piece("core", 0.0196, 6, core), piece("cover", 0.0214, 3, cover)];
    BallConstruction { pieces, cube: 12, element: Element::OnePoint, mass: Some(0.046) }
}

/// Runs a case on some threads; returns the time of its loop, s, and its figures.
fn run(make: &(dyn Fn() -> Simulation<f64> + Sync), options: &Options, threads: usize) -> (f64, String) {
    let pool = thread_pool(threads);
    let mut impact = make();
    let result = pool.install(|| impact.run(options, &mut |_| true)).expect("the options are valid");
    assert!(result.stopped.is_none(), "{:?}", result.stopped);
    let (v, figures) = (result.ball.velocity, result.records.summary(impact.radius));
    let text = format!(
        "{} steps, {:.1} us each; ball {:.2} m/s, {:.0} rpm, {:.0} N, energies off by {:.0e}",
        result.steps,
        result.wall * 1e6 / result.steps as f64,
        v.norm(),
        result.ball.spin.norm() * 60.0 / std::f64::consts::TAU,
        figures.peak_force,
        figures.energy_error,
    );
    (result.wall, text)
}

/// The least of some.
fn least(mut time: impl FnMut() -> f64) -> f64 {
    (0..RUNS).map(|_| time()).fold(f64::INFINITY, f64::min)
}

/// Share of the contact in the steps about the peak of the force, on one thread.
fn contact_share(mut impact: Simulation<f64>) -> f64 {
    let pool = thread_pool(1);
    let options = Options { duration: 280e-6, ..Options::default() };
    let result = pool.install(|| impact.run(&options, &mut |_| true)).expect("the options are valid");
    let step = result.wall / result.steps as f64;
    let (structure, contact) = (&impact.structure, &mut impact.contact);
    let alone = least_time(RUNS, || {
        for _ in 0..100 {
            contact.assemble(&structure.positions, &structure.velocities, result.step);
        }
    });
    alone / 100.0 / step
}

fn main() {
    let mut driver = Driver::roh_and_lee();
    driver.thickness = DriverThickness { face_centre: 1.85e-3, face_edge: 1.75e-3, ..driver.thickness };
    let start = Instant::now();
    let head = driver.mesh().expect("Roh and Lee's head").head;
    println!("head meshed in {:.3} s", start.elapsed().as_secs_f64());
    let touch = first_touch::delivered(&head, 0.0, 0.0);
    let shells = || {
        ball_against_deformable_head(&head, &ball(), &touch, FRICTION, &Environment::native())
            .expect("Roh and Lee's case")
    };
    let rigid = || {
        ball_against_rigid_head(&ball(), &touch, FRICTION, &Environment::native())
            .expect("Roh and Lee's ball")
    };
    // As in the case that is shipped.
    let whole = Options { safety: Some(0.99), ..Options::default() };
    let short = Options { until_separation: true, ..Options::default() };
    type Make<'a> = &'a (dyn Fn() -> Simulation<f64> + Sync);
    let cases: [(&str, Make, &Options); 2] =
        [("Roh and Lee's case", &shells, &whole), ("rigid head until separation", &rigid, &short)];
    for (name, make, options) in cases {
        for threads in [1, 2] {
            let mut text = String::new();
            let time = least(|| {
                let (time, figures) = run(make, options, threads);
                text = figures;
                time
            });
            println!("{name}, {threads} threads: {time:.3} s; {text}");
        }
    }
    println!("contact at the peak: {:.1}% of a step on one thread", 100.0 * contact_share(shells()));
    let side_by_side = |runs: usize| {
        least(|| {
            let start = Instant::now();
            std::thread::scope(|scope| {
                for _ in 0..runs {
                    scope.spawn(|| run(&shells, &whole, 1));
                }
            });
            start.elapsed().as_secs_f64()
        })
    };
    println!("with set-up, one run {:.3} s, two side by side {:.3} s", side_by_side(1), side_by_side(2));
    if let Ok(status) = std::fs::read_to_string("/proc/self/status") {
        println!("memory, {}", status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or("not known"));
    }
}
