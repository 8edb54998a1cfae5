//! Errors: requests that cannot be met, and runs that had to stop.

use std::fmt;

/// A request that cannot be met, or a run that had to stop.
#[derive(Clone, Debug, PartialEq)]
pub enum FemError {
    /// An input that makes no sense.
    Input {
        /// What was given, such as "cover.poisson".
        name: String,
        /// Its value, with unit.
        value: String,
        /// What it must be, and what to do.
        allowed: String,
    },
    /// The volume of an element has left the range of its material law.
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
    /// The energy balance is off.
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
    /// The ball and the face did not touch.
    Missed {
        /// Simulated time, us.
        microseconds: f64,
    },
    /// The ball has not left the face yet.
    Unfinished {
        /// Simulated time, us.
        microseconds: f64,
    },
    /// The caller has stopped the run.
    Interrupted {
        /// Time, us.
        microseconds: f64,
    },
}

impl std::error::Error for FemError {}

impl fmt::Display for FemError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input { name, value, allowed } => write!(f, "{name} is {value}; {allowed}"),
            Self::ElementLost { element, part, ratio, microseconds } => write!(
                f,
                "element {element} of {part} {} at {microseconds:.0} us: the time step is too long (choose a smaller \
                 `safety`), the mesh too coarse, or the material too soft for this impact",
                volume(*ratio)
            ),
            Self::Energy { element, part, percent, edge, microseconds } => write!(
                f,
                "the energy balance was off by {} at {microseconds:.0} us (at most 1% is allowed); {}",
                percentage(*percent),
                cause(*edge, *element, part)
            ),
            Self::Missed { microseconds } => write!(
                f,
                "the ball and the face did not touch within {microseconds:.0} us; the head must move towards the ball \
                 and not pass it"
            ),
            Self::Unfinished { microseconds } => write!(
                f,
                "the ball was still on the face at {microseconds:.0} us, so there is no launch; choose a longer \
                 `duration`"
            ),
            Self::Interrupted { microseconds } => write!(f, "stopped at {microseconds:.0} us by request"),
        }
    }
}

impl FemError {
    /// An input that is not allowed. The message reads "`name` is `value`; `allowed`".
    pub fn input(name: impl Into<String>, value: impl std::fmt::Display, allowed: impl Into<String>) -> Self {
        Self::Input { name: name.into(), value: value.to_string(), allowed: allowed.into() }
    }

    /// An unknown name of something of which some are known.
    pub fn unknown<'a>(what: &str, name: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        let known: Vec<_> = known.into_iter().collect();
        Self::input(what, format!("{name:?}"), format!("it must be one of {}", known.join(", ")))
    }

    /// Whether the model broke down, so that the last results are worth nothing.
    #[must_use]
    pub fn failed(&self) -> bool {
        matches!(self, Self::ElementLost { .. } | Self::Energy { .. })
    }
}

/// The volume of an element, by its ratio to that at rest.
fn volume(ratio: f64) -> String {
    if ratio > 0.0 && ratio < 100.0 {
        format!("had {ratio:.2} times its original volume")
    } else {
        "was turned inside out".to_owned()
    }
}

/// An error of the energies, per cent, also if it is not a number any more.
fn percentage(percent: f64) -> String {
    if percent < 1e3 {
        format!("{percent:.1}% of the initial kinetic energy")
    } else {
        "more than ten times the initial kinetic energy".to_owned()
    }
}

/// Why the energy balance is off, and what to do.
fn cause(edge: bool, element: usize, part: &str) -> String {
    if edge {
        return "the ball reached round the edge of the face, where contact ends: hit it nearer the face centre"
            .to_owned();
    }
    format!(
        "the time step is too long (choose a smaller `safety`) or an element is failing, most likely the most strained one, element {element} of {part}"
    )
}
