//! Forces of a patch of one-point hexahedra in a step.

use super::patch::{Arrangement, SolidPatch};
use super::stress::Stress;
use crate::element::bulk_viscosity::Drag;
use crate::element::field::Scratch;
use crate::element::ratios::Ratios;
use clubface_math::{Pack, PackKernel, Real, Row};

/// Computes forces.
pub struct Forces<'a, R> {
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
