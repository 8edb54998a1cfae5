//! Concentric rings: their matrices, their friction, a sphere on a plane, and the model made of them.

mod friction;
mod influence;
mod model;
mod plane;
