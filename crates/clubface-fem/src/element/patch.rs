//! Interface between the solver and patches of elements of any kind.

use super::field::Scratch;
use super::output::OutputSink;
use crate::moments::{Moments, Origin};
use clubface_math::{Pack, Real, Row};

/// Ratios of current to reference volume between which the laws hold.
pub const RATIOS: (f64, f64) = (0.3, 2.5);

/// Energies of a group of elements, J.
#[derive(Clone, Copy, Debug, Default)]
pub struct Energy {
    /// Elastic.
    pub strain: f64,
    /// Energy of the hourglass modes, in which the point of one-point elements has no strain.
    pub hourglass: f64,
    /// Done on viscoelastic branches: stored there or turned into heat.
    pub viscous: f64,
    /// Turned into heat by plastic flow.
    pub plastic: f64,
}

/// What a patch reports of a step.
#[derive(Clone, Copy, Debug)]
pub struct StepOutput {
    /// Energies.
    pub energy: Energy,
    /// Smallest and largest ratio of current to reference volume.
    pub ratios: (f64, f64),
    /// Kinetic energy of the interior nodes between their velocities before and after the step, J.
    pub kinetic: f64,
}

impl std::ops::AddAssign for Energy {
    fn add_assign(&mut self, other: Self) {
        self.strain += other.strain;
        self.hourglass += other.hourglass;
        self.viscous += other.viscous;
        self.plastic += other.plastic;
    }
}

impl Energy {
    /// Sum of all.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.strain + self.hourglass + self.viscous + self.plastic
    }
}

/// A part of the structure that is worked on by one thread at a time: some elements, and the forces on their nodes.
pub trait Patch<R: Real>: Send + Sync {
    /// Nodes the patch exerts forces on.
    fn nodes(&self) -> &[u32];
    /// Computes the forces for the given positions (m) and velocities (m/s) of all nodes; state variables move on by
    /// `dt` seconds.
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64);
    /// Computes the forces after small displacements (m, or rad) to the given positions, the state variables left as
    /// they are. Elements whose stress follows from positions alone need only those, in no time.
    fn perturbed_forces(&mut self, positions: &[Row<R>], displacements: &[Row<R>]) {
        self.assemble(positions, displacements, 0.0);
    }
    /// Rough time that the forces take, ns: to give threads as much to do.
    fn cost(&self) -> usize;
    /// Forces on [`Patch::nodes`], N.
    fn forces(&self) -> &[Row<R>];
    /// Whether all volumes were within [`RATIOS`] of the undeformed ones when the last forces were made.
    fn volumes_valid(&self) -> bool {
        true
    }
    /// Energies at the given positions, and the smallest and largest ratio of current to reference volume; the state
    /// stays as it is.
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64));
    /// Gives the sink stress and strain of every element at the given positions, after a step as long as the last
    /// that has passed; the state stays as it is.
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>);
    /// Energies at the given positions; the state stays as it is.
    fn energy(&mut self, positions: &[Row<R>]) -> Energy {
        self.energies(positions).0
    }
    /// Gives its undeformed elements a linear bulk viscosity, if it has volumes: a pressure of `coefficient` times
    /// density, speed of waves, size and rate of volume.
    fn set_bulk_viscosity(&mut self, _coefficient: f64) {}
    /// Takes charge of the motion of some nodes in [`Patch::step`], and returns their places in [`Patch::nodes`].
    /// Given for each of them whether nothing but this patch acts on it, and its inverse mass, 1/kg.
    fn claim_interior_nodes(&mut self, _alone: &[bool], _inverse_masses: &[R]) -> Vec<u32> {
        vec![]
    }
    /// Takes the motion of interior nodes from the fields of all nodes, m and m/s.
    fn load_interior(&mut self, _positions: &[Row<R>], _velocities: &[Row<R>]) {}
    /// As [`Patch::assemble`], with forces on the nodes that are not interior, in their order; the others move on by
    /// `dt` seconds, unseen in the fields of all nodes. If asked for, reports energies at the positions from which
    /// they go on.
    fn step(
        &mut self,
        positions: &[Row<R>],
        velocities: &[Row<R>],
        dt: f64,
        _scratch: &mut Scratch<R>,
        output: Option<&mut StepOutput>,
    ) {
        self.assemble(positions, velocities, dt);
        if let Some(output) = output {
            let (energy, ratios) = self.energies(positions);
            *output = StepOutput { energy, ratios, kinetic: 0.0 };
        }
    }
    /// Moments of the interior nodes.
    fn interior_moments(&mut self, _origin: &Origin<R>) -> Moments<R> {
        Moments::zero()
    }
    /// Stores the motion of interior nodes by `give`: each node's number, its position and its velocity.
    fn store_interior(&mut self, _give: &mut dyn FnMut(u32, Row<R>, Row<R>)) {}
}

/// `0..count` in equal parts of at most `most`, give or take one.
pub fn parts(count: usize, most: usize) -> impl Iterator<Item = std::ops::Range<usize>> {
    let parts = count.div_ceil(most);
    (0..parts).map(move |part| part * count / parts..(part + 1) * count / parts)
}

/// Smallest and largest ratio of current to reference volume of some elements.
#[derive(Clone, Copy)]
pub struct Ratios<P> {
    least: P,
    most: P,
}

impl<P: Pack> Ratios<P> {
    /// Ratios of undeformed elements: 1.
    #[inline(always)]
    pub fn new() -> Self {
        Self { least: P::one(), most: P::one() }
    }
    /// The same, with the ratios of a pack included.
    #[inline(always)]
    pub fn and(self, ratio: P) -> Self {
        Self { least: self.least.min(ratio), most: self.most.max(ratio) }
    }
    /// Whether the laws hold for all of them.
    #[inline(always)]
    pub fn valid(self) -> bool {
        (0..P::LANES).all(|lane| self.least.lane(lane) >= RATIOS.0 && self.most.lane(lane) <= RATIOS.1)
    }
    /// Both, of all lanes.
    #[inline(always)]
    pub fn range(self) -> (f64, f64) {
        (0..P::LANES).fold((1.0, 1.0), |(least, most): (f64, f64), lane| {
            (least.min(self.least.lane(lane)), most.max(self.most.lane(lane)))
        })
    }
}
