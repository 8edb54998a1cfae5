//! Parts of material laws.

mod hardening;
mod stretch;
