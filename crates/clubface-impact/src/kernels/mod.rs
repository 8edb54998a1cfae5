//! What is compiled once for every model: launches in packs, launches with derivatives, one launch with its history.
//!
//! Only the impact itself is compiled for each model; what stands around it is one function for each kind of number.

mod derivatives;
mod launches;
mod run;

pub use derivatives::{Differentiated, derivatives};
pub use launches::launches;
#[cfg(feature = "multibody")]
pub use run::stepped;
pub use run::{MOST_PARAMETERS, history};
