//! Numbers, packs, rotations and steppers against closed forms, published constants and each other.

mod dual;
mod elementary;
mod lanes;
mod ode;
mod packs;
mod rotations;
