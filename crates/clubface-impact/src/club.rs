//! The clubhead.

use clubface_math::{Mat3, Scalar, Vec3};

use crate::face::{Face, curvature};
use crate::head_inertia::{HeadInertia, SPATIAL_COUNT, SpatialMatrix};

/// Mass properties and face of a clubhead, in Caldwell and McPhee's axes with the club at its static loft (meanings and
/// signs: [`crate::shot::INPUTS`]). A left-handed club is the mirror image of the right-handed one of the same numbers.
#[derive(Clone, Copy, Debug)]
pub struct Club<S> {
    /// Mass, kg.
    pub mass: S,
    /// Vector from CG to face centre, m.
    pub cg_to_face: Vec3<S>,
    /// Inertia about the CG, kg m2: xx, yy, zz, xy, xz, yz.
    pub inertia: [S; 6],
    /// Static loft, rad.
    pub static_loft: S,
    /// Bulge radius, m, infinite if flat.
    pub bulge: S,
    /// Roll radius, m, infinite if flat.
    pub roll: S,
    /// Width of the face outline, m.
    pub face_width: S,
    /// Height of the face outline, m.
    pub face_height: S,
    /// Characteristic time of the face, s; 0 is rigid.
    pub characteristic_time: S,
    /// 1 for a right-hander, -1 for a left-hander.
    pub hand: S,
    /// What shaft and hands add to the inertia about the CG, as of [`SpatialMatrix::from_values`].
    pub added: [S; SPATIAL_COUNT],
}

impl<S: Scalar> Club<S> {
    /// Face curvatures.
    #[inline(always)]
    pub fn face(&self) -> Face<S> {
        Face { bulge: curvature(self.bulge), roll: curvature(self.roll) }
    }
    /// Vector from CG to face centre in face axes, m.
    #[inline(always)]
    pub fn lever(&self) -> Vec3<S> {
        Mat3::rotation_z(self.static_loft.sin_cos()).transpose() * self.cg_to_face
    }
    /// Inertia about the CG in face axes.
    #[inline(always)]
    pub fn head_inertia(&self) -> HeadInertia<S> {
        let turn = Mat3::rotation_z(self.static_loft.sin_cos());
        let inertia = turn.transpose() * (Mat3::symmetric(self.inertia) * turn);
        let added = SpatialMatrix::from_values(&self.added).map(|added| added.in_axes(turn));
        HeadInertia { mass: self.mass, inertia, added }
    }
}
