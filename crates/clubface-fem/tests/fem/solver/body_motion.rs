//! The motion of a body from the moments of its nodes.

use clubface_fem::moments::{Nodes, Origin};
use clubface_fem::solve::BodyMotion;
use clubface_math::{with_lanes, Row, Vec3};

/// Fifteen bodies of different mass in a rigid motion: an odd number, so that packs are not full.
#[test]
fn a_rigid_motion_is_found_again() {
    let (drift, spin) = (Vec3::new(3.0, -2.0, 1.0), Vec3::new(40.0, 300.0, -7.0));
    let mut state = 1_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / f64::from(1 << 24)
    };
    let x: Vec<_> =
        (0..15).map(|_| Vec3::new(0.04 * random() + 0.1, 0.04 * random(), 0.04 * random())).collect();
    let masses: Vec<f64> = (0..15).map(|_| 1e-3 * (1.0 + random())).collect();
    let mass: f64 = masses.iter().sum();
    let centre = x.iter().zip(&masses).fold(Vec3::zero(), |sum, (x, m)| sum + *x * *m) * mass.recip();
    let v: Vec<_> = x.iter().map(|x| drift + spin.cross(*x - centre)).collect();
    let angular = x
        .iter()
        .zip(&v)
        .zip(&masses)
        .fold(Vec3::zero(), |sum, ((x, v), m)| sum + (*x - centre).cross(*v) * *m);
    let energy: f64 = v.iter().zip(&masses).map(|(v, m)| 0.5 * m * v.norm_squared()).sum();
    let rows = |v: &[Vec3<f64>]| v.iter().map(|v| Row::from_vec(*v)).collect::<Vec<_>>();
    for lanes in [1, 4, 8] {
        let (positions, velocities) = (&rows(&x)[..], &rows(&v)[..]);
        let nodes = Nodes { positions, velocities, masses: &masses };
        let origin = Origin { position: positions[7].vec(), velocity: velocities[7].vec() };
        let all: Vec<u32> = (0..15).collect();
        // In two lists, of which the first fills its packs.
        let sums =
            with_lanes(lanes, || nodes.moments(&all[..8], origin).plus(&nodes.moments(&all[8..], origin)));
        let found = BodyMotion::from_moments(&sums, &origin);
        // Rounding, as large as the products are.
        assert!((found.mass - mass).abs() < 1e-16, "{found:?}");
        assert!((found.centre - centre).norm() < 1e-15, "{found:?}");
        assert!((found.velocity - drift).norm() < 1e-13, "{found:?}");
        assert!((found.spin - spin).norm() < 1e-10, "{found:?}");
        assert!((found.angular_momentum - angular).norm() < 1e-16, "{found:?}");
        assert!((found.energy - energy).abs() < 1e-14 * energy, "{found:?}");
    }
}
