//! Materials that make no sense are refused by name.

use crate::support::elastic;
use clubface_fem::material::{Material, Maxwell, MooneyRivlin, NeoHookean};

fn refused(material: &Material<f64>, words: &[&str]) {
    let message = material.check("the cover").expect_err("it must be refused").to_string();
    for word in words.iter().chain(&["of the cover"]) {
        assert!(message.contains(word), "{message:?} lacks {word:?}");
    }
}

#[test]
fn good_materials_pass() {
    for poisson in [-0.5, 0.0, 0.3, 0.4999 - 1e-9] {
        let mut material = elastic(1e6, poisson, 1000.0);
        assert!((material.poisson() - poisson).abs() < 1e-9);
        material.maxwell = vec![Maxwell { modulus: 0.5, time: 1e-4 }];
        material.check("the cover").expect("it is allowed");
    }
}

#[test]
fn bad_materials_are_refused() {
    let good = || elastic(1e6, 0.4, 1000.0);
    refused(&elastic(1e6, 0.5, 1000.0), &["bulk modulus", "0.5", "0.49"]);
    refused(&elastic(1e6, 0.499_95, 1000.0), &["Poisson's ratio", "0.49995"]);
    refused(&elastic(-1e6, 0.4, 1000.0), &["shear of", "-357142", "zero or above"]);
    refused(&Material { bulk: -2.0, ..good() }, &["bulk modulus", "-2 Pa"]);
    refused(&Material { density: 0.0, ..good() }, &["density", "0 kg/m3"]);
    refused(&Material { density: f64::NAN, ..good() }, &["density", "NaN"]);
    let rubber = MooneyRivlin { c10: 4e6, c01: -1e6 }.law();
    refused(&Material { law: rubber, ..good() }, &["c01", "-1000000 Pa"]);
    refused(&Material { law: NeoHookean { shear: 0.0 }.law(), ..good() }, &["shear modulus"]);
    let term = |modulus, time| Material { maxwell: vec![Maxwell { modulus, time }], ..good() };
    refused(&term(-0.1, 1e-4), &["relative modulus", "-0.1"]);
    refused(&term(0.1, 0.0), &["relaxation time", "0 s"]);
    refused(&term(1e5, 1e-4), &["relative modulus", "100000"]);
    refused(
        &Material { maxwell: vec![Maxwell { modulus: 1.0, time: 1e-4 }; 5], ..good() },
        &["5", "at most 4"],
    );
}
