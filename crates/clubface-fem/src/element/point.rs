//! What happens at the integration points of a pack of one-point hexahedra, however the elements find their nodes.

use super::one_point::{Constants, Hexahedron, CONSTANTS};
use super::{Aligned, Energy, BLOCK};
use crate::material::{add_branches, Decay, Deformation, Isochoric, Kinematics, Symmetric, MAX_TERMS};
use clubface_math::Pack;

/// Constants of the elements of a block.
pub type Block<R> = Aligned<[R; CONSTANTS * BLOCK]>;

/// Stress at the points of packs of elements.
pub trait Points<P: Pack> {
    /// Second Piola-Kirchhoff stress (Pa) times minus the reference volume (m3) at the points of lanes `first..` of a block; histories move on by a step.
    fn stress(&mut self, block: usize, first: usize, volume: P, at: &Deformation<P>) -> Symmetric<P>;
}

/// Something that looks at packs of elements.
pub trait Look<P: Pack> {
    /// Looks at lanes `first..` of a block.
    fn see(&mut self, block: usize, first: usize, constants: &Constants<P>, element: &Hexahedron<P>);
}

/// Elements without memory.
pub struct Elastic<P, L> {
    /// Law of the change of shape.
    pub law: L,
    /// Bulk modulus, Pa.
    pub bulk: P,
}

impl<P: Pack, L> Elastic<P, L> {
    #[inline(always)]
    fn pressure(&self, at: &Deformation<P>) -> P {
        self.bulk * (at.volume - 1.0)
    }
}

impl<P: Pack, L: Isochoric<P>> Points<P> for Elastic<P, L> {
    #[inline(always)]
    fn stress(&mut self, _block: usize, _first: usize, volume: P, at: &Deformation<P>) -> Symmetric<P> {
        self.law.second_piola(at, self.pressure(at), -volume)
    }
}

/// Elements with viscoelastic branches.
pub struct Viscous<'a, P: Pack, L> {
    /// The elements without their branches.
    pub elastic: Elastic<P, L>,
    /// Decay of the branches in a step.
    pub decays: &'a [Decay<P>],
    /// History of all blocks.
    pub history: &'a mut [P::Real],
    /// Numbers of history an element has.
    pub history_length: usize,
}

impl<P: Pack, L: Isochoric<P>> Points<P> for Viscous<'_, P, L> {
    #[inline(always)]
    fn stress(&mut self, block: usize, first: usize, volume: P, at: &Deformation<P>) -> Symmetric<P> {
        let length = self.history_length;
        let stored = &mut self.history[block * length * BLOCK..(block + 1) * length * BLOCK];
        let mut history = [P::zero(); 13 + 6 * MAX_TERMS];
        for i in 0..length {
            history[i] = P::load(&stored[i * BLOCK + first..]);
        }
        let kinematics = Kinematics::of(*at);
        let stress = self.elastic.law.stress(&kinematics.c);
        let stress = add_branches(&kinematics, stress, self.decays, &mut history[..length]);
        for i in 0..length {
            history[i].store(&mut stored[i * BLOCK + first..]);
        }
        kinematics.second_piola(&stress, self.elastic.pressure(at), -volume)
    }
}

/// Energies and volumes of elements.
pub struct Tally<'a, P: Pack, L> {
    elastic: Elastic<P, L>,
    history: &'a [P::Real],
    history_length: usize,
    /// Energies, J.
    pub energy: Energy,
    /// Smallest and largest ratio of current to reference volume.
    pub ratios: (f64, f64),
}

impl<'a, P: Pack, L> Tally<'a, P, L> {
    /// Before the first element.
    pub fn new(elastic: Elastic<P, L>, history: &'a [P::Real], history_length: usize) -> Self {
        let ratios = (f64::INFINITY, f64::NEG_INFINITY);
        Self { elastic, history, history_length, energy: Energy::default(), ratios }
    }
}

impl<P: Pack, L: Isochoric<P>> Look<P> for Tally<'_, P, L> {
    #[inline(always)]
    fn see(&mut self, block: usize, first: usize, constants: &Constants<P>, element: &Hexahedron<P>) {
        let Elastic { law, bulk } = &self.elastic;
        let kinematics = Kinematics::new(element.gradient(constants));
        let (reference, ratio) = (constants.volume(), kinematics.deformation.volume);
        let dilation = ratio - 1.0;
        let strain = (law.energy(&kinematics.c) + *bulk * dilation * dilation * 0.5) * reference;
        let hourglass = element.hourglass_energy(constants);
        let viscous = if self.history_length > 0 {
            let at = (block * self.history_length + 12) * BLOCK + first;
            P::load(&self.history[at..]) * reference
        } else {
            P::zero()
        };
        for lane in 0..P::LANES {
            if reference.lane(lane) > 0.0 {
                self.energy.strain += strain.lane(lane);
                self.energy.hourglass += hourglass.lane(lane);
                self.energy.viscous += viscous.lane(lane);
                self.ratios.0 = self.ratios.0.min(ratio.lane(lane));
                self.ratios.1 = self.ratios.1.max(ratio.lane(lane));
            }
        }
    }
}
