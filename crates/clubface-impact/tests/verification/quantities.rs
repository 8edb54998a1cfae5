//! The table of quantities: one meaning a name, units that are known, columns and parameters that agree with it.

use clubface_impact::flight;
use clubface_impact::launch::OUTPUTS;
use clubface_impact::quantity::{QUANTITIES, quantity};
use clubface_impact::registry;
use clubface_impact::shot::INPUTS;
use clubface_impact::unit::{DIMENSIONS, UNITS, unit};
use std::collections::{HashMap, HashSet};

#[test]
fn every_quantity_is_complete_and_is_read_in_units_of_its_dimension() {
    for each in &QUANTITIES {
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
    for each in &QUANTITIES {
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
