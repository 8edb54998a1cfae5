//! The eight-node hexahedron with one integration point and hourglass control.

mod arrangement;
mod constants;
mod element;
mod energies;
mod forces;
mod indexed;
mod interface;
mod interior;
mod lattice;
mod output;
mod patch;
mod places;
mod side;
mod stress;
mod visitor;

pub use patch::{solid_patches, SolidPatch};

#[cfg(test)]
mod tests {
    use super::solid_patches;
    use crate::ball::{BallConstruction as Ball, BallPiece as Piece};
    use crate::element::Element;
    use crate::material::{Material, NeoHookean};
    use clubface_math::{Mat3, Vec3};

    #[test]
    fn sides_of_a_ball_share_their_constants() {
        let law = NeoHookean { shear: 1e7 }.law();
        let material = Material { law, bulk: 5e8, maxwell: vec![], density: 1150.0 };
        let piece = |name: &str, radius: f64, layers: usize| {
            let (name, material) = (name.into(), material.clone());
            Piece { name, radius, layers, material }
        };
        // Turned, and away from the origin: positions are rounded.
        let ((a, b), (c, d)) = (0.3_f64.sin_cos(), 0.7_f64.sin_cos());
        let turn = Mat3::from_columns(
            Vec3::new(b, a * d, a * c),
            Vec3::new(-a, b * d, b * c),
            Vec3::new(0.0, -c, d),
        );
        for fine in [1, 2] {
            let (cube, layers) = (12 * fine, [6 * fine, 3 * fine]);
            let pieces = vec![piece("core", 0.0196, layers[0]), piece("cover", 0.0214, layers[1])];
            let ball = Ball { pieces, cube, element: Element::OnePoint, mass: None };
            let mesh = ball.mesh(&turn, Vec3::new(0.4, -0.3, 0.2)).expect("a ball").mesh;
            let mut from = cube.pow(3);
            for layers in layers {
                let to = from + 6 * cube * cube * layers;
                let patches = solid_patches(&mesh, from..to, &material);
                let mut kinds: Vec<_> = patches.iter().map(|patch| patch.constants.as_ptr()).collect();
                // Those that share follow each other.
                kinds.dedup();
                assert_eq!((patches.len() % 6, kinds.len()), (0, patches.len() / 6), "{fine} times as fine");
                from = to;
            }
        }
    }
}
