//! Gear effect and what bulge and roll do against it.

use crate::shots::*;
use clubface_impact::{Accuracy, ImpactModel};

/// All models that keep angular momentum: jorgensen's spin does not know the turning of the head.
fn models() -> impl Iterator<Item = ImpactModel> {
    every_model().filter(|model| *model != JORGENSEN)
}

/// A hit without a displaced CG, which gives spin of its own.
fn struck(model: ImpactModel, inputs: &Inputs) -> Outputs {
    let parameters = published_but(model, Club::Driver, &[("dcg_x", 0.0), ("dcg_y", 0.0), ("dcg_z", 0.0)]);
    hit(model, inputs, &parameters, Accuracy::Tolerance(1e-9))
}

/// A toe hit turns the head open, so its face drags the ball round to the left: sidespin is negative (a draw), and the
/// other way round at the heel. Mirrored for a left-hander.
#[test]
fn a_toe_hit_on_a_flat_face_draws_and_a_heel_hit_fades() {
    for model in models() {
        let toe = struck(model, &simple_head(0.04).with(&[("toe", 0.02)])).at("sidespin");
        let heel = struck(model, &simple_head(0.04).with(&[("toe", -0.02)])).at("sidespin");
        let opposite = (heel + toe).abs() < 1e-6 * heel;
        assert!(toe < -300.0 * RPM && opposite, "{}: {toe} {heel}", model.info().name);
        let left_hander = struck(model, &simple_head(0.04).with(&[("toe", 0.02), ("hand", -1.0)]));
        assert_eq!(left_hander.at("sidespin"), -toe);
    }
}

/// A high hit turns the head back and drags the ball's face side up: less backspin; a low hit adds some.
#[test]
fn a_high_hit_takes_backspin_away_and_a_low_hit_adds_it() {
    for model in models() {
        let backspin = |high: f64| {
            struck(model, &simple_head(0.04).with(&[("loft", 0.2), ("high", high)])).at("backspin")
        };
        let (high, centre, low) = (backspin(0.012), backspin(0.0), backspin(-0.012));
        assert!(high < centre - 200.0 * RPM && low > centre + 200.0 * RPM, "{}", model.info().name);
    }
}

/// With the CG on the face an off-centre normal force turns the head about a point of the face: no point of it moves
/// along the face. Impulse models: exactly; a contact lasts, and the face turns a little meanwhile (2% of the spin at
/// 4 cm of depth).
#[test]
fn gear_effect_vanishes_with_the_cg_on_the_face() {
    for model in models() {
        let on_face = struck(model, &simple_head(0.0).with(&[("toe", 0.02)])).at("sidespin");
        let behind = struck(model, &simple_head(0.04).with(&[("toe", 0.02)])).at("sidespin");
        let limit = if moves(model) { 0.3 * behind.abs() } else { 1e-10 };
        assert!(on_face.abs() <= limit, "{}: {on_face} of {behind}", model.info().name);
    }
}

/// The face of a wood at the toe points right: the ball starts right and with more spin to the right, so that the draw
/// brings it back.
#[test]
fn bulge_counters_the_gear_effect() {
    for model in models() {
        let flat = struck(model, &simple_head(0.04).with(&[("toe", 0.02)]));
        let bulged = struck(model, &simple_head(0.04).with(&[("toe", 0.02), ("bulge", 0.305)]));
        assert!(bulged.at("azimuth") > flat.at("azimuth") + 0.02, "{}", model.info().name);
        let (with, without) = (bulged.at("sidespin"), flat.at("sidespin"));
        assert!(with > 0.7 * without && without < 0.0, "{}: {with} {without}", model.info().name);
    }
}

/// The same upright: roll raises the launch of a high hit and gives back some of its backspin.
#[test]
fn roll_counters_the_vertical_gear_effect() {
    for model in models() {
        let at = |roll: f64| {
            struck(model, &simple_head(0.04).with(&[("loft", 0.2), ("high", 0.012), ("roll", roll)]))
        };
        let (flat, rolled) = (at(f64::INFINITY), at(0.305));
        assert!(rolled.at("launch") > flat.at("launch") + 0.01, "{}", model.info().name);
        assert!(rolled.at("backspin") > flat.at("backspin"), "{}", model.info().name);
    }
}
