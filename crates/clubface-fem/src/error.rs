//! What can go wrong.

use thiserror::Error;

/// A request that cannot be met, or a run that had to stop.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FemError {
    /// An input that makes no sense.
    #[error("{name} is {value}: {allowed}")]
    Input {
        /// What was given, such as "cover.poisson".
        name: String,
        /// Its value, with unit.
        value: String,
        /// What is allowed, and what to do.
        allowed: String,
    },
    /// An element was squeezed or stretched beyond what its law can follow.
    #[error("element {element} of {part} {} at {microseconds:.0} us: the time step is too long (a smaller `safety` helps), the mesh too coarse, or the material too soft for this impact", fate(*ratio))]
    ElementLost {
        /// Number of the most strained element in the mesh of the body.
        element: usize,
        /// Piece of the ball, or part of the head.
        part: String,
        /// Current over reference volume.
        ratio: f64,
        /// Time, us.
        microseconds: f64,
    },
    /// The energies no longer add up.
    #[error("the energies were off by {} at {microseconds:.0} us (1% is allowed): {}", off(*percent), cause(*edge, *element, part))]
    Energy {
        /// Number of the most strained element in the mesh of the body.
        element: usize,
        /// Its piece of the ball, or part of the head.
        part: String,
        /// Error over the initial kinetic energy, per cent.
        percent: f64,
        /// Whether the ball has reached round the edge of the face.
        edge: bool,
        /// Time, us.
        microseconds: f64,
    },
    /// The ball and the face never met.
    #[error("the ball and the face did not meet in {microseconds:.0} us: the head moves away from the ball, or passes it")]
    Missed {
        /// Simulated time, us.
        microseconds: f64,
    },
    /// The ball has not left yet.
    #[error("the ball was still on the face at {microseconds:.0} us, so there is no launch yet: a longer `duration` helps")]
    Unfinished {
        /// Simulated time, us.
        microseconds: f64,
    },
    /// Stopped by request.
    #[error("stopped at {microseconds:.0} us by request")]
    Interrupted {
        /// Time, us.
        microseconds: f64,
    },
}

impl FemError {
    /// An input that is not allowed.
    pub fn input(name: impl Into<String>, value: impl std::fmt::Display, allowed: impl Into<String>) -> Self {
        Self::Input { name: name.into(), value: value.to_string(), allowed: allowed.into() }
    }

    /// Whether the model broke down: what it found last is worth nothing.
    #[must_use]
    pub fn failed(&self) -> bool {
        matches!(self, Self::ElementLost { .. } | Self::Energy { .. })
    }
}

/// What became of an element, by the share of its volume that is left.
fn fate(ratio: f64) -> String {
    if ratio > 0.0 && ratio < 100.0 {
        format!("kept {ratio:.2} of its volume")
    } else {
        "was turned inside out".to_owned()
    }
}

/// An error of the energies, per cent, also where they are no number any more.
fn off(percent: f64) -> String {
    if percent < 1e3 {
        format!("{percent:.1}%")
    } else {
        "more than they are themselves".to_owned()
    }
}

/// Why energies are off, and what to do.
fn cause(edge: bool, element: usize, part: &str) -> String {
    if edge {
        return "the ball reached round the edge of the face, where contact ends; strike nearer the face centre"
            .to_owned();
    }
    format!("the time step is too long (a smaller `safety` helps), or an element is failing; the most strained is element {element} of {part}")
}
