//! Grooves: their profile, and a node pressed into them.

use clubface_fem::contact::{BallSide, Contact, DeformableContact, FaceSide, Grooves, PenaltySprings};
use clubface_math::{Row, Vec3};

const GROOVES: Grooves = Grooves { width: 1e-3, depth: 0.5e-3, pitch: 4e-3, wall: 0.3e-3 };
/// Heights of the middle of a groove, of the middle of its walls, above and below, and of lands.
const MIDDLE: f64 = 2e-3;
const WALL: f64 = 0.5e-3 - 0.15e-3;

#[test]
fn the_profile_is_that_of_the_dimensions() {
    for number in [-3.0, 0.0, 4.0] {
        let middle = MIDDLE + 4e-3 * number;
        let close = |at: f64, depth: f64, slope: f64| {
            let result = GROOVES.relief(middle + at);
            // Rounding of a height of 2 cm against walls of 0.3 mm.
            assert!((result.0 - depth).abs() < 1e-15 && (result.1 - slope).abs() < 1e-11, "{at}: {result:?}");
        };
        close(0.0, 0.5e-3, 0.0);
        close(0.19e-3, 0.5e-3, 0.0);
        close(-0.51e-3, 0.0, 0.0);
        close(2e-3, 0.0, 0.0);
        // A cubic wall is half as deep in its middle and one and a half times as steep as straight.
        close(WALL, 0.25e-3, -2.5);
        close(-WALL, 0.25e-3, 2.5);
    }
    // The slope is the derivative: steps of 1e-8 m leave 1e-8 of curvature 1e4/m.
    for i in 0..200 {
        let (at, step) = (1e-3 + 1e-5 * f64::from(i), 1e-8);
        let difference = (GROOVES.relief(at + step).0 - GROOVES.relief(at - step).0) / (2.0 * step);
        assert!((difference - GROOVES.relief(at).1).abs() < 2e-4, "{at}");
    }
}

/// Force on a node 0.1 mm behind the lands of a skewed face in the plane x = 0, at a height, and all forces, with their
/// moment. The node slides at 1 m/s if there is friction.
fn pressed(height: f64, friction: f64, depth: f64) -> (Vec3<f64>, Vec3<f64>, Vec3<f64>) {
    let corners = [[-0.01, -0.012], [0.012, -0.01], [0.01, 0.011], [-0.012, 0.01]];
    // Seen from +x: z to the left, y up.
    let mut places: Vec<Vec3<f64>> = corners.iter().map(|[z, y]| Vec3::new(0.0, *y, -*z)).collect();
    let heights: Vec<f64> = places.iter().map(|p| p.y).chain([0.0]).collect();
    places.push(Vec3::new(-1e-4, height, 1e-3));
    let positions: Vec<Row<f64>> = places.iter().map(|p| Row::from_vec(*p)).collect();
    let masses = [1e-3; 5];
    let ball = BallSide { nodes: &[4], masses: &masses, areas: &[0.0, 0.0, 0.0, 0.0, 1e-6] };
    let quads = vec![[0, 1, 2, 3]];
    let face = FaceSide {
        quads,
        thickness: vec![0.0],
        rotations: None,
        masses: &masses,
        grooves: Some((Grooves { depth, ..GROOVES }, heights)),
    };
    let mut contact = DeformableContact::new(&ball, &face, friction, PenaltySprings::default(), &positions);
    let mut velocities = vec![Row::zero(); 5];
    if friction > 0.0 {
        velocities[4] = Row::from_vec(Vec3::new(0.0, 0.6, 0.8));
    }
    contact.assemble(&positions, &velocities, 1e-6);
    let (mut sum, mut moment, mut on_ball) = (Vec3::zero(), Vec3::zero(), Vec3::zero());
    for (&node, force) in contact.nodes().iter().zip(contact.forces()) {
        let place = places[node as usize];
        sum += force.vec();
        moment += place.cross(force.vec());
        if node == 4 {
            on_ball = force.vec();
        }
    }
    (on_ball, sum, moment)
}

#[test]
fn walls_push_sideways_and_floors_are_deep() {
    let size = pressed(0.0, 0.0, 0.0).0.norm();
    assert!(size > 1.0);
    for height in [0.0, MIDDLE, MIDDLE + WALL, MIDDLE - WALL, MIDDLE + 0.46e-3, 3.5e-3] {
        let (_, sum, moment) = pressed(height, 0.3, GROOVES.depth);
        // The foot of a first search is found to 1e-10 of the size of the face.
        assert!(sum.norm() < 1e-12 * size && moment.norm() < 1e-11 * size, "{sum:?} {moment:?}");
        let (force, sum, moment) = pressed(height, 0.0, GROOVES.depth);
        assert!(sum.norm() < 1e-12 * size && moment.norm() < 1e-11 * size, "{sum:?} {moment:?}");
        let (depth, slope) = GROOVES.relief(height);
        // The face gives way differently from place to place, so the land there is the measure.
        let land = pressed(height, 0.0, 0.0).0.norm();
        // Distance from the wall along its normal (1, slope): what is pressed in is less by the depth.
        let steep = (1.0 + slope * slope).sqrt();
        let expected = if depth < 1e-4 {
            Vec3::new(1.0, slope, 0.0) * (land * (1e-4 - depth) / 1e-4 / (steep * steep))
        } else {
            Vec3::zero()
        };
        // 1e-12 m in the place of the foot, of 1e-5 m and more.
        assert!((force - expected).norm() < 1e-6 * size, "{height}: {force:?} {expected:?}");
    }
    // At 0.46 mm from the middle the wall is met.
    assert!(pressed(MIDDLE + 0.46e-3, 0.0, GROOVES.depth).0.y < -1e-3 * size);
}
