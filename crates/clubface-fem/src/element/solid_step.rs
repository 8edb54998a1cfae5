//! What a patch of hexahedra does in a step.

use super::bulk_viscosity::Drag;
use super::field::Scratch;
use super::point::{Block, Elastic, Inelastic};
use super::solid::{Layout, SolidPatch};
use crate::material::{InelasticLaw, Isochoric, StateVariables, UseInelastic, UseLaw};
use clubface_math::{Pack, PackKernel, Real, Row};

/// Computes forces.
pub struct Assemble<'a, R> {
    /// What is computed; the caller has checked that its nodes exist.
    pub patch: &'a mut SolidPatch<R>,
    /// Positions of all nodes, m.
    pub positions: &'a [Row<R>],
    /// The step for which state variables move on, s.
    pub dt: f64,
    /// Keeps the forces on interior nodes.
    pub scratch: &'a mut Scratch<R>,
    /// Whether nodes are about to move that the patch has adopted.
    pub moving: bool,
}

impl<R: Real> PackKernel<R> for Assemble<'_, R> {
    type Output = bool;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> bool {
        let SolidPatch { material, layout, nodes, constants, state, updates, viscosity, .. } = self.patch;
        let dt = self.dt;
        let rest = Loop {
            drag: viscosity.as_mut().map(|viscosity| Drag { viscosity, dt }),
            layout,
            scratch: self.scratch,
            moving: self.moving,
            positions: self.positions,
            nodes,
            constants,
            state,
            bulk: P::splat(material.bulk),
        };
        // Compiled apart: elements without memory have nothing to load.
        if rest.state.is_empty() {
            material.with_law::<P, _>(rest)
        } else {
            material.with_inelastic::<P, _>(updates.next(dt), rest)
        }
    }
}

/// All that the elements of a patch need, before the law is known.
struct Loop<'a, P: Pack> {
    drag: Option<Drag<'a, P::Real>>,
    layout: &'a mut Layout<P::Real>,
    scratch: &'a mut Scratch<P::Real>,
    moving: bool,
    positions: &'a [Row<P::Real>],
    nodes: &'a [u32],
    constants: &'a [Block<P::Real>],
    state: &'a mut StateVariables<P::Real>,
    bulk: P,
}

impl<P: Pack> UseLaw<P> for Loop<'_, P> {
    type Output = bool;
    #[inline(always)]
    fn with<L: Isochoric<P>>(self, law: L) -> bool {
        let Loop { drag, layout, scratch, moving, positions, nodes, constants, bulk, .. } = self;
        let points = Elastic { law, bulk, drag };
        match layout {
            // SAFETY: `assemble` has checked the nodes.
            Layout::Lattice(lattice) => unsafe {
                lattice.assemble(scratch, positions, nodes, constants, points, moving)
            },
            Layout::Indexed(indexed) => indexed.assemble(positions, nodes, constants, points),
        }
    }
}

impl<P: Pack> UseInelastic<P> for Loop<'_, P> {
    type Output = bool;
    #[inline(always)]
    fn with<M: InelasticLaw<P>>(self, law: M) -> bool {
        let Loop { drag, layout, scratch, moving, positions, nodes, constants, state, bulk } = self;
        let points = Inelastic { law, bulk, state, drag };
        match layout {
            // SAFETY: `assemble` has checked the nodes.
            Layout::Lattice(lattice) => unsafe {
                lattice.assemble(scratch, positions, nodes, constants, points, moving)
            },
            Layout::Indexed(indexed) => indexed.assemble(positions, nodes, constants, points),
        }
    }
}
