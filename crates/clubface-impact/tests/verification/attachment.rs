//! Heads that hang in a mechanism, against free heads that move alike, conservation laws and finite differences.

use crate::histories::ledger;
use crate::shots::*;
use clubface_impact::check::check;
use clubface_impact::contact::Frame;
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::sensitivity::sensitivity;
use clubface_impact::{Accuracy, ImpactModel};
use clubface_math::{Mat3, Quat, Vec3};

const TIGHT: Accuracy = Accuracy::Tolerance(1e-11);

fn spatial(mass: Mat3<f64>, coupling: Mat3<f64>, inertia: Mat3<f64>) -> Vec<(String, f64)> {
    let mut values = Vec::new();
    let axes = ["x", "y", "z"];
    for (i, row) in axes.iter().enumerate() {
        for (j, column) in axes.iter().enumerate() {
            if i <= j {
                values.push((format!("added_mass_{row}{column}"), mass.rows[i].array()[j]));
                values.push((format!("added_inertia_{row}{column}"), inertia.rows[i].array()[j]));
            }
            values.push((format!("added_coupling_{row}{column}"), coupling.rows[i].array()[j]));
        }
    }
    values
}

pub fn with(inputs: Inputs, values: &[(String, f64)]) -> Inputs {
    let values: Vec<(&str, f64)> = values.iter().map(|(name, value)| (name.as_str(), *value)).collect();
    inputs.with(&values)
}

/// Inertia of a mass (kg) at a point (m) about the origin.
fn about_origin(mass: f64, point: Vec3<f64>) -> Mat3<f64> {
    (Mat3::cross(point) * Mat3::cross(point)).scale(-mass)
}

/// Masses that are fixed to the head, as a mechanism: velocity of each is u + w x r.
fn fixed_masses(masses: &[(f64, Vec3<f64>)]) -> Vec<(String, f64)> {
    let zero = Mat3::diagonal(0.0);
    let (mut mass, mut coupling, mut inertia) = (zero, zero, zero);
    for &(m, r) in masses {
        mass = mass + Mat3::diagonal(m);
        coupling = coupling + Mat3::cross(r).scale(-m);
        inertia = inertia + about_origin(m, r);
    }
    spatial(mass, coupling, inertia)
}

/// A mechanism as a shaft may be: heavy along one direction, coupled and lopsided. A sum of squares, so no motion of it
/// takes energy.
pub fn shaft() -> Vec<(String, f64)> {
    let masses = [(0.008, Vec3::new(-0.03, 0.05, -0.04)), (0.004, Vec3::new(-0.04, 0.20, -0.08))];
    let mut values = fixed_masses(&masses);
    for (name, value) in &mut values {
        let least = if name.contains("mass") { 4e-3 } else { 4e-5 };
        if name.ends_with("xx") || name.ends_with("yy") || name.ends_with("zz") {
            *value += if name.contains("coupling") { 0.0 } else { least };
        }
    }
    let along = Vec3::new(0.1, 0.85, -0.5);
    for (i, row) in ["x", "y", "z"].iter().enumerate() {
        for (j, column) in ["x", "y", "z"].iter().enumerate().skip(i) {
            let name = format!("added_mass_{row}{column}");
            let value = values.iter_mut().find(|(each, _)| *each == name).unwrap();
            value.1 += 0.02 * along.array()[i] * along.array()[j];
        }
    }
    values
}

/// The same head with the masses as a part of it, delivered alike.
fn composite(inputs: &Inputs, masses: &[(f64, Vec3<f64>)]) -> Inputs {
    let touch = FirstTouch::from_inputs(&inputs.0);
    let own = inputs.at("club_mass");
    let total = own + masses.iter().map(|(m, _)| m).sum::<f64>();
    let centre = masses.iter().fold(Vec3::zero(), |sum, &(m, r)| sum + r * (m / total));
    let symmetric = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];
    let mut inertia = Mat3::symmetric(symmetric.map(|name| inputs.at(name)));
    for &(m, r) in masses {
        inertia = inertia + about_origin(m, r);
    }
    inertia = inertia + about_origin(total, centre).scale(-1.0);
    // The CG of both moves as a point of the head.
    let turn = Mat3::rotation_z(inputs.at("static_loft").sin_cos());
    let velocity = touch.attitude * (touch.club_velocity + touch.club_spin.cross(turn.transpose() * centre));
    let [a, b, c] = inertia.rows;
    inputs.with(&[
        ("club_mass", total),
        ("cg_x", inputs.at("cg_x") - centre.x),
        ("cg_y", inputs.at("cg_y") - centre.y),
        ("cg_z", inputs.at("cg_z") - centre.z),
        ("ixx", a.x),
        ("iyy", b.y),
        ("izz", c.z),
        ("ixy", a.y),
        ("ixz", a.z),
        ("iyz", b.z),
        ("speed", velocity.norm()),
        ("attack", (velocity.y / velocity.norm()).asin()),
        ("path", velocity.z.atan2(velocity.x)),
    ])
}

fn each(check: impl Fn(ImpactModel, Club, Inputs)) {
    for model in every_model() {
        for (club, hand) in SIDES {
            for face in FACES {
                check(model, club, on_face(mishit(club, hand), face));
            }
        }
    }
}

fn assert_alike(model: ImpactModel, one: &Outputs, other: &Outputs, tolerance: f64) {
    for (a, b) in [(one.ball_velocity(), other.ball_velocity()), (one.ball_spin(), other.ball_spin())] {
        let error = (a - b).norm() / a.norm();
        assert!(error < tolerance, "{}: {error:e}", model.info().name);
    }
}

/// A mechanism that adds a trillionth of a gram goes through the equations of attached heads and changes nothing but
/// digits: `rings` may let a ring stick a step sooner, which makes some 1e-4.
#[test]
fn a_head_on_almost_nothing_is_free() {
    let nothing = spatial(Mat3::diagonal(1e-15), Mat3::diagonal(0.0), Mat3::diagonal(0.0));
    each(|model, club, inputs| {
        let parameters = published(model, club);
        let free = hit(model, &inputs, &parameters, TIGHT);
        let attached = hit(model, &with(inputs, &nothing), &parameters, TIGHT);
        for (a, b) in free.0.iter().zip(attached.0).filter(|(a, _)| !a.is_nan()) {
            let tolerance = if model == RINGS { 1e-3 } else { 1e-8 };
            assert!((a - b).abs() <= tolerance * a.abs().max(1.0), "{}: {a} and {b}", model.info().name);
        }
    });
}

/// Masses on a mechanism that is rigidly fixed to the head are the same as a head that has them. This holds the momenta,
/// their coupling and the turning of the momentum. `response` takes shares of turn and displacement about the CG, which is
/// elsewhere in the two: its contact point moves otherwise by some 10 um. `rings` as above.
#[test]
fn a_rigid_mechanism_is_a_part_of_the_head() {
    let masses = [(0.030, Vec3::new(-0.03, 0.04, -0.05)), (0.015, Vec3::new(0.02, -0.03, 0.01))];
    each(|model, club, inputs| {
        // Heavier heads would press a face that gives less than the included one too hard.
        if inputs.at("hand") < 0.0 || inputs.at("characteristic_time") < inputs.at("included_time") {
            return;
        }
        let parameters = published_but(model, club, &[("extra_mass", 0.0)]);
        let attached = hit(model, &with(inputs, &fixed_masses(&masses)), &parameters, TIGHT);
        let whole = hit(model, &composite(&inputs, &masses), &parameters, TIGHT);
        let tolerance = match model.info().name {
            "response" => 2e-3,
            "rings" => 1e-4,
            _ => 1e-7,
        };
        assert_alike(model, &attached, &whole, tolerance);
        let free = hit(model, &inputs, &parameters, TIGHT);
        assert!((free.ball_velocity() - whole.ball_velocity()).norm() > 0.1);
    });
}

/// Caldwell and McPhee's adjusted model has an extra mass at the CG; as a mechanism it gives the same.
#[test]
fn extra_mass_of_the_adjusted_model_is_a_mechanism() {
    for club in CLUBS {
        let inputs = mishit(club, 1.0);
        let parameters = published(ADJUSTED, club);
        let extra = parameters[parameter(ADJUSTED, "extra_mass").unwrap()];
        let mechanism = spatial(Mat3::diagonal(extra), Mat3::diagonal(0.0), Mat3::diagonal(0.0));
        let without = changed(ADJUSTED, parameters.clone(), &[("extra_mass", 0.0)]);
        let one = hit(ADJUSTED, &inputs, &parameters, TIGHT);
        let other = hit(ADJUSTED, &with(inputs, &mechanism), &without, TIGHT);
        assert_alike(ADJUSTED, &one, &other, 1e-13);
    }
}

fn each_history(check: impl Fn(ImpactModel, &Inputs, &[Frame])) {
    for model in contacts() {
        for (club, hand) in SIDES {
            let inputs = with(on_face(mishit(club, hand), FACES[1]), &shaft());
            let (history, _) = model.history(&inputs.0, &published(model, club), TIGHT).unwrap();
            check(model, &inputs, &history.frames);
        }
    }
}

/// Momentum of ball, head and mechanism, the latter by the change of the head's motion.
#[test]
fn momentum_is_kept_at_every_step() {
    each_history(|model, inputs, frames| {
        let touch = FirstTouch::from_inputs(&inputs.0);
        let hand = inputs.at("hand");
        let upright = |v: [f64; 3]| Vec3::new(v[0], v[1], v[2] * hand);
        let upright_spin = |v: [f64; 3]| Vec3::new(v[0] * hand, v[1] * hand, v[2]);
        let total = |f: &Frame| {
            let [w, x, y, z] = f.club_attitude;
            let turn: Mat3<f64> = touch.attitude * Quat { w, v: Vec3::new(x, y, z) }.matrix();
            let change = upright(f.club_velocity) - upright(frames[0].club_velocity);
            let (linear, _) =
                touch.head.momenta(turn.transpose() * change, turn.transpose() * upright_spin(f.club_spin));
            turn * linear + upright(f.ball_velocity) * inputs.at("ball_mass")
        };
        let start = total(&frames[0]);
        for frame in frames {
            let error = (total(frame) - start).norm();
            assert!(error < 1e-12, "{}: {error:e}", model.info().name);
        }
    });
}

/// The kinetic energy of all three, and what normal force, friction and damper have taken: of some 240 J 1e-8.
#[test]
fn energy_is_accounted_for_at_every_step() {
    each_history(|model, _, frames| {
        for frame in frames {
            let error = (ledger(frame) - ledger(&frames[0])).abs() / ledger(&frames[0]);
            assert!(error < 1e-8, "{}: {error:e}", model.info().name);
        }
    });
}

/// The CG of the head is followed by the mean velocity of each step, and meets the ball's path: penetration and place of
/// contact say where it is.
#[test]
fn the_head_is_where_its_velocity_takes_it() {
    each_history(|model, _, frames| {
        let mut moved = Vec3::from_f64(frames[0].club_position);
        for pair in frames.windows(2) {
            let mean = (Vec3::from_f64(pair[0].club_velocity) + Vec3::from_f64(pair[1].club_velocity)) * 0.5;
            moved += mean * (pair[1].time - pair[0].time);
            let error = (moved - Vec3::from_f64(pair[1].club_position)).norm();
            assert!(error < 1e-12, "{}: {error:e}", model.info().name);
        }
        // The ball's path by its own velocity, of which the frames are not made.
        let mut ball = Vec3::from_f64(frames[0].ball_position);
        for pair in frames.windows(2) {
            let mean = (Vec3::from_f64(pair[0].ball_velocity) + Vec3::from_f64(pair[1].ball_velocity)) * 0.5;
            ball += mean * (pair[1].time - pair[0].time);
        }
        let end = Vec3::from_f64(frames.last().unwrap().ball_position);
        assert!((ball - end).norm() < 2e-6, "{}: {:e}", model.info().name, (ball - end).norm());
    });
}

/// Central differences of 1 g, 1 g cm and 10 g cm2, whose error is up to 1e-3 of the derivative with the sharp friction of
/// `area`; other steps of 1e-11 on both sides add some 1e-7 of the value over the difference. `rings` switches between
/// sticking and slipping, so its differences are noise alone.
#[test]
fn launches_are_differentiated_by_what_is_added() {
    for model in every_model().filter(|&model| model != RINGS) {
        let inputs = with(mishit(Club::Driver, 1.0), &shaft());
        let parameters = published(model, Club::Driver);
        let names = ["added_mass_xx", "added_coupling_xz", "added_inertia_yy"];
        let variables = names.map(input);
        let exact = sensitivity(model, &inputs.0, &parameters, &variables, TIGHT).unwrap();
        for (i, name) in names.iter().enumerate() {
            let step = match name.rsplit_once('_').unwrap().0 {
                "added_mass" => 1e-3,
                "added_coupling" => 1e-5,
                _ => 1e-6,
            };
            let [up, down] = [step, -step].map(|change| {
                hit(model, &inputs.with(&[(name, inputs.at(name) + change)]), &parameters, TIGHT)
            });
            for output in ["ball_speed", "backspin", "spin_y"].map(output) {
                let difference = (up.0[output] - down.0[output]) / (2.0 * step);
                let result = exact.jacobian[output][i];
                let error = (result - difference).abs();
                assert!(
                    error < 1e-3 * result.abs() + 2e-7 * exact.values[output].abs().max(10.0) / step,
                    "{} by {name}: {result} and {difference}",
                    model.info().name
                );
            }
        }
    }
}

/// A mechanism that would take energy, or numbers that are none, are refused by name.
#[test]
fn an_impossible_mechanism_is_refused() {
    let good = mishit(Club::Driver, 1.0);
    for (name, value) in
        [("added_mass_xx", -1e-3), ("added_coupling_xy", 1.0), ("added_inertia_zz", f64::NAN)]
    {
        let error = check(&good.with(&[(name, value)]).0).expect_err("it is impossible");
        assert!(error.input.starts_with("added_"), "{}", error.input);
    }
    check(&with(good, &shaft()).0).expect("a shaft");
    check(&with(good, &fixed_masses(&[(0.05, Vec3::new(0.0, 1.0, 0.0))])).0).expect("a point mass");
}
