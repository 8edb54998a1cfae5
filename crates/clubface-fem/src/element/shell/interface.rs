//! What the solver asks of patches of shells.

use super::energies::Energies;
use super::forces::AssembleForces;
use super::output::Output;
use super::patch::ShellPatch;
use crate::element::output::OutputSink;
use crate::element::patch::{Energy, Patch};
use clubface_math::{Real, Row};

impl<R: Real> Patch<R> for ShellPatch<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64) {
        self.check(positions);
        self.check(&velocities[self.behind..]);
        self.forces.fill(Row::zero());
        R::dispatch(AssembleForces { patch: self, positions, velocities, dt });
    }
    fn perturbed_forces(&mut self, positions: &[Row<R>], displacements: &[Row<R>]) {
        let state = self.state.clone();
        self.assemble(positions, displacements, 1.0);
        self.state = state;
    }
    fn cost(&self) -> usize {
        self.elements * (45 + 2 * self.points.len())
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn energies(&mut self, positions: &[Row<R>]) -> (Energy, (f64, f64)) {
        self.check(positions);
        R::dispatch(Energies { patch: self, positions })
    }
    fn element_output(&mut self, positions: &[Row<R>], sink: &mut OutputSink<'_>) {
        self.check(positions);
        R::singly(Output { patch: self, positions, sink });
    }
}
