//! Laws of materials: stress is the derivative of energy, knows no rotation, and has the moduli it claims.

use super::support::Random;
use clubface_fem::material::{
    Hencky, Isochoric, Kinematics, Material, MooneyRivlin, NeoHookean, Shape, UseLaw,
};
use clubface_math::{Dual, Mat3, Pack, Real, Scalar, Vec3};

/// Every law, with a shear modulus of 10 MPa and a bulk modulus of 40 MPa.
fn materials<R: Real>() -> Vec<(&'static str, Material<R>)> {
    let c = R::from_f64;
    [
        ("Mooney-Rivlin", Shape::MooneyRivlin(MooneyRivlin { c10: c(4e6), c01: c(1e6) })),
        ("neo-Hookean", Shape::NeoHookean(NeoHookean { shear: c(10e6) })),
        ("Hencky", Shape::Hencky(Hencky { shear: c(10e6) })),
    ]
    .map(|(name, shape)| (name, Material { shape, bulk: c(40e6), maxwell: vec![], density: c(1000.0) }))
    .into()
}

/// Energy (J/m3) and first Piola-Kirchhoff stress (Pa) at a deformation gradient.
struct At<P>(Mat3<P>, P);

impl<P: Pack> UseLaw<P> for At<P> {
    type Output = (P, Mat3<P>);
    fn with<L: Isochoric<P>>(self, law: L) -> Self::Output {
        let at = Kinematics::new(self.0);
        let dilation = at.volume - 1.0;
        let stress = at.first_piola(&law.stress(&at.c), self.1 * dilation);
        (law.energy(&at.c) + self.1 * dilation * dilation * 0.5, stress)
    }
}

fn evaluate<R: Pack<Real = R> + Real>(material: &Material<R>, f: Mat3<R>) -> (R, Mat3<R>) {
    material.with_law::<R, _>(At(f, material.bulk))
}

fn elements<S: Scalar>(m: &Mat3<S>) -> [S; 9] {
    let [a, b, c] = m.rows;
    [a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z]
}

fn matrix<S: Scalar>(e: [S; 9]) -> Mat3<S> {
    Mat3::from_rows(Vec3::of(&e, 0), Vec3::of(&e, 3), Vec3::of(&e, 6))
}

/// Deformations up to a third in every component, where elements live.
fn deformations() -> Vec<Mat3<f64>> {
    let mut random = Random(1);
    let determinant = |f: &Mat3<f64>| f.rows[0].dot(f.rows[1].cross(f.rows[2]));
    (0..200).map(|_| random.gradient(0.33)).filter(|f| (0.5..1.7).contains(&determinant(f))).collect()
}

#[test]
fn stress_is_the_derivative_of_energy() {
    // Exact derivatives on both sides: only rounding is left, and what four Newton steps leave of the cube root (1e-12).
    for (name, material) in materials::<Dual<f64, 9>>() {
        for f in deformations() {
            let mut variables = elements(&f).map(Dual::constant);
            for (i, variable) in variables.iter_mut().enumerate() {
                variable.tangent[i] = 1.0;
            }
            let (energy, stress) = evaluate(&material, matrix(variables));
            let stress = elements(&stress).map(|s| s.value);
            let size = stress.iter().fold(1e6, |m: f64, s| m.max(s.abs()));
            for i in 0..9 {
                assert!(
                    (energy.tangent[i] - stress[i]).abs() < 1e-10 * size,
                    "{name}: {} {}",
                    energy.tangent[i],
                    stress[i]
                );
            }
        }
    }
}

#[test]
fn rotation_turns_stress_and_leaves_energy() {
    // Rounding only.
    let mut random = Random(2);
    for (name, material) in materials::<f64>() {
        for f in deformations() {
            let turn = random.rotation();
            let (energy, stress) = evaluate(&material, f);
            let (turned_energy, turned_stress) = evaluate(&material, turn * f);
            assert!((energy - turned_energy).abs() < 1e-11 * energy, "{name}");
            let (expected, found) = (elements(&(turn * stress)), elements(&turned_stress));
            for i in 0..9 {
                assert!((expected[i] - found[i]).abs() < 1e-11 * 40e6, "{name}");
            }
        }
    }
}

#[test]
fn small_strains_meet_the_moduli() {
    // The tangent at rest, exact but for rounding: mu in shear, K + 4/3 mu along a stretch, K - 2/3 mu across it.
    for (name, material) in materials::<Dual<f64, 1>>() {
        let tangent = |row: usize, column: usize| {
            let mut f = elements(&Mat3::diagonal(Dual::constant(1.0)));
            f[3 * row + column].tangent[0] = 1.0;
            elements(&evaluate(&material, matrix(f)).1).map(|s| s.tangent[0])
        };
        let (shear, bulk) = (material.shear().value, material.bulk.value);
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-10 * bulk, "{name}: {a} {b}");
        close(shear, 10e6);
        close(tangent(0, 1)[1], shear);
        close(tangent(0, 1)[3], shear);
        close(tangent(1, 1)[4], bulk + 4.0 / 3.0 * shear);
        close(tangent(1, 1)[8], bulk - 2.0 / 3.0 * shear);
        close(tangent(1, 1)[1], 0.0);
    }
}
