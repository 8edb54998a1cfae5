//! Unit quaternions: the attitude of the clubhead relative to its attitude at first touch.

use crate::mat3::Mat3;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// A quaternion w + xi + yj + zk.
#[derive(Clone, Copy, Debug)]
pub struct Quat<S> {
    /// Scalar part.
    pub w: S,
    /// Vector part.
    pub v: Vec3<S>,
}

impl<S: Scalar> Quat<S> {
    /// No rotation.
    #[inline(always)]
    pub fn identity() -> Self {
        Self { w: S::one(), v: Vec3::zero() }
    }
    /// Time derivative of the attitude for an angular velocity in body axes, rad/s.
    #[inline(always)]
    #[must_use]
    pub fn rate(self, body_spin: Vec3<S>) -> Self {
        Self {
            w: self.v.dot(body_spin) * -0.5,
            v: (body_spin * self.w + self.v.cross(body_spin)) * S::from_f64(0.5),
        }
    }
    /// Rotation matrix (body to reference axes); the quaternion need not be of unit length.
    #[inline(always)]
    pub fn matrix(self) -> Mat3<S> {
        let Self { w, v } = self;
        let scale = (w * w + v.norm_squared()).recip() * 2.0;
        let (xx, yy, zz) = (v.x * v.x, v.y * v.y, v.z * v.z);
        let (xy, xz, yz) = (v.x * v.y, v.x * v.z, v.y * v.z);
        let (wx, wy, wz) = (w * v.x, w * v.y, w * v.z);
        Mat3::from_rows(
            Vec3::new(-(yy + zz) * scale + 1.0, (xy - wz) * scale, (xz + wy) * scale),
            Vec3::new((xy + wz) * scale, -(xx + zz) * scale + 1.0, (yz - wx) * scale),
            Vec3::new((xz - wy) * scale, (yz + wx) * scale, -(xx + yy) * scale + 1.0),
        )
    }
}
