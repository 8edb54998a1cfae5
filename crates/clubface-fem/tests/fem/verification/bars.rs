//! A slender bar: period of its longitudinal vibration, and its stroke against a wall (Saint-Venant).

use crate::support::{ELEMENTS, SPRING, block, elastic, masses, period, step, structure};
use clubface_fem::contact::{Contact, Plane, RigidContact};
use clubface_fem::element::Element;
use clubface_math::{Row, Vec3};

const LENGTH: f64 = 0.1;
const WIDTH: f64 = 0.005;
/// Without lateral contraction, the one-dimensional theory is exact: waves run at 1000 m/s.
const YOUNG: f64 = 1e9;
const DENSITY: f64 = 1000.0;
const SPEED: f64 = 1000.0;

#[test]
fn period_of_a_free_bar() {
    // n elements along half a wave: lumped masses lower the frequency by (pi/n)^2/24, the time step raises it by less.
    let n = 20;
    let mesh = block([n, 1, 1], [LENGTH, WIDTH, WIDTH]);
    let mode: Vec<_> = mesh
        .nodes
        .iter()
        .map(|x| Vec3::new(1e-3 * (std::f64::consts::PI * x.x / LENGTH).cos(), 0.0, 0.0))
        .collect();
    let expected = 2.0 * LENGTH / SPEED;
    for element in ELEMENTS {
        let mut bar = structure(element, &mesh, &elastic(YOUNG, 0.0, DENSITY), &[]);
        let result = period(&mut bar, &mode, expected);
        assert!((result / expected - 1.0).abs() < 1.2e-3, "{result} {expected}");
    }
}

#[test]
fn a_bar_strikes_a_wall() {
    // The force on the wall is rho c v A until the wave returns from the far end, 2 L / c later, and the bar leaves with the
    // opposite velocity.
    let mesh = block([80, 2, 2], [LENGTH, WIDTH, WIDTH]);
    let touching: Vec<u32> =
        (0..mesh.nodes.len() as u32).filter(|&n| mesh.nodes[n as usize].x == 0.0).collect();
    let mut bar = structure(Element::OnePoint, &mesh, &elastic(YOUNG, 0.0, DENSITY), &touching);
    let areas = vec![WIDTH * WIDTH / 9.0; mesh.nodes.len()];
    let mut contact =
        RigidContact::new(Plane, 0.0, touching, &masses(&mesh, DENSITY), &areas).with_springs(SPRING);
    let speed = 0.1;
    bar.velocities.fill(Row([-speed, 0.0, 0.0, 0.0]));
    let dt = bar.stable_step(60) * 0.8;
    let (mut time, mut impulse, mut plateau, mut lasted) = (0.0, 0.0, vec![], 0.0);
    let (expected, returns) = (DENSITY * SPEED * speed * WIDTH * WIDTH, 2.0 * LENGTH / SPEED);
    while time < 1.5 * returns {
        step(&mut bar, &mut contact, dt);
        time += dt;
        let force = contact.resultant().normal;
        impulse += force * dt;
        if time > 0.2 * returns && time < 0.8 * returns {
            plateau.push(force);
        }
        if impulse < expected * returns * 0.5 {
            lasted = time;
        }
    }
    let mean = plateau.iter().sum::<f64>() / plateau.len() as f64;
    let velocity = bar.body_motion(0..mesh.nodes.len()).velocity.x;
    // The front is spread over a few elements and rings; the mean over most of the plateau does not care.
    assert!((mean / expected - 1.0).abs() < 5e-3, "{mean} {expected}");
    // The springs of the contact, a quarter of node mass over step squared, give the front a rise of its own: its time
    // constant is rho c A over their stiffness, by which every part of the impulse is late.
    let mass = DENSITY * WIDTH * WIDTH * LENGTH / 160.0;
    let late = DENSITY * SPEED * WIDTH * WIDTH * dt * dt / (SPRING.stiffness * mass);
    assert!((2.0 * (lasted - late) / returns - 1.0).abs() < 1e-2, "{lasted} {late} {returns}");
    // What rings in the bar is missing in the rebound.
    assert!((velocity / speed - 1.0).abs() < 2e-2, "{velocity}");
}
