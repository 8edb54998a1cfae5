//! Laws that are written down as energies: the laws of the crate written so, closed forms, derivatives against those of
//! dual numbers, and what is refused.

use super::{apart, deformations, elements, evaluate, material, named, tension};
use crate::support::{ELEMENTS, piece};
use clubface_fem::ball::BallConstruction;
use clubface_fem::cases::ball_against_plane;
use clubface_fem::element::{Element, Kernels};
use clubface_fem::environment::Environment;
use clubface_fem::material::{Energy, Law, Material, MaterialPoint, Maxwell, Number, STRETCHES};
use clubface_math::{Dual, Mat3, Vec3};
use proptest::prelude::*;
use std::sync::Arc;

const RIVLIN: &str = "c10*(I1-3) + c01*(I2-3)";
const YEOH: &str = "c10*(I1-3) + c20*(I1-3)^2 + c30*(I1-3)^3";
const GENT: &str = "-mu/2*limit*log(1 - (I1-3)/limit)";
const FUNG: &str = "mu/(2*b)*(exp(b*(I1-3)) - 1)";
/// Bažant's approximation of the logarithmic strain: mu e:e, with e the deviator of (C - C^-1)/4.
const HENCKY: &str = "mu/16*(I1^2 - 2*I2 + I2**2 - 2*I1 - 6 - (I1 - I2)^2/3)";
/// tr C^2 = I1^2 - 2 I2, and tr C^-2 = I2^2 - 2 I1.
const OGDEN: &str = "m1/4*(I1bar^2 - 2*I2bar - 3) - m2/4*(I2bar^2 - 2*I1bar - 3)";
/// Powers that are neither whole nor half.
const POWERS: &str = "mu/2*(3/p)*((I1/3)^p*3^0 - 1)*.5 + mu/4*3^(1-q)/q*(I2^q - 3^q)";

fn energy<R: Number>(text: &str, constants: &[f64]) -> Arc<dyn Law<R>> {
    let constants: Vec<R> = constants.iter().map(|&value| R::from_f64(value)).collect();
    let law = Arc::new(Energy::new(text).expect("an energy")).law(&constants).expect("its constants");
    law.check("the test").expect("an allowed energy");
    law
}

/// Energies of a shear modulus of 10 MPa.
pub fn examples<R: Number>() -> Vec<(String, Material<R>)> {
    let all: [(&str, &[f64]); 7] = [
        (RIVLIN, &[4e6, 1e6]),
        (YEOH, &[5e6, 3e5, 2e4]),
        (GENT, &[10e6, 20.0]),
        (FUNG, &[10e6, 0.4]),
        (HENCKY, &[10e6]),
        (OGDEN, &[3e6, -2e6]),
        (POWERS, &[10e6, 1.3, 0.7]),
    ];
    all.iter().map(|(text, constants)| ((*text).to_owned(), material(energy(text, constants)))).collect()
}

#[test]
fn the_laws_of_the_crate_written_as_energies_are_the_same() {
    // Rounding of stresses that are sums of terms up to ten times their size, over the shear modulus.
    for (text, constants, law) in [
        (RIVLIN, &[4e6, 1e6][..], named("mooney-rivlin", &[4e6, 1e6])),
        ("G/2*(I1-3)", &[10e6], named("neo-hookean", &[10e6])),
        (HENCKY, &[10e6], named("linear", &[10e6])),
        (GENT, &[10e6, 20.0], named("gent", &[10e6, 20.0])),
        (OGDEN, &[3e6, -2e6], named("ogden", &[3e6, 4.0, -2e6, -4.0])),
    ] {
        let result = apart(energy(text, constants), law);
        assert!(result < 1e-11, "{text}: {result}");
    }
}

#[test]
fn branches_stand_over_an_energy_as_over_a_law() {
    let maxwell = vec![Maxwell { modulus: 0.6, time: 1e-4 }, Maxwell { modulus: 1.5, time: 7e-4 }];
    let law = Material { maxwell, ..material(named::<f64>("mooney-rivlin", &[4e6, 1e6])) };
    let written = Material { law: energy(RIVLIN, &[4e6, 1e6]), ..law.clone() };
    let [mut one, mut other] = [&law, &written].map(MaterialPoint::new);
    for f in deformations() {
        let stresses = [&mut one, &mut other].map(|point| elements(&point.update(&f, 2e-5)));
        let viscous = [&mut one, &mut other].map(|point| point.energy(&f).viscous);
        // Rounding of both, and of what the branches keep.
        assert!(stresses[0].iter().zip(stresses[1]).all(|(a, b)| (a - b).abs() < 1e-11 * 40e6));
        assert!((viscous[0] - viscous[1]).abs() < 1e-11 * 40e6);
        assert!(viscous[0] > 0.0);
    }
}

/// Velocity (m/s) and spin (rad/s) of a coarse ball 300 us after it was thrown at a plane.
fn bounce<R: Kernels + Number>(element: Element, core: Arc<dyn Law<R>>, cover: Arc<dyn Law<R>>) -> [R; 3] {
    let piece_of = |name: &str, radius: f64, layers: usize, law, bulk: f64| {
        let maxwell = vec![Maxwell { modulus: R::from_f64(0.3), time: R::from_f64(1e-4) }];
        let material = Material { law, bulk: R::from_f64(bulk), maxwell, density: R::from_f64(1000.0) };
        piece(name, R::from_f64(radius), layers, material)
    };
    let pieces = vec![piece_of("core", 0.0196, 2, core, 5e8), piece_of("cover", 0.0214, 1, cover, 5.8e8)];
    let ball = BallConstruction { pieces, cube: 4, element, mass: Some(0.046) };
    let (speed, angle, friction) = (R::from_f64(35.0), R::from_f64(0.2), R::from_f64(0.35));
    let impact = ball_against_plane(&ball, speed, angle, friction, &Environment::native()).expect("a case");
    let (mut structure, mut contact) = (impact.structure, impact.contact);
    for _ in 0..300 {
        structure.assemble(contact.as_mut(), 1e-6);
        structure.advance(contact.as_ref(), 1e-6);
    }
    let kinetics = structure.body_motion(0..structure.positions.len());
    [kinetics.velocity.x, kinetics.velocity.y, kinetics.spin.z]
}

#[test]
fn a_ball_of_energies_bounces_as_one_of_laws_and_so_do_its_derivatives() {
    type Derived = Dual<f64, 4>;
    for element in ELEMENTS {
        let laws = bounce::<f64>(element, named("mooney-rivlin", &[4e6, 1e6]), named("linear", &[1.25e8]));
        let energies = bounce::<f64>(element, energy(RIVLIN, &[4e6, 1e6]), energy(HENCKY, &[1.25e8]));
        for (a, b) in laws.iter().zip(energies) {
            // Rounding, which the contact of 300 steps makes larger by some powers of ten.
            assert!((a - b).abs() < 1e-9 * a.abs(), "{element:?}: {laws:?} {energies:?}");
        }
    }
    // The derivative by c10, the first constant of both.
    let constants = [Derived::variable(4e6, 0), Dual::constant(1e6)];
    let law = clubface_fem::material::law_from_name("mooney-rivlin", &constants).expect("the law");
    let written = Arc::new(Energy::new(RIVLIN).expect("an energy")).law(&constants).expect("the energy");
    let cover = || named::<Derived>("linear", &[1.25e8]);
    let [laws, energies] = [law, written].map(|core| bounce(Element::OnePoint, core, cover()));
    for (a, b) in laws.iter().zip(energies) {
        let (a, b) = (a.tangent[0], b.tangent[0]);
        assert!(a != 0.0 && (a - b).abs() < 1e-8 * a.abs(), "{a} {b}");
    }
}

#[test]
fn tension_of_yeohs_rubber() {
    // Force over the undeformed section of an incompressible bar: 2 (l - l^-2) (W1 + W2 / l); Yeoh, Rubber Chem.
    // Technol. 66, 1993, for W2 = 0.
    let law = energy(YEOH, &[5e6, 3e5, 2e4]);
    for stretch in [0.5, 0.8, 1.0, 1.5, 2.0] {
        let x = stretch * stretch + 2.0 / stretch - 3.0;
        let slope = 5e6 + 2.0 * 3e5 * x + 3.0 * 2e4 * x * x;
        let exact = 2.0 * (stretch - 1.0 / (stretch * stretch)) * slope;
        // Rounding, and what Newton's steps leave of the cube root of the volume (1e-12).
        assert!((tension(&law, stretch) - exact).abs() < 1e-11 * 10e6, "{stretch}: {exact}");
    }
}

#[test]
fn simple_shear_of_an_energy_of_both_invariants() {
    // Cauchy's shear stress is 2 (W1 + W2) k, and the normal stresses along the shear and across it differ by k times
    // that (Rivlin, Phil. Trans. R. Soc. A 241, 1948). In simple shear s12 = P12, s11 = P11 + k P12 and s22 = P22.
    let constants = [3e6, 2e6, 5e5];
    let law = energy("a*(I1-3) + b*(I2-3) + c*(I1-3)*(I2-3)", &constants);
    for k in [0.1, 0.5, 1.0] {
        let f = Mat3::from_rows(Vec3::new(1.0, k, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
        let [a, b, c] = constants;
        let (w1, w2) = (a + c * k * k, b + c * k * k);
        let stress = elements(&evaluate(&material(Arc::clone(&law)), f).1);
        let shear = 2.0 * (w1 + w2) * k;
        assert!((stress[1] - shear).abs() < 1e-11 * 10e6, "{k}: {} {shear}", stress[1]);
        let difference = stress[0] + k * stress[1] - stress[4];
        assert!((difference - k * shear).abs() < 1e-11 * 10e6, "{k}: {difference} {}", k * shear);
    }
}

/// Expressions of any shape over the invariants and two constants.
fn expressions() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("I1".to_owned()),
        Just("I2bar".to_owned()),
        Just("a".to_owned()),
        Just("b".to_owned()),
        (0.1..4.0f64).prop_map(|value| format!("{value:.3}")),
        Just("2".to_owned()),
    ];
    leaf.prop_recursive(5, 40, 2, |inner| {
        let two = (inner.clone(), inner.clone());
        let exponents = prop_oneof![
            Just("2".to_owned()),
            Just("-1".to_owned()),
            Just("(3/2)".to_owned()),
            Just("0.3".to_owned()),
            Just("a".to_owned()),
            inner.clone().prop_map(|exponent| format!("({exponent})")),
        ];
        prop_oneof![
            two.clone().prop_map(|(x, y)| format!("({x} + {y})")),
            two.clone().prop_map(|(x, y)| format!("({x} - {y})")),
            two.clone().prop_map(|(x, y)| format!("{x}*({y})")),
            two.prop_map(|(x, y)| format!("({x})/({y})")),
            (inner.clone(), exponents).prop_map(|(x, y)| format!("({x})^{y}")),
            inner.clone().prop_map(|x| format!("-({x})")),
            inner.clone().prop_map(|x| format!("exp(0.1*({x}))")),
            inner.clone().prop_map(|x| format!("log({x})")),
            inner.prop_map(|x| format!("sqrt({x})")),
        ]
    })
}

/// What formulas are made of, in any order.
fn scraps() -> impl Strategy<Value = String> {
    let scrap = prop::sample::select(vec![
        "I1", "I2", "(", ")", "+", "-", "*", "/", "^", "**", "exp", "log(", "sqrt(", "c10", "3", "1e", ".",
        "1e308", " ", "J", "\u{e9}", "\u{200b}", "#", ",", "_", "0", "lambda", "9.9.9", "^-",
    ]);
    prop::collection::vec(scrap, 0..30).prop_map(|scraps| scraps.concat())
}

/// Reads an energy and, if it is one, asks it everything.
fn ask(text: &str) {
    if let Ok(energy) = Energy::new(text) {
        let constants = vec![0.7; energy.constants().len()];
        let energy = Arc::new(energy);
        let law = energy.law(&constants).expect("as many constants");
        let _ = law.check("the test");
        let _ = energy.instability(&constants);
        evaluate(&material(law), Mat3::diagonal(1.1));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// Symbolic derivatives are those of dual numbers, which know nothing of symbols: rounding over what both are sums of.
    #[test]
    fn derivatives_of_expressions_are_those_of_dual_numbers(
        text in expressions(), first in 3.0..6.0f64, second in 3.0..6.0f64, a in 0.2..3.0f64, b in 0.2..3.0f64,
    ) {
        let energy = Energy::new(&text).expect("an expression");
        let known = |name: &String| if name == "a" { a } else { b };
        let constants: Vec<Dual<f64, 2>> = energy.constants().iter().map(|name| Dual::constant(known(name))).collect();
        let invariants = [Dual::variable(first, 0), Dual::variable(second, 1)];
        let (value, slopes, [w11, w12, w22]) = energy.evaluate(&constants, invariants);
        let pairs = [
            (value.tangent[0], slopes[0].value), (value.tangent[1], slopes[1].value),
            (slopes[0].tangent[0], w11.value), (slopes[0].tangent[1], w12.value),
            (slopes[1].tangent[0], w12.value), (slopes[1].tangent[1], w22.value),
        ];
        let size = pairs.iter().flat_map(|(x, y)| [x.abs(), y.abs()]).fold(value.value.abs(), f64::max);
        // Where something overflows, or a root is of a negative number, there is nothing to compare.
        if value.value.is_finite() && size < 1e6 && pairs.iter().all(|(x, y)| x.is_finite() && y.is_finite()) {
            for (dual, symbolic) in pairs {
                prop_assert!((dual - symbolic).abs() <= 1e-7 * size.max(1.0), "{text}: {dual} {symbolic}");
            }
        }
    }

    /// The list of operations computes what the graph says: the stress of a block of the same volume.
    #[test]
    fn operations_on_packs_compute_the_expression(text in expressions(), stretch in 1.05..1.6f64) {
        let energy = Arc::new(Energy::new(&text).expect("an expression"));
        let constants: Vec<f64> = energy.constants().iter().map(|name| if name == "a" { 0.8 } else { 1.7 }).collect();
        // No plane strain: both invariants would be the same number, and their difference rounding.
        let stretches @ [long, side, thin] = [stretch, 1.1, 1.0 / (1.1 * stretch)];
        let f = Mat3::from_rows(
            Vec3::new(long, 0.0, 0.0), Vec3::new(0.0, side, 0.0), Vec3::new(0.0, 0.0, thin),
        );
        let [x, y, z] = stretches.map(|each| each * each);
        let (value, [w1, w2], _) = energy.evaluate(&constants, [x + y + z, 1.0 / x + 1.0 / y + 1.0 / z]);
        let law = energy.law(&constants).expect("as many constants");
        let (energy, stress) = evaluate(&material(law), f);
        // Principal Kirchhoff stresses 2 (W1 l^2 - W2 / l^2) less their mean; the volume is that at rest.
        let kirchhoff = [x, y, z].map(|square| 2.0 * (w1 * square - w2 / square));
        let mean = kirchhoff.iter().sum::<f64>() / 3.0;
        let size = kirchhoff.iter().fold(value.abs().max(1.0), |most, each| most.max(each.abs()));
        if value.is_finite() && kirchhoff.iter().all(|each| each.is_finite()) && size < 1e6 {
            // Rounding of the expression, and 1e-12 of the cube root, times the bulk modulus of 40 MPa.
            let along = stress.rows[0].x * stretch;
            prop_assert!((along - (kirchhoff[0] - mean)).abs() < 1e-7 * size + 1e-3, "{text}: {along} {kirchhoff:?}");
            prop_assert!((energy - value).abs() < 1e-7 * size + 1e-3, "{text}: {energy} {value}");
        }
    }

    /// Any text is read or refused.
    #[test]
    fn no_text_makes_it_panic(text in "\\PC{0,60}") {
        ask(&text);
    }

    /// The same, of what looks more like an energy.
    #[test]
    fn no_scraps_of_formulas_make_it_panic(text in scraps()) {
        ask(&text);
    }
}

#[test]
fn long_and_deep_expressions_are_refused_and_not_followed() {
    for text in [
        "(".repeat(1900),
        "-".repeat(1900),
        "2^".repeat(900),
        "exp(".repeat(400),
        "I1*".repeat(3000),
        (0..200).map(|i| format!("c{i}+")).collect(),
        format!("{}I1{}", "(".repeat(900), ")".repeat(900)),
    ] {
        Energy::new(&text).expect_err("it is too long, too deep or not finished");
    }
    // Long sums and products are no matter of depth.
    ask(&format!("c10*({}I1-3)", "I1-I2+".repeat(200)));
    ask(&format!("c10*({}I1-3)", "(1+I1*I2)*".repeat(100)));
    ask(&format!("{}(I1-3){}", "exp(I2/".repeat(50), ")".repeat(50)));
}

#[test]
fn an_error_names_its_place() {
    // The character at which something is wrong, counted from one, and what is there.
    for (text, place) in [
        ("c10*(I1-3", 10),
        ("c10*(I1-3))", 11),
        ("c10*(I1 3)", 9),
        ("2c10", 2),
        ("c10*(i1-3)", 6),
        ("\u{b5}*(I1-3)", 1),
        ("c10*sin(I1)", 5),
        ("c10 ** * I1", 8),
        ("", 1),
        ("1.2.3*I1", 1),
        ("c10*(J-1)^2", 6),
        ("c10(I1-3)", 1),
        ("exp*I1", 1),
        ("I1 , 3", 4),
    ] {
        let error = Energy::new(text).expect_err("it is wrong").to_string();
        assert!(error.contains(&format!("at character {place},")), "{error}");
    }
}

#[test]
fn what_an_energy_must_be_at_rest() {
    let refused = |text: &str, constants: &[f64]| {
        let law = Arc::new(Energy::new(text).expect("an energy")).law(constants).expect("its constants");
        law.check("core").expect_err("it is not allowed").to_string()
    };
    for (text, constants, what) in [
        ("c10*(I1-1)", &[1e6][..], "zero at rest"),
        ("c10*(I1-3)", &[-1e6], "shear modulus"),
        ("c10*(I1-3)^2", &[1e6], "shear modulus"),
        ("c10*sqrt(I1-3)", &[1e6], "finite"),
        ("c10*log(I1-3)", &[1e6], "finite"),
        ("c10*(I1-3)", &[f64::NAN], "c10"),
        ("c10*(I1-3)/b", &[1e6, 0.0], "finite"),
    ] {
        let error = refused(text, constants);
        assert!(error.contains(what) && error.contains("core"), "{error}");
    }
    let count = Arc::new(Energy::new(RIVLIN).expect("an energy")).law(&[1e6]).expect_err("one is missing");
    assert!(count.to_string().contains("c01"));
}

#[test]
fn energies_that_soften_are_found() {
    let found = |text: &str, constants: &[f64]| Energy::new(text).expect("an energy").instability(constants);
    for (text, constants) in
        [(RIVLIN, &[4e6, 1e6][..]), (YEOH, &[5e6, 3e5, 2e4]), (FUNG, &[10e6, 0.4]), (GENT, &[10e6, 20.0])]
    {
        assert_eq!(found(text, constants), None, "{text}");
    }
    // A bar of Yeoh's rubber with a negative c20: the true stress 2 (l^2 - 1/l) (c10 + 2 c20 (I1 - 3)) stops to grow
    // with the logarithm of the stretch where its derivative vanishes, found here by halving intervals.
    let (c10, c20) = (5e6, -8e5);
    let slope = |l: f64| {
        let x = l * l + 2.0 / l - 3.0;
        (2.0 * l * l + 1.0 / l) * (c10 + 2.0 * c20 * x)
            + (l * l - 1.0 / l) * 2.0 * c20 * (2.0 * l * l - 2.0 / l)
    };
    let (mut low, mut high) = (1.0, STRETCHES.1);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if slope(middle) > 0.0 { low = middle } else { high = middle }
    }
    let softens = found("c10*(I1-3) + c20*(I1-3)^2", &[c10, c20]).expect("it softens");
    assert!(!softens.undefined);
    // No later than the bar, and by the scan's steps of 1.4% and the modes that soften sooner not much before.
    assert!(softens.stretch < low * 1.015 && softens.stretch > 0.75 * low, "{softens:?}, bar {low}");
    // Chains that end at a stretch of 1.6: I1 - 3 is 0.81 there.
    let ends = found(GENT, &[10e6, 0.81]).expect("it ends");
    assert!(ends.undefined, "{ends:?}");
}
