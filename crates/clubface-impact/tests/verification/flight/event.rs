//! The place of an event within a step.

use clubface_impact::ball::Ball;
use clubface_impact::flight::event::Step;
use clubface_impact::flight::trajectory::{Air, Flight, HEIGHT};
use clubface_math::ode::{Method, System, DORMAND_PRINCE};
use clubface_math::Vec3;

/// One Runge-Kutta step of the length found must end on the ground, to rounding of heights of metres.
#[test]
fn an_event_is_placed_to_rounding_within_steps_of_any_length() {
    let ball = Ball { mass: 0.0459, radius: 0.0213, inertia: 8.336e-6 };
    let air = Air { density: 1.18, wind: Vec3::zero() };
    let flight = Flight::new(&ball, Vec3::new(0.0, -30.0, 250.0), &air);
    for (height, h) in [(0.5, 0.1), (2.0, 0.4), (10.0, 1.0), (20.0, 2.0)] {
        let y = [200.0, height, 1.0, 25.0, -14.0, 2.0, 0.9];
        let rate = flight.rhs(&y);
        let end = DORMAND_PRINCE.attempt(&flight, &y, &rate, h);
        assert!(end.y[HEIGHT] < 0.0);
        let step = Step { time: 0.0, h, start: (y, rate), end: (end.y, end.rate) };
        let (time, state) = step.at_zero_of(HEIGHT, &flight);
        let landed = DORMAND_PRINCE.attempt(&flight, &y, &rate, time);
        assert!(landed.y[HEIGHT].abs() < 1e-13 * height.max(1.0) * 10.0, "{:e}", landed.y[HEIGHT]);
        assert!((landed.y[0] - state[0]).abs() < 1e-10, "{:e}", landed.y[0] - state[0]);
    }
}
