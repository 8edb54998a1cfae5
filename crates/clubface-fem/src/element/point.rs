//! What happens at the integration points of a pack of one-point hexahedra, however the elements find their nodes.

use super::one_point::{Face, Hexahedron, CONSTANTS};
use super::{Aligned, Energy, BLOCK};
use crate::material::{add_branches, Decay, Isochoric, Kinematics, MAX_TERMS};
use clubface_math::pack::prefetch;
use clubface_math::Pack;

/// Constants of the elements of a block.
pub type Block<R> = Aligned<[R; CONSTANTS * BLOCK]>;

/// Forces of packs of elements.
pub trait Forces<P> {
    /// Forces on the side below (added to those given) and on the side above, for the positions of both, of lanes `first..` of a block.
    fn forces(
        &mut self,
        block: usize,
        first: usize,
        low: &Face<P>,
        high: &Face<P>,
        below: &Face<P>,
    ) -> (Face<P>, Face<P>);
}

/// Something that looks at packs of elements.
pub trait Look<P> {
    /// Looks at lanes `first..` of a block, by the positions of both sides.
    fn see(&mut self, block: usize, first: usize, low: &Face<P>, high: &Face<P>);
}

/// Elements without memory.
pub struct Elastic<'a, P: Pack, L> {
    /// Law of the change of shape.
    pub law: L,
    /// By block.
    pub constants: &'a [Block<P::Real>],
    /// Bulk modulus, Pa.
    pub bulk: P,
    /// Shear modulus, Pa.
    pub shear: P,
}

impl<P: Pack, L: Isochoric<P>> Forces<P> for Elastic<'_, P, L> {
    #[inline(always)]
    fn forces(
        &mut self,
        block: usize,
        first: usize,
        low: &Face<P>,
        high: &Face<P>,
        below: &Face<P>,
    ) -> (Face<P>, Face<P>) {
        prefetch(&raw const self.constants[block], 1);
        let element = Hexahedron::new(&self.constants[block].0, first, low, high);
        let at = Kinematics::new(element.gradient());
        // Between the roots in the kinematics and the stress that waits for them.
        let hourglass = element.hourglass(self.shear);
        let stress = self.law.stress(&at.c);
        let pressure = self.bulk * (at.volume - 1.0);
        element.forces(&at.weighted_piola(&stress, pressure, -element.volume), &hourglass, below)
    }
}

/// Elements with viscoelastic branches.
pub struct Viscous<'a, P: Pack, L> {
    /// The elements without their branches.
    pub elastic: Elastic<'a, P, L>,
    /// Decay of the branches in a step.
    pub decays: &'a [Decay<P>],
    /// History of all blocks.
    pub history: &'a mut [P::Real],
    /// Numbers of history an element has.
    pub history_length: usize,
}

impl<P: Pack, L: Isochoric<P>> Forces<P> for Viscous<'_, P, L> {
    #[inline(always)]
    fn forces(
        &mut self,
        block: usize,
        first: usize,
        low: &Face<P>,
        high: &Face<P>,
        below: &Face<P>,
    ) -> (Face<P>, Face<P>) {
        let Elastic { law, constants, bulk, shear } = &self.elastic;
        prefetch(&raw const constants[block], 1);
        let element = Hexahedron::new(&constants[block].0, first, low, high);
        let at = Kinematics::new(element.gradient());
        let hourglass = element.hourglass(*shear);
        let length = self.history_length;
        let stored = &mut self.history[block * length * BLOCK..(block + 1) * length * BLOCK];
        let mut history = [P::zero(); 13 + 6 * MAX_TERMS];
        for i in 0..length {
            history[i] = P::load(&stored[i * BLOCK + first..]);
        }
        let stress = add_branches(&at, law.stress(&at.c), self.decays, &mut history[..length]);
        for i in 0..length {
            history[i].store(&mut stored[i * BLOCK + first..]);
        }
        let pressure = *bulk * (at.volume - 1.0);
        element.forces(&at.weighted_piola(&stress, pressure, -element.volume), &hourglass, below)
    }
}

/// Energies and volumes of elements.
pub struct Tally<'a, P: Pack, L> {
    elastic: Elastic<'a, P, L>,
    history: &'a [P::Real],
    history_length: usize,
    /// Energies, J.
    pub energy: Energy,
    /// Smallest and largest ratio of current to reference volume.
    pub ratios: (f64, f64),
}

impl<'a, P: Pack, L> Tally<'a, P, L> {
    /// Before the first element.
    pub fn new(elastic: Elastic<'a, P, L>, history: &'a [P::Real], history_length: usize) -> Self {
        let ratios = (f64::INFINITY, f64::NEG_INFINITY);
        Self { elastic, history, history_length, energy: Energy::default(), ratios }
    }
}

impl<P: Pack, L: Isochoric<P>> Look<P> for Tally<'_, P, L> {
    #[inline(always)]
    fn see(&mut self, block: usize, first: usize, low: &Face<P>, high: &Face<P>) {
        let Elastic { law, constants, bulk, shear } = &self.elastic;
        let element = Hexahedron::new(&constants[block].0, first, low, high);
        let at = Kinematics::new(element.gradient());
        let strain = element.strain_energy(*law, *bulk, &at);
        let hourglass = element.hourglass_energy(*shear);
        let viscous = if self.history_length > 0 {
            let at = (block * self.history_length + 12) * BLOCK + first;
            P::load(&self.history[at..]) * element.volume
        } else {
            P::zero()
        };
        for lane in 0..P::LANES {
            if element.volume.lane(lane) > 0.0 {
                self.energy.strain += strain.lane(lane);
                self.energy.hourglass += hourglass.lane(lane);
                self.energy.viscous += viscous.lane(lane);
                self.ratios.0 = self.ratios.0.min(at.volume.lane(lane));
                self.ratios.1 = self.ratios.1.max(at.volume.lane(lane));
            }
        }
    }
}
