//! A law by a function of C among those that the contracts are tested with, and its registration.

use super::{Material, material, named};
use clubface_fem::material::{LAWS, Number, OwnFunction, register_law, registered, unchecked_law};
use std::sync::Arc;

/// Mooney's and Rivlin's rubber.
unsafe extern "C" fn rivlin(
    count: usize,
    shapes: *const f64,
    constants: *const f64,
    _step: f64,
    _states: *mut f64,
    results: *mut f64,
) {
    let (shapes, constants, results) = unsafe {
        (
            std::slice::from_raw_parts(shapes, 6 * count),
            std::slice::from_raw_parts(constants, 2),
            std::slice::from_raw_parts_mut(results, 8 * count),
        )
    };
    for i in 0..count {
        let c: [f64; 6] = std::array::from_fn(|row| shapes[row * count + i]);
        let first = c[0] + c[1] + c[2];
        let square =
            c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + 2.0 * (c[3] * c[3] + c[4] * c[4] + c[5] * c[5]);
        for row in 0..6 {
            let one = if row < 3 { 2.0 * (constants[0] + constants[1] * first) } else { 0.0 };
            results[row * count + i] = one - 2.0 * constants[1] * c[row];
        }
        let second = 0.5 * (first * first - square);
        results[6 * count + i] = constants[0] * (first - 3.0) + constants[1] * (second - 3.0);
    }
}

fn function() -> OwnFunction {
    // SAFETY: it does what such a function does.
    unsafe { OwnFunction::new("rivlin", vec!["c10".into(), "c01".into()], 0, rivlin) }.expect("two constants")
}

/// The law, of a shear modulus of 10 MPa.
pub fn examples<R: Number>() -> Vec<(String, Material<R>)> {
    let constants = [4e6, 1e6].map(R::from_f64);
    let law = Arc::new(function()).law(&constants).expect("both constants");
    vec![("a function of C".into(), material(law))]
}

#[test]
fn a_function_that_is_registered_is_a_law_by_its_name() {
    let shear = register_law(function(), &[4e6, 1e6]).expect("it is allowed");
    // Differences of the fourth order at 0.1% strain.
    assert!((shear / named::<f64>("mooney-rivlin", &[4e6, 1e6]).shear() - 1.0).abs() < 1e-11, "{shear}");
    assert!(registered("rivlin").is_some() && registered("gum").is_none());
    assert_eq!(unchecked_law::<f64>("rivlin", &[1.0, 2.0]).expect("it is there").constants(), &[1.0, 2.0]);
    assert!(unchecked_law::<f64>("rivlin", &[1.0]).is_err());
    for name in ["", "energy", LAWS[0].description.name] {
        // SAFETY: as above.
        let named = unsafe { OwnFunction::new(name, vec![], 0, rivlin) }.expect("no constants");
        assert!(register_law(named, &[]).is_err(), "{name}");
    }
    // SAFETY: it is never called.
    assert!(unsafe { OwnFunction::new("much", vec![], 65, rivlin) }.is_err());
}
