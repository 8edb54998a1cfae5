//! The section of a shell: from strain increments to stress resultants through the thickness.

use super::quadrilateral::{Across, HOURGLASS, Increment};
use crate::material::Numbers;
use clubface_math::{Pack, Scalar};

/// Share of the section that carries transverse shear.
const SHEAR_SHARE: f64 = 5.0 / 6.0;

/// Stiffness of drilling over that of shear in the plane: enough to hold it, too little to shorten the stable step.
const DRILLING: f64 = 0.1;

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
    /// Thickness, m.
    pub thickness: P,
    /// Second moment of area over width, m3.
    moment: P,
}

impl<P: Scalar> Section<P> {
    /// A section with a thickness, m.
    #[inline(always)]
    pub fn new(elastic: Isotropic<P>, plate: P, shear: P, thickness: P) -> Self {
        let moment = thickness.product(thickness).product(thickness) * (1.0 / 12.0);
        Self { elastic, plate, shear, thickness, moment }
    }

    /// Stiffness of the stabilised modes of an element with the given area and ratio of sides (across over along, and
    /// its inverse).
    #[inline(always)]
    pub fn hourglass(&self, area: P, (across, along): (P, P)) -> [P; HOURGLASS] {
        let membrane = self.elastic.young.product(self.thickness) * (4.0 / 3.0);
        let bending = self.plate.product(self.moment) * (4.0 / 3.0);
        let torsion = self.shear.product(self.moment) * (4.0 / 3.0);
        let shear = self.shear.product(self.thickness) * (SHEAR_SHARE * 4.0 / 3.0);
        [
            membrane.product(across),
            membrane.product(along),
            bending.mul_add(across, torsion.product(along)),
            bending.mul_add(along, torsion.product(across)),
            shear.product(across),
            shear.product(along),
            self.shear.product(self.thickness).product(area) * DRILLING,
        ]
    }

    /// Plane stress from strain, both of them resultants or both at a point.
    #[inline(always)]
    pub fn stress(&self, e: &[P; 3]) -> [P; 3] {
        let nu = self.elastic.poisson;
        let [x, y] = [nu.mul_add(e[1], e[0]), nu.mul_add(e[0], e[1])];
        [self.plate.product(x), self.plate.product(y), self.shear.product(e[2])]
    }

    /// Elastic strain of plane stress: xx, yy, xy, zz.
    #[inline(always)]
    pub fn strain(&self, &[x, y, xy]: &[P; 3]) -> [P; 4] {
        let (nu, soft) = (self.elastic.poisson, self.elastic.young.recip());
        [(x - nu * y) * soft, (y - nu * x) * soft, xy * (nu + 1.0) * soft, -((x + y) * nu) * soft]
    }

    /// Elastic energy of plane stress, J/m3.
    #[inline(always)]
    pub fn energy(&self, s: &[P; 3]) -> P {
        let sum = s[0] + s[1];
        let twice = sum * sum + (self.elastic.poisson + 1.0) * (s[2] * s[2] - s[0] * s[1]) * 2.0;
        twice / (self.elastic.young * 2.0)
    }

    /// Adds the response to transverse shear and to the hourglass modes, which is elastic in any metal.
    #[inline(always)]
    pub fn respond_across(
        &self,
        increment: &Increment<P>,
        hourglass: &[P; HOURGLASS],
        across: &mut Across<P>,
    ) {
        let shear = self.shear.product(self.thickness) * SHEAR_SHARE;
        for i in 0..2 {
            across.shear[i] = shear.mul_add(increment.shear[i], across.shear[i]);
        }
        for i in 0..HOURGLASS {
            across.hourglass[i] = hourglass[i].mul_add(increment.hourglass[i], across.hourglass[i]);
        }
    }

    /// Elastic energy of transverse shear over an area, and of the hourglass modes, J.
    #[inline(always)]
    pub fn energy_across(&self, across: &Across<P>, area: P, hourglass: &[P; HOURGLASS]) -> (P, P) {
        let [x, y] = across.shear;
        let shear = (x * x + y * y) / (self.shear * self.thickness * (2.0 * SHEAR_SHARE));
        let mut stabilising = P::zero();
        for i in 0..HOURGLASS {
            stabilising += across.hourglass[i] * across.hourglass[i] / hourglass[i] * 0.5;
        }
        (shear * area, stabilising)
    }
}

/// Numbers that transverse shear and hourglass modes take.
pub const ACROSS: usize = 2 + HOURGLASS;

impl<P: Pack> Across<P> {
    /// From the first numbers.
    #[inline(always)]
    pub fn load(state: &Numbers<P::Real>) -> Self {
        Self { shear: state.load(0), hourglass: state.load(2) }
    }
    /// Writes them.
    #[inline(always)]
    pub fn store(&self, state: &mut Numbers<P::Real>) {
        state.store(0, self.shear);
        state.store(2, self.hourglass);
    }
}

/// A section that answers to strain.
pub trait SectionResponse<P: Pack> {
    /// Membrane forces and bending moments over width after a strain increment, for the area of the elements; the
    /// state variables move on.
    fn respond(
        &self,
        section: &Section<P>,
        increment: &Increment<P>,
        area: P,
        state: &mut Numbers<P::Real>,
    ) -> [[P; 3]; 2];
}

/// An elastic section: its resultants are all of its state variables.
pub struct ElasticSection;

impl ElasticSection {
    /// Numbers of state.
    pub const LENGTH: usize = ACROSS + 6;
    /// See [`super::response::Response::sides`].
    #[inline(always)]
    pub fn sides<P: Pack>(section: &Section<P>, state: &Numbers<P::Real>) -> ([[P; 3]; 2], P) {
        let (membrane, bending): ([P; 3], [P; 3]) = (state.load(ACROSS), state.load(ACROSS + 3));
        let (mean, slope) = (section.thickness.recip(), section.thickness * 0.5 / section.moment);
        let [mut outer, mut inner] = [[P::zero(); 3]; 2];
        for i in 0..3 {
            outer[i] = membrane[i].mul_add(mean, bending[i] * slope);
            inner[i] = membrane[i].mul_add(mean, -(bending[i] * slope));
        }
        ([outer, inner], P::zero())
    }
    /// See [`super::response::Response::energy`].
    #[inline(always)]
    pub fn energy<P: Pack>(section: &Section<P>, area: P, state: &Numbers<P::Real>) -> (P, P) {
        let membrane = section.energy(&state.load(ACROSS)) / section.thickness;
        let bending = section.energy(&state.load(ACROSS + 3)) / section.moment;
        ((membrane + bending) * area, P::zero())
    }
}

impl<P: Pack> SectionResponse<P> for ElasticSection {
    #[inline(always)]
    fn respond(
        &self,
        section: &Section<P>,
        increment: &Increment<P>,
        _area: P,
        state: &mut Numbers<P::Real>,
    ) -> [[P; 3]; 2] {
        let (n, m) = (section.stress(&increment.membrane), section.stress(&increment.curvature));
        let (mut membrane, mut bending): ([P; 3], [P; 3]) = (state.load(ACROSS), state.load(ACROSS + 3));
        for i in 0..3 {
            membrane[i] = section.thickness.mul_add(n[i], membrane[i]);
            bending[i] = section.moment.mul_add(m[i], bending[i]);
        }
        state.store(ACROSS, membrane);
        state.store(ACROSS + 3, bending);
        [membrane, bending]
    }
}
