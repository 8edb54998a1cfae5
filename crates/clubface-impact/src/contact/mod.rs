//! Contact of two free rigid bodies, integrated until they separate (Caldwell and McPhee, section 2.2).
//!
//! All vectors are in face axes, which are fixed in the clubhead: the face and the clubhead's inertia are constant
//! there, and its attitude is needed only to turn the result into world axes. Linear momentum is kept exactly, since
//! only the relative velocity is integrated.

mod dynamics;
mod frame;
mod head_motion;
mod history;
mod law;
mod linear;
mod recorder;
mod run;
mod separation;
mod state;
#[cfg(feature = "multibody")]
mod stepped;

pub use dynamics::{Bodies, Contact, Loads};
pub use frame::Frame;
pub use head_motion::motions;
pub use history::History;
pub use law::{ContactLaw, Core, Indentation, Sliding};
pub use linear::ContactJacobian;
pub use recorder::{Recorder, RingFrame, Unrecorded};
pub use run::run;
pub use separation::Separation;
#[cfg(feature = "multibody")]
pub(crate) use separation::{hermite_root, parabola_peak};
pub use state::{
    BALL_SPIN, CLUB_SPIN, ContactPoint, LAYERED, LAYERED_GIVING, POSITION, RECORDED_LAYERED,
    RECORDED_SLIDING, RECORDED_SOLID, SLIDING, SLIP, SOLID, SOLID_GIVING, VELOCITY, face, initial, scales,
};
#[cfg(feature = "multibody")]
pub use stepped::{Instant, RelativeMotion, SteppedContact, stepped};
