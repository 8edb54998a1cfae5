//! What the solver asks of patches of fully integrated hexahedra.

use super::element::reference_volume;
use super::energies::Energies;
use super::forces::AssembleForces;
use super::output::Output;
use super::patch::FullPatch;
use crate::block::BLOCK;
use crate::element::bulk_viscosity::BulkViscosity;
use crate::element::output::OutputSink;
use crate::element::patch::{Energy, Patch};
use clubface_math::{Real, Row};

impl<R: Real> Patch<R> for FullPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes[..self.real_nodes]
    }
    fn assemble(&mut self, positions: &[Row<R>], _velocities: &[Row<R>], dt: f64) {
        self.load(positions);
        self.forces.fill(Row::zero());
        self.volumes_valid = R::dispatch(AssembleForces { patch: self, dt });
    }
    fn volumes_valid(&self) -> bool {
        self.volumes_valid
    }
    fn set_bulk_viscosity(&mut self, coefficient: f64) {
        let volume = |at: usize| reference_volume(&self.constants[at / BLOCK], at % BLOCK);
        let size = f64::cbrt((0..self.elements).map(volume).sum::<f64>() / self.elements as f64);
        self.viscosity = Some(BulkViscosity::new(coefficient, &self.material, size, self.corners.len()));
    }
    fn cost(&self) -> usize {
        self.elements * 230
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces[..self.real_nodes]
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.load(positions);
        R::dispatch(Energies { patch: self })
    }
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>) {
        self.load(positions);
        R::singly(Output { patch: self, sink });
    }
}
