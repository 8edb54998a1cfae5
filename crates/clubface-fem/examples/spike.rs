//! The reference case: P2's ball on a rigid plane.

use clubface_fem::ball::{Ball, Piece};
use clubface_fem::cases::against_plane;
use clubface_fem::material::{Hencky, Material, MooneyRivlin, Shape};
use clubface_fem::solve::Options;

fn main() {
    let args: Vec<f64> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let refine = args.first().copied().unwrap_or(1.0) as usize;
    let safety = args.get(1).copied().unwrap_or(0.8);
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
            Piece { name: "core".into(), radius: 0.0196, layers: 6 * refine, material: core },
            Piece { name: "cover".into(), radius: 0.0214, layers: 3 * refine, material: cover },
        ],
        cube: 12 * refine,
        mass: Some(0.046),
    };
    let mut impact = against_plane(&ball, 35.0, 11.5_f64.to_radians(), 0.35).expect("the case is valid");
    let options = Options { safety, ..Options::default() };
    let outcome = impact.run(&options, &mut |_, _| true).expect("the options are valid");
    let rpm = 30.0 / std::f64::consts::PI;
    println!("{:?}", outcome.stopped);
    println!(
        "{:.4} {:.4} m/s, {:.2} rpm",
        outcome.ball.velocity.x,
        outcome.ball.velocity.y,
        outcome.ball.spin.z * rpm
    );
    println!("{:#?}", outcome.history.figures(ball.radius()));
    println!("{:?}", outcome.history.motion.last());
    let elements = 9504.0 * (refine * refine * refine) as f64;
    println!(
        "{} steps, {:.3} s, {:.1} ns",
        outcome.steps,
        outcome.wall,
        outcome.wall * 1e9 / outcome.steps as f64 / elements
    );
}
