//! Deformation at a point, its change of shape apart from that of volume.

use super::symmetric::{cross, dot, times, Symmetric};
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
        Self { volume, root: inverse_cube_root(volume), right: Symmetric::gram(&f) }
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
        Self::of(Deformation::new(f))
    }
    /// From a deformation.
    #[inline(always)]
    pub fn of(deformation: Deformation<S>) -> Self {
        let shape = deformation.root * deformation.root;
        let c = deformation.right.scale(shape);
        Self { deformation, inverse_volume: shape * deformation.root, shape, c, inverse: c.cofactors() }
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
        stress.plus(along, &self.inverse).scale(self.shape * weight)
    }
    /// `2 dW/dC̄` without the part that would change the volume: `S - (S : C̄)/3 C̄^-1`.
    #[inline(always)]
    pub fn deviator(&self, stress: &Symmetric<S>) -> Symmetric<S> {
        stress.plus(stress.contract(&self.c) * (-1.0 / 3.0), &self.inverse)
    }
}

/// `J^(-1/3)` from a parabola through J = 0.5, 1, 1.7, within 2% there. With `h = 1 - J y^3` the root is
/// `y (1 - h)^(-1/3)`, whose series to the third order leaves `h^4/7`: two steps are exact there. They lead to the
/// root for J between 0.3 and 2.5, beyond which an element is lost.
#[inline(always)]
fn inverse_cube_root<S: Scalar>(j: S) -> S {
    let mut y = (j * 0.240_2 - 0.880_1).mul_add(j, S::from_f64(1.639_9));
    for _ in 0..2 {
        let h = (-(y * y)).mul_add(y * j, S::one());
        let series = h.mul_add(S::from_f64(14.0 / 81.0), S::from_f64(2.0 / 9.0));
        let series = series.mul_add(h, S::from_f64(1.0 / 3.0));
        y = (y * h).mul_add(series, y);
    }
    y
}
