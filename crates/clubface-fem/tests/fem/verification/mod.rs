//! Verification against closed forms, published solutions and exact identities.

mod bars;
mod bounces;
mod bulk;
mod conservation;
mod damped_bounce;
mod elements;
mod face_springs;
mod fields;
mod flow;
mod friction;
mod grooves;
mod hourglass;
mod inputs;
mod laws;
mod multipliers;
mod reference;
mod spheres;
mod tetrahedra;
mod thrown;
mod viscosity;
