//! Cases: a ball and what it meets.

mod deformable_head;
mod rigid_face;

pub use deformable_head::ball_against_deformable_head;
pub(crate) use deformable_head::deformable_head_in_steps;
pub(crate) use rigid_face::rigid_head_in_steps;
pub use rigid_face::{ball_against_plane, ball_against_rigid_head};
