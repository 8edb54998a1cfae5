//! The impact models against closed forms, conservation laws, symmetries, published figures and each other.

mod accuracy;
mod area;
mod bad_input;
mod batches;
mod delivery;
mod derivatives;
mod face;
mod gear_effect;
mod histories;
mod impulse;
mod jorgensen;
mod lanes;
mod laws;
mod normal_impact;
mod one_dimension;
mod overlap;
mod published;
mod rigid;
mod shots;
mod symmetry;
