//! Impact models and flight against closed forms, conservation laws, symmetries, published figures and each other.

// Helpers outside test functions may panic like tests; a negated comparison lets a NaN fail.
#![allow(clippy::unwrap_used, clippy::neg_cmp_op_on_partial_ord, clippy::type_complexity)]

mod accuracy;
mod area;
mod attachment;
mod bad_input;
mod batch_derivatives;
mod batches;
mod delivery;
mod derivatives;
mod face;
mod face_spring;
mod flight;
mod gear_effect;
mod giving_face;
mod histories;
mod impulse;
mod jorgensen;
mod lanes;
mod laws;
mod linearized;
mod normal_impact;
mod one_dimension;
mod overlap;
mod published;
mod quadratic_spring;
mod quantities;

mod response;
mod rigid;
mod rings;
mod shots;
mod stepped;
mod symmetry;
