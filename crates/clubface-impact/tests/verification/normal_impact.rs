//! Central, normal impact of a ball on a heavy or a free club: Hertz's closed forms and Hunt and Crossley's
//! restitution.

use crate::one_dimension::{Bounce, Stop};
use crate::shots::*;
use clubface_impact::{Accuracy, ImpactModel};
use std::f64::consts::PI;

const TIGHT: Accuracy = Accuracy::Tolerance(1e-11);
const MODULUS: f64 = 5.4e7;
const POISSON: f64 = 0.4;

/// A head that the ball hits square through the CG, of `mass` (kg) and spherical face of `radius` (m).
fn square(mass: f64, radius: f64) -> Inputs {
    let inputs = simple_head(0.04).with(&[("club_mass", mass), ("bulge", radius), ("roll", radius)]);
    inputs.with(&[("ixx", mass), ("iyy", mass), ("izz", mass)])
}

const HEAVY: f64 = 1e9;

fn area(damping: f64) -> Vec<f64> {
    let model = AREA;
    let values = [("shear_modulus", MODULUS), ("poisson", POISSON), ("damping", damping)];
    changed(model, model.info().defaults(), &values)
}

/// Caldwell and McPhee, Eqs. 15 and 16: k = 4 G sqrt(R)/(3 (1 - nu)), 1/R = 1/r_ball + 1/r_club.
fn hertz_stiffness(face_radius: f64) -> f64 {
    let radius = (1.0 / 0.0213 + 1.0 / face_radius).recip();
    4.0 * MODULUS * radius.sqrt() / (3.0 * (1.0 - POISSON))
}

fn reduced(club_mass: f64) -> f64 {
    (1.0 / 0.0459 + 1.0 / club_mass).recip()
}

/// Speed of separation over that of approach.
fn restitution(inputs: &Inputs, outputs: &Outputs) -> f64 {
    (outputs.ball_velocity().x - outputs.club_velocity().x) / inputs.at("speed")
}

/// Hertz (Johnson, Contact Mechanics, 1985, section 11.4): d_max = (5 m v^2/(4 k))^(2/5), duration 2.943275 d_max/v,
/// peak force k d_max^1.5. Steps of 1e-11 leave the motion correct to 1e-9; the separation is located on a cubic, the
/// peak on a parabola through a step of some 1/500 of the contact: 1e-8 and better.
#[test]
fn an_elastic_normal_impact_follows_hertz() {
    let v = 48.0;
    for (mass, radius) in [(HEAVY, f64::INFINITY), (HEAVY, 0.305), (0.2, f64::INFINITY), (0.2, 0.305)] {
        let inputs = square(mass, radius).with(&[("speed", v)]);
        for model in [AREA, RINGS] {
            let values = [("shear_modulus", MODULUS), ("poisson", POISSON), ("damping", 0.0)];
            let parameters = changed(model, model.info().defaults(), &values);
            let outputs = hit(model, &inputs, &parameters, TIGHT);
            let (m, k) = (reduced(mass), hertz_stiffness(radius));
            let depth = (5.0 * m * v * v / (4.0 * k)).powf(0.4);
            let duration = outputs.at("contact_time") * v / depth;
            assert!((duration / 2.943_275 - 1.0).abs() < 3e-7, "duration {duration}");
            let force = outputs.at("peak_force") / (k * depth.powf(1.5));
            assert!((force - 1.0).abs() < 1e-7, "peak {force}");
            assert!((restitution(&inputs, &outputs) - 1.0).abs() < 1e-8);
            assert!(outputs.ball_spin().norm() < 1e-9 && outputs.ball_velocity().y.abs() < 1e-9);
        }
    }
}

/// The fast setting promises the launch to 1e-4; time and force follow to a few times that.
#[test]
fn the_fast_setting_follows_hertz_to_its_tolerance() {
    let inputs = square(HEAVY, f64::INFINITY).with(&[("speed", 48.0)]);
    let (m, k) = (reduced(HEAVY), hertz_stiffness(f64::INFINITY));
    let depth = (5.0 * m * 48.0f64.powi(2) / (4.0 * k)).powf(0.4);
    let outputs = hit(AREA, &inputs, &area(0.0), Accuracy::Fast);
    assert!((restitution(&inputs, &outputs) - 1.0).abs() < 1e-4);
    assert!((outputs.at("contact_time") * 48.0 / depth / 2.943_275 - 1.0).abs() < 5e-4);
    assert!((outputs.at("peak_force") / (k * depth.powf(1.5)) - 1.0).abs() < 5e-4);
}

fn assert_bounce(model: ImpactModel, inputs: &Inputs, parameters: &[f64], exact: &Bounce) {
    let outputs = hit(model, inputs, parameters, TIGHT);
    let relative = |result: f64, exact: f64, tolerance: f64, what: &str| {
        let error = (result / exact - 1.0).abs();
        assert!(error < tolerance, "{} {what}: {result} for {exact}, {error:e}", model.info().name);
    };
    relative(restitution(inputs, &outputs), exact.restitution, 1e-8, "restitution");
    // 4000 midpoints leave 1e-7 of the integral, and find the top of the force to 1e-7.
    relative(outputs.at("contact_time"), exact.duration, 1e-6, "duration");
    relative(outputs.at("peak_force"), exact.peak_force, 1e-6, "peak force");
    let (history, _) = model.history(&inputs.0, parameters, TIGHT).unwrap();
    let deepest = history.frames.iter().map(|frame| frame.penetration).fold(0.0, f64::max);
    // The deepest recorded step is within half a step of the top of a parabola: (1/300)^2 of it.
    relative(deepest, exact.depth, 1e-4, "depth");
}

/// Hunt and Crossley (J. Appl. Mech. 42, 1975, 440-445): the exact solution by quadrature, over speeds and dampings.
#[test]
fn damped_hertz_contact_follows_hunt_and_crossley() {
    for (speed, damping) in [(48.0, 6.35e-3), (30.0, 9.89e-3), (10.0, 0.03), (55.0, 1e-4)] {
        for mass in [HEAVY, 0.25] {
            let k = hertz_stiffness(f64::INFINITY);
            let exact = Stop {
                force: |x: f64| k * x.powf(1.5),
                potential: |x: f64| 0.4 * k * x.powf(2.5),
                damping,
                mass: reduced(mass),
                speed,
            };
            let inputs = square(mass, f64::INFINITY).with(&[("speed", speed)]);
            assert_bounce(AREA, &inputs, &area(damping), &exact.bounce());
        }
    }
}

/// The same with the force of the volumetric model on a plane, V = pi x^2 (3 R - x)/3.
#[test]
fn the_volumetric_contact_follows_hunt_and_crossley() {
    let model = VOLUMETRIC;
    for club in CLUBS {
        let parameters = published(model, club);
        let (k, damping) = (parameters[0], parameters[1]);
        let (radius, speed) = (0.0213, shot(club).at("speed"));
        let exact = Stop {
            force: |x: f64| k * PI * x * x * (radius - x / 3.0),
            potential: |x: f64| k * PI * x.powi(3) * (radius / 3.0 - x / 12.0),
            damping,
            mass: reduced(0.25),
            speed,
        };
        let inputs = square(0.25, f64::INFINITY).with(&[("speed", speed)]);
        assert_bounce(model, &inputs, &parameters, &exact.bounce());
    }
}

/// Stiffness scales out of a launch (only the lever R - d knows it), time goes with k^-0.4 and force with k^0.4.
#[test]
fn stiffness_scales_time_and_force_but_not_speed() {
    let inputs = square(0.2, f64::INFINITY);
    let at =
        |modulus: f64| hit(AREA, &inputs, &changed(AREA, area(6e-3), &[("shear_modulus", modulus)]), TIGHT);
    let (soft, hard) = (at(1e7), at(1e9));
    assert!((restitution(&inputs, &soft) / restitution(&inputs, &hard) - 1.0).abs() < 1e-8);
    let scale = 100f64.powf(0.4);
    assert!((soft.at("contact_time") / hard.at("contact_time") / scale - 1.0).abs() < 1e-6);
    assert!((hard.at("peak_force") / soft.at("peak_force") / scale - 1.0).abs() < 1e-6);
}
