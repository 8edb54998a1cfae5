//! P2's case with the ball of the reference case: a ball at rest, met by a driver head of shells at 35 m/s.

use clubface_fem::ball::{Ball, Piece};
use clubface_fem::driver::Driver;
use clubface_fem::element::Element;
use clubface_fem::material::{Hencky, Material, MooneyRivlin, Shape};
use clubface_fem::solve::Options;

fn main() {
    let bulk = |mu: f64, nu: f64| 2.0 * mu * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
    let rubber = MooneyRivlin { c10: 4e6, c01: 1e6 };
    let shear = 350e6 / 2.8;
    let core = Material {
        shape: Shape::MooneyRivlin(rubber),
        bulk: bulk(10e6, 0.49),
        maxwell: vec![],
        density: 1e3,
    };
    let cover = Material {
        shape: Shape::Hencky(Hencky { shear }),
        bulk: bulk(shear, 0.4),
        maxwell: vec![],
        density: 950.0,
    };
    let ball = Ball {
        pieces: vec![
            Piece { name: "core".into(), radius: 0.0196, layers: 6, material: core },
            Piece { name: "cover".into(), radius: 0.0214, layers: 3, material: cover },
        ],
        cube: 12,
        element: Element::OnePoint,
        mass: Some(0.046),
    };
    let driver = Driver::<f64>::p2();
    let head = driver.mesh().expect("the head is valid");
    let reached = head.mass_properties();
    println!("{:.3} g, mass centre {:?} m", reached.mass * 1e3, reached.centre);
    println!("inertia {:?} kg m2", reached.inertia);
    println!("body {:.3}, trim masses {:?} kg", head.tuned.scale, head.tuned.trims);
    let mut impact = driver.against_ball(&ball, 35.0, 0.35).expect("the case is valid");
    let outcome = impact.run(&Options::default(), &mut |_, _| true).expect("the options are valid");
    println!("{:?}", outcome.stopped);
    let v = outcome.ball.velocity;
    println!("ball {:.3} m/s, launch {:.3} deg", v.norm(), v.y.atan2(v.x).to_degrees());
    println!("spin {:.1} rpm", outcome.ball.spin.z * 30.0 / std::f64::consts::PI);
    println!("head after: {:?}", outcome.head);
    println!("{:#?}", outcome.history.figures(ball.radius()));
    println!("{:?}", outcome.history.energy.last());
    println!(
        "{} steps of {:.4} us, {:.3} s, {:.1} us a step",
        outcome.steps,
        outcome.step * 1e6,
        outcome.wall,
        outcome.wall * 1e6 / outcome.steps as f64
    );
}
