//! Laws of materials: stress is the derivative of energy, knows no rotation, and has the moduli it claims.

use super::support::Random;
use clubface_fem::material::{
    Hardening, Hencky, Isochoric, Kinematics, Material, MooneyRivlin, NeoHookean, Ogden, OgdenTerm, Shape,
    UseLaw, VonMises,
};
use clubface_math::{Dual, Mat3, Pack, PackKernel, Real, Scalar, Vec3};

/// Every law, with a shear modulus of 10 MPa and a bulk modulus of 40 MPa.
fn materials<R: Real>() -> Vec<(&'static str, Material<R>)> {
    let c = R::from_f64;
    [
        ("Mooney-Rivlin", Shape::MooneyRivlin(MooneyRivlin { c10: c(4e6), c01: c(1e6) })),
        ("neo-Hookean", Shape::NeoHookean(NeoHookean { shear: c(10e6) })),
        ("Hencky", Shape::Hencky(Hencky { shear: c(10e6) })),
        ("von Mises", Shape::VonMises(VonMises { shear: c(10e6), hardening: Hardening::elastic() })),
        // Half the sum of mu alpha: 10 MPa.
        ("Ogden, one term", Shape::Ogden(ogden(&[(-4e6, -5.0)]))),
        ("Ogden, two terms", Shape::Ogden(ogden(&[(4e6, 3.5), (-3e6, -2.0)]))),
        ("Ogden, three terms", Shape::Ogden(ogden(&[(10e6, 1.3), (0.6e6, 5.0), (-2e6, -2.0)]))),
    ]
    .map(|(name, shape)| (name, Material { shape, bulk: c(40e6), maxwell: vec![], density: c(1000.0) }))
    .into()
}

/// Ogden's rubber from mu (Pa) and alpha of each term.
fn ogden<R: Real>(terms: &[(f64, f64)]) -> Ogden<R> {
    let term = |&(mu, alpha): &(f64, f64)| OgdenTerm { mu: R::from_f64(mu), alpha: R::from_f64(alpha) };
    Ogden::new(&terms.iter().map(term).collect::<Vec<_>>())
}

/// Energy (J/m3) and first Piola-Kirchhoff stress (Pa) at a deformation gradient.
struct At<P>(Mat3<P>, P);

impl<P: Pack> UseLaw<P> for At<P> {
    type Output = (P, Mat3<P>);
    fn with<L: Isochoric<P>>(self, law: L) -> Self::Output {
        let at = Kinematics::new(self.0);
        let dilation = at.deformation.volume - 1.0;
        let stress = at.first_piola(&self.0, &law.stress(&at.c), self.1 * dilation);
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

/// Largest difference of the first Piola-Kirchhoff stresses and of the energies of two laws, over the shear modulus of 10 MPa.
fn apart(a: &Shape<f64>, b: &Shape<f64>) -> f64 {
    let of = |shape: &Shape<f64>| Material { shape: *shape, bulk: 40e6, maxwell: vec![], density: 1e3 };
    let (a, b) = (of(a), of(b));
    let mut most = 0.0_f64;
    for f in deformations().iter().chain(&[Mat3::diagonal(1.0)]) {
        let ((energy, stress), (other, against)) = (evaluate(&a, *f), evaluate(&b, *f));
        most = most.max((energy - other).abs());
        for (x, y) in elements(&stress).iter().zip(elements(&against)) {
            most = most.max((x - y).abs());
        }
    }
    most / 10e6
}

#[test]
fn ogden_with_even_exponents_is_mooney_and_rivlins() {
    // Rounding of stretches up to 2.5, to the power of four.
    let one = apart(&Shape::Ogden(ogden(&[(10e6, 2.0)])), &Shape::NeoHookean(NeoHookean { shear: 10e6 }));
    let rivlin = Shape::MooneyRivlin(MooneyRivlin { c10: 4e6, c01: 1e6 });
    let two = apart(&Shape::Ogden(ogden(&[(8e6, 2.0), (-2e6, -2.0)])), &rivlin);
    assert!(one < 1e-12 && two < 1e-12, "{one} {two}");
}

/// Force over the undeformed section (Pa) of a bar of incompressible rubber in tension: that along it, less the pressure that keeps
/// its sides free.
fn tension(law: &Shape<f64>, stretch: f64) -> f64 {
    let material = Material { shape: *law, bulk: 1e9, maxwell: vec![], density: 1e3 };
    let across = stretch.powf(-0.5);
    let f = Mat3::from_rows(
        Vec3::new(stretch, 0.0, 0.0),
        Vec3::new(0.0, across, 0.0),
        Vec3::new(0.0, 0.0, across),
    );
    let stress = evaluate(&material, f).1;
    // A pressure p adds p / stretch along the bar and p / across to the sides.
    stress.rows[0].x - stress.rows[1].y * across / stretch
}

#[test]
fn tension_of_ogdens_rubber() {
    // Ogden's constants for Treloar's vulcanised rubber, and the closed form of its tension (Proc. R. Soc. Lond. A 326, 1972):
    // sum of mu (l^(alpha - 1) - l^(-alpha/2 - 1)).
    let terms = [(0.63e6, 1.3), (1.2e3, 5.0), (-10e3, -2.0)];
    let law = Shape::Ogden(ogden(&terms));
    for stretch in [0.5, 0.8, 1.0, 1.12, 2.0, 3.58, 5.0, 7.0] {
        let f = |(mu, alpha): (f64, f64)| {
            mu * (f64::powf(stretch, alpha - 1.0) - stretch.powf(-0.5 * alpha - 1.0))
        };
        let exact: f64 = terms.map(f).iter().sum();
        // Rounding to a stretch of 5; the series of the logarithm ends at 1e-12 beyond. Over the shear modulus.
        assert!((tension(&law, stretch) - exact).abs() < 1e-11 * 0.4225e6, "{stretch}: {exact}");
    }
}

/// Stresses at eight deformations by packs, as wide as the CPU has.
struct Wide<'a>(&'a Material<f64>, &'a [Mat3<f64>]);

impl PackKernel<f64> for Wide<'_> {
    type Output = Vec<[f64; 9]>;
    fn run<P: Pack<Real = f64>>(self) -> Self::Output {
        let mut found = Vec::new();
        for some in self.1.chunks_exact(P::LANES) {
            let lanes: Vec<_> = some.iter().map(elements).collect();
            let f = std::array::from_fn(|i| P::load(&lanes.iter().map(|e| e[i]).collect::<Vec<_>>()));
            let stress = elements(&self.0.with_law::<P, _>(At(matrix(f), P::splat(self.0.bulk))).1);
            found.extend((0..P::LANES).map(|lane| stress.map(|s| s.lane(lane))));
        }
        found
    }
}

#[test]
fn lanes_are_numbers_on_their_own() {
    let many = deformations();
    for (name, material) in materials::<f64>() {
        let wide = f64::dispatch(Wide(&material, &many[..8]));
        for (f, lane) in many.iter().zip(&wide) {
            // Multiplications and sums may be one operation in one width and two in another.
            let alone = elements(&evaluate(&material, *f).1);
            let size = alone.iter().fold(1e6, |m: f64, s| m.max(s.abs()));
            assert!(alone.iter().zip(lane).all(|(a, b)| (a - b).abs() < 1e-12 * size), "{name}");
        }
        assert_eq!(wide.len(), 8);
    }
}
