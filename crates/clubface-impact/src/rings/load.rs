//! What rings are made of and what presses them together.

/// Friction and tangential elasticity of the surfaces.
#[derive(Clone, Copy, Debug)]
pub struct RingMaterial<S> {
    /// Coefficient of friction mu, 1. At zero there is no force and no derivative.
    pub friction: S,
    /// Effective Poisson's ratio nu, 1.
    pub poisson: S,
    /// Effective shear modulus G of the tangential compliance (2 - nu)/(8 G), Pa.
    pub modulus: S,
}

/// Normal load at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Load<S> {
    /// Normal force F_N, N; not positive without contact. The pressure is 3 F_N/(2 pi a^2) sqrt(1 - r^2/a^2).
    pub force: S,
    /// Contact radius a, m.
    pub radius: S,
}
