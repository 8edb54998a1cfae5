//! A struck ball ([`clubface_impact::struck_ball`]) as a unit for co-simulation: what a master of FMI 2.0 or 3.0 calls.
//!
//! One library serves every exported unit: what a unit is stands in `resources/impact.json`, which the exporter writes
//! next to the description of the model. It names the variables in the order of their value references.

// The names are those of the standard.
#![allow(non_snake_case)]
// Every function takes what a master passes, as the standard says.
#![allow(clippy::missing_safety_doc)]

mod fmi2;
mod fmi3;
mod unit;

pub use unit::{Setup, Unit};
