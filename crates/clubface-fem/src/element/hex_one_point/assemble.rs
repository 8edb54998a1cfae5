//! Assembly of a lattice of elements: from the positions of its nodes to the forces on them, in element packs.
//!
//! A pack takes neighbouring elements of a row, one a lane. A stack is a few packs on top of each other, so that what
//! one has gathered from the nodes between two layers serves the next. For every stack: gather positions and form
//! the modes, deformation gradients, stresses, then forces that are scattered to the nodes.

use super::constants::{Constants, Shapes};
use super::element::{Component, Hexahedron, Sums, empty};
use super::numbers::Block;
use super::passes::{in_passes, part, set_part};
use super::places::{Places, Quads, gather_side, scatter_side};
use super::stress::{RUN, Run, Stress, on_bases};
use crate::block::BLOCK;
use crate::element::field::Field;
use crate::material::Symmetric;
use clubface_math::pack::prefetch;
use clubface_math::{Pack, Part, Real, Scalar};

/// Most layers of a lattice.
pub const DEPTH: usize = 6;

/// Assembles the forces of a lattice of the given shape, and returns whether the laws hold for all volumes.
///
/// Each stack is worked on in separate loops: modes, deformation, stress, forces. One loop would be a long chain of
/// operations, which wait for each other and need more registers than there are. Modes and forces go component by
/// component, because the numbers of one component fit the registers: constants are loaded three times, but nothing
/// is spilled. Numbers with derivatives go through these two loops part by part, for the same reason.
///
/// # Safety
/// The fields are those of the lattice.
#[inline(always)]
pub unsafe fn assemble<P: Pack, const SLOPES: bool>(
    shape: [usize; 3],
    positions: &mut Field<P::Real>,
    forces: &mut Field<P::Real>,
    shapes: &Shapes<P::Real>,
    mut stress: Stress<P>,
) -> bool {
    let [ni, _, nk] = shape;
    assert!(nk <= DEPTH);
    let (row, places) = (ni + 1, Places::new(shape));
    for k in 0..=nk {
        for axis in 0..3 {
            for at in (0..row).step_by(P::LANES) {
                // SAFETY: the stride has room for two rows.
                unsafe { P::zero().write_parts(forces.at(k, axis).add(at), forces.stride()) };
            }
        }
    }
    let no_forces = [[[<P::Value as Pack>::Quad::zero(); 2]; DEPTH + 1]; 3];
    let mut carry = P::Real::each_part(no_forces);
    let mut shared_side = [empty::<P>(); BLOCK];
    let mut elements = [Hexahedron::<P>::zero(); RUN];
    let mut points = Run::new();
    for (column, blocks) in shapes.blocks().chunks_exact(nk).enumerate() {
        for start in (0..nk).step_by(RUN) {
            let blocks = &blocks[start..(start + RUN).min(nk)];
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = places.quads::<P>(column * BLOCK + first);
                let number = column * nk + start;
                let stack = Stack::<_, SLOPES> { shapes, blocks, number, first, start, at };
                for axis in 0..3 {
                    // SAFETY of these: `at` is within the columns.
                    in_passes!(P::Real, |pass| if stack.pattern_varies(pass) {
                        unsafe { stack.gather_modes::<P, P::Pair>(positions, axis, pass, &mut elements) };
                    } else {
                        unsafe { stack.gather_modes::<P, P::Value>(positions, axis, pass, &mut elements) };
                    });
                }
                let lane = number * BLOCK + first;
                for (layer, (constants, element)) in stack.constants().zip(&elements).enumerate() {
                    // The loops from here to the forces compute more than they load: time to fetch what the next ones
                    // need.
                    if first == 0 {
                        prefetch(constants.block(), RUN);
                    }
                    let gradient = element.gradient(&constants);
                    stress.set(&mut points, layer, lane + layer * BLOCK, gradient, constants.volume());
                }
                stress.compute(&mut points, blocks.len(), lane, BLOCK);
                for (constants, stress) in stack.constants().zip(&mut points.stresses) {
                    *stress = on_bases(&constants, stress);
                }
                for axis in 0..3 {
                    if P::Real::PARTS > 1 {
                        for (layer, (constants, element)) in stack.constants().zip(&mut elements).enumerate()
                        {
                            let component = &mut element.components[axis];
                            *component = component.loads(&constants, &points.stresses[layer]);
                        }
                    }
                    in_passes!(P::Real, |pass| {
                        let carry = &mut P::Real::part_mut(&mut carry, pass)[axis];
                        let from_below = if start == 0 {
                            [P::Value::zero(); 4]
                        } else {
                            part(&shared_side[first][axis], pass)
                        };
                        let all = (&elements, &points.stresses);
                        let to_above = if stack.pattern_varies(pass) {
                            unsafe {
                                stack.scatter_forces::<P, P::Pair>(forces, axis, pass, from_below, all, carry)
                            }
                        } else {
                            unsafe {
                                stack
                                    .scatter_forces::<P, P::Value>(forces, axis, pass, from_below, all, carry)
                            }
                        };
                        set_part(&mut shared_side[first][axis], pass, &to_above);
                        if start + blocks.len() == nk {
                            unsafe {
                                scatter_side(forces, nk, axis, pass, &stack.at, to_above, &mut carry[nk]);
                            };
                        }
                    });
                }
            }
        }
    }
    stress.ratios.valid()
}

/// Packs of elements above each other.
struct Stack<'a, R: Real, const SLOPES: bool> {
    shapes: &'a Shapes<R>,
    /// Their blocks, and the number of the lowest.
    blocks: &'a [Block<R>],
    number: usize,
    /// Lane of their blocks in which they begin.
    first: usize,
    /// Layer of the lowest.
    start: usize,
    at: Quads,
}

impl<R: Real, const SLOPES: bool> Stack<'_, R, SLOPES> {
    /// Constants, from the lowest up.
    #[inline(always)]
    fn constants(&self) -> impl Iterator<Item = Constants<'_, R, SLOPES>> {
        let constants_at =
            |(layer, block)| Constants::new(self.shapes, self.number + layer, block, self.first);
        self.blocks.iter().enumerate().map(constants_at)
    }

    /// Whether hourglass shapes and mean gradients depend on the variable of a pass.
    #[inline(always)]
    fn pattern_varies(&self, pass: usize) -> bool {
        SLOPES && self.shapes.pattern_varies(pass)
    }

    /// One pass of a component of the modes.
    ///
    /// # Safety
    /// As for [`gather_side`].
    #[inline(always)]
    unsafe fn gather_modes<P: Pack<Real = R>, G: Part<P>>(
        &self,
        positions: &mut Field<R>,
        axis: usize,
        pass: usize,
        elements: &mut [Hexahedron<P>; RUN],
    ) {
        let Self { start, at, .. } = self;
        // SAFETY of these: the caller's promise.
        let mut low = unsafe { gather_side::<G, _>(positions, *start, axis, G::places(pass), at) };
        for (layer, (constants, element)) in self.constants().zip(elements).enumerate() {
            let high =
                unsafe { gather_side::<G, _>(positions, start + layer + 1, axis, G::places(pass), at) };
            let component = Component::new(&constants.shape::<P, G>(pass), &low, &high);
            element.components[axis].set_part(pass, &component);
            low = high;
        }
    }

    /// One pass of a component of the forces, added to those on the nodes; returns those on the upper side of the
    /// highest, given those on the lower side of the lowest. Elements are loads by now if there are more passes.
    ///
    /// # Safety
    /// As for [`gather_side`].
    #[inline(always)]
    unsafe fn scatter_forces<P: Pack<Real = R>, G: Part<P>>(
        &self,
        forces: &mut Field<R>,
        axis: usize,
        pass: usize,
        mut from_below: Sums<P::Value>,
        (elements, stresses): (&[Hexahedron<P>; RUN], &[Symmetric<P>; RUN]),
        carry: &mut [[<P::Value as Pack>::Quad; 2]; DEPTH + 1],
    ) -> Sums<P::Value> {
        for (layer, (constants, element)) in self.constants().zip(elements).enumerate() {
            let component = &element.components[axis];
            let (force, above) = if R::PARTS == 1 {
                let loads = component.loads(&constants, &stresses[layer]);
                loads.part_of_forces::<G, SLOPES>(&constants, pass, &from_below)
            } else {
                component.part_of_forces::<G, SLOPES>(&constants, pass, &from_below)
            };
            let k = self.start + layer;
            // SAFETY: the caller's promise.
            unsafe { scatter_side(forces, k, axis, pass, &self.at, force, &mut carry[k]) };
            from_below = above;
        }
        from_below
    }
}
