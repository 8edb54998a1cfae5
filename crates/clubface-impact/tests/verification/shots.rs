//! The published clubs and parameter sets, shots with them, and their results by name.

use clubface_impact::batch::Batch;
use clubface_impact::columns::Column;
use clubface_impact::error::ImpactError;
use clubface_impact::launch::{OUTPUT_COUNT, OUTPUTS};
use clubface_impact::shot::{INPUT_COUNT, INPUTS};
use clubface_impact::{Accuracy, ImpactModel, ModelKind, registry};
use clubface_math::Vec3;
use proptest::prelude::*;

pub use clubface_impact::registry::{ADJUSTED, AREA, JORGENSEN, RESPONSE, RINGS, SLIP, STANDARD, VOLUMETRIC};

clubface_impact::registry! {
    QUADRATIC_SPRING => crate::quadratic_spring::QuadraticSpring;
}

/// The models of the library, and one that is not.
pub fn every_model() -> impl Iterator<Item = ImpactModel> {
    registry::ALL.iter().chain(ALL).copied()
}

/// Values of a shot in the order of [`INPUTS`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs(pub [f64; INPUT_COUNT]);

impl Inputs {
    pub fn at(&self, name: &str) -> f64 {
        self.0[input(name)]
    }
    pub fn with(mut self, values: &[(&str, f64)]) -> Self {
        for (name, value) in values {
            self.0[input(name)] = *value;
        }
        self
    }
}

/// Index of an input.
pub fn input(name: &str) -> usize {
    INPUTS.iter().position(|input| input.quantity.name == name).expect("an input")
}

/// Index of an output.
pub fn output(name: &str) -> usize {
    OUTPUTS.iter().position(|output| output.name == name).expect("an output")
}

/// One of the two clubs of Caldwell and McPhee (2023).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Club {
    Driver,
    Iron,
}

pub const CLUBS: [Club; 2] = [Club::Driver, Club::Iron];
pub const MPH: f64 = 0.44704;
pub const RPM: f64 = std::f64::consts::PI / 30.0;

/// Caldwell and McPhee's ball, Table 1.
const BALL: [(&str, f64); 3] = [("ball_mass", 0.0459), ("ball_radius", 0.0213), ("ball_inertia", 83.36e-7)];

/// Caldwell and McPhee's club (Table 1; the paper gives no outline) and ball, delivered square and level at its static
/// loft with the clubhead speed of Caldwell and McPhee's drives or an iron's.
pub fn shot(club: Club) -> Inputs {
    let deg = f64::to_radians;
    let values: [(&str, f64); 17] = match club {
        Club::Driver => [
            ("speed", 108.0 * MPH),
            ("loft", deg(9.8)),
            ("club_mass", 0.204),
            ("cg_x", 40.8e-3),
            ("cg_y", 11.4e-3),
            ("cg_z", 1.0e-3),
            ("ixx", 2843e-7),
            ("iyy", 5679e-7),
            ("izz", 4085e-7),
            ("ixy", -733e-7),
            ("ixz", 530.2e-7),
            ("iyz", 0.5e-7),
            ("static_loft", deg(9.8)),
            ("bulge", 0.305),
            ("roll", 0.305),
            ("face_width", 0.105),
            ("face_height", 0.055),
        ],
        Club::Iron => [
            ("speed", 84.0 * MPH),
            ("loft", deg(30.5)),
            ("club_mass", 0.264),
            ("cg_x", 3.61e-3),
            ("cg_y", 4.85e-3),
            ("cg_z", 1.12e-3),
            ("ixx", 2752e-7),
            ("iyy", 2889e-7),
            ("izz", 576.6e-7),
            ("ixy", -51e-7),
            ("ixz", -53e-7),
            ("iyz", -429e-7),
            ("static_loft", deg(30.5)),
            ("bulge", f64::INFINITY),
            ("roll", f64::INFINITY),
            ("face_width", 0.070),
            ("face_height", 0.054),
        ],
    };
    Inputs([0.0; INPUT_COUNT]).with(&values).with(&BALL).with(&[("hand", 1.0)])
}

/// A drive and an iron shot as they are hit: the drive of Caldwell and McPhee's speed, 2 deg up with 13 deg of dynamic
/// loft, the iron 4 deg down with 24 deg.
pub fn played(club: Club) -> Inputs {
    let (attack, loft) = match club {
        Club::Driver => (2.0, 13.0),
        Club::Iron => (-4.0, 24.0),
    };
    shot(club).with(&[("attack", f64::to_radians(attack)), ("loft", f64::to_radians(loft))])
}

/// Off-centre, across the ball, with head and ball turning about every axis: no value is zero.
pub fn mishit(club: Club, hand: f64) -> Inputs {
    played(club).with(&[
        ("path", 0.05),
        ("face", -0.03),
        ("lie", 0.06),
        ("toe", 0.015),
        ("high", -0.008),
        ("closure", 40.0),
        ("pitch_rate", 12.0),
        ("lie_rate", -8.0),
        ("ball_backspin", 90.0),
        ("ball_sidespin", -40.0),
        ("ball_riflespin", 25.0),
        ("hand", hand),
    ])
}

/// Clubs and hands of mishits.
pub const SIDES: [(Club, f64); 3] = [(Club::Driver, 1.0), (Club::Iron, 1.0), (Club::Driver, -1.0)];

/// A head without curvature, products of inertia or offset: CG `depth` (m) behind the face centre, on its normal.
pub fn simple_head(depth: f64) -> Inputs {
    shot(Club::Driver).with(&[
        ("loft", 0.0),
        ("static_loft", 0.0),
        ("cg_x", depth),
        ("cg_y", 0.0),
        ("cg_z", 0.0),
        ("ixy", 0.0),
        ("ixz", 0.0),
        ("iyz", 0.0),
        ("bulge", f64::INFINITY),
        ("roll", f64::INFINITY),
    ])
}

/// Parameters of a model: those published for a club, else the defaults (Caldwell and McPhee (2023), Tables 6-10, G
/// divided by 100).
pub fn published(model: ImpactModel, club: Club) -> Vec<f64> {
    let values: &[(&str, [f64; 2])] = match model.info().name {
        "adjusted" => &[
            ("extra_mass", [2.54e-3, 10.10e-3]),
            ("dcg_x", [0.0, -0.395e-3]),
            ("dcg_y", [-0.482e-3, -0.182e-3]),
            ("dcg_z", [-0.068e-3, -0.071e-3]),
        ],
        "slip" => &[("slip_y", [-0.0103, 0.0183]), ("slip_z", [-0.0150, 0.0423])],
        "volumetric" => &[
            ("stiffness", [6.25e9, 6.83e9]),
            ("damping", [6.42e-3, 9.26e-3]),
            ("friction", [0.372, 0.489]),
            ("layer_stiffness", [13.5, 34.1]),
            ("layer_damping", [2.53e-3, 13.2e-3]),
            ("cover_thickness", [1.26e-3, 2.55e-3]),
            ("transition_speed", [0.936, 0.812]),
        ],
        "rings" => &[
            ("shear_modulus", [5.58e7, 5.74e7]),
            ("poisson", [0.407, 0.418]),
            ("damping", [6.50e-3, 11.5e-3]),
            ("friction", [0.360, 0.519]),
            ("ring_modulus", [5.58e7, 5.74e7]),
        ],
        "area" => &[
            ("shear_modulus", [5.40e7, 5.24e7]),
            ("poisson", [0.398, 0.412]),
            ("damping", [6.35e-3, 9.89e-3]),
            ("friction", [0.0486, 0.118]),
        ],
        _ => &[],
    };
    let column = usize::from(club == Club::Iron);
    let values: Vec<_> = values.iter().map(|(name, sets)| (*name, sets[column])).collect();
    changed(model, model.info().defaults(), &values)
}

/// Parameters with some values changed by name.
pub fn changed(model: ImpactModel, mut parameters: Vec<f64>, values: &[(&str, f64)]) -> Vec<f64> {
    for (name, value) in values {
        let index = parameter(model, name).expect("a parameter");
        parameters[index] = *value;
    }
    parameters
}

/// The published parameters of a model, some changed by name where it has them.
pub fn published_but(model: ImpactModel, club: Club, values: &[(&str, f64)]) -> Vec<f64> {
    let known: Vec<_> = values.iter().copied().filter(|(name, _)| parameter(model, name).is_some()).collect();
    changed(model, published(model, club), &known)
}

/// Index of a parameter, if the model has it.
pub fn parameter(model: ImpactModel, name: &str) -> Option<usize> {
    model.info().parameters.iter().position(|parameter| parameter.name == name)
}

/// Models that resolve the contact in time.
pub fn contacts() -> impl Iterator<Item = ImpactModel> {
    every_model().filter(|model| model.info().kind == ModelKind::Contact)
}

/// Characteristic times of a face and of the one that the parameters include, s: both rigid, one that gives, and faces
/// that give more and less than the included one.
pub const FACES: [(f64, f64); 4] = [(0.0, 0.0), (250e-6, 0.0), (257e-6, 239e-6), (200e-6, 250e-6)];

/// A shot with these characteristic times.
pub fn on_face(inputs: Inputs, (own, included): (f64, f64)) -> Inputs {
    inputs.with(&[("characteristic_time", own), ("included_time", included)])
}

/// Models that do not.
pub fn impulses() -> impl Iterator<Item = ImpactModel> {
    every_model().filter(|model| model.info().kind == ModelKind::Impulse)
}

/// Whether ball and head move while they touch: in contact models, and in an impulse model that knows the contact time.
pub fn moves(model: ImpactModel) -> bool {
    model.info().kind == ModelKind::Contact || parameter(model, "time").is_some()
}

/// Results of a shot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs(pub [f64; OUTPUT_COUNT]);

impl Outputs {
    pub fn at(&self, name: &str) -> f64 {
        self.0[output(name)]
    }
    fn vector(&self, first: &str) -> Vec3<f64> {
        Vec3::from_slice(&self.0, output(first))
    }
    pub fn ball_velocity(&self) -> Vec3<f64> {
        self.vector("velocity_x")
    }
    pub fn ball_spin(&self) -> Vec3<f64> {
        self.vector("spin_x")
    }
    pub fn club_velocity(&self) -> Vec3<f64> {
        self.vector("club_velocity_x")
    }
    pub fn club_spin(&self) -> Vec3<f64> {
        self.vector("club_spin_x")
    }
    /// Bits, with one pattern for all NaN.
    pub fn bits(&self) -> [u64; OUTPUT_COUNT] {
        self.0.map(|value| if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() })
    }
}

/// One shot.
pub fn try_hit(
    model: ImpactModel,
    inputs: &Inputs,
    parameters: &[f64],
    accuracy: Accuracy,
) -> Result<Outputs, ImpactError> {
    let inputs = inputs.0.map(Column::Constant);
    let parameters: Vec<_> = parameters.iter().copied().map(Column::Constant).collect();
    let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy };
    batch.validate(1)?;
    let mut values = [0.0; OUTPUT_COUNT];
    let rejects = batch.run(0..1, values.chunks_mut(1).collect());
    match rejects.into_iter().next() {
        Some(reject) => Err(reject.error),
        None => Ok(Outputs(values)),
    }
}

/// One shot that must succeed.
pub fn hit(model: ImpactModel, inputs: &Inputs, parameters: &[f64], accuracy: Accuracy) -> Outputs {
    try_hit(model, inputs, parameters, accuracy).expect("a shot")
}

/// Deliveries people make, and mishits: every value a swing may have, up to an impact 25 mm from the face centre.
pub fn delivered(club: Club) -> impl Strategy<Value = Inputs> {
    let (speed, attack, loft, toe) = match club {
        Club::Driver => (35.0..55.0, -0.10..0.12, 0.10..0.35, 25e-3),
        Club::Iron => (25.0..42.0, -0.17..0.03, 0.25..0.65, 20e-3),
    };
    let angles = (attack, -0.14..0.14f64, loft, -0.14..0.14f64, -0.14..0.14f64);
    let rates = (-10.0..60.0f64, -20.0..20.0f64, -20.0..20.0f64);
    let spins = (-150.0..150.0f64, -150.0..150.0f64, -150.0..150.0f64);
    (speed, angles, (-toe..toe, -12e-3..12e-3f64), rates, spins, prop::bool::ANY).prop_map(
        move |(speed, (attack, path, loft, face, lie), (toe, high), rates, spins, left)| {
            shot(club).with(&[
                ("speed", speed),
                ("attack", attack),
                ("path", path),
                ("loft", loft),
                ("face", face),
                ("lie", lie),
                ("toe", toe),
                ("high", high),
                ("closure", rates.0),
                ("pitch_rate", rates.1),
                ("lie_rate", rates.2),
                ("ball_backspin", spins.0),
                ("ball_sidespin", spins.1),
                ("ball_riflespin", spins.2),
                ("hand", if left { -1.0 } else { 1.0 }),
            ])
        },
    )
}

/// A club and a delivery of it.
pub fn any_delivery() -> impl Strategy<Value = (Club, Inputs)> {
    prop_oneof![
        delivered(Club::Driver).prop_map(|inputs| (Club::Driver, inputs)),
        delivered(Club::Iron).prop_map(|inputs| (Club::Iron, inputs)),
    ]
}
