//! The steppers against solutions known in closed form: order, stability, control of the error, and lanes that do
//! not see each other.

mod control;
mod neighbours;
mod order;
mod problems;
mod stability;
