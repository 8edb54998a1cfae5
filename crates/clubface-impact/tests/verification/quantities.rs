//! The table of quantities: one meaning a name, units that are known, columns and parameters that agree with it.

use crate::shots::*;
use clubface_impact::Accuracy;
use clubface_impact::check::check;
use clubface_impact::flight;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::quantity::{QUANTITIES, quantity};
use clubface_impact::registry;
use clubface_impact::shot::{DELIVERY_COUNT, INPUTS};
use clubface_impact::unit::{DIMENSIONS, UNITS, unit};
use std::collections::{HashMap, HashSet};

#[test]
fn every_quantity_is_complete_and_is_read_in_units_of_its_dimension() {
    for each in QUANTITIES {
        let si = unit(each.unit).unwrap_or_else(|| panic!("{}: unit {}", each.name, each.unit));
        assert!(si.numerator == si.denominator && si.offset == 0.0, "{}: {} is not SI", each.name, each.unit);
        for reading in [each.metric, each.golf] {
            let read = unit(reading.unit).unwrap_or_else(|| panic!("{}: unit {}", each.name, reading.unit));
            assert_eq!(read.dimension, si.dimension, "{}", each.name);
            assert!(reading.digits <= 6, "{}", each.name);
        }
        assert!(!each.label.is_empty() && !each.meaning.is_empty(), "{}", each.name);
        assert!(
            each.sides.is_none() || !each.sign.is_empty() || each.name == "hand",
            "{}: no sign",
            each.name
        );
    }
}

#[test]
fn a_name_means_one_quantity_and_a_synonym_one_column() {
    let mut names = HashSet::new();
    assert!(QUANTITIES.iter().all(|each| names.insert(each.name)), "a name is there twice");
    let columns = INPUTS.iter().map(|input| input.quantity).chain(OUTPUTS).chain(flight::OUTPUTS);
    let mut known: HashMap<_, _> = columns.map(|column| (column.name, column.name)).collect();
    for each in QUANTITIES {
        for synonym in each.synonyms {
            assert_eq!(
                known.insert(synonym, each.name),
                None,
                "{synonym} of {} means another column",
                each.name
            );
        }
    }
}

#[test]
fn every_dimension_of_a_unit_has_one_si_unit() {
    for each in UNITS {
        let dimension =
            DIMENSIONS.iter().find(|dimension| dimension.name == each.dimension).expect("a dimension");
        for symbol in [dimension.unit, dimension.metric.unit, dimension.golf.unit] {
            assert_eq!(unit(symbol).map(|unit| unit.dimension), Some(each.dimension), "{symbol}");
        }
    }
    assert!(DIMENSIONS.iter().all(|each| UNITS.iter().any(|unit| unit.dimension == each.name)));
}

#[test]
fn a_parameter_with_the_name_of_a_quantity_has_its_unit() {
    for model in registry::ALL {
        for parameter in model.info().parameters {
            assert!(unit(parameter.unit).is_some(), "{}: unit {}", parameter.name, parameter.unit);
            if let Some(quantity) = quantity(parameter.name) {
                assert_eq!(quantity.unit, parameter.unit, "{} of {}", parameter.name, model.info().name);
            }
        }
    }
}

#[test]
fn columns_say_what_positive_means() {
    let description = |name: &str| quantity(name).expect("a quantity").description();
    assert_eq!(description("side"), "distance of the landing from the target line: right is positive");
    assert_eq!(description("ball_speed"), "speed of the ball");
    assert!(INPUTS.iter().filter(|input| input.group == "delivery").all(|input| {
        ["speed", "loft"].contains(&input.quantity.name) != input.quantity.description().contains("positive")
    }));
    assert!(OUTPUTS.iter().all(|output| output.sides.is_none() || output.description().contains("positive")));
}

/// The bounds that are described are those that are checked: just outside, the input itself is at fault.
#[test]
fn a_value_outside_its_bounds_is_refused_by_its_name() {
    for input in &INPUTS {
        let (name, bounds) = (input.quantity.name, input.bounds);
        for (end, outside) in [(bounds.lower, -1e-3), (bounds.upper, 1e-3)] {
            if end.is_finite() {
                let value = end + outside * end.abs().max(1e-3);
                let error = check(&played(Club::Driver).with(&[(name, value)]).0).expect_err(name);
                assert_eq!(error.input, name, "{value}: {}", error.message);
            }
        }
        if let Some(whole) = input.half_of {
            let shot = played(Club::Driver);
            let value = shot.at(whole) / 2.0 * 1.001;
            assert_eq!(check(&shot.with(&[(name, value)]).0).unwrap_err().input, name);
        }
    }
}

/// What a slider reaches is allowed, on a face that is wide enough.
#[test]
fn usual_values_are_allowed() {
    let wide = played(Club::Driver).with(&[("face_width", 0.12), ("face_height", 0.06)]);
    for input in &INPUTS[..DELIVERY_COUNT] {
        let usual = input.usual.expect("deliveries have usual values");
        assert!(usual.lower < usual.upper && input.bounds.contains(usual.lower));
        for value in [usual.lower, usual.upper] {
            assert_eq!(
                check(&wide.with(&[(input.quantity.name, value)]).0),
                Ok(()),
                "{}",
                input.quantity.name
            );
        }
    }
    for input in &flight::INPUTS {
        if let Some(usual) = input.usual {
            assert!(usual.lower < usual.upper, "{}", input.quantity.name);
            assert!(
                [usual.lower, usual.upper, input.default].iter().all(|&value| input.bounds.contains(value))
            );
            assert!(usual.contains(input.default), "{}", input.quantity.name);
        }
    }
}

/// A model lacks the outputs that it leaves NaN, and its valid range is of what it has.
#[test]
fn models_describe_what_they_lack_and_where_they_are_valid() {
    for model in every_model() {
        let info = model.info();
        let launch = hit(model, &played(Club::Driver), &info.defaults(), Accuracy::Fast);
        for (output, value) in OUTPUTS.iter().zip(launch.0) {
            assert_eq!(value.is_nan(), info.lacks.contains(&output.name), "{} of {}", output.name, info.name);
        }
        for each in info.valid {
            let of_model = info.parameters.iter().find(|parameter| parameter.name == each.name);
            let input = INPUTS.iter().find(|input| input.quantity.name == each.name);
            assert!(of_model.is_some() || input.is_some() || each.name == "incidence", "{}", each.name);
            assert!(unit(each.reading).is_some() && each.bounds.lower < each.bounds.upper, "{}", each.name);
            let bounds =
                of_model.map(|p| (p.lower, p.upper)).or(input.map(|i| (i.bounds.lower, i.bounds.upper)));
            let (lower, upper) = bounds.unwrap_or((0.0, f64::INFINITY));
            assert!(lower <= each.bounds.lower && each.bounds.upper <= upper, "{}", each.name);
        }
    }
    assert!(!RESPONSE.info().valid.is_empty());
}
