//! Stress and strain in elements, in the axes of the positions; the forces need neither in these axes.

use crate::material::{Kinematics, Symmetric, stretch::Stretches};
use clubface_math::{Mat3, Pack, Scalar};

/// Output of an element, in the axes of the positions.
#[derive(Clone, Copy, Debug, Default)]
pub struct ElementOutput {
    /// Cauchy stress, Pa, components as in [`Symmetric`]: on the outer and the inner side of a shell, twice that of a
    /// solid element.
    pub stress: [[f64; 6]; 2],
    /// Logarithmic strain in the same places; of a shell only the elastic part.
    pub strain: [[f64; 6]; 2],
    /// Equivalent plastic strain, the largest of the element.
    pub plastic_strain: f64,
}

impl ElementOutput {
    /// One lane, outer and inner side.
    #[inline(always)]
    pub fn from_lane<P: Pack>(
        stress: [&Symmetric<P>; 2],
        strain: [&Symmetric<P>; 2],
        plastic_strain: P,
        lane: usize,
    ) -> Self {
        let numbers = |side: &Symmetric<P>| side.0.map(|component| component.lane(lane));
        Self {
            stress: stress.map(numbers),
            strain: strain.map(numbers),
            plastic_strain: plastic_strain.lane(lane),
        }
    }
}

/// What takes the output of an element, by its number in its mesh.
pub type OutputSink<'a> = dyn FnMut(usize, &ElementOutput) + 'a;

/// Logarithm of the left stretch.
#[inline(always)]
pub fn logarithmic<S: Scalar>(f: &Mat3<S>, at: &Kinematics<S>) -> Symmetric<S> {
    let identity = Symmetric::diagonal(S::one());
    let left = identity.seen_through(f).scale(at.shape);
    let stretches = Stretches::new(left.trace(), left.second());
    let [one, linear, square] = stretches.factors(&(stretches.logarithm().scale(S::from_f64(0.5))));
    let volume = at.deformation.volume.ln() * (1.0 / 3.0);
    identity.sandwich(&left).scale(square).plus(linear, &left).plus_diagonal(one + volume)
}
