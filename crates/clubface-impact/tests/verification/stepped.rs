//! Contacts that a program of someone's own steps through: the same as those of `impact`, to the bit where the bodies are
//! described alike, and to the accuracy of an integrator in world axes.

use crate::attachment::{shaft, with};
use crate::shots::*;
use clubface_impact::contact::{
    BALL_SPIN, CLUB_SPIN, Contact, ContactLaw, Loads, POSITION, Recorder, RelativeMotion, SOLID,
    SteppedContact, VELOCITY,
};
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::impact_model::Tangents;
use clubface_impact::model::Model;
use clubface_impact::models::{area::Area, rings::Rings, volumetric::Volumetric};
use clubface_impact::multibody::{BODY, Body, HEAD, Head, HeadContact, MOTION, WRENCH};
use clubface_impact::struck_ball::{Phase, StruckBall};
use clubface_impact::{Accuracy, ImpactModel};
use clubface_math::ode::System;
use clubface_math::{Mat3, Vec3};

const STEPPED: [ImpactModel; 3] = [VOLUMETRIC, RINGS, AREA];
const LEDGER: usize = 3;

fn each(check: impl Fn(ImpactModel, Club, &Inputs, &[f64])) {
    for model in STEPPED {
        for (club, hand) in SIDES {
            for face in FACES {
                check(model, club, &on_face(mishit(club, hand), face), &published(model, club));
            }
        }
    }
}

/// Compares, at every step of an impact, the rates of its state with those that a program has from the stepped contact.
struct Comparison {
    touch: FirstTouch<f64>,
    stepped: Box<dyn SteppedContact<f64>>,
    steps: usize,
}

impl Recorder<f64> for Comparison {
    const ACTIVE: bool = true;

    fn record<L: ContactLaw<f64>, const N: usize>(
        &mut self,
        contact: &Contact<f64, L>,
        _: f64,
        y: &[f64; N],
    ) {
        let expected = contact.rhs(y);
        let at = |start| Vec3::from_slice(y, start);
        let motion = RelativeMotion {
            position: at(POSITION),
            velocity: at(VELOCITY),
            head_spin: at(CLUB_SPIN),
            surface_spin: at(BALL_SPIN),
        };
        let states = &y[SOLID..N - LEDGER];
        let mut internal = states.to_vec();
        let memory = contact.law.memory();
        internal.extend(&memory);
        let mut rates = vec![f64::NAN; internal.len()];
        let Loads { force, point, torque } = self.stepped.evaluate(&motion, &internal, &mut rates).loads;

        // Newton and Euler, in axes fixed in the head.
        let touch = &self.touch;
        let spin = motion.head_spin;
        let moment = -point.cross(force) - spin.cross(touch.head.inertia * spin);
        let (slowed, turned) = touch.head_mobility().response(-force, moment);
        let surface = touch.ball.inertia - contact.core().map_or(0.0, |core| core.inertia);
        let velocity = force * touch.ball.mass.recip() - slowed - spin.cross(motion.velocity);
        let surface_rate = torque * surface.recip() - spin.cross(motion.surface_spin);
        let parts = [
            (POSITION, motion.velocity - spin.cross(motion.position)),
            (VELOCITY, velocity),
            (CLUB_SPIN, turned),
            (BALL_SPIN, surface_rate),
        ];
        // The solver of rings starts from where it was last, and is exact to 1e-11 from anywhere.
        let exactly = memory.is_empty();
        let alike = |a: f64, b: f64, size: f64| {
            if exactly { a.to_bits() == b.to_bits() } else { (a - b).abs() <= 1e-9 * size }
        };
        for (start, vector) in parts {
            for (i, value) in vector.array().into_iter().enumerate() {
                let wanted = expected[start + i];
                assert!(
                    alike(value, wanted, vector.norm()),
                    "state {} of {N}: {value} and {wanted}",
                    start + i
                );
            }
        }
        let internal_rates = &expected[SOLID..N - LEDGER];
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&rates[..states.len()]), bits(internal_rates));
        assert!(rates[states.len()..].iter().all(|&rate| rate == 0.0));
        self.steps += 1;
    }
}

fn compare<M: Model<f64>>(model: ImpactModel, inputs: &Inputs, parameters: &[f64]) {
    let touch = FirstTouch::from_inputs(&inputs.0);
    let stepped = model.stepped(&touch, parameters).unwrap();
    let mut comparison = Comparison { touch, stepped, steps: 0 };
    let impact = M::from_values(parameters).impact(&touch, Accuracy::Fast, &mut comparison);
    assert!(impact.separated && comparison.steps > 20);
}

/// `impact` is the stepped contact with our integrator: the rates that it integrates are those that anyone would have from
/// the stepped contact, to the bit, at every step of every impact; those of rings, by their memory, to the solver's 1e-9.
#[test]
fn an_impact_integrates_the_stepped_contact_to_the_bit() {
    each(|model, _, inputs, parameters| match model.info().name {
        "volumetric" => compare::<Volumetric<f64>>(model, inputs, parameters),
        "rings" => compare::<Rings<f64>>(model, inputs, parameters),
        _ => compare::<Area<f64>>(model, inputs, parameters),
    });
}

/// Head and ball at first touch as a multibody program has them: the ball's centre at a place of the world.
fn bodies(inputs: &Inputs) -> ([f64; HEAD], [f64; BODY]) {
    let touch = FirstTouch::from_inputs(&inputs.0);
    let loft = Mat3::rotation_z(inputs.at("static_loft").sin_cos());
    let centre = touch.contact + touch.normal * touch.ball.radius;
    let hand = inputs.at("hand");
    let place = Vec3::new(0.3, -0.2, 0.1);
    let spin = touch.attitude * touch.ball_spin;
    let ball = Body { position: place, velocity: Vec3::zero(), spin }.mirrored(hand);
    let head = Head {
        rotation: touch.attitude * loft.transpose(),
        body: Body {
            position: place - touch.attitude * centre,
            velocity: touch.attitude * touch.club_velocity,
            spin: touch.attitude * touch.club_spin,
        },
    };
    let mirrored = head.mirrored(hand);
    // `place` is the same on both sides, so that the mirror image is not taken for granted.
    (values(&mirrored), ball.values())
}

fn values(head: &Head<f64>) -> [f64; HEAD] {
    let mut values = [0.0; HEAD];
    head.rotation.rows.iter().enumerate().for_each(|(i, row)| row.put(&mut values, 3 * i));
    values[9..].copy_from_slice(&head.body.values());
    values
}

/// Before first touch by `time` seconds, at constant velocities.
fn before(head: &[f64; HEAD], time: f64) -> [f64; HEAD] {
    let mut earlier = Head::from_values(head);
    let Body { position, velocity, spin } = earlier.body;
    earlier.body.position = position - velocity * time;
    let rate = spin.norm().max(1e-9);
    let (axis, angle) = (Mat3::cross(spin * rate.recip()), -rate * time);
    let turn = Mat3::diagonal(1.0) + axis.scale(angle.sin()) + (axis * axis).scale(1.0 - angle.cos());
    earlier.rotation = turn * earlier.rotation;
    values(&earlier)
}

/// Largest difference of two results, over the size of the vector or the value.
fn difference(one: &Outputs, other: &Outputs) -> f64 {
    let vectors = [
        (one.ball_velocity(), other.ball_velocity()),
        (one.ball_spin(), other.ball_spin()),
        (one.club_velocity(), other.club_velocity()),
        (one.club_spin(), other.club_spin()),
    ];
    let times = ["contact_time", "peak_force"].map(|name| (one.at(name), other.at(name)));
    let vectors = vectors.into_iter().map(|(a, b)| (a - b).norm() / b.norm());
    vectors.chain(times.into_iter().map(|(a, b)| (a - b).abs() / b)).fold(0.0, f64::max)
}

/// A single step that takes in the whole contact is the impact. Stages of 0.25 us are good for 5e-5, by the
/// time of separation and the peak of the force; for rings, which get a ring more or less at a stage, for 3e-3. A head that
/// hangs in a mechanism has its inertia in the step.
#[test]
fn a_ball_struck_within_one_step_is_that_of_the_impact() {
    each(|model, _, inputs, parameters| {
        for inputs in [*inputs, with(*inputs, &shaft())] {
            let (head, ball) = bodies(&inputs);
            let mut struck = StruckBall::new(model, &inputs.0, parameters, &ball, true).unwrap();
            assert_eq!(struck.phase(), Phase::Waiting);
            struck.advance(&before(&head, 3.1e-4), 2e-3).unwrap();
            assert_eq!(struck.phase(), Phase::Launched);
            let one = Outputs(*struck.launch().unwrap());
            let other = hit(model, &inputs, parameters, Accuracy::Tolerance(1e-10));
            let tolerance = if model == RINGS { 3e-3 } else { 5e-5 };
            let error = difference(&one, &other);
            assert!(error < tolerance, "{} {inputs:?}: {error:e}", model.info().name);
        }
    });
}

/// A program with a rigid head of its own, which it moves by the mean force and torque of each step.
fn driven(
    model: ImpactModel,
    inputs: &Inputs,
    parameters: &[f64],
    step: f64,
) -> (Outputs, Body<f64>, Vec3<f64>) {
    let hand = inputs.at("hand");
    let (at_touch, ball) = bodies(inputs);
    let mut given = before(&at_touch, 20.3e-6);
    let mut struck = StruckBall::new(model, &inputs.0, parameters, &ball, true).unwrap();
    let (mass, symmetric) = (inputs.at("club_mass"), ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]);
    let inertia = Mat3::symmetric(symmetric.map(|name| inputs.at(name)));
    let mut impulse = Vec3::zero();
    while struck.phase() != Phase::Launched {
        let loads = struck.advance(&given, step).unwrap();
        impulse += loads.force * step;
        // Of the right-hander, in parts of the step: Heun's method.
        let mut head = Head::from_values(&given).mirrored(hand);
        let acting = Body { position: loads.force, velocity: loads.force, spin: loads.torque }.mirrored(hand);
        let parts = 20;
        let h = step / f64::from(parts);
        let turn_rate = |head: &Head<f64>| {
            let spin = head.rotation.transpose() * head.body.spin;
            let torque = head.rotation.transpose() * acting.spin;
            head.rotation * (inertia.inverse() * (torque - spin.cross(inertia * spin)))
        };
        for _ in 0..parts {
            let acceleration = acting.velocity * mass.recip();
            let first = turn_rate(&head);
            let middle_spin = head.body.spin + first * (h / 2.0);
            head.body.position += head.body.velocity * h + acceleration * (h * h / 2.0);
            head.body.velocity += acceleration * h;
            let rate = middle_spin.norm().max(1e-9);
            let axis = Mat3::cross(middle_spin * rate.recip());
            let turn = Mat3::diagonal(1.0)
                + axis.scale((rate * h).sin())
                + (axis * axis).scale(1.0 - (rate * h).cos());
            let after = Head {
                rotation: turn * head.rotation,
                body: Body { spin: head.body.spin + first * h, ..head.body },
            };
            head.body.spin += (first + turn_rate(&after)) * (h / 2.0);
            head.rotation = after.rotation;
        }
        given = values(&head.mirrored(hand));
    }
    (Outputs(*struck.launch().unwrap()), struck.ball(), impulse)
}

/// Steps by a program with its own head: the impulse on the head is what the ball has gained, and the launch is that of the
/// impact, to 5e-5 with steps of 20 us, where the mean force does not leave the head quite where it was, and a quarter of
/// it with a quarter of the step.
#[test]
fn a_program_that_moves_its_head_by_mean_forces_has_the_impact() {
    for (club, hand) in SIDES {
        let inputs = mishit(club, hand);
        let parameters = published(VOLUMETRIC, club);
        let exact = hit(VOLUMETRIC, &inputs, &parameters, Accuracy::Tolerance(1e-10));
        let mut errors = [20e-6, 10e-6, 5e-6].map(|step| {
            let (launch, ball, impulse) = driven(VOLUMETRIC, &inputs, &parameters, step);
            let missed = impulse + ball.velocity * inputs.at("ball_mass");
            assert!(missed.norm() < 1e-12 * impulse.norm(), "{missed:?} N s");
            (launch.ball_velocity() - exact.ball_velocity()).norm() / exact.ball_velocity().norm()
        });
        assert!(errors[0] < 5e-5, "{errors:?}");
        errors.sort_by(f64::total_cmp);
        assert!(errors[0] < errors[2] / 3.0, "{errors:?}");
    }
}

/// With a head that moves as prescribed the ball is struck as by a head without end of mass.
#[test]
fn a_prescribed_head_strikes_like_a_wall() {
    let inputs = played(Club::Driver);
    let parameters = published(VOLUMETRIC, Club::Driver);
    let (head, ball) = bodies(&inputs);
    let mut struck = StruckBall::new(VOLUMETRIC, &inputs.0, &parameters, &ball, false).unwrap();
    struck.advance(&before(&head, 1e-4), 2e-3).unwrap();
    let heavy = inputs.with(&[("club_mass", 1e9), ("ixx", 1e9), ("iyy", 1e9), ("izz", 1e9)]);
    let heavy = heavy.with(&[("ixy", 0.0), ("ixz", 0.0), ("iyz", 0.0)]);
    let wall = hit(VOLUMETRIC, &heavy, &parameters, Accuracy::Tolerance(1e-10));
    let one = Outputs(*struck.launch().unwrap());
    for (a, b) in [(one.ball_velocity(), wall.ball_velocity()), (one.ball_spin(), wall.ball_spin())] {
        assert!((a - b).norm() < 1e-5 * b.norm(), "{a:?} and {b:?}");
    }
}

/// A head that passes next to the ball, or behind it, does not touch it, and one that has struck it does so once.
#[test]
fn a_ball_is_struck_by_the_face_alone() {
    let inputs = played(Club::Driver);
    let parameters = published(VOLUMETRIC, Club::Driver);
    let (head, ball) = bodies(&inputs);
    let early = before(&head, 5e-3);
    let phase_at_offset = |distance: f64| {
        let mut given = early;
        given[11] += distance;
        let mut struck = StruckBall::new(VOLUMETRIC, &inputs.0, &parameters, &ball, true).unwrap();
        let loads = struck.advance(&given, 0.05).unwrap();
        (struck.phase(), loads.force.norm())
    };
    assert_eq!(phase_at_offset(0.0).0, Phase::Launched);
    // The face is 105 mm wide.
    assert_eq!(phase_at_offset(0.060), (Phase::Waiting, 0.0));
    assert_eq!(phase_at_offset(-0.060), (Phase::Waiting, 0.0));
    // Backwards, from before the ball.
    let mut back = head;
    (12..15).for_each(|i| back[i] = -back[i]);
    let mut struck = StruckBall::new(VOLUMETRIC, &inputs.0, &parameters, &ball, true).unwrap();
    struck.advance(&back, 0.01).unwrap();
    assert_eq!(struck.phase(), Phase::Waiting);
}

/// Derivatives of what acts, against central differences: to 1e-6 of the size of a row, rounding of the differences.
#[test]
fn derivatives_of_the_wrench_are_those_of_differences() {
    each(|model, _, inputs, parameters| {
        let (head, mut ball) = bodies(inputs);
        let plain = HeadContact::<f64>::begin(model, &inputs.0, parameters, &head, &ball).unwrap();
        let dual = HeadContact::<Tangents>::begin(model, &inputs.0, parameters, &head, &ball).unwrap();
        // A millimetre into the face, sliding, with the internal states off their rest.
        let normal = {
            let touch = FirstTouch::from_inputs(&inputs.0);
            let normal = touch.attitude * touch.normal;
            Vec3::new(normal.x, normal.y, normal.z * inputs.at("hand"))
        };
        (Vec3::from_slice(&ball, 0) - normal * 1e-3).put(&mut ball, 0);
        let mut internal = plain.initial().to_vec();
        let names = plain.names();
        assert_eq!(names.len(), internal.len());
        for (i, name) in names.iter().enumerate() {
            internal[i] += match name.as_str() {
                "face_depth" => 1e-4,
                "twist_x" | "twist_y" | "twist_z" => 0.01,
                _ if name.starts_with("slip") => 2e-5,
                _ => 0.0,
            };
        }
        let rows = dual.jacobian(&head, &ball, &internal);
        assert_eq!(rows.len(), WRENCH + internal.len());
        let value = |column: usize, by: f64| {
            let (mut moved, mut ball, mut internal) = (Head::from_values(&head), ball, internal.clone());
            let axis = |i: usize| {
                Vec3::new(
                    f64::from(u8::from(i == 0)),
                    f64::from(u8::from(i == 1)),
                    f64::from(u8::from(i == 2)),
                )
            };
            match column {
                0..3 => moved.body.position += axis(column) * by,
                3..6 => {
                    let turn = Mat3::cross(axis(column - 3));
                    moved.rotation =
                        (Mat3::diagonal(1.0) + turn.scale(by.sin()) + (turn * turn).scale(1.0 - by.cos()))
                            * moved.rotation;
                }
                6..9 => moved.body.velocity += axis(column - 6) * by,
                9..12 => moved.body.spin += axis(column - 9) * by,
                12..MOTION => ball[column - 12] += by,
                _ => internal[column - MOTION] += by,
            }
            let mut rates = vec![0.0; internal.len()];
            let wrench = plain.evaluate(&moved, &Body::from_values(&ball), &internal, &mut rates);
            wrench.values().into_iter().chain(rates).collect::<Vec<_>>()
        };
        let plainly = value(0, 0.0);
        for (row, value) in rows.iter().zip(&plainly) {
            // Values of dual numbers round otherwise where a quotient is a product with the reciprocal.
            assert!((row[0] - value).abs() <= 1e-9 * value.abs().max(1e-9));
        }
        let states = names.iter().filter(|name| !name.starts_with("memory")).count();
        for column in 0..MOTION + states {
            let by = if column < MOTION && (column / 3) % 3 < 2 && column % 9 < 6 { 1e-7 } else { 1e-6 };
            let (more, less) = (value(column, by), value(column, -by));
            for (i, row) in rows.iter().enumerate() {
                let slope = (more[i] - less[i]) / (2.0 * by);
                let size = row[1..].iter().fold(plainly[i].abs(), |size, each| size.max(each.abs()));
                assert!(
                    (row[1 + column] - slope).abs() <= 2e-5 * size,
                    "{}: row {i}, column {column}: {} and {slope}",
                    model.info().name,
                    row[1 + column]
                );
            }
        }
    });
}

/// Mistakes are named.
#[test]
fn faulty_contacts_are_refused() {
    let inputs = played(Club::Driver);
    let (head, ball) = bodies(&inputs);
    let parameters = published(VOLUMETRIC, Club::Driver);
    let begin = |model: ImpactModel, inputs: &Inputs, head: &[f64; HEAD], ball: &[f64; BODY]| {
        let parameters = published(model, Club::Driver);
        HeadContact::<f64>::begin(model, &inputs.0, &parameters, head, ball).err().map(|error| error.input)
    };
    assert_eq!(begin(VOLUMETRIC, &inputs, &head, &ball), None);
    assert_eq!(begin(ADJUSTED, &inputs, &head, &ball), Some("model"));
    assert_eq!(begin(VOLUMETRIC, &inputs.with(&[("club_mass", -1.0)]), &head, &ball), Some("club_mass"));
    let mut turned = head;
    turned[0] *= 1.01;
    assert_eq!(begin(VOLUMETRIC, &inputs, &turned, &ball), Some("head"));
    let mut parting = head;
    (12..15).for_each(|i| parting[i] = -parting[i]);
    assert_eq!(begin(VOLUMETRIC, &inputs, &parting, &ball), Some("speed"));
    let mut nowhere = ball;
    nowhere[4] = f64::NAN;
    assert_eq!(begin(VOLUMETRIC, &inputs, &head, &nowhere), Some("ball"));
    let mut struck = StruckBall::new(VOLUMETRIC, &inputs.0, &parameters, &ball, true).unwrap();
    assert_eq!(struck.advance(&head, -1.0).err().map(|error| error.input), Some("duration"));
    assert!(StruckBall::new(STANDARD, &inputs.0, &published(STANDARD, Club::Driver), &ball, true).is_err());
}
