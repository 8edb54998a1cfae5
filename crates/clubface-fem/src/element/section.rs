//! The section of a shell: from strain increments to stress resultants through the thickness.

use super::quadrilateral::{Increment, Resultants, HOURGLASS};
use clubface_math::{Pack, Scalar};

/// Share of the section that carries transverse shear.
const SHEAR_SHARE: f64 = 5.0 / 6.0;

/// Elastic constants of a shell.
#[derive(Clone, Copy, Debug)]
pub struct Isotropic<R> {
    /// Young's modulus E, Pa.
    pub young: R,
    /// Poisson's ratio.
    pub poisson: R,
}

impl<R: Scalar> Isotropic<R> {
    /// Shear modulus, Pa.
    #[inline(always)]
    pub fn shear(&self) -> R {
        self.young / (self.poisson + 1.0) * 0.5
    }
    /// `E / (1 - nu^2)`, Pa.
    #[inline(always)]
    pub fn plate(&self) -> R {
        self.young / (R::one() - self.poisson * self.poisson)
    }
    /// Both constants in every lane.
    #[inline(always)]
    pub fn splat<P: Pack<Real = R>>(&self) -> Isotropic<P> {
        Isotropic { young: P::splat(self.young), poisson: P::splat(self.poisson) }
    }
}

/// Stiffness of sections of one thickness a lane.
pub struct Section<P> {
    elastic: Isotropic<P>,
    plate: P,
    shear: P,
    thickness: P,
    /// Second moment of area over width, m3.
    moment: P,
}

impl<P: Scalar> Section<P> {
    /// Of a thickness, m.
    #[inline(always)]
    pub fn new(elastic: Isotropic<P>, plate: P, shear: P, thickness: P) -> Self {
        let moment = thickness * thickness * thickness * (1.0 / 12.0);
        Self { elastic, plate, shear, thickness, moment }
    }

    /// Stiffness of the hourglass modes of an element with the given ratio of sides (across over along, and its inverse).
    #[inline(always)]
    pub fn hourglass(&self, (across, along): (P, P)) -> [P; HOURGLASS] {
        let membrane = self.elastic.young * self.thickness * (4.0 / 3.0);
        let bending = self.plate * self.moment * (4.0 / 3.0);
        let torsion = self.shear * self.moment * (4.0 / 3.0);
        let shear = self.shear * self.thickness * (SHEAR_SHARE * 4.0 / 3.0);
        [
            membrane * across,
            membrane * along,
            bending * across + torsion * along,
            bending * along + torsion * across,
            shear * across,
            shear * along,
        ]
    }

    /// Plane stress from strain, both of them resultants or both at a point.
    #[inline(always)]
    pub fn stress(&self, e: &[P; 3]) -> [P; 3] {
        let nu = self.elastic.poisson;
        [self.plate * (e[0] + nu * e[1]), self.plate * (e[1] + nu * e[0]), self.shear * e[2]]
    }

    /// Adds the elastic response to a strain increment.
    #[inline(always)]
    pub fn respond(&self, increment: &Increment<P>, hourglass: &[P; HOURGLASS], r: &mut Resultants<P>) {
        let (n, m) = (self.stress(&increment.membrane), self.stress(&increment.curvature));
        let shear = self.shear * self.thickness * SHEAR_SHARE;
        for i in 0..3 {
            r.membrane[i] += self.thickness * n[i];
            r.bending[i] += self.moment * m[i];
        }
        for i in 0..2 {
            r.shear[i] += shear * increment.shear[i];
        }
        for i in 0..HOURGLASS {
            r.hourglass[i] += hourglass[i] * increment.hourglass[i];
        }
    }

    /// Elastic energy of the resultants over an area, and of the hourglass modes, J.
    #[inline(always)]
    pub fn energy(&self, r: &Resultants<P>, area: P, hourglass: &[P; HOURGLASS]) -> (P, P) {
        let nu = self.elastic.poisson;
        let half = (self.elastic.young * 2.0).recip();
        let shear = (r.shear[0] * r.shear[0] + r.shear[1] * r.shear[1])
            / (self.shear * self.thickness * (2.0 * SHEAR_SHARE));
        let membrane = complementary(&r.membrane, nu) * half / self.thickness;
        let bending = complementary(&r.bending, nu) * half / self.moment;
        let mut stabilising = P::zero();
        for i in 0..HOURGLASS {
            stabilising += r.hourglass[i] * r.hourglass[i] / hourglass[i] * 0.5;
        }
        ((membrane + bending + shear) * area, stabilising)
    }
}

/// `E` times strain times stress of plane stress.
#[inline(always)]
fn complementary<P: Scalar>(s: &[P; 3], nu: P) -> P {
    let sum = s[0] + s[1];
    sum * sum + (nu + 1.0) * (s[2] * s[2] - s[0] * s[1]) * 2.0
}
