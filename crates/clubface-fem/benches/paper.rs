//! Cost of P2's case as a whole, beside the launch it computes: P2's ball and head of shells, then the same struck by a rigid head.
//!
//! `cargo bench -p clubface-fem --bench paper`: the least of some runs, which is what the machine does when nobody else uses it; what a step is made of;
//! the memory the process has taken; and two runs side by side against one.

#![allow(missing_docs)]

use clubface_fem::ball::{Ball, Piece};
use clubface_fem::cases::against_head;
use clubface_fem::element::Element;
use clubface_fem::head::{against_ball, DeformableHead, Driver, ShellHead};
use clubface_fem::material::{Hencky, Material, Maxwell, MooneyRivlin, Shape};
use clubface_fem::mesh::DriverThickness;
use clubface_fem::solve::{Impact, Options};
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::shot::{Shot, INPUTS};
use std::time::Instant;

const RUNS: usize = 5;
const FRICTION: f64 = 0.12;

/// The ball called "paper".
fn ball() -> Ball<f64> {
    let bulk = |shear: f64, poisson: f64| 2.0 * shear * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson));
    let (c10, c01) = (5.87e6, 0.207e6);
    let core = Material {
        shape: Shape::MooneyRivlin(MooneyRivlin { c10, c01 }),
        bulk: bulk(2.0 * (c10 + c01), 0.49),
        maxwell: vec![Maxwell { modulus: 0.218, time: 88.3e-6 }],
        density: 1150.0,
    };
    let shear = 173e6 / (2.0 * 1.449);
    let cover = Material {
        shape: Shape::Hencky(Hencky { shear }),
        bulk: bulk(shear, 0.449),
        maxwell: vec![Maxwell { modulus: 6.31, time: 22.2e-6 }],
        density: 950.0,
    };
    let piece = |name: &str, radius, layers, material| Piece { name: name.into(), radius, layers, material };
    let pieces = vec![piece("core", 0.0196, 6, core), piece("cover", 0.0214, 3, cover)];
    Ball { pieces, cube: 12, element: Element::OnePoint, mass: Some(0.046) }
}

/// The head called "p2", at 35 m/s and its loft.
fn delivered(head: &ShellHead<f64>) -> FirstTouch<f64> {
    let is = head.mass_properties();
    let ([x, y, z], at) = (is.inertia.rows, is.centre * -1.0);
    let values = [
        ("speed", 35.0),
        ("loft", head.loft),
        ("club_mass", is.mass),
        ("cg_x", at.x),
        ("cg_y", at.y),
        ("cg_z", at.z),
        ("ixx", x.x),
        ("iyy", y.y),
        ("izz", z.z),
        ("ixy", x.y),
        ("ixz", x.z),
        ("iyz", y.z),
        ("static_loft", head.loft),
        ("bulge", 0.305),
        ("roll", 0.305),
        ("hand", 1.0),
    ];
    let inputs = INPUTS.map(|input| values.iter().find(|v| v.0 == input.name).map_or(0.0, |v| v.1));
    FirstTouch::of(&Shot::from_inputs(&inputs))
}

/// Runs a case on some threads; returns the time of its loop, s, and its figures.
fn run(make: &(dyn Fn() -> Impact<f64> + Sync), options: &Options, threads: usize) -> (f64, String) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let mut impact = make();
    let found = pool.install(|| impact.run(options, &mut |_, _| true)).expect("the options are valid");
    assert!(found.stopped.is_none(), "{:?}", found.stopped);
    let (v, figures) = (found.ball.velocity, found.history.figures(impact.radius));
    let told = format!(
        "{} steps, {:.1} us each; ball {:.2} m/s, {:.0} rpm, {:.0} N, energies off by {:.0e}",
        found.steps,
        found.wall * 1e6 / found.steps as f64,
        v.norm(),
        found.ball.spin.norm() * 60.0 / std::f64::consts::TAU,
        figures.peak_force,
        figures.energy_error,
    );
    (found.wall, told)
}

/// The least of some.
fn least(mut time: impl FnMut() -> f64) -> f64 {
    (0..RUNS).map(|_| time()).fold(f64::INFINITY, f64::min)
}

/// Share of the contact in the steps about the peak of the force, on one thread.
fn contact_share(mut impact: Impact<f64>) -> f64 {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("threads");
    let options = Options { duration: 280e-6, ..Options::default() };
    let found = pool.install(|| impact.run(&options, &mut |_, _| true)).expect("the options are valid");
    let step = found.wall / found.steps as f64;
    let (structure, contact) = (&impact.structure, &mut impact.contact);
    let alone = least(|| {
        let start = Instant::now();
        for _ in 0..100 {
            contact.assemble(&structure.positions, &structure.velocities, found.step);
        }
        start.elapsed().as_secs_f64() / 100.0
    });
    alone / step
}

fn main() {
    let mut driver = Driver::p2();
    driver.thickness = DriverThickness { face_centre: 1.8e-3, face_edge: 1.57e-3, ..driver.thickness };
    let start = Instant::now();
    let head = driver.mesh().expect("P2's head").head;
    println!("head meshed in {:.3} s", start.elapsed().as_secs_f64());
    let touch = delivered(&head);
    let shells = || against_ball(&head, &ball(), &touch, FRICTION).expect("P2's case");
    let rigid = || against_head(&ball(), &touch, FRICTION).expect("P2's ball");
    let whole = Options::default();
    let short = Options { until_separation: true, ..Options::default() };
    type Make<'a> = &'a (dyn Fn() -> Impact<f64> + Sync);
    let cases: [(&str, Make, &Options); 2] =
        [("P2's case", &shells, &whole), ("rigid head until separation", &rigid, &short)];
    for (name, make, options) in cases {
        for threads in [1, 2] {
            let mut told = String::new();
            let time = least(|| {
                let (time, figures) = run(make, options, threads);
                told = figures;
                time
            });
            println!("{name}, {threads} threads: {time:.3} s; {told}");
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
