//! Checks of shells against closed forms and published solutions.

mod benchmarks;
mod heads;
mod patches;
mod plates;
mod support;
mod yielding;
