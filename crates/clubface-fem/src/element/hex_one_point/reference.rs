//! The one-point hexahedron as textbooks write it: slow, plain, and what the fast element is tested against.
//!
//! Total Lagrangian, over any scalar, with X the reference position of node a, x the current one, `xi` the reference
//! coordinates in the cube from -1 to 1 and `N_a = (1 + xi xi_a)(1 + eta eta_a)(1 + zeta zeta_a) / 8`:
//!
//! 1. uniform gradient: `B_a = 1/V ∫ dN_a/dX dV` (Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17, 1981),
//! 2. deformation gradient: `F = sum_a x_a (x) B_a`,
//! 3. hourglass shapes: `gamma_a = h_a - sum_i (h . X_i) b_ai`, with the gradients b at the centre, blind to every
//!    linear field (Belytschko, Ong, Liu and Kennedy, Comput. Methods Appl. Mech. Eng. 43, 1984),
//! 4. hourglass stiffness `k`, of a block of the element's edges in bending, shear and torsion (after Belytschko and
//!    Bindeman, Comput. Methods Appl. Mech. Eng. 105, 1993),
//! 5. forces: `f_a = -V P(F) B_a - sum_h k_h gamma_ha (sum_b gamma_hb x_b)`, with the first Piola-Kirchhoff stress P.

use crate::mesh::{CORNERS, base_vectors, signs};
use clubface_math::{Mat3, Scalar, Vec3};

/// Reference coordinates whose product is each hourglass vector h: `eta zeta`, `xi zeta`, `xi eta`, `xi eta zeta`.
const HOURGLASS: [[bool; 3]; 4] = [[false, true, true], [true, false, true], [true, true, false], [true; 3]];

/// A hexahedron with one integration point and hourglass control.
#[derive(Clone, Debug)]
pub struct ReferenceHexahedron<S> {
    /// Reference volume, m3.
    pub volume: S,
    /// Uniform gradient by node (1), 1/m.
    pub gradients: [Vec3<S>; CORNERS],
    /// Hourglass shapes by node (3).
    pub shapes: [[S; CORNERS]; 4],
    /// Stiffness of each (4), N/m.
    pub stiffness: [S; 4],
}

impl<S: Scalar> ReferenceHexahedron<S> {
    /// From the corners (m) in binary order and the shear modulus (Pa) of the material.
    pub fn new(corners: &[Vec3<S>; CORNERS], shear: S) -> Self {
        // (1) Two points along each coordinate integrate dN/dX det J exactly.
        let (mut volume, mut gradients) = (S::zero(), [Vec3::zero(); CORNERS]);
        for point in 0..CORNERS {
            let at = signs(point).map(|sign| sign / 3.0_f64.sqrt());
            let [g1, g2, g3] = base_vectors(corners, at);
            let determinant = g1.dot(g2.cross(g3));
            volume += determinant;
            for (sum, gradient) in gradients.iter_mut().zip(shape_gradients(corners, at)) {
                *sum += gradient * determinant;
            }
        }
        let gradients = gradients.map(|sum| sum * volume.recip());
        // (3)
        let centre = shape_gradients(corners, [0.0; 3]);
        let shapes = HOURGLASS.map(|coordinates| {
            let h: [f64; CORNERS] = std::array::from_fn(|node| {
                (0..3).filter(|&axis| coordinates[axis]).map(|axis| signs(node)[axis]).product()
            });
            let moment = (0..CORNERS).fold(Vec3::zero(), |sum, b| sum + corners[b] * S::from_f64(h[b]));
            std::array::from_fn(|a| S::from_f64(h[a]) - moment.dot(centre[a]))
        });
        Self { volume, gradients, shapes, stiffness: hourglass_stiffness(corners, volume, shear) }
    }

    /// Deformation gradient (2).
    pub fn deformation_gradient(&self, positions: &[Vec3<S>; CORNERS]) -> Mat3<S> {
        let terms = positions.iter().zip(self.gradients);
        terms.fold(Mat3::diagonal(S::zero()), |f, (&x, gradient)| f + Mat3::outer(x, gradient))
    }

    /// Forces on the nodes (5), N, for a law that gives the first Piola-Kirchhoff stress (Pa) at a deformation gradient.
    pub fn forces(
        &self,
        positions: &[Vec3<S>; CORNERS],
        law: impl FnOnce(&Mat3<S>) -> Mat3<S>,
    ) -> [Vec3<S>; CORNERS] {
        let stress = law(&self.deformation_gradient(positions));
        let mut forces = self.gradients.map(|gradient| (stress * gradient) * -self.volume);
        for (shape, &stiffness) in self.shapes.iter().zip(&self.stiffness) {
            let amplitude = self.amplitude(shape, positions);
            for (force, &share) in forces.iter_mut().zip(shape) {
                *force += amplitude * -(stiffness * share);
            }
        }
        forces
    }

    /// Energy of the hourglass modes, J.
    pub fn hourglass_energy(&self, positions: &[Vec3<S>; CORNERS]) -> S {
        let energy = |(shape, &stiffness): (&[S; CORNERS], &S)| {
            self.amplitude(shape, positions).norm_squared() * stiffness * 0.5
        };
        self.shapes.iter().zip(&self.stiffness).map(energy).fold(S::zero(), |sum, energy| sum + energy)
    }

    fn amplitude(&self, shape: &[S; CORNERS], positions: &[Vec3<S>; CORNERS]) -> Vec3<S> {
        positions.iter().zip(shape).fold(Vec3::zero(), |sum, (&x, &share)| sum + x * share)
    }
}

/// Gradients of the shape functions with respect to the reference position, at reference coordinates: `J^-T dN/dxi`.
fn shape_gradients<S: Scalar>(corners: &[Vec3<S>; CORNERS], at: [f64; 3]) -> [Vec3<S>; CORNERS] {
    let [g1, g2, g3] = base_vectors(corners, at);
    let inverse_transposed = Mat3::from_columns(g1, g2, g3).inverse().transpose();
    std::array::from_fn(|node| {
        let [s, t, u] = signs(node);
        let [a, b, c] = [1.0 + s * at[0], 1.0 + t * at[1], 1.0 + u * at[2]];
        inverse_transposed * Vec3::from_f64([s * b * c / 8.0, a * t * c / 8.0, a * b * u / 8.0])
    })
}

/// Hourglass stiffness (4). A block with edges `l` and `e = 4 / l^2` has `G V / 48 e` in a mode across two edges along
/// either of them, and a quarter of that with the sum of both along the third. One stiffness serves all directions: the
/// one whose period is the mean of theirs.
fn hourglass_stiffness<S: Scalar>(corners: &[Vec3<S>; CORNERS], volume: S, shear: S) -> [S; 4] {
    let e = base_vectors(corners, [0.0; 3]).map(|half_edge| half_edge.norm_squared().recip());
    let scale = shear * volume * (1.0 / 48.0);
    let across = |i: usize| {
        let [one, other] = [e[(i + 1) % 3], e[(i + 2) % 3]];
        let period = [one, other, (one + other) * 0.25].map(|stiffness| stiffness.sqrt().recip());
        let mean = (period[0] + period[1] + period[2]) * (1.0 / 3.0);
        scale * (mean * mean).recip()
    };
    [across(0), across(1), across(2), scale * 0.25 * (e[0] * e[1] * e[2]).powf(1.0 / 3.0)]
}
