//! What solids are made of: a law for the change of shape, one file each, and one common law for the change of volume.
//!
//! Every law is an energy per unit reference volume, `W(C̄) + K/2 (J - 1)^2` with `C̄ = J^(-2/3) F^T F`, so that nearly incompressible
//! rubber and compressible plastics are treated alike (Holzapfel, Nonlinear Solid Mechanics, 2000, section 6.4).

mod check;
mod hardening;
mod hencky;
mod inelastic;
mod mooney_rivlin;
mod neo_hookean;
mod ogden;
mod plane_stress;
mod registry;
mod state_variables;
pub(crate) mod stretch;
mod symmetric;
mod viscous;
mod von_mises;

pub use hardening::{Hardening, HARDENING_POINTS};
pub use hencky::Hencky;
pub use inelastic::{InelasticLaw, PointEnergy, UseInelastic};
pub use mooney_rivlin::MooneyRivlin;
pub use neo_hookean::NeoHookean;
pub use ogden::{Ogden, OgdenTerm, OGDEN_TERMS};
pub use plane_stress::{PlaneState, PlaneStress};
pub use registry::{Constant, LawInfo, LAWS};
pub use state_variables::{eight_alike, Eight, Numbers, State, StateVariables, Update, Updates};
pub use symmetric::{times, Symmetric};
pub use viscous::{add_branches, work, Branches, Decay, Maxwell, MAX_TERMS};
pub use von_mises::{PlasticState, VonMises};

use clubface_math::{Computation, Mat3, Pack, Real, Scalar, Vec3};
use std::marker::PhantomData;

/// A law for the change of shape: an energy of the modified right Cauchy-Green tensor `C̄` (determinant one).
pub trait Isochoric<S: Scalar>: Copy {
    /// `2 dW/dC̄`, Pa, but for a multiple of `C̄^-1`, which changes no shape and is taken out of any stress.
    fn stress(&self, c: &Symmetric<S>) -> Symmetric<S>;
    /// W, J/m3.
    fn energy(&self, c: &Symmetric<S>) -> S;
    /// Second Piola-Kirchhoff stress with `pressure`, `dW/dJ`, times a weight.
    #[inline(always)]
    fn second_piola(&self, at: &Deformation<S>, pressure: S, weight: S) -> Symmetric<S> {
        let kinematics = Kinematics::of(*at);
        kinematics.second_piola(&self.stress(&kinematics.c), pressure, weight)
    }
}

/// A law that is an energy of the first two invariants alone, `tr C̄` and `tr C̄^-1`.
pub trait OfInvariants<S: Scalar>: Copy {
    /// Factors (Pa) of the identity and of `C̄` in `2 dW/dC̄`; what is left goes along `C̄^-1`.
    fn factors(&self, first: S, second: S) -> [S; 2];
    /// W, J/m3.
    fn energy(&self, c: &Symmetric<S>) -> S;
}

/// Laws of the invariants as laws of the change of shape.
macro_rules! of_invariants {
    ($($law:ident)+) => {$(
        impl<S: Scalar> Isochoric<S> for $law<S> {
            #[inline(always)]
            fn stress(&self, c: &Symmetric<S>) -> Symmetric<S> {
                let [one, along] = self.factors(c.trace(), c.cofactors().trace());
                c.scale(along).plus_diagonal(one)
            }
            #[inline(always)]
            fn energy(&self, c: &Symmetric<S>) -> S {
                OfInvariants::energy(self, c)
            }
            #[inline(always)]
            fn second_piola(&self, at: &Deformation<S>, pressure: S, weight: S) -> Symmetric<S> {
                // As any law, in fewer operations.
                let cofactors = at.right.cofactors();
                let shape = at.root * at.root;
                let inverse_volume = shape * at.root;
                let first = at.right.trace() * shape;
                let second = cofactors.trace() * (shape * shape);
                let [one, along] = self.factors(first, second);
                // S : C̄ = one tr C̄ + along tr C̄^2, and J C^-1 = cof C / J.
                let square = first.mul_add(first, -(second + second));
                let mean = along.mul_add(square, one * first) * (inverse_volume * (1.0 / 3.0));
                let weighted = shape * weight;
                let sum = cofactors.scale((pressure - mean) * (inverse_volume * weight));
                sum.plus(along * (shape * weighted), &at.right).plus_diagonal(one * weighted)
            }
        }
    )+};
}

of_invariants!(MooneyRivlin NeoHookean Hencky Ogden);

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

#[inline(always)]
pub(crate) fn cross<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Vec3<S> {
    Vec3::new(a.y.mul_add(b.z, -(a.z * b.y)), a.z.mul_add(b.x, -(a.x * b.z)), a.x.mul_add(b.y, -(a.y * b.x)))
}
#[inline(always)]
pub(crate) fn dot<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> S {
    a.z.mul_add(b.z, a.y.mul_add(b.y, a.x * b.x))
}
/// `J^(-1/3)` from a parabola through J = 0.5, 1, 1.7, within 2% there. With `h = 1 - J y^3` the root is `y (1 - h)^(-1/3)`, whose series to the
/// third order leaves `h^4/7`: two steps are exact there. They lead to the root for J between 0.3 and 2.5, beyond which an element is lost.
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

/// A law by name, with its constants.
#[derive(Clone, Copy, Debug)]
pub enum Shape<R> {
    /// Mooney and Rivlin's rubber.
    MooneyRivlin(MooneyRivlin<R>),
    /// Neo-Hookean rubber.
    NeoHookean(NeoHookean<R>),
    /// Linear elasticity in logarithmic strain.
    Hencky(Hencky<R>),
    /// Ogden's rubber, powers of the principal stretches.
    Ogden(Ogden<R>),
    /// Metal that yields.
    VonMises(VonMises<R>),
}

/// A material: change of shape, change of volume, creep, density.
#[derive(Clone, Debug)]
pub struct Material<R> {
    /// Law of the change of shape.
    pub shape: Shape<R>,
    /// Bulk modulus K, Pa.
    pub bulk: R,
    /// Viscoelastic terms, none for an elastic material.
    pub maxwell: Vec<Maxwell<R>>,
    /// Density, kg/m3.
    pub density: R,
}

impl<R: Real> Shape<R> {
    /// Shear modulus of small deformation, Pa.
    pub fn shear(&self) -> R {
        match self {
            Self::MooneyRivlin(law) => (law.c10 + law.c01) * 2.0,
            Self::NeoHookean(law) => law.shear,
            Self::Hencky(law) => law.shear,
            Self::Ogden(law) => law.shear(),
            Self::VonMises(law) => law.shear,
        }
    }
}

impl<R: Real> Material<R> {
    /// Shear modulus of small, slow deformation, Pa.
    pub fn shear(&self) -> R {
        self.shape.shear()
    }
    /// Shear modulus of small, fast deformation, Pa.
    pub fn instantaneous_shear(&self) -> R {
        let mut sum = R::one();
        for term in &self.maxwell {
            sum += term.modulus;
        }
        self.shear() * sum
    }
    /// Runs a computation with the law of the change of shape spread over packs; of a metal that yields, the law before it does.
    #[inline(always)]
    pub fn with_law<P: Pack<Real = R>, U: UseLaw<P>>(&self, computation: U) -> U::Output {
        match &self.shape {
            Shape::MooneyRivlin(law) => P::outline(Under::law(computation, law.splat::<P>())),
            Shape::NeoHookean(law) => P::outline(Under::law(computation, law.splat::<P>())),
            Shape::Hencky(law) => P::outline(Under::law(computation, law.splat::<P>())),
            Shape::Ogden(law) => P::outline(Under::law(computation, law.splat::<P>())),
            Shape::VonMises(law) => {
                P::outline(Under::law(computation, Hencky { shear: law.shear }.splat::<P>()))
            }
        }
    }
}

/// A computation for [`Material::with_law`].
pub trait UseLaw<P: Scalar> {
    /// What it returns.
    type Output;
    /// Runs it; implement with `#[inline(always)]`.
    fn with<L: Isochoric<P>>(self, law: L) -> Self::Output;
}

/// A computation under a law, as a function of its own: one of all laws would be too large to compile in reasonable time.
struct Under<P, U, L> {
    computation: U,
    law: L,
    pack: PhantomData<P>,
}

impl<P, U, L> Under<P, U, L> {
    #[inline(always)]
    fn law(computation: U, law: L) -> Self {
        Self { computation, law, pack: PhantomData }
    }
}

impl<P: Scalar, U: UseLaw<P>, L: Isochoric<P>> Computation for Under<P, U, L> {
    type Output = U::Output;
    #[inline(always)]
    fn run(self) -> U::Output {
        self.computation.with(self.law)
    }
}
