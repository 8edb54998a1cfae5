//! What a free ball keeps, and what a ball and a rigid head keep.

use crate::first_touch::touch;
use crate::support::{ELEMENTS, Loads, Random, elastic, momenta, piece, step, structure};
use clubface_fem::ball::BallConstruction;
use clubface_fem::cases::ball_against_rigid_head;
use clubface_fem::element::Element;
use clubface_fem::environment::Environment;
use clubface_fem::material::Maxwell;
use clubface_fem::mesh::{Fineness, SolidMesh, cubed_sphere};
use clubface_fem::solve::{Options, Simulation, Structure};
use clubface_math::{Row, Vec3};

fn mesh() -> SolidMesh {
    cubed_sphere(&[0.02], &Fineness { cube: 6, layers: vec![4] })
}

/// A viscoelastic ball that flies, spins and is shaken through and through.
fn shaken(element: Element, mesh: &SolidMesh) -> Structure<f64> {
    let mut material = elastic(30e6, 0.45, 1000.0);
    material.maxwell = vec![Maxwell { modulus: 0.5, time: 1e-4 }];
    let mut ball = structure(element, mesh, &material, &[]);
    let mut random = Random(8);
    for (v, x) in ball.velocities.iter_mut().zip(&mesh.nodes) {
        let velocity =
            Vec3::new(30.0, 5.0, -2.0) + Vec3::new(100.0, -300.0, 200.0).cross(*x) + random.vector();
        *v = Row::from_vec(velocity);
    }
    ball
}

#[test]
fn a_free_ball_keeps_momentum_and_angular_momentum() {
    // Rounding only: forces inside are equal and opposite, and central differences keep both momenta exactly.
    let mesh = mesh();
    for element in ELEMENTS {
        let mut ball = shaken(element, &mesh);
        let dt = ball.stable_step(60) * 0.5;
        let before = momenta(&ball);
        for _ in 0..500 {
            step(&mut ball, &mut Loads::none(), dt);
        }
        for (after, before) in momenta(&ball).iter().zip(before) {
            assert!((*after - before).norm() < 1e-10 * before.norm(), "{after:?} {before:?}");
        }
    }
}

/// A ball that loses nothing, hit off centre by a head that turns and whose face is rigid or gives.
fn hit(characteristic_time: f64) -> Simulation<f64> {
    let touch = touch(&[
        ("speed", 40.0),
        ("loft", 0.3),
        ("static_loft", 0.3),
        ("toe", 0.012),
        ("high", -0.006),
        ("closure", 30.0),
        ("club_mass", MASS),
        ("cg_x", 0.03),
        ("ixx", INERTIA),
        ("iyy", INERTIA),
        ("izz", INERTIA),
        ("bulge", 0.3),
        ("roll", 0.3),
        ("characteristic_time", characteristic_time),
        ("hand", 1.0),
    ]);
    let core = piece("core", 0.0214, 3, elastic(30e6, 0.45, 1000.0));
    let ball =
        BallConstruction { pieces: vec![core], cube: 4, element: Element::OnePoint, mass: Some(0.046) };
    ball_against_rigid_head(&ball, &touch, 0.3, &Environment::native()).expect("the case is valid")
}

const MASS: f64 = 0.2;
/// As large about every axis, so that angular momentum follows from the spin whatever the attitude.
const INERTIA: f64 = 3e-4;
const FACES: [f64; 3] = [0.0, 150e-6, 300e-6];

#[test]
fn a_ball_and_a_rigid_head_keep_momentum_and_angular_momentum() {
    for time in FACES {
        let Simulation { mut structure, mut contact, .. } = hit(time);
        let dt = structure.stable_step(60) * 0.5;
        // The origin is the head's CG at first touch; it moves on with the velocity of every step.
        let mut cg = Vec3::zero();
        let mut sums = Vec::new();
        for _ in 0..400 {
            let [mut linear, mut angular] = momenta(&structure);
            let head = contact.head_motion().expect("a rigid head");
            linear += head.velocity * MASS;
            angular += cg.cross(head.velocity) * MASS + head.spin * INERTIA;
            sums.push([linear, angular]);
            step(&mut structure, contact.as_mut(), dt);
            cg += contact.head_motion().expect("a rigid head").velocity * dt;
        }
        let spun = structure.body_motion(0..structure.positions.len()).spin.norm();
        assert!(spun > 30.0, "a hit off centre: {spun} rad/s");
        // Rounding, over the momentum of the head and the lever of its CG.
        for [linear, angular] in &sums {
            assert!((*linear - sums[0][0]).norm() < 1e-10 * MASS * 40.0, "{linear:?} {:?}", sums[0][0]);
            let lost = (*angular - sums[0][1]).norm();
            assert!(lost < 1e-10 * MASS * 40.0 * 0.03, "{angular:?} {:?}", sums[0][1]);
        }
    }
}

#[test]
fn a_ball_and_a_rigid_head_keep_their_energy_whether_the_face_gives_or_not() {
    let options = Options { until_separation: true, ..Options::default() };
    for time in FACES {
        let mut simulation = hit(time);
        let radius = simulation.radius;
        let result = simulation.run(&options, &mut |_| true).expect("the options are valid");
        assert!(result.stopped.is_none());
        let error = result.records.summary(radius).energy_error;
        // Of the penalty springs at the nodes that come and go.
        assert!(error < 2e-3, "{time}: {error}");
    }
}
