//! Interface between the solver and patches of one-point hexahedra.

use super::lattice::Lattice;
use super::output::{Energies, Output};
use super::patch::{Arrangement, SolidPatch};
use super::stress::Stress;
use crate::block::BLOCK;
use crate::element::bulk_viscosity::{BulkViscosity, Drag};
use crate::element::field::Scratch;
use crate::element::output::OutputSink;
use crate::element::patch::{Energy, Patch, Ratios, StepOutput};
use crate::moments::{Moments, Origin};
use clubface_math::{Pack, PackKernel, Real, Row};

impl<R: Real> Patch<R> for SolidPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes[..self.nodes.len() - BLOCK]
    }
    fn assemble(&mut self, positions: &[Row<R>], _velocities: &[Row<R>], dt: f64) {
        self.check(positions);
        let scratch = &mut Scratch::new();
        self.volumes_valid = R::dispatch(Forces { patch: self, positions, dt, scratch, moving: false });
    }
    fn set_bulk_viscosity(&mut self, coefficient: f64) {
        let volumes = self.constants.volumes();
        let (sum, count) =
            volumes.into_iter().filter(|v| *v > 0.0).fold((0.0, 0.0), |(sum, n), v| (sum + v, n + 1.0));
        let size = f64::cbrt(sum / count);
        self.viscosity = Some(BulkViscosity::new(coefficient, &self.material, size, self.constants.len()));
    }
    fn claim_interior_nodes(&mut self, alone: &[bool], inverse_masses: &[R]) -> Vec<u32> {
        match &mut self.arrangement {
            Arrangement::Lattice(lattice) => lattice.claim_interior_nodes(alone, inverse_masses),
            Arrangement::Indexed(_) => vec![],
        }
    }
    fn load_interior(&mut self, positions: &[Row<R>], velocities: &[Row<R>]) {
        if let Arrangement::Lattice(Lattice { interior: Some(interior), .. }) = &mut self.arrangement {
            interior.load(positions, velocities, &self.nodes);
        }
    }
    fn step(
        &mut self,
        positions: &[Row<R>],
        _velocities: &[Row<R>],
        dt: f64,
        scratch: &mut Scratch<R>,
        output: Option<&mut StepOutput>,
    ) {
        self.check(positions);
        self.volumes_valid = R::dispatch(Forces { patch: self, positions, dt, scratch, moving: true });
        if let Some(output) = output {
            let (energy, ratios) = R::dispatch(Energies { patch: self, positions, loaded: true });
            let kinetic = match &mut self.arrangement {
                Arrangement::Lattice(lattice) => lattice.kinetic(scratch, dt).re(),
                Arrangement::Indexed(_) => 0.0,
            };
            *output = StepOutput { energy, ratios, kinetic };
        }
        if let Arrangement::Lattice(lattice) = &mut self.arrangement {
            lattice.advance(scratch, dt);
        }
    }
    fn volumes_valid(&self) -> bool {
        self.volumes_valid
    }
    fn interior_moments(&mut self, origin: &Origin<R>) -> Moments<R> {
        match &mut self.arrangement {
            Arrangement::Lattice(Lattice { interior: Some(interior), .. }) => interior.moments(origin),
            _ => Moments::zero(),
        }
    }
    fn store_interior(&mut self, give: &mut dyn FnMut(u32, Row<R>, Row<R>)) {
        if let Arrangement::Lattice(Lattice { interior: Some(interior), .. }) = &mut self.arrangement {
            interior.store(&self.nodes, give);
        }
    }
    fn cost(&self) -> usize {
        let each = if self.state.is_empty() { self.material.law.description().cost } else { 39 };
        self.constants.len() * BLOCK * each
    }
    fn forces(&self) -> &[Row<R>] {
        match &self.arrangement {
            Arrangement::Lattice(lattice) => lattice.forces(),
            Arrangement::Indexed(indexed) => indexed.forces(),
        }
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.check(positions);
        R::dispatch(Energies { patch: self, positions, loaded: false })
    }
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>) {
        self.check(positions);
        R::singly(Output { patch: self, positions, sink });
    }
}

/// Computes forces.
pub struct Forces<'a, R: Real> {
    /// Whose elements they are; the caller has checked that its nodes exist.
    pub patch: &'a mut SolidPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// The step by which state variables move on, s.
    pub dt: f64,
    /// Keeps the forces on interior nodes.
    pub scratch: &'a mut Scratch<R>,
    /// Whether interior nodes are about to move.
    pub moving: bool,
}

impl<R: Real> PackKernel<R> for Forces<'_, R> {
    type Output = bool;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> bool {
        let Forces { patch, positions, dt, scratch, moving } = self;
        let SolidPatch { material, arrangement, nodes, constants, state, updates, viscosity, .. } = patch;
        let stage = material.stage::<P>(updates.next(dt));
        let stress = Stress {
            stage: &*stage,
            bulk: P::splat(material.bulk),
            state,
            drag: viscosity.as_mut().map(|viscosity| Drag { viscosity, dt }),
            ratios: Ratios::new(),
        };
        match arrangement {
            // SAFETY: the caller has checked the nodes.
            Arrangement::Lattice(lattice) => unsafe {
                lattice.assemble(scratch, positions, nodes, constants, stress, moving)
            },
            Arrangement::Indexed(indexed) => indexed.assemble(positions, nodes, constants, stress),
        }
    }
}
