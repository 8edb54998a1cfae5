//! Contracts of the laws of the table: stress is the derivative of energy, knows no rotation, has the moduli it
//! claims, and gives no work away; the same in every kind of number and of packs. A law that is added to the table is
//! tested here with no other line.

mod energies;
mod gent;
mod own;

use crate::support::Random;
use clubface_fem::material::{
    Deformation, Entry, LAWS, Law, Material, MaterialPoint, Maxwell, MooneyRivlin, NeoHookean, Number,
    Points, Symmetric, Update, VolumeLaw, Volumetric, from_table, law_from_name, map_law, times,
};
use clubface_fem::materials;
use clubface_math::{Dual, Mat3, Pack, PackKernel, Scalar, Vec3};
use std::sync::Arc;

materials! {
    /// Laws that exist only in these tests.
    static ADDED;
    gent::Gent<()>;
}

/// Numbers with derivatives.
type Derived = Dual<f64, 4>;

/// All laws.
fn table() -> Vec<Entry> {
    LAWS.iter().chain(ADDED).copied().collect()
}

fn named<R: Number>(name: &str, constants: &[f64]) -> Arc<dyn Law<R>> {
    let constants: Vec<R> = constants.iter().map(|&value| R::from_f64(value)).collect();
    from_table(&table(), name, &constants).expect("the constants are allowed")
}

fn material<R: Number>(law: Arc<dyn Law<R>>) -> Material<R> {
    Material { law, bulk: R::from_f64(40e6), maxwell: vec![], density: R::from_f64(1000.0) }
}

/// Every law with its example, of a shear modulus of 10 MPa, and a bulk modulus of 40 MPa.
fn examples<R: Number>() -> Vec<(String, Material<R>)> {
    let example = |entry: &Entry| {
        let name = entry.description.name;
        (name.to_owned(), material(named::<R>(name, entry.description.example)))
    };
    table().iter().map(example).collect()
}

/// Every law where it is elastic: what yields does not.
fn elastic<R: Number>() -> Vec<(String, Material<R>)> {
    let mut all = examples::<R>();
    all.retain(|(_, material)| material.law.description().state.is_empty());
    // Half the sum of mu alpha: 10 MPa.
    all.push(("Ogden, one term".into(), material(named("ogden", &[-4e6, -5.0]))));
    all.push(("Ogden, two terms".into(), material(named("ogden", &[4e6, 3.5, -3e6, -2.0]))));
    all.push(("von Mises".into(), material(named("von-mises", &[10e6, 1e150, 0.0, 0.0]))));
    all.extend(energies::examples());
    all.extend(own::examples());
    let energy = Arc::new(Volumetric::new("bulk/4*(J^2 - 1 - 2*log(J))").expect("an energy"));
    let rubber = named("mooney-rivlin", &[4e6, 1e6]);
    all.push(("an energy of the volume".into(), material(VolumeLaw::over(rubber, &energy))));
    all
}

/// Energy (J/m3) and first Piola-Kirchhoff stress (Pa) at a deformation gradient.
fn evaluate<R: Number>(material: &Material<R>, f: Mat3<R>) -> (R, Mat3<R>) {
    let mut point = MaterialPoint::new(material);
    (point.energy(&f).strain, point.update(&f, 0.0))
}

fn elements<S: Scalar>(m: &Mat3<S>) -> [S; 9] {
    let [a, b, c] = m.rows;
    [a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z]
}

fn matrix<S: Scalar>(e: [S; 9]) -> Mat3<S> {
    Mat3::from_rows(Vec3::from_slice(&e, 0), Vec3::from_slice(&e, 3), Vec3::from_slice(&e, 6))
}

/// Deformations up to a third in every component, where elements live.
fn deformations() -> Vec<Mat3<f64>> {
    let mut random = Random(1);
    let determinant = |f: &Mat3<f64>| f.rows[0].dot(f.rows[1].cross(f.rows[2]));
    (0..200).map(|_| random.gradient(0.33)).filter(|f| (0.5..1.7).contains(&determinant(f))).collect()
}

#[test]
fn stress_is_the_derivative_of_energy() {
    // Exact derivatives on both sides: only rounding is left, and what four Newton steps leave of the cube root
    // (1e-12).
    for (name, material) in elastic::<Derived>() {
        for f in deformations() {
            for chosen in [0..4, 4..8, 8..9] {
                let mut variables = elements(&f).map(Dual::constant);
                for (direction, i) in chosen.clone().enumerate() {
                    variables[i].tangent[direction] = 1.0;
                }
                let (energy, stress) = evaluate(&material, matrix(variables));
                let stress = elements(&stress).map(|s| s.value);
                let size = stress.iter().fold(1e6, |m: f64, s| m.max(s.abs()));
                for (direction, i) in chosen.enumerate() {
                    let (slope, stress) = (energy.tangent[direction], stress[i]);
                    assert!((slope - stress).abs() < 1e-10 * size, "{name}: {slope} {stress}");
                }
            }
        }
    }
}

#[test]
fn derivatives_of_stress_are_its_differences() {
    // Central differences over 1e-6 of a component: their own error is 1e-12 of third derivatives, rounding over the
    // step 1e-9.
    for (name, material) in elastic::<Derived>() {
        let plain = material_of(&material);
        for f in &deformations()[..20] {
            let direction = elements(&Random(9).gradient(0.3));
            let step = |by: f64| {
                let moved = std::array::from_fn(|i| elements(f)[i] + by * direction[i]);
                elements(&evaluate(&plain, matrix(moved)).1)
            };
            let along = std::array::from_fn(|i| Dual {
                value: elements(f)[i],
                tangent: [direction[i], 0.0, 0.0, 0.0],
            });
            let exact = elements(&evaluate(&material, matrix(along)).1).map(|s| s.tangent[0]);
            let size = exact.iter().fold(1e7, |m: f64, s| m.max(s.abs()));
            for (i, (more, less)) in step(1e-6).iter().zip(step(-1e-6)).enumerate() {
                let difference = (more - less) / 2e-6;
                assert!((difference - exact[i]).abs() < 1e-7 * size, "{name}: {difference} {}", exact[i]);
            }
        }
    }
}

/// The same material in plain numbers.
fn material_of(derived: &Material<Derived>) -> Material<f64> {
    material(map_law(&*derived.law, &mut |_, value| value.value))
}

#[test]
fn rotation_turns_stress_and_leaves_energy() {
    // The same path, seen by someone who turns: rounding only.
    let mut random = Random(2);
    for (name, material) in elastic::<f64>().into_iter().chain(examples()) {
        let [mut still, mut turned] = [(); 2].map(|()| MaterialPoint::new(&material));
        for f in deformations() {
            let turn = random.rotation();
            let (stress, turned_stress) = (still.update(&f, 1e-6), turned.update(&(turn * f), 1e-6));
            let (energy, turned_energy) = (still.energy(&f).strain, turned.energy(&(turn * f)).strain);
            assert!((energy - turned_energy).abs() < 1e-11 * energy, "{name}: {energy} {turned_energy}");
            let (expected, result) = (elements(&(turn * stress)), elements(&turned_stress));
            for i in 0..9 {
                assert!((expected[i] - result[i]).abs() < 1e-11 * 40e6, "{name}: {expected:?} {result:?}");
            }
        }
    }
}

#[test]
fn small_strains_meet_the_moduli() {
    // The tangent at rest, exact but for rounding: mu in shear, K + 4/3 mu along a stretch, K - 2/3 mu across it.
    for (name, material) in elastic::<Derived>() {
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

/// Largest difference of the first Piola-Kirchhoff stresses and of the energies of two laws, over the shear modulus
/// of 10 MPa.
fn apart(a: Arc<dyn Law<f64>>, b: Arc<dyn Law<f64>>) -> f64 {
    let (a, b) = (material(a), material(b));
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
    let one = apart(named("ogden", &[10e6, 2.0]), NeoHookean { shear: 10e6 }.law());
    let rivlin = MooneyRivlin { c10: 4e6, c01: 1e6 }.law();
    let two = apart(named("ogden", &[8e6, 2.0, -2e6, -2.0]), rivlin);
    assert!(one < 1e-12 && two < 1e-12, "{one} {two}");
}

#[test]
fn gent_with_endless_chains_is_neo_hookean() {
    // What is left is of the size of the invariant over the limit, 3 / 1e6.
    let result = apart(named("gent", &[10e6, 1e6]), NeoHookean { shear: 10e6 }.law());
    assert!(result < 1e-5, "{result}");
}

/// Force over the undeformed section (Pa) of a bar of incompressible rubber in tension: that along it, less the
/// pressure that keeps its sides free.
fn tension(law: &Arc<dyn Law<f64>>, stretch: f64) -> f64 {
    let material = Material { law: Arc::clone(law), bulk: 1e9, maxwell: vec![], density: 1e3 };
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
    // Ogden's constants for Treloar's vulcanised rubber, and the closed form of its tension (Proc. R. Soc. Lond. A
    // 326, 1972): sum of mu (l^(alpha - 1) - l^(-alpha/2 - 1)).
    let terms = [(0.63e6, 1.3), (1.2e3, 5.0), (-10e3, -2.0)];
    let law = named("ogden", terms.map(|(mu, alpha)| [mu, alpha]).as_flattened());
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
        let Wide(material, all) = self;
        let stage = material.stage::<P>(Update { dt: 0.0, add_work: false });
        let mut result = Vec::new();
        for some in all.chunks_exact(P::LANES) {
            let lanes: Vec<_> = some.iter().map(elements).collect();
            let load = |i: usize| P::load(&lanes.iter().map(|e| e[i]).collect::<Vec<_>>());
            let f = matrix(std::array::from_fn(load));
            let at = Deformation::new(f);
            let mut stresses = [Symmetric::diagonal(P::zero())];
            stage.stress(&mut Points {
                lane: 0,
                step: 0,
                state: &mut material.state(1),
                deformations: &[at],
                pressures: &[P::splat(material.bulk) * (at.volume - 1.0)],
                weights: &[P::one()],
                stresses: &mut stresses,
            });
            let stress = elements(&times(&f, &stresses[0]));
            result.extend((0..P::LANES).map(|lane| stress.map(|s| s.lane(lane))));
        }
        result
    }
}

#[test]
fn lanes_are_numbers_on_their_own() {
    let many = deformations();
    for (name, material) in examples::<f64>().into_iter().chain(elastic()) {
        let wide = <f64 as clubface_math::Real>::dispatch(Wide(&material, &many[..8]));
        for (f, lane) in many.iter().zip(&wide) {
            // Multiplications and sums may be one operation in one width and two in another.
            let alone = elements(&evaluate(&material, *f).1);
            let size = alone.iter().fold(1e6, |m: f64, s| m.max(s.abs()));
            assert!(alone.iter().zip(lane).all(|(a, b)| (a - b).abs() < 1e-12 * size), "{name}");
        }
        assert_eq!(wide.len(), 8);
    }
}

#[test]
fn nothing_acts_at_rest() {
    for (name, material) in examples::<f64>().into_iter().chain(energies::examples()) {
        let mut point = MaterialPoint::new(&material);
        let unit = Mat3::diagonal(1.0);
        let energy = point.energy(&unit);
        // Rounding, and what Newton's steps leave of the cube root.
        let stress = elements(&point.update(&unit, 1e-6));
        assert!(stress.iter().all(|s| s.abs() < 1e-9 * 10e6), "{name}: {stress:?}");
        assert!(energy.strain.abs() < 1e-9 * 10e6, "{name}");
        assert_eq!([energy.viscous, energy.plastic], [0.0; 2], "{name}");
        assert!(point.plastic_strain() == 0.0, "{name}");
    }
}

#[test]
fn a_closed_path_gives_no_work() {
    // What does not come back is accounted for as viscous work or heat. The work is summed by the trapezoidal rule:
    // steps half as long leave a quarter of the error.
    let swings: Vec<Mat3<f64>> = {
        let mut random = Random(5);
        (0..3).map(|_| random.gradient(0.25) + Mat3::diagonal(-1.0)).collect()
    };
    let at = |share: f64| {
        let mut f = Mat3::diagonal(1.0);
        for (n, swing) in swings.iter().enumerate() {
            f = f + swing.scale((std::f64::consts::PI * share * (n + 1) as f64).sin() * 0.5);
        }
        f
    };
    for (name, elastic) in examples::<f64>().into_iter().chain(energies::examples()) {
        let inelastic = !elastic.law.description().state.is_empty();
        let terms = [Maxwell { modulus: 0.6, time: 1e-4 }, Maxwell { modulus: 1.5, time: 7e-4 }];
        // Branches stand over elastic laws alone.
        for branches in 0..=if inelastic { 0 } else { 2 } {
            let material = Material { maxwell: terms[..branches].to_vec(), ..elastic.clone() };
            // Work that is not accounted for, over the most that was stored.
            let missing = |steps: i32| {
                let mut point = MaterialPoint::new(&material);
                let (mut work, mut most) = (0.0, 0.0_f64);
                let (mut f, mut stress) = (Mat3::diagonal(1.0), Mat3::diagonal(0.0));
                for n in 1..=steps {
                    let next = at(f64::from(n) / f64::from(steps));
                    let after = point.update(&next, 1e-3 / f64::from(steps));
                    let (mean, change) = ((after + stress).scale(0.5), next + f.scale(-1.0));
                    work += (0..3).map(|i| mean.rows[i].dot(change.rows[i])).sum::<f64>();
                    (f, stress) = (next, after);
                    most = most.max(point.energy(&f).strain);
                }
                let energy = point.energy(&f);
                assert!(work > -1e-5 * most, "{name}: {work} of {most}");
                assert_eq!(work > 0.01 * most, inelastic || branches > 0, "{name}: {work} of {most}");
                (work - energy.viscous - energy.plastic - energy.strain) / most
            };
            let (coarse, fine) = (missing(1000), missing(2000));
            assert!(fine.abs() < 1e-5 && fine.abs() < 0.3 * coarse.abs(), "{name}: {coarse:e} {fine:e}");
        }
    }
}

#[test]
fn the_table_is_all_that_a_law_needs() {
    // By its name, with its description and its checks, over both kinds of numbers.
    for Entry { description, .. } in table() {
        let law = named::<f64>(description.name, description.example);
        assert_eq!(law.constants(), description.example);
        assert_eq!(law.shear(), named::<Derived>(description.name, description.example).shear().value);
        assert!((law.shear() / 10e6 - 1.0).abs() < 1e-12, "{}", description.name);
        assert!(!description.summary.is_empty() && !description.source.is_empty());
        let refusal = |constants: &[f64]| {
            from_table(&table(), description.name, constants).expect_err("it must be refused").to_string()
        };
        assert!(refusal(&[]).contains(description.constants[0].name));
        // Each constant out of its bounds, without a change of the others.
        for (i, constant) in description.constants.iter().enumerate().take(description.example.len()) {
            if constant.most < f64::MAX {
                let mut constants = description.example.to_vec();
                constants[i] = constant.most * 1.5;
                assert!(
                    refusal(&constants).contains(constant.name),
                    "{}: {}",
                    description.name,
                    constant.name
                );
            }
        }
    }
    let unknown = from_table::<f64>(&table(), "gum", &[1.0]).expect_err("there is none").to_string();
    assert!(unknown.contains("mooney-rivlin") && unknown.contains("gent"), "{unknown}");
    // A law of the tests is not one of the crate.
    assert!(law_from_name::<f64>("gent", &[1e6, 20.0]).is_err());
}
