//! The ball.

/// A ball.
#[derive(Clone, Copy, Debug)]
pub struct Ball<S> {
    /// Mass, kg.
    pub mass: S,
    /// Radius, m.
    pub radius: S,
    /// Moment of inertia about any diameter, kg m2.
    pub inertia: S,
}
