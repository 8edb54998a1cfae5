//! Face geometry: a plane or a torus, nearest point and impact point in closed form.
//!
//! Face frame: origin at the face centre, x outward along the normal, y up the face, z towards the toe. The roll arc
//! lies in the x-y plane and is revolved about the axis parallel to y that lies the bulge radius behind the centre.
//! Everything is written in curvatures, so a plane is the torus of zero curvature and needs no case of its own.

use clubface_math::{Mask, Scalar, Vec3};

/// A face by its curvatures, 1/m (0 is flat).
#[derive(Clone, Copy, Debug)]
pub struct Face<S> {
    /// Horizontal curvature, 1 / bulge radius.
    pub bulge: S,
    /// Vertical curvature, 1 / roll radius.
    pub roll: S,
}

/// The face as the ball sees it.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<S> {
    /// Distance of the point from the face, positive in front of it, m.
    pub distance: S,
    /// Outward unit normal at the nearest face point.
    pub normal: Vec3<S>,
    /// Mean of the two principal curvatures at the nearest face point, 1/m.
    pub curvature: S,
}

/// Signed distance of (x, y) from a circle of curvature `k` through the origin with outward normal +x, and the
/// components of the unit normal there. Regular for k = 0.
#[inline(always)]
fn circle<S: Scalar>(x: S, y: S, k: S) -> (S, S, S) {
    let radial = k * x + 1.0;
    let root = (radial.squared() + (k * y).squared()).sqrt();
    let distance = (x * 2.0 + k * (x.squared() + y.squared())) / (root + 1.0);
    let inverse = root.recip();
    (distance, radial * inverse, k * y * inverse)
}

impl<S: Scalar> Face<S> {
    /// Nearest face point to `p` (face frame, m).
    #[inline(always)]
    pub fn nearest(&self, p: Vec3<S>) -> Nearest<S> {
        let (x1, radial_x, radial_z) = circle(p.x, p.z, self.bulge);
        let (distance, normal_x, normal_y) = circle(x1, p.y, self.roll);
        // Second principal curvature of the torus: cos(angle) / distance of the face point from the axis.
        let along = self.bulge * (x1 - distance * normal_x) + 1.0;
        let other = normal_x * self.bulge / along;
        Nearest {
            distance,
            normal: Vec3::new(normal_x * radial_x, normal_y, normal_x * radial_z),
            curvature: (self.roll + other) * 0.5,
        }
    }

    /// Face point whose offsets in the plane tangent at the centre are `toe` and `high`, m (face frame).
    #[inline(always)]
    pub fn point(&self, toe: S, high: S) -> Vec3<S> {
        let roll_root = (-(self.roll * high).squared() + 1.0).sqrt();
        let x1 = -(self.roll * high.squared()) / (roll_root + 1.0);
        let radial = self.bulge * x1 + 1.0;
        let bulge_root = (radial.squared() - (self.bulge * toe).squared()).sqrt();
        let x = (x1 * 2.0 + self.bulge * (x1.squared() - toe.squared())) / (bulge_root + 1.0);
        Vec3::new(x, high, toe)
    }
}

/// Tangent directions at a face point with normal `normal`: up the face (y') and towards the toe (z').
#[inline(always)]
pub fn tangents<S: Scalar>(normal: Vec3<S>) -> (Vec3<S>, Vec3<S>) {
    let up = Vec3::new(S::zero(), S::one(), S::zero()).reject(normal);
    let up = up * up.norm_squared().sqrt().recip();
    (up, normal.cross(up))
}

/// Curvature of a radius in m: zero for an infinite radius, with a finite derivative.
#[inline(always)]
pub fn curvature<S: Scalar>(radius: S) -> S {
    let flat = radius.gt(S::from_f64(1e12));
    let bounded = S::select(flat, S::one(), radius);
    if flat.all() {
        return S::zero();
    }
    S::select(flat, S::zero(), bounded.recip())
}
