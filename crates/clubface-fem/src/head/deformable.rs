//! What every deformable head has in common.

use crate::contact::Grooves;
use crate::element::Patch;
use crate::error::FemError;
use crate::mesh::{MassProperties, ShellMasses, mass_properties};
use clubface_math::{Real, Vec3};

/// A head made of elements. Axes: x towards the target, y up, z to the toe, as the club is soled; the origin is the
/// face centre.
pub trait DeformableHead<R: Real> {
    /// Checks that the head can be simulated.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first element, node or value that is not allowed.
    fn check(&self) -> Result<(), FemError>;
    /// Elevation of the face normal at the face centre, rad.
    fn loft(&self) -> f64;
    /// Positions of the nodes, m.
    fn nodes(&self) -> &[Vec3<f64>];
    /// Masses of the nodes; rotary inertias only if nodes have rotations.
    fn masses(&self) -> ShellMasses<R>;
    /// Patches of elements with the names of their parts, for the positions of the nodes at first touch. Node 0 is row
    /// `first` of the structure; the rows of rotations follow behind those of all positions.
    fn patches(&self, positions: &[Vec3<R>], first: u32) -> Vec<(String, Box<dyn Patch<R>>)>;
    /// Quadrilaterals that the ball may touch, counterclockwise seen from outside, and their thickness, m. The surface
    /// lies half of it outside them.
    fn face(&self) -> (Vec<[u32; 4]>, Vec<R>);

    /// Grooves of the face.
    fn grooves(&self) -> Option<Grooves> {
        None
    }
    /// Checks that the face points towards the ball.
    ///
    /// # Errors
    /// [`FemError::Input`] if it points away.
    fn check_face(&self) -> Result<(), FemError> {
        let nodes = self.nodes();
        let mut out = Vec3::zero();
        for quad in self.face().0 {
            let [a, b, c, d] = quad.map(|n| nodes[n as usize]);
            out += (c - a).cross(d - b);
        }
        if out.dot(face_axes(self.loft())[0]) > 0.5 * out.norm() {
            return Ok(());
        }
        let allowed = "its normal must be within 60 degrees of that of the loft: list the corners counterclockwise seen from outside, and let x point towards the target";
        Err(FemError::input("face", "turned away from the ball", allowed))
    }

    /// Mass, mass centre and inertia.
    fn mass_properties(&self) -> MassProperties {
        let masses: Vec<f64> = self.masses().translation.iter().map(|m| m.re()).collect();
        mass_properties(self.nodes(), &masses)
    }
}

/// Unit vectors of a face of the given loft (rad) at its centre: its normal, up the face, and to the toe.
#[must_use]
pub fn face_axes(loft: f64) -> [Vec3<f64>; 3] {
    let (s, c) = loft.sin_cos();
    [Vec3::new(c, s, 0.0), Vec3::new(-s, c, 0.0), Vec3::new(0.0, 0.0, 1.0)]
}

/// Adds masses to the nodes that carry them.
pub(super) fn add_masses<R: Real>(masses: &mut [R], added: &[f64]) {
    for (mass, &more) in masses.iter_mut().zip(added) {
        *mass += R::from_f64(more);
    }
}
