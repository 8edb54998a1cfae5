//! Deformation at a point, its change of shape apart from that of volume.

use super::symmetric::{Symmetric, cross, dot, times};
use clubface_math::{Mat3, Scalar};

/// Deformation at a point: what laws see of its gradient.
#[derive(Clone, Copy, Debug)]
pub struct Deformation<S> {
    /// Determinant J of the gradient F.
    pub volume: S,
    /// `J^(-1/3)`.
    pub root: S,
    /// `C = F^T F`.
    pub right: Symmetric<S>,
}

impl<S: Scalar> Deformation<S> {
    /// From the deformation gradient.
    #[inline(always)]
    pub fn new(f: Mat3<S>) -> Self {
        let [a, b, c] = f.rows;
        let volume = dot(a, cross(b, c));
        Self { volume, root: volume.inverse_cube_root(), right: Symmetric::gram(&f) }
    }
}

/// Deformation at a point, with its change of shape apart from that of volume, as the laws need it.
#[derive(Clone, Copy, Debug)]
pub struct Kinematics<S> {
    /// Deformation.
    pub deformation: Deformation<S>,
    /// `1 / J`.
    pub inverse_volume: S,
    /// `J^(-2/3)`.
    pub shape: S,
    /// `C̄`.
    pub c: Symmetric<S>,
    /// `C̄^-1`.
    pub inverse: Symmetric<S>,
}

impl<S: Scalar> Kinematics<S> {
    /// From the deformation gradient; exact for a volume ratio between 0.3 and 2.5.
    #[inline(always)]
    pub fn new(f: Mat3<S>) -> Self {
        Self::from_deformation(Deformation::new(f))
    }
    /// From a deformation.
    #[inline(always)]
    pub fn from_deformation(deformation: Deformation<S>) -> Self {
        let shape = deformation.root.product(deformation.root);
        let c = deformation.right.scale(shape);
        Self {
            deformation,
            inverse_volume: shape.product(deformation.root),
            shape,
            c,
            inverse: c.cofactors(),
        }
    }
    /// First Piola-Kirchhoff stress, from `2 dW/dC̄` and `dW/dJ`, for the gradient.
    #[inline(always)]
    pub fn first_piola(&self, f: &Mat3<S>, stress: &Symmetric<S>, pressure: S) -> Mat3<S> {
        times(f, &self.second_piola(stress, pressure, S::one()))
    }
    /// Second Piola-Kirchhoff stress times a weight, from `2 dW/dC̄` and `dW/dJ`.
    #[inline(always)]
    pub fn second_piola(&self, stress: &Symmetric<S>, pressure: S, weight: S) -> Symmetric<S> {
        // J^(-2/3) [S - (S : C̄)/3 C̄^-1] + p J C^-1, with C^-1 = J^(-2/3) C̄^-1.
        let mean = stress.contract(&self.c) * (1.0 / 3.0);
        let along = pressure.mul_add(self.deformation.volume, -mean);
        stress.plus(along, &self.inverse).scale(self.shape.product(weight))
    }
    /// `2 dW/dC̄` without the part that would change the volume: `S - (S : C̄)/3 C̄^-1`.
    #[inline(always)]
    pub fn deviator(&self, stress: &Symmetric<S>) -> Symmetric<S> {
        stress.plus(stress.contract(&self.c) * (-1.0 / 3.0), &self.inverse)
    }
}
