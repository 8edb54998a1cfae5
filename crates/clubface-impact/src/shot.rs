//! Everything that goes into one impact: club, ball and delivery, and the table of these inputs.

use crate::ball::Ball;
use crate::club::Club;
use crate::delivery::Delivery;
use crate::quantity::{Quantity, known};
use clubface_math::Scalar;

/// One scalar input of an impact.
#[derive(Clone, Copy, Debug)]
pub struct Input {
    /// Its name, unit, meaning and sign.
    pub quantity: &'static Quantity,
    /// "delivery", "club", "ball" or "parameters".
    pub group: &'static str,
    /// Whether launch is differentiable with respect to it.
    pub differentiable: bool,
}

macro_rules! inputs {
    ($($group:literal { $($name:ident $(($mark:ident))?)+ })+) => {
        [$($(Input {
            quantity: known(stringify!($name)),
            group: $group,
            differentiable: inputs!(@differentiable $($mark)?),
        }),+),+]
    };
    (@differentiable) => { true };
    (@differentiable constant) => { false };
}

/// Number of inputs that describe the delivery: the first ones.
pub const DELIVERY_COUNT: usize = 14;

/// Number of inputs.
pub const INPUT_COUNT: usize = 35;

/// All inputs, in the order of the columns of a batch; launch is not differentiated with respect to a `constant` one.
pub const INPUTS: [Input; INPUT_COUNT] = inputs! {
    "delivery" {
        speed attack path loft face lie toe high closure pitch_rate lie_rate ball_backspin ball_sidespin
        ball_riflespin
    }
    "club" {
        club_mass cg_x cg_y cg_z ixx iyy izz ixy ixz iyz static_loft bulge roll face_width (constant)
        face_height (constant) characteristic_time hand (constant)
    }
    "ball" { ball_mass ball_radius ball_inertia }
    "parameters" { included_time (constant) }
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
