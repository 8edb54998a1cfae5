//! Cost of the ball on a rigid plane (the reference case), in nanoseconds per element and step, next to the launch it
//! computes.
//!
//! `cargo bench -p clubface-benches --bench ball`: criterion's figures for some steps after the impact in which nothing
//! rests, and a table with the least time of such steps during it and the least of some runs as anybody gets them,
//! with records and ledger and the core at rest in every second step: that is what the machine does when nobody else
//! uses it.

#![allow(missing_docs)]

use clubface_benches::{bulk_modulus, least_time, thread_pool};
use clubface_fem::ball::{BallConstruction, BallPiece};
use clubface_fem::cases::ball_against_plane;
use clubface_fem::contact::Contact;
use clubface_fem::element::Element;
use clubface_fem::environment::Environment;
use clubface_fem::material::{Hencky, Material, MooneyRivlin};
use clubface_fem::solve::{Options, Simulation, SimulationResult, Structure};
use clubface_math::Vec3;
use criterion::Criterion;
use std::time::Duration;

/// Steps at a time.
const MARCH: usize = 8;
/// Runs of which the quickest counts.
const RUNS: usize = 5;

struct Case {
    structure: Structure<f64>,
    contact: Box<dyn Contact<f64>>,
    step: f64,
    elements: usize,
}

/// The reference case, `refine` times as fine.
fn impact(refine: usize) -> Simulation<f64> {
    let core = Material {
        law: MooneyRivlin { c10: 4e6, c01: 1e6 }.law(),
        bulk: bulk_modulus(10e6, 0.49),
        maxwell: vec![],
        density: 1150.0,
    };
    let shear = 350e6 / 2.8;
    let cover = Material {
        law: Hencky { shear }.law(),
        bulk: bulk_modulus(shear, 0.4),
        maxwell: vec![],
        density: 950.0,
    };
    let piece = |name: &str, radius: f64, layers: usize, material: Material<f64>| BallPiece {
        name: name.into(),
        radius,
        layers: layers * refine,
        material,
    };
    let pieces = vec![piece("core", 0.0196, 6, core), piece("cover", 0.0214, 3, cover)];
    let ball = BallConstruction { pieces, cube: 12 * refine, element: Element::OnePoint, mass: Some(0.046) };
    ball_against_plane(&ball, 35.0, 11.5_f64.to_radians(), 0.35, &Environment::native())
        .expect("the reference case")
}

fn elements(refine: usize) -> usize {
    (12_usize.pow(3) + 54 * 12_usize.pow(2)) * refine.pow(3)
}

/// Its steps alone.
fn case(refine: usize) -> Case {
    let Simulation { mut structure, contact, .. } = impact(refine);
    let step = 0.9 * structure.stable_step(40);
    Case { structure, contact, step, elements: elements(refine) }
}

/// Figures of a ball: velocity (m/s), spin (rad/s) and peak force (N).
fn figures(velocity: Vec3<f64>, spin: Vec3<f64>, peak: f64) -> String {
    format!(
        "{:.3} m/s normal, {:.3} tangential, {:.0} rpm, {peak:.0} N",
        velocity.x,
        velocity.y,
        spin.z * 60.0 / std::f64::consts::TAU
    )
}

/// The quickest of some runs.
fn quickest(refine: usize, pool: &rayon::ThreadPool) -> SimulationResult<f64> {
    let run = |_| {
        let mut impact = impact(refine);
        pool.install(|| impact.run(&Options::default(), &mut |_| true)).expect("the options are valid")
    };
    (0..RUNS).map(run).min_by(|one, other| one.wall.total_cmp(&other.wall)).expect("some runs")
}

impl Case {
    fn integrate(&mut self) {
        self.structure.integrate(self.contact.as_mut(), self.step, MARCH, &mut |_, _| true);
    }
}

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_secs(2))
        .configure_from_args();
    let mut table = String::new();
    for refine in [1, 2] {
        for threads in [1, 2] {
            let pool = thread_pool(threads);
            let mut case = case(refine);
            let steps = (1e-3 / case.step).ceil() as usize;
            let mut peak = 0.0_f64;
            let least = pool.install(|| {
                least_time(steps / MARCH, || {
                    case.integrate();
                    peak = peak.max(case.contact.resultant().normal);
                })
            });
            let launch = case.structure.body_motion(0..case.structure.positions.len());
            let each = |time: f64| time * 1e9 / (MARCH * case.elements) as f64;
            let result = quickest(refine, &pool);
            table += &format!(
                "fineness {refine}, {threads} threads: {:.1} ns per element and step, nothing rests; {}\n{:>24} {:.1} ns in a whole run; {}\n",
                each(least),
                figures(launch.velocity, launch.spin, peak),
                "",
                result.wall * 1e9 / (result.steps * case.elements) as f64,
                figures(result.ball.velocity, result.ball.spin, result.records.summary(1.0).peak_force),
            );
            criterion.bench_function(
                &format!("ball, {MARCH} steps/fineness {refine}/{threads} threads"),
                |b| {
                    b.iter(|| pool.install(|| case.integrate()));
                },
            );
        }
    }
    println!("{table}");
}
