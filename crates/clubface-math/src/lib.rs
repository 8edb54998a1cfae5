//! Arithmetic that physics is written on: one [`Scalar`] trait that `f64`, packs of numbers ([`pack`]) and dual
//! numbers ([`Dual`]) implement, small vectors and matrices over it, and ODE steppers that treat every lane on its own.

pub mod dual;
pub mod elementary;
pub mod mat3;
pub mod ode;
pub mod pack;
pub mod quat;
pub mod scalar;
pub mod vec3;

pub use dual::Dual;
pub use mat3::Mat3;
pub use pack::{
    Kernel, Lanes, Numbers, Pack, PackKernel, Part, Real, Row, RowsKernel, dispatch, dispatch_rows,
    with_lanes,
};
pub use quat::Quat;
pub use scalar::{Computation, Mask, Scalar};
pub use vec3::Vec3;
