//! Stress and strain in elements, for those who look at them; the forces need neither in these axes.

use super::one_point::Hexahedron;
use super::one_point_constants::Constants;
use super::point::Visitor;
use super::BLOCK;
use crate::material::{stretch::Stretches, InelasticLaw, Kinematics, StateVariables, Symmetric};
use clubface_math::{Mat3, Pack, Scalar};

/// What an element feels, in the axes of the positions.
#[derive(Clone, Copy, Debug, Default)]
pub struct ElementOutput {
    /// Cauchy stress, Pa, components as of [`Symmetric`]: on the outer and the inner side of a shell, twice that of a solid element.
    pub stress: [[f64; 6]; 2],
    /// Logarithmic strain in the same places; of a shell only the elastic part.
    pub strain: [[f64; 6]; 2],
    /// Equivalent plastic strain, the largest of the element.
    pub plastic_strain: f64,
}

impl ElementOutput {
    /// One lane, outer and inner side.
    #[inline(always)]
    pub fn of<P: Pack>(
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

/// Who is told, by the number of an element in its mesh.
pub type OutputSink<'a> = dyn FnMut(usize, &ElementOutput) + 'a;

/// Cauchy stress, Pa, from `2 dW/dC̄` and `dW/dJ`.
#[inline(always)]
pub fn cauchy<S: Scalar>(
    f: &Mat3<S>,
    at: &Kinematics<S>,
    stress: &Symmetric<S>,
    pressure: S,
) -> Symmetric<S> {
    at.second_piola(stress, pressure, at.inverse_volume).seen_through(f)
}

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

/// Looks at one-point elements.
pub struct OutputVisitor<'a, 'b, P: Pack, M> {
    /// Law of the change of shape.
    pub law: M,
    /// Bulk modulus, Pa.
    pub bulk: P,
    /// StateVariables of all blocks.
    pub state: &'a StateVariables<P::Real>,
    /// Number of the element in every lane of the blocks, if there is one.
    pub numbers: &'a [Option<u32>],
    /// Who is told.
    pub sink: &'a mut OutputSink<'b>,
}

impl<P: Pack, M: InelasticLaw<P>> Visitor<P> for OutputVisitor<'_, '_, P, M> {
    #[inline(always)]
    fn visit(&mut self, block: usize, first: usize, constants: &Constants<P>, element: &Hexahedron<P>) {
        let f = element.gradient(constants);
        let at = Kinematics::new(f);
        // A copy: who looks changes nothing.
        let mut state = self.state.copy(block);
        let mut state = state.of(0, first);
        let stress = self.law.advance(&at, &mut state);
        let stress = cauchy(&f, &at, &stress, self.bulk * (at.deformation.volume - 1.0));
        let (strain, plastic) = (logarithmic(&f, &at), self.law.plastic_strain(&state));
        for which in 0..P::LANES {
            let Some(number) = self.numbers[block * BLOCK + first + which] else { continue };
            (self.sink)(number as usize, &ElementOutput::of([&stress; 2], [&strain; 2], plastic, which));
        }
    }
}
