//! The linearised contact force against differences of the force.

use clubface_impact::contact::{
    BALL_SPIN, CLUB_SPIN, Contact, ContactLaw, POSITION, SOLID, VELOCITY, initial,
};
use clubface_impact::description::FromValues;
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::model::Describe;
use clubface_impact::models::area::Area;
use clubface_impact::models::volumetric::Volumetric;
use clubface_impact::shot::INPUT_COUNT;
use clubface_math::Vec3;
use clubface_math::ode::{StiffSystem, System};

const CLUB_MASS: f64 = 0.204;
const BALL_MASS: f64 = 0.0459;

/// A drive on a face of equal bulge and roll, 1 / `curvature`.
fn drive(curvature: f64) -> FirstTouch<f64> {
    let mut inputs = [0.0; INPUT_COUNT];
    inputs[..8].copy_from_slice(&[48.0, 0.03, 0.04, 0.22, -0.02, 0.0, 0.012, -0.007]);
    inputs[14..18].copy_from_slice(&[CLUB_MASS, 40.8e-3, 11.4e-3, 1e-3]);
    inputs[18..24].copy_from_slice(&[2843e-7, 5679e-7, 4085e-7, -733e-7, 530.2e-7, 0.5e-7]);
    inputs[24..31].copy_from_slice(&[0.17, 1.0 / curvature, 1.0 / curvature, 0.12, 0.06, 0.0, 1.0]);
    inputs[31..34].copy_from_slice(&[BALL_MASS, 0.0213, 83.36e-7]);
    FirstTouch::from_inputs(&inputs)
}

/// Contact force on the ball in state `y`, from the acceleration.
fn force<L: ContactLaw<f64>>(contact: &Contact<f64, L>, y: &[f64; SOLID]) -> Vec3<f64> {
    let acceleration = Vec3::from_slice(&contact.rhs(y), VELOCITY);
    let turned = Vec3::from_slice(y, CLUB_SPIN).cross(Vec3::from_slice(y, VELOCITY));
    (acceleration + turned) * (BALL_MASS.recip() + CLUB_MASS.recip()).recip()
}

/// Against central differences. A third of the speed and a spin near rolling, so that the ball slides at some m/s.
fn assert_linearized<L: ContactLaw<f64>>(law: L, curvature: f64, tolerance: f64) {
    let touch = drive(curvature);
    let contact = Contact::new(&touch, law);
    let mut y = initial::<f64, SOLID>(&touch);
    let within = (touch.normal * -0.003).array();
    for i in 0..3 {
        y[POSITION + i] += within[i];
        y[VELOCITY + i] *= 0.3;
        y[CLUB_SPIN + i] += [30.0, -50.0, 20.0][i];
        y[BALL_SPIN + i] += [60.0, -90.0, 120.0][i];
    }
    let result = contact.linearize(&y);
    let bodies = [(POSITION, result.by_position, 1e-8), (VELOCITY, result.by_velocity, 1e-5)];
    for (start, jacobian, h) in bodies {
        let columns = jacobian.transpose().rows;
        let largest = columns.iter().map(|column| column.norm()).fold(0.0, f64::max);
        for i in 0..3 {
            let at = |shift: f64| {
                let mut moved = y;
                moved[start + i] += shift;
                force(&contact, &moved)
            };
            let difference = (at(h) - at(-h)) * (0.5 / h);
            let error = (columns[i] - difference).norm() / largest;
            assert!(error < tolerance, "state {}: {:?}, differences {difference:?}", start + i, columns[i]);
        }
    }
}

/// Rounding of a force of 10 kN over the change that a step of the differences makes: below 1e-6.
#[test]
fn the_linearized_force_is_that_of_differences() {
    let volumetric = Volumetric::from_values(&Volumetric::INFO.defaults());
    let mut area = Area::from_values(&Area::INFO.defaults());
    area.area_damping = 20.0;
    for curvature in [1e-9, 1.0 / 0.305, 5.0] {
        assert_linearized(volumetric, curvature, 1e-6);
        assert_linearized(area, curvature, 1e-6);
    }
}
