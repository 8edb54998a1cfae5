//! Everything that goes into one impact: club, ball and delivery, and their table of names, units and signs.

use crate::ball::Ball;
use crate::club::Club;
use crate::delivery::Delivery;
use clubface_math::Scalar;

/// One scalar input of an impact.
#[derive(Clone, Copy, Debug)]
pub struct Input {
    /// Name, as in the Python API.
    pub name: &'static str,
    /// "delivery", "club" or "ball".
    pub group: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// What it is, and what positive means.
    pub meaning: &'static str,
    /// Whether launch is differentiable with respect to it.
    pub differentiable: bool,
}

const fn input(
    name: &'static str,
    group: &'static str,
    unit: &'static str,
    meaning: &'static str,
    differentiable: bool,
) -> Input {
    Input { name, group, unit, meaning, differentiable }
}

/// Number of inputs that describe the delivery: the first ones.
pub const DELIVERY_COUNT: usize = 11;

/// Number of inputs.
pub const INPUT_COUNT: usize = 30;

/// All inputs, in the order of the columns of a batch.
pub const INPUTS: [Input; INPUT_COUNT] = [
    input("speed", "delivery", "m/s", "speed of the clubhead CG", true),
    input("attack", "delivery", "rad", "attack angle: clubhead CG moving up is positive", true),
    input("path", "delivery", "rad", "club path: clubhead CG moving right of target is positive", true),
    input("loft", "delivery", "rad", "dynamic loft: face normal at the face centre above horizontal", true),
    input("face", "delivery", "rad", "face angle: face normal pointing right of target is positive", true),
    input(
        "lie",
        "delivery",
        "rad",
        "lie tilt about the horizontal axis to the target: toe up is positive",
        true,
    ),
    input(
        "toe",
        "delivery",
        "m",
        "impact offset towards the toe, in the plane tangent at the face centre",
        true,
    ),
    input(
        "high",
        "delivery",
        "m",
        "impact offset towards the crown, in the plane tangent at the face centre",
        true,
    ),
    input("closure", "delivery", "rad/s", "closure rate about the world vertical: closing is positive", true),
    input(
        "pitch_rate",
        "delivery",
        "rad/s",
        "rate of loft about the horizontal to the right: increasing is positive",
        true,
    ),
    input(
        "lie_rate",
        "delivery",
        "rad/s",
        "rate of lie about the horizontal to the target: toe up is positive",
        true,
    ),
    input("club_mass", "club", "kg", "mass of the clubhead", true),
    input("cg_x", "club", "m", "CG to face centre, along x (to the target) at static loft", true),
    input("cg_y", "club", "m", "CG to face centre, along y (up) at static loft", true),
    input("cg_z", "club", "m", "CG to face centre, along z (to the toe) at static loft", true),
    input("ixx", "club", "kg m2", "inertia about the CG at static loft, element xx", true),
    input("iyy", "club", "kg m2", "inertia about the CG at static loft, element yy", true),
    input("izz", "club", "kg m2", "inertia about the CG at static loft, element zz", true),
    input("ixy", "club", "kg m2", "inertia about the CG at static loft, element xy", true),
    input("ixz", "club", "kg m2", "inertia about the CG at static loft, element xz", true),
    input("iyz", "club", "kg m2", "inertia about the CG at static loft, element yz", true),
    input("static_loft", "club", "rad", "loft of the club", true),
    input("bulge", "club", "m", "horizontal radius of the face, infinite if flat", true),
    input("roll", "club", "m", "vertical radius of the face, infinite if flat", true),
    input(
        "face_width",
        "club",
        "m",
        "width of the face outline, heel to toe, centred on the face centre",
        false,
    ),
    input("face_height", "club", "m", "height of the face outline, centred on the face centre", false),
    input("hand", "club", "1", "1 for a right-handed club, -1 for its mirror image", false),
    input("ball_mass", "ball", "kg", "mass of the ball", true),
    input("ball_radius", "ball", "m", "radius of the ball", true),
    input("ball_inertia", "ball", "kg m2", "moment of inertia of the ball about any diameter", true),
];

/// A club, a ball and how they meet.
#[derive(Clone, Copy, Debug)]
pub struct Shot<S> {
    /// How the club is delivered.
    pub delivery: Delivery<S>,
    /// The clubhead.
    pub club: Club<S>,
    /// The ball.
    pub ball: Ball<S>,
}

impl<S: Scalar> Shot<S> {
    /// From values in the order of [`INPUTS`].
    #[inline(always)]
    pub fn from_inputs(v: &[S; INPUT_COUNT]) -> Self {
        Self {
            delivery: Delivery {
                speed: v[0],
                attack: v[1],
                path: v[2],
                loft: v[3],
                face: v[4],
                lie: v[5],
                toe: v[6],
                high: v[7],
                closure: v[8],
                pitch_rate: v[9],
                lie_rate: v[10],
            },
            club: Club {
                mass: v[11],
                cg_to_face: clubface_math::Vec3::new(v[12], v[13], v[14]),
                inertia: [v[15], v[16], v[17], v[18], v[19], v[20]],
                static_loft: v[21],
                bulge: v[22],
                roll: v[23],
                face_width: v[24],
                face_height: v[25],
                hand: v[26],
            },
            ball: Ball { mass: v[27], radius: v[28], inertia: v[29] },
        }
    }
}
