//! Finite elements: the reference case, a ball on a rigid plane.

use clubface_fem::FemError;
use clubface_fem::ball::{BallConstruction, BallPiece};
use clubface_fem::cases::ball_against_plane;
use clubface_fem::element::Element;
use clubface_fem::environment::{Environment, SingleThread};
use clubface_fem::material::{Hencky, Material, MooneyRivlin};
use clubface_fem::solve::{Options, Progress, Recording};
use serde_json::{Value, json};
use std::sync::Arc;

#[link(wasm_import_module = "clubface")]
unsafe extern "C" {
    fn now() -> f64;
    fn progress(time: f64, duration: f64) -> u32;
}

/// Throws the reference ball at a rigid plane for 1000 us, at `speed` (m/s) and `angle` (rad) from its normal, with
/// Coulomb's `friction`, on a mesh `refine` times as fine. Leaves the velocity (m/s) and spin (rad/s) of the ball, peak
/// force (N), contact time (s), number of elements and steps, and the time that the steps took (s).
#[unsafe(no_mangle)]
pub extern "C" fn reference_case(speed: f64, angle: f64, friction: f64, refine: usize) -> u32 {
    crate::finish(run(speed, angle, friction, refine).map_err(|error| json!({"message": error.to_string()})))
}

fn run(speed: f64, angle: f64, friction: f64, refine: usize) -> Result<Value, FemError> {
    let ball = reference_ball(refine);
    // SAFETY: the caller provides both functions.
    let environment = Environment { clock: || unsafe { now() }, executor: Arc::new(SingleThread) };
    let mut simulation = ball_against_plane(&ball, speed, angle, friction, &environment)?;
    // SAFETY: as above.
    let mut report = |at: &Progress| unsafe { progress(at.time, at.duration) != 0 };
    let record = simulation.record(&Options::default(), Recording::default(), None, &mut report)?;
    if let Some(stopped) = record.stopped {
        return Err(stopped);
    }
    let layers: usize = ball.pieces.iter().map(|piece| piece.layers).sum();
    Ok(json!({
        "velocity": record.ball.velocity.array(), "spin": record.ball.spin.array(),
        "peak_force": record.summary.peak_force, "contact_time": record.summary.contact_time,
        "energy_error": record.summary.energy_error, "elements": ball.cube.pow(3) + 6 * ball.cube.pow(2) * layers,
        "steps": record.steps, "wall": record.wall,
    }))
}

/// Bulk modulus, Pa.
fn bulk(shear: f64, poisson: f64) -> f64 {
    2.0 * shear * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson))
}

/// The ball of Roh and Lee: a Mooney-Rivlin core in a stiffer cover.
fn reference_ball(refine: usize) -> BallConstruction<f64> {
    let shear = 350e6 / 2.8;
    let core = Material {
        law: MooneyRivlin { c10: 4e6, c01: 1e6 }.law(),
        bulk: bulk(10e6, 0.49),
        maxwell: vec![],
        density: 1150.0,
    };
    let cover =
        Material { law: Hencky { shear }.law(), bulk: bulk(shear, 0.4), maxwell: vec![], density: 950.0 };
    let pieces = vec![
        BallPiece { name: "core".into(), radius: 0.0196, layers: 6 * refine, material: core },
        BallPiece { name: "cover".into(), radius: 0.0214, layers: 3 * refine, material: cover },
    ];
    BallConstruction { pieces, cube: 12 * refine, element: Element::OnePoint, mass: Some(0.046) }
}
