//! Checks of shells against closed forms and published solutions.

mod benchmarks;
mod heads;
mod hourglass;
mod patches;
mod plates;
mod support;
mod yielding;
