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
    /// "delivery", "club", "ball" or "parameters".
    pub group: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// What it is, and what positive means.
    pub meaning: &'static str,
    /// Whether launch is differentiable with respect to it.
    pub differentiable: bool,
}

macro_rules! inputs {
    ($($group:literal $name:ident [$unit:literal] $differentiable:literal, $meaning:literal;)+) => {
        [$(Input {
            name: stringify!($name),
            group: $group,
            unit: $unit,
            meaning: $meaning,
            differentiable: $differentiable,
        }),+]
    };
}

/// Number of inputs that describe the delivery: the first ones.
pub const DELIVERY_COUNT: usize = 14;

/// Number of inputs.
pub const INPUT_COUNT: usize = 35;

/// All inputs, in the order of the columns of a batch.
pub const INPUTS: [Input; INPUT_COUNT] = inputs! {
    "delivery" speed ["m/s"] true, "speed of the clubhead CG";
    "delivery" attack ["rad"] true, "attack angle: clubhead CG moving up is positive";
    "delivery" path ["rad"] true, "club path: clubhead CG moving right of target is positive";
    "delivery" loft ["rad"] true, "dynamic loft: face normal at the face centre above horizontal";
    "delivery" face ["rad"] true, "face angle: face normal pointing right of target is positive";
    "delivery" lie ["rad"] true, "lie tilt about the horizontal axis to the target: toe up is positive";
    "delivery" toe ["m"] true, "impact offset towards the toe, in the plane tangent at the face centre";
    "delivery" high ["m"] true, "impact offset towards the crown, in the plane tangent at the face centre";
    "delivery" closure ["rad/s"] true, "closure rate about the world vertical: closing is positive";
    "delivery" pitch_rate ["rad/s"] true,
        "rate of loft about the horizontal to the right: increasing is positive";
    "delivery" lie_rate ["rad/s"] true, "rate of lie about the horizontal to the target: toe up is positive";
    "delivery" ball_backspin ["rad/s"] true,
        "spin of the ball before impact about the horizontal to the right of the target; 0 for a ball at rest";
    "delivery" ball_sidespin ["rad/s"] true,
        "spin of the ball before impact about the downward vertical; 0 for a ball at rest";
    "delivery" ball_riflespin ["rad/s"] true,
        "spin of the ball before impact about the horizontal to the target; 0 for a ball at rest";
    "club" club_mass ["kg"] true, "mass of the clubhead";
    "club" cg_x ["m"] true, "CG to face centre, along x (to the target) at static loft";
    "club" cg_y ["m"] true, "CG to face centre, along y (up) at static loft";
    "club" cg_z ["m"] true, "CG to face centre, along z (to the toe) at static loft";
    "club" ixx ["kg m2"] true, "inertia about the CG at static loft, element xx";
    "club" iyy ["kg m2"] true, "inertia about the CG at static loft, element yy";
    "club" izz ["kg m2"] true, "inertia about the CG at static loft, element zz";
    "club" ixy ["kg m2"] true, "inertia about the CG at static loft, element xy";
    "club" ixz ["kg m2"] true, "inertia about the CG at static loft, element xz";
    "club" iyz ["kg m2"] true, "inertia about the CG at static loft, element yz";
    "club" static_loft ["rad"] true, "loft of the club";
    "club" bulge ["m"] true, "horizontal radius of the face, infinite if flat";
    "club" roll ["m"] true, "vertical radius of the face, infinite if flat";
    "club" face_width ["m"] false, "width of the face outline, heel to toe, centred on the face centre";
    "club" face_height ["m"] false, "height of the face outline, centred on the face centre";
    "club" characteristic_time ["s"] true, "how long the face gives under the rules' pendulum; 0 is rigid";
    "club" hand ["1"] false, "1 for a right-handed club, -1 for its mirror image";
    "ball" ball_mass ["kg"] true, "mass of the ball";
    "ball" ball_radius ["m"] true, "radius of the ball";
    "ball" ball_inertia ["kg m2"] true, "moment of inertia of the ball about any diameter";
    "parameters" included_time ["s"] false, "characteristic time of the face that the parameters include";
};

/// A club, a ball and how they meet.
#[derive(Clone, Copy, Debug)]
pub struct Shot<S> {
    /// How the club is delivered.
    pub delivery: Delivery<S>,
    /// The clubhead.
    pub club: Club<S>,
    /// The ball.
    pub ball: Ball<S>,
    /// Characteristic time of the face that the parameters of the model include, s; 0 if they are of the ball alone.
    pub included_time: S,
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
                ball_backspin: v[11],
                ball_sidespin: v[12],
                ball_riflespin: v[13],
            },
            club: Club {
                mass: v[14],
                cg_to_face: clubface_math::Vec3::new(v[15], v[16], v[17]),
                inertia: [v[18], v[19], v[20], v[21], v[22], v[23]],
                static_loft: v[24],
                bulge: v[25],
                roll: v[26],
                face_width: v[27],
                face_height: v[28],
                characteristic_time: v[29],
                hand: v[30],
            },
            ball: Ball { mass: v[31], radius: v[32], inertia: v[33] },
            included_time: v[34],
        }
    }
}
