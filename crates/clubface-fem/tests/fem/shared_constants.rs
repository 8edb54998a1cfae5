//! Elements that differ by a rotation share their constants.

use crate::support::piece;
use clubface_fem::ball::BallConstruction;
use clubface_fem::element::{Element, constant_sets};
use clubface_fem::material::{Material, NeoHookean};
use clubface_math::{Mat3, Vec3};

#[test]
fn sides_of_a_ball_share_their_constants() {
    let law = NeoHookean { shear: 1e7 }.law();
    let material = Material { law, bulk: 5e8, maxwell: vec![], density: 1150.0 };
    // Turned, and away from the origin: positions are rounded.
    let ((a, b), (c, d)) = (0.3_f64.sin_cos(), 0.7_f64.sin_cos());
    let turn =
        Mat3::from_columns(Vec3::new(b, a * d, a * c), Vec3::new(-a, b * d, b * c), Vec3::new(0.0, -c, d));
    for fine in [1, 2] {
        let (cube, layers) = (12 * fine, [6 * fine, 3 * fine]);
        let pieces = [("core", 0.0196, layers[0]), ("cover", 0.0214, layers[1])];
        let pieces =
            pieces.map(|(name, radius, layers)| piece(name, radius, layers, material.clone())).to_vec();
        let ball = BallConstruction { pieces, cube, element: Element::OnePoint, mass: None };
        let mesh = ball.mesh(&turn, Vec3::new(0.4, -0.3, 0.2)).expect("a ball").mesh;
        let mut from = cube.pow(3);
        for layers in layers {
            let to = from + 6 * cube * cube * layers;
            let mut sets = constant_sets(&mesh, from..to, &material);
            let patches = sets.len();
            // Those that share follow each other.
            sets.dedup();
            assert_eq!((patches % 6, sets.len()), (0, patches / 6), "{fine} times as fine");
            from = to;
        }
    }
}
