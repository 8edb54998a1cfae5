//! Flight against closed forms and symmetry.

use super::{INPUT_COUNT, assert_close, column, drive, flown, launch, value, with};
use clubface_impact::ball::Ball;
use clubface_impact::flight::aerodynamics::{LOWEST_SPIN_PARAMETER, SPIN_DECAY, air_load, drag_coefficient};
use clubface_impact::flight::air::viscosity;
use clubface_impact::flight::trajectory::{Air, Flight, GRAVITY, Landing, fly_to_ground};
use clubface_math::Vec3;
use core::f64::consts::PI;

const BALL: Ball<f64> = Ball { mass: 0.0459, radius: 0.0213, inertia: 8.336e-6 };

fn air(density: f64) -> Air<f64> {
    Air { density, viscosity: viscosity(298.15), wind: Vec3::zero() }
}

fn area() -> f64 {
    PI * BALL.radius.powi(2)
}

fn land(velocity: [f64; 3], spin: [f64; 3], air: &Air<f64>, tolerance: f64) -> Landing<f64> {
    let flight = Flight::new(&BALL, Vec3::from_f64(spin), air);
    fly_to_ground(&flight, Vec3::from_f64(velocity), tolerance, f64::INFINITY, |_, _| {})
}

/// A Runge-Kutta method of order 5 integrates a parabola without error, so rounding alone is left.
#[test]
fn without_air_the_ball_flies_galileis_parabola() {
    for [x, y, z] in [[60.0, 15.0, 3.0], [5.0, 1.0, -2.0], [0.0, 30.0, 0.0], [70.0, 1e-3, 0.0]] {
        let landing = land([x, y, z], [0.0, 50.0, 300.0], &air(0.0), 1e-7);
        let time = 2.0 * y / GRAVITY;
        assert!(landing.landed);
        assert_close(landing.time, time, 1e-12);
        assert_close(landing.position.x, x * time, 1e-12);
        assert_close(landing.position.z, z * time, 1e-12);
        assert_close(landing.velocity.y, -y, 1e-12);
        assert_close(landing.apex, y * y / (2.0 * GRAVITY), 1e-12);
        assert_close(landing.spin.norm(), 50f64.hypot(300.0), 1e-12);
    }
}

/// Without spin C_D is that of the lower end of the fit, without viscosity that beyond the drag crisis, and a ball
/// thrown straight up at v comes back at v u / sqrt(v^2 + u^2), u its terminal velocity, after u/g (atan(v/u) +
/// asinh(v/u)). Dense air brings it within 0.1 % of u. Tolerance: steps of 1e-10, of which there are some hundred.
#[test]
fn a_ball_thrown_straight_up_falls_back_at_its_terminal_velocity() {
    for density in [1.18, 10.0, 60.0] {
        let drag = drag_coefficient(LOWEST_SPIN_PARAMETER, 1e9);
        let terminal = (2.0 * BALL.mass * GRAVITY / (density * area() * drag)).sqrt();
        let speed = 100.0;
        let ratio: f64 = speed / terminal;
        let thin = Air { viscosity: 1e-15, ..air(density) };
        let landing = land([0.0, speed, 0.0], [0.0; 3], &thin, 1e-10);
        assert_close(landing.velocity.y, -speed / ratio.hypot(1.0), 1e-8);
        assert_close(landing.time, terminal / GRAVITY * (ratio.atan() + ratio.asinh()), 1e-8);
        assert_close(landing.apex, terminal.powi(2) / (2.0 * GRAVITY) * (1.0 + ratio * ratio).ln(), 1e-8);
    }
}

/// Energy lost is the work of drag, as lift does none; the power is summed by trapezia of 1 ms, good to about 1e-7.
#[test]
fn the_energy_the_ball_loses_is_the_work_of_drag() {
    let air = air(1.18);
    let (velocity, spin) = (Vec3::new(70.0, 14.0, 2.0), Vec3::new(20.0, -60.0, 280.0));
    let flight = Flight::new(&BALL, spin, &air);
    let reynolds = |v: Vec3<f64>| 2.0 * BALL.radius * air.density * v.norm() / air.viscosity;
    let power = |v: Vec3<f64>, left: f64| {
        let spin_parameter = BALL.radius * spin.norm() * left / v.norm();
        0.5 * air.density * area() * drag_coefficient(spin_parameter, reynolds(v)) * v.norm().powi(3)
    };
    let (mut work, mut before) = (0.0, (0.0, power(velocity, 1.0)));
    let mut step = |time: f64, now: f64| {
        work += 0.5 * (before.1 + now) * (time - before.0);
        before = (time, now);
    };
    let landing = fly_to_ground(&flight, velocity, 1e-10, 1e-3, |time, y| {
        step(time, power(Vec3::from_slice(y, 3), y[6]));
    });
    step(landing.time, power(landing.velocity, landing.spin.norm() / spin.norm()));
    let lost = 0.5 * BALL.mass * (velocity.norm_squared() - landing.velocity.norm_squared());
    assert_close(lost / work, 1.0, 1e-6);
}

/// Within the fit I d(omega)/dt = -0.5 rho A 0.01 r^2 v omega, so the spin decays exponentially with the way flown; the
/// way is a polygon of 1 ms, too short by less than 1e-7.
#[test]
fn spin_decays_exponentially_with_the_way_flown() {
    let air = air(1.18);
    let (velocity, spin) = (Vec3::new(70.0, 14.0, 0.0), Vec3::new(0.0, -60.0, 280.0));
    let flight = Flight::new(&BALL, spin, &air);
    let (mut way, mut here) = (0.0, Vec3::zero());
    let mut step = |place: Vec3<f64>| {
        way += (place - here).norm();
        here = place;
    };
    let landing = fly_to_ground(&flight, velocity, 1e-10, 1e-3, |_, y| step(Vec3::from_slice(y, 0)));
    step(landing.position);
    let rate = 0.5 * air.density * area() * SPIN_DECAY * BALL.radius.powi(2) / BALL.inertia;
    assert!(!landing.outside_fit);
    assert_close((landing.spin.norm() / spin.norm()).ln(), -rate * way, 1e-6);
    assert!(landing.spin.cross(spin).norm() < 1e-9, "the spin keeps its axis");
}

#[test]
fn backspin_lifts_and_positive_sidespin_curves_right() {
    let none = flown(&launch(150.0, 12.0, 0.0, 0.0)).landing;
    assert!(value(&drive(), "apex") > value(&launch(171.0, 10.4, 1500.0, 0.0), "apex"));
    assert!(value(&launch(150.0, 12.0, 2500.0, 0.0), "carry") > none.position.x);
    assert!(value(&launch(150.0, 12.0, -2500.0, 0.0), "carry") < none.position.x);
    assert!(value(&launch(150.0, 12.0, 2500.0, 500.0), "side") > 5.0);
    assert!(value(&launch(150.0, 12.0, 2500.0, -500.0), "side") < -5.0);
    assert_eq!(value(&launch(150.0, 12.0, 2500.0, 0.0), "side"), 0.0);
}

/// The load itself: drag against the motion, lift along spin x velocity, of the fit's size; half of the drag crisis at
/// its middle; and lift fades below the fit.
#[test]
fn the_load_has_the_fits_size_and_lift_vanishes_with_the_spin() {
    let v = Vec3::new(50.0, 0.0, 0.0);
    let fast = 1e9;
    let load = |spin: f64| air_load(BALL.radius, fast, v, Vec3::new(0.0, 0.0, spin), spin.abs());
    let at = |s: f64| load(s * 50.0 / BALL.radius);
    let drag = 0.156 + 0.850 * 0.2 - 0.916 * 0.04;
    assert_close(at(0.2).force.x, -drag * 2500.0, 1e-14);
    assert_close(at(0.2).force.y, (0.0617 + 1.256 * 0.2 - 1.324 * 0.04) * 2500.0, 1e-14);
    assert_close(at(0.2).decay, 0.01 * 50.0 * BALL.radius.powi(2), 1e-14);
    assert_close(at(2.0).force.y, at(1.0).force.y, 1e-14);
    assert_close(at(0.01).force.y, 0.5 * at(0.02).force.y, 1e-14);
    assert_eq!(load(0.0).force.y, 0.0);
    let spin = 0.2 * 50.0 / BALL.radius;
    let slow = air_load(BALL.radius, 67_700.0 / 50.0, v, Vec3::new(0.0, 0.0, spin), spin);
    assert_close(slow.force.x, -(drag + 0.5 * 0.149) * 2500.0, 1e-14);
    // Spin along the flight, as of a rifle bullet, does not lift.
    assert_eq!(air_load(BALL.radius, fast, v, Vec3::new(300.0, 0.0, 0.0), 300.0).force.y, 0.0);
}

/// Left and right differ by signs alone, and floating-point arithmetic is symmetric in sign: equal bits.
#[test]
fn the_mirror_image_of_a_shot_flies_the_mirror_image() {
    let mut shot = launch(160.0, 12.0, 2800.0, 600.0);
    shot[column("velocity_z")] = 3.0;
    shot[column("wind_z")] = -4.0;
    shot[column("spin_x")] = 30.0;
    let mut mirrored: [f64; INPUT_COUNT] = shot;
    // A reflection in z turns z of vectors, and x and y of angular velocities.
    for name in ["velocity_z", "wind_z", "spin_x", "spin_y"] {
        mirrored[column(name)] = -mirrored[column(name)];
    }
    let (a, b) = (flown(&shot).outputs(), flown(&mirrored).outputs());
    for (i, output) in clubface_impact::flight::OUTPUTS.iter().enumerate() {
        let sign = if output.name.ends_with("side") || output.name == "curve" { -1.0 } else { 1.0 };
        assert_eq!(a[i], sign * b[i], "{}", output.name);
    }
}

/// Rotating launch, spin and wind about the vertical rotates the flight; tolerance: steps of 1e-7 placed differently.
#[test]
fn no_direction_of_the_compass_is_special() {
    let shot = with(with(launch(160.0, 12.0, 2800.0, 600.0), "wind_x", 3.0), "wind_z", -5.0);
    let (sine, cosine) = 0.7f64.sin_cos();
    let mut turned = shot;
    for start in [3, 6, 12] {
        turned[start] = cosine * shot[start] - sine * shot[start + 2];
        turned[start + 2] = sine * shot[start] + cosine * shot[start + 2];
    }
    for name in ["carry", "apex", "flight_time", "total", "landing_angle", "landing_spin"] {
        assert_close(value(&turned, name), value(&shot, name), 1e-6);
    }
}

#[test]
fn carry_grows_with_tailwind_altitude_and_warmth() {
    let shot = drive();
    let carries = |name: &str, values: &[f64]| -> Vec<f64> {
        values.iter().map(|&value| super::value(&with(shot, name, value), "carry")).collect()
    };
    let rising = |carries: Vec<f64>| carries.windows(2).all(|pair| pair[1] > pair[0]);
    assert!(rising(carries("wind_x", &[-10.0, -5.0, 0.0, 5.0, 10.0])));
    assert!(rising(carries("temperature", &[273.15, 283.15, 298.15, 308.15])));
    assert!(rising(carries("humidity", &[0.0, 0.5, 1.0])));
    let altitudes = [0.0, 500.0, 1000.0, 2000.0, 2500.0];
    assert!(rising(carries("pressure", &altitudes.map(clubface_impact::flight::air::pressure_at_altitude))));
    // Headwind costs more than tailwind gives.
    let carry = carries("wind_x", &[-10.0, 0.0, 10.0]);
    assert!(carry[1] - carry[0] > carry[2] - carry[1]);
    assert!(value(&with(shot, "wind_z", 5.0), "side") > 5.0);
}

/// A ball that moves with the wind has no wind: seen from the ground, its flight is that in still air, carried along.
#[test]
fn flight_in_wind_is_flight_in_still_air_seen_from_a_moving_frame() {
    let (wind, v) = (Vec3::new(-7.0, 0.0, 4.0), Vec3::new(60.0, 18.0, 2.0));
    let spin = [0.0, -40.0, 320.0];
    let still = land(v.array(), spin, &air(1.18), 1e-10);
    let windy = land((v + wind).array(), spin, &Air { wind, ..air(1.18) }, 1e-10);
    assert_close(windy.time, still.time, 1e-8);
    assert_close(windy.position.x, still.position.x + wind.x * still.time, 1e-8);
    assert_close(windy.position.z, still.position.z + wind.z * still.time, 1e-8);
}

#[test]
fn a_ball_struck_downwards_has_no_flight_and_level_it_needs_lift() {
    let down = launch(100.0, -3.0, 2000.0, 0.0);
    assert_eq!([value(&down, "carry"), value(&down, "apex"), value(&down, "flight_time")], [0.0; 3]);
    assert_close(value(&down, "landing_angle").to_degrees(), 3.0, 1e-12);
    assert!(value(&down, "total") > 1.0);
    assert_eq!(value(&launch(60.0, 0.0, 0.0, 0.0), "carry"), 0.0);
    // 80 m/s with 4000 rpm: lift exceeds weight, and the ball rises from a level launch.
    assert!(value(&launch(180.0, 0.0, 4000.0, 0.0), "apex") > 1.0);
}
