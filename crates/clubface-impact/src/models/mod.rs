//! Impact models, one file each.

pub mod adjusted;
pub mod area;
pub mod hertz;
pub mod impulse;
pub mod jorgensen;
pub mod response;
pub mod rings;
pub mod slip;
pub mod standard;
pub mod volumetric;
