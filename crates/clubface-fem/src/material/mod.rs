//! What solids are made of: a law for the change of shape, one file each, and one common law for the change of volume.
//!
//! Every law is an energy per unit reference volume, `W(C̄) + K/2 (J - 1)^2` with `C̄ = J^(-2/3) F^T F`, so that nearly incompressible
//! rubber and compressible plastics are treated alike (Holzapfel, Nonlinear Solid Mechanics, 2000, section 6.4).

mod check;
mod hencky;
mod mooney_rivlin;
mod neo_hookean;
mod registry;
mod viscous;

pub use hencky::Hencky;
pub use mooney_rivlin::MooneyRivlin;
pub use neo_hookean::NeoHookean;
pub use registry::{LawInfo, LAWS};
pub use viscous::{add_branches, history_length, Decay, Maxwell, MAX_TERMS};

use clubface_math::{Mat3, Pack, Real, Scalar, Vec3};

/// Six components of a symmetric tensor: xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy, Debug)]
pub struct Symmetric<S>(pub [S; 6]);

impl<S: Scalar> Symmetric<S> {
    /// `value` times the identity.
    #[inline(always)]
    pub fn diagonal(value: S) -> Self {
        let o = S::zero();
        Self([value, value, value, o, o, o])
    }
    /// `A^T A`.
    #[inline(always)]
    pub fn gram(a: &Mat3<S>) -> Self {
        let [r, s, t] = a.rows;
        let (x, y, z) = (Vec3::new(r.x, s.x, t.x), Vec3::new(r.y, s.y, t.y), Vec3::new(r.z, s.z, t.z));
        Self([dot(x, x), dot(y, y), dot(z, z), dot(x, y), dot(x, z), dot(y, z)])
    }
    /// Sum of the diagonal.
    #[inline(always)]
    pub fn trace(&self) -> S {
        self.0[0] + self.0[1] + self.0[2]
    }
    /// Double contraction `A : B`.
    #[inline(always)]
    pub fn contract(&self, o: &Self) -> S {
        let (a, b) = (&self.0, &o.0);
        let diagonal = a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]));
        let shear = a[5].mul_add(b[5], a[4].mul_add(b[4], a[3] * b[3]));
        diagonal + (shear + shear)
    }
    /// `A + s B`.
    #[inline(always)]
    #[must_use]
    pub fn plus(&self, s: S, o: &Self) -> Self {
        let mut sum = self.0;
        for i in 0..6 {
            sum[i] = o.0[i].mul_add(s, sum[i]);
        }
        Self(sum)
    }
    /// `s A`.
    #[inline(always)]
    #[must_use]
    pub fn scale(&self, s: S) -> Self {
        let mut product = self.0;
        for i in 0..6 {
            product[i] = product[i] * s;
        }
        Self(product)
    }
    /// As a matrix.
    #[inline(always)]
    pub fn matrix(&self) -> Mat3<S> {
        Mat3::symmetric(self.0)
    }
    /// `B A B` for symmetric A and B.
    #[inline(always)]
    #[must_use]
    pub fn sandwich(&self, b: &Self) -> Self {
        let product = times(&b.matrix(), self);
        let rows = times(&product, b).rows;
        Self([rows[0].x, rows[1].y, rows[2].z, rows[0].y, rows[0].z, rows[1].z])
    }
}

/// `A B` for symmetric B.
#[inline(always)]
pub fn times<S: Scalar>(a: &Mat3<S>, b: &Symmetric<S>) -> Mat3<S> {
    let [x, y, z] = b.matrix().rows;
    let [r, s, t] = a.rows;
    Mat3::from_rows(
        Vec3::new(dot(r, x), dot(r, y), dot(r, z)),
        Vec3::new(dot(s, x), dot(s, y), dot(s, z)),
        Vec3::new(dot(t, x), dot(t, y), dot(t, z)),
    )
}

/// A law for the change of shape: an energy of the modified right Cauchy-Green tensor `C̄` (determinant one).
pub trait Isochoric<S: Scalar>: Copy {
    /// `2 dW/dC̄`, Pa.
    fn stress(&self, c: &Symmetric<S>) -> Symmetric<S>;
    /// W, J/m3.
    fn energy(&self, c: &Symmetric<S>) -> S;
}

/// Deformation at a point, as the laws need it.
#[derive(Clone, Copy, Debug)]
pub struct Kinematics<S> {
    /// Deformation gradient.
    pub f: Mat3<S>,
    /// Its determinant.
    pub volume: S,
    /// Its cofactors, `J F^-T`.
    pub cofactors: Mat3<S>,
    /// `1 / J`.
    pub inverse_volume: S,
    /// `J^(-2/3)`.
    pub shape: S,
    /// `C̄`.
    pub c: Symmetric<S>,
}

impl<S: Scalar> Kinematics<S> {
    /// From the deformation gradient; exact for a volume ratio between 0.3 and 2.5.
    #[inline(always)]
    pub fn new(f: Mat3<S>) -> Self {
        let [a, b, c] = f.rows;
        let cofactors = Mat3::from_rows(cross(b, c), cross(c, a), cross(a, b));
        let volume = dot(a, cofactors.rows[0]);
        let root = inverse_cube_root(volume);
        let shape = root * root;
        let inverse_volume = shape * root;
        Self { f, volume, cofactors, inverse_volume, shape, c: Symmetric::gram(&f).scale(shape) }
    }
    /// First Piola-Kirchhoff stress, from `2 dW/dC̄` and `dW/dJ`.
    #[inline(always)]
    pub fn first_piola(&self, stress: &Symmetric<S>, pressure: S) -> Mat3<S> {
        self.weighted_piola(stress, pressure, S::one())
    }
    /// First Piola-Kirchhoff stress times a weight.
    #[inline(always)]
    pub fn weighted_piola(&self, stress: &Symmetric<S>, pressure: S, weight: S) -> Mat3<S> {
        // J^(-2/3) [F S - (S : C)/3 F^-T] + p J F^-T.
        let mean = stress.contract(&self.c) * self.inverse_volume * (1.0 / 3.0);
        let (shape, cofactor_part) = (self.shape * weight, (pressure - mean) * weight);
        let shaped = times(&self.f, stress);
        let (s, c) = (&shaped.rows, &self.cofactors.rows);
        Mat3::from_rows(
            combine(s[0], shape, c[0], cofactor_part),
            combine(s[1], shape, c[1], cofactor_part),
            combine(s[2], shape, c[2], cofactor_part),
        )
    }
    /// `2 dW/dC̄` without the part that would change the volume: `S - (S : C̄)/3 C̄^-1`.
    #[inline(always)]
    pub fn deviator(&self, stress: &Symmetric<S>) -> Symmetric<S> {
        // C̄^-1 = cof^T cof J^(-2) / J^(-2/3), with J^(-4/3) = shape^2.
        let inverse = Symmetric::gram(&self.cofactors).scale(self.shape * self.shape);
        stress.plus(stress.contract(&self.c) * (-1.0 / 3.0), &inverse)
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
#[inline(always)]
fn combine<S: Scalar>(a: Vec3<S>, s: S, b: Vec3<S>, t: S) -> Vec3<S> {
    Vec3::new(a.x.mul_add(s, b.x * t), a.y.mul_add(s, b.y * t), a.z.mul_add(s, b.z * t))
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

impl<R: Real> Material<R> {
    /// Shear modulus of small, slow deformation, Pa.
    pub fn shear(&self) -> R {
        match &self.shape {
            Shape::MooneyRivlin(law) => (law.c10 + law.c01) * 2.0,
            Shape::NeoHookean(law) => law.shear,
            Shape::Hencky(law) => law.shear,
        }
    }
    /// Shear modulus of small, fast deformation, Pa.
    pub fn instantaneous_shear(&self) -> R {
        let mut sum = R::one();
        for term in &self.maxwell {
            sum += term.modulus;
        }
        self.shear() * sum
    }
    /// Runs a computation with the law of the change of shape spread over packs.
    #[inline(always)]
    pub fn with_law<P: Pack<Real = R>, U: UseLaw<P>>(&self, computation: U) -> U::Output {
        match &self.shape {
            Shape::MooneyRivlin(law) => computation.with(law.splat::<P>()),
            Shape::NeoHookean(law) => computation.with(law.splat::<P>()),
            Shape::Hencky(law) => computation.with(law.splat::<P>()),
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
