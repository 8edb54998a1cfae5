//! Time of the rings next to their results: one solve, a sphere on a plane, a drive and an iron shot.

use clubface_impact::Accuracy;
use clubface_impact::batch::Batch;
use clubface_impact::columns::Column;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::registry::RINGS;
use clubface_impact::rings::plane::{Resolution, Sphere};
use clubface_impact::rings::{Load, RingContact, RingMaterial};
use criterion::Criterion;
use std::f64::consts::PI;
use std::hint::black_box;

fn solve(criterion: &mut Criterion) {
    let material = RingMaterial { friction: 0.36, poisson: 0.407, modulus: 5.58e7 };
    let load = Load { force: 10_000.0, radius: 0.0098 };
    for (title, slip) in
        [("sticking", [2e-5, 1e-5]), ("slipping outside", [3e-4, 2e-4]), ("sliding", [4e-3, 2e-3])]
    {
        let mut rings = RingContact::new(20, material, 0.01);
        // A history whose displacements point elsewhere, so that slip directions differ from ring to ring.
        rings.force([1e-4, -1e-4], Load { force: 8000.0, radius: 0.009 });
        rings.commit();
        let force = rings.force(slip, load);
        println!("{title}: {:.1} N, {:.1} N, {:?}", force[0], force[1], rings.effort());
        let mut other = false;
        criterion.bench_function(&format!("rings: one solve, {title}"), |bencher| {
            bencher.iter(|| {
                // Two slips in turn: each solve starts from a neighbour, as in an integration.
                other = !other;
                let scale = if other { 1.02 } else { 1.0 };
                rings.force(black_box([slip[0] * scale, slip[1]]), load)
            });
        });
    }
}

fn plane(criterion: &mut Criterion) {
    let material = RingMaterial { friction: 0.2, poisson: 0.3, modulus: 5.58e7 };
    let sphere = Sphere { mass: 0.0459, radius: 0.0213, inertia_ratio: 0.4, material };
    let resolution = Resolution { rings: 20, steps_per_ring: 1, longest_step: 0.05 };
    let unit = sphere.psi_per_velocity(40.0);
    for psi in [0.6, 2.0, 5.5] {
        let rebound = sphere.bounce(40.0, [psi / unit, 0.0], resolution);
        println!("psi {psi} to {:.4} in {} solves", rebound.surface_velocity[0] * unit, rebound.solves);
        criterion.bench_function(&format!("rings: sphere on a plane, psi {psi}"), |bencher| {
            bencher.iter(|| sphere.bounce(40.0, black_box([psi / unit, 0.0]), resolution));
        });
    }
}

fn shots(criterion: &mut Criterion) {
    let degree = PI / 180.0;
    let driver = [0.204, 0.0408, 0.0114, 0.001, 2843e-7, 5679e-7, 4085e-7, -733e-7, 530.2e-7, 0.5e-7];
    let iron = [0.264, 0.00361, 0.00485, 0.00112, 2752e-7, 2889e-7, 576.6e-7, -51e-7, -53e-7, -429e-7];
    let wood_face = [9.8 * degree, 0.305, 0.305, 0.12, 0.06];
    let flat_face = [30.5 * degree, f64::INFINITY, f64::INFINITY, 0.08, 0.05];
    let driver_set = [5.58e7, 0.407, 6.50e-3, 0.360, 5.58e7];
    let iron_set = [5.74e7, 0.418, 11.5e-3, 0.519, 5.74e7];
    // Speed, attack, path, loft, face, lie, toe, high, closure, pitch rate, lie rate.
    let centred = [48.28, 2.0 * degree, 0.0, 13.0 * degree, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let toe = [50.5, -0.02, 0.05, 0.22, -0.03, 0.0, 0.012, -0.005, 40.0, 0.0, 0.0];
    let seven = [40.0, -4.0 * degree, 0.0, 22.0 * degree, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    for (title, delivery, club, face, set) in [
        ("drive", centred, driver, wood_face, driver_set),
        ("drive off the toe", toe, driver, wood_face, driver_set),
        ("7-iron", seven, iron, flat_face, iron_set),
    ] {
        let ball = [0.0, 1.0, 0.0459, 0.0213, 83.36e-7];
        let mut inputs = [0.0; 31];
        inputs.copy_from_slice(&[&delivery[..], &club, &face, &ball].concat());
        let parameters = set.map(Column::Constant);
        let shot = |accuracy| {
            let inputs = black_box(inputs).map(Column::Constant);
            let batch = Batch { model: RINGS, inputs: &inputs, parameters: &parameters, accuracy };
            let mut outputs = [0.0; OUTPUT_COUNT];
            assert!(batch.run(0..1, outputs.chunks_mut(1).collect()).is_empty());
            outputs
        };
        // The seventh output is the total spin.
        let rpm = |accuracy| shot(accuracy)[6] * 30.0 / PI;
        let (fast, converged) = (rpm(Accuracy::Fast), rpm(Accuracy::Tolerance(1e-10)));
        let error = (fast / converged - 1.0) * 100.0;
        println!("{title}: {fast:.1} rpm, converged {converged:.1} rpm, {error:+.3}%");
        criterion.bench_function(&format!("rings: {title}"), |bencher| bencher.iter(|| shot(Accuracy::Fast)));
    }
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    solve(&mut criterion);
    plane(&mut criterion);
    shots(&mut criterion);
    criterion.final_summary();
}
