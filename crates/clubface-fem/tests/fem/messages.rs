//! What errors say.

use crate::support::piece;
use clubface_fem::FemError;
use clubface_fem::ball::{BallConstruction, MAX_PIECES};
use clubface_fem::contact::ContactMethod;
use clubface_fem::element::Element;
use clubface_fem::material::{Material, NeoHookean};
use clubface_fem::solve::Options;

#[test]
fn an_input_is_named_with_its_value_and_what_it_must_be() {
    let options = Options { safety: Some(2.0), ..Options::default() };
    let message = options.check().expect_err("beyond the stable step").to_string();
    assert_eq!(message, "safety is 2; it must be above 0 and at most 1 (the stable step)");
    for method in [ContactMethod::Penalty, ContactMethod::AugmentedLagrange] {
        assert_eq!(ContactMethod::from_name(method.name()), Ok(method));
    }
    let message = ContactMethod::from_name("glue").expect_err("unknown").to_string();
    assert_eq!(message, "contact is \"glue\"; it must be one of penalty, augmented-lagrange");
}

#[test]
fn an_error_of_the_energies_is_stated_whatever_it_is() {
    let message = |percent, edge| {
        let (element, part, microseconds) = (7, "cover".into(), 12.3);
        FemError::Energy { element, part, percent, edge, microseconds }.to_string()
    };
    for (percent, words) in
        [(1.04, "off by 1.0% of"), (1e4, "off by more than ten times"), (f64::NAN, "ten times")]
    {
        assert!(message(percent, false).contains(words), "{}", message(percent, false));
    }
    assert!(message(2.0, false).contains("element 7 of cover") && message(2.0, false).contains("12 us"));
    assert!(message(2.0, true).contains("reached round the edge of the face"));
}

#[test]
fn a_lost_element_is_described_in_words_whatever_its_volume() {
    let message = |ratio| {
        let (element, part, microseconds) = (7, "cover".into(), 12.3);
        FemError::ElementLost { element, part, ratio, microseconds }.to_string()
    };
    for (ratio, words) in [(0.294, "had 0.29 times"), (2.6, "had 2.60 times its original volume at 12 us")] {
        let message = message(ratio);
        assert!(message.starts_with("element 7 of cover ") && message.contains(words), "{message}");
    }
    for ratio in [-0.1, 2e283, f64::INFINITY, f64::NAN] {
        assert!(message(ratio).contains("was turned inside out"), "{}", message(ratio));
    }
}

#[test]
fn a_ball_has_as_many_pieces_as_is_said_and_no_more() {
    let checked = |count: usize| {
        let material =
            Material { law: NeoHookean { shear: 1e7 }.law(), bulk: 5e8, maxwell: vec![], density: 1150.0 };
        let pieces =
            (1..=count).map(|place| piece("shell", 0.003 * place as f64, 1, material.clone())).collect();
        BallConstruction { pieces, cube: 4, element: Element::OnePoint, mass: None }.check()
    };
    for count in [1, MAX_PIECES] {
        assert!(checked(count).is_ok(), "{count} pieces");
    }
    for count in [0, MAX_PIECES + 1] {
        let message = checked(count).expect_err("too few or too many").to_string();
        assert_eq!(message, format!("pieces is {count}; it must be from 1 to {MAX_PIECES}"));
    }
}
