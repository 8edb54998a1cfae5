//! The shape of a shot: how far the ball curves from the line on which it starts, and what golfers call that.
//!
//! The *curve* is the distance of the landing from the line on which the ball starts. It is measured across that line, so
//! that a shot which is turned to the left or right as a whole curves as much as before; wind is part of it. The names
//! follow from start and curve alone: a push or pull starts off the target line, a draw or fade curves, a hook or slice
//! curves much. Where the ball lands is stated as a number next to the name.
//!
//! The limits are those of Open Golf Coach 0.3 (<https://docs.rs/crate/opengolfcoach/0.3.0>, shot_classifier.rs), a public
//! library that names the shots of simulators: a push or pull starts more than 3 degrees off the target line; a shot
//! curves from 3 degrees of spin axis on, and much from 12 degrees on. Measured and computed flights have no spin axis
//! that stands for wind and carry as well, so that the limits of the axis are taken as the curve they make, 0.7% of the
//! carry for a degree of axis: it is 0.6 to 1.0% for the clubs of the tours with the flight of this library.

use clubface_math::{Scalar, Vec3};
use core::f64::consts::PI;

/// Names of shots, and the limits between them.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ShotShapes {
    /// Largest angle between the start and the target line that is no push or pull, rad.
    pub straight_start: f64,
    /// Largest curve, as a share of the carry, that is neither draw nor fade: that of 3 degrees of spin axis.
    pub straight_curve: f64,
    /// Largest curve, as a share of the carry, that is no hook or slice: that of 12 degrees of spin axis.
    pub big_curve: f64,
    /// Of a right-handed player, by the start (left, straight, right) and the curve (much to the left, to the left, none,
    /// to the right, much to the right).
    pub names: [[&'static str; 5]; 3],
}

/// The shapes of shots.
pub static SHOT_SHAPES: ShotShapes = ShotShapes {
    straight_start: 3.0 * (PI / 180.0),
    straight_curve: 0.02,
    big_curve: 0.085,
    names: [
        ["pull hook", "pull draw", "pull", "pull fade", "pull slice"],
        ["hook", "draw", "straight shot", "fade", "slice"],
        ["push hook", "push draw", "push", "push fade", "push slice"],
    ],
};

/// Distance of a landing `place` (m) from the line on which a ball with this launch `velocity` starts; to the right is
/// positive.
#[inline(always)]
pub fn curve<S: Scalar>(velocity: Vec3<S>, place: Vec3<S>) -> S {
    let level = (velocity.x.squared() + velocity.z.squared()).safe_sqrt();
    // A ball that goes straight up starts along the target line.
    let upright = level.le(S::zero());
    let along = S::select(upright, S::one(), level);
    let across = (place.z * velocity.x - place.x * velocity.z) / along;
    S::select(upright, place.z, across)
}

/// The same of what a monitor reports: launch direction `azimuth` (rad), straight distance to the landing `carry` (m) and
/// distance of the landing from the target line `side` (m), both right of it positive.
#[must_use]
pub fn curve_from(azimuth: f64, carry: f64, side: f64) -> f64 {
    let along = (carry * carry - side * side).max(0.0).sqrt();
    side * azimuth.cos() - along * azimuth.sin()
}

/// What golfers call a shot that starts in direction `azimuth` (rad) and curves by `curve` (m) over `carry` (m), such as
/// "pull hook"; empty for one that does not fly. `hand` is 1 for a right-handed player, -1 for a left-handed one, whose
/// push starts left and whose draw curves right.
#[must_use]
pub fn shot_shape(azimuth: f64, curve: f64, carry: f64, hand: f64) -> &'static str {
    let (start, share) = (azimuth * hand, curve * hand / carry);
    if carry.is_nan() || carry <= 0.0 || start.is_nan() || share.is_nan() {
        return "";
    }
    let beyond = |value: f64, limit: f64| i8::from(value > limit) - i8::from(value < -limit);
    let side = 1 + beyond(start, SHOT_SHAPES.straight_start);
    let bend = 2 + beyond(share, SHOT_SHAPES.straight_curve) + beyond(share, SHOT_SHAPES.big_curve);
    SHOT_SHAPES.names[side as usize][bend as usize]
}
