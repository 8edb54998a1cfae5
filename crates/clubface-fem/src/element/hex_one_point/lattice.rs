//! Elements in rows, columns and layers: neighbours share what they read and write.
//!
//! Positions and forces stand component by component in the order of the lattice, so that the corners of consecutive
//! elements are consecutive numbers. Where rows do not fill whole packs, the last node of one makes an element with
//! the first of the next, which exists only to keep the packs full: it has no volume. Each pack of elements walks up
//! through the layers and carries the side it shares with the next one along.

use super::arrangement::order;
use super::constants::{Block, Constants, Shapes};
use super::element::{empty, in_passes, on_bases, part, set_part, Component, Hexahedron, Sums, Visitor};
use super::interior::{Advance, Interior, Kinetic};
use super::places::{add, face, side, Places, Quads};
use super::stress::{Run, Stress, RUN};
use crate::block::BLOCK;
use crate::element::field::{Field, Layout, Scratch};
use crate::material::Symmetric;
use crate::mesh::CORNERS;
use clubface_math::pack::prefetch;
use clubface_math::{Pack, Part, Real, Row, Scalar};

/// Most layers.
pub const DEPTH: usize = 6;
/// A lattice of elements.
pub struct Lattice<R: Real> {
    /// Elements along the three directions.
    shape: [usize; 3],
    layout: Layout,
    /// Forces by node, with room for a pack to overrun.
    rows: Vec<Row<R>>,
    /// Of the nodes inside, if the lattice moves them itself.
    pub interior: Option<Interior<R>>,
}

impl<R: Real> Lattice<R> {
    /// From the elements of a lattice by their corners; also the nodes, and the element in every lane of the blocks.
    pub fn new(shape: [usize; 3], elements: &[[u32; CORNERS]]) -> (Self, Vec<u32>, Vec<Option<usize>>) {
        let [ni, nj, nk] = shape;
        assert!(nk <= DEPTH);
        let (nodes, lanes) = order(shape, elements);
        let row = ni + 1;
        // The last pack reads as far as the corner after the next row, and one that begins in the last row but one
        // overruns by less than a block.
        let last = Places::new(shape).at(lanes.len() / nk - 1);
        let stride = (last + row + 2).max(row * nj + BLOCK).next_multiple_of(BLOCK);
        let layout = Layout { row, plane: row * (nj + 1), planes: nk + 1, stride };
        let rows = vec![Row::zero(); nodes.len() + BLOCK];
        (Self { shape, layout, rows, interior: None }, nodes, lanes)
    }

    /// Takes charge of the nodes inside, if nothing else acts on them; returns their places.
    pub fn claim_interior_nodes(&mut self, alone: &[bool], inverse_masses: &[R]) -> Vec<u32> {
        self.interior = Interior::new(self.layout, alone, inverse_masses);
        self.interior.as_ref().map_or(vec![], Interior::inside)
    }

    /// Forces on the nodes.
    pub fn forces(&self) -> &[Row<R>] {
        &self.rows[..self.rows.len() - BLOCK]
    }

    /// Forces of all elements for the positions of their nodes, a list longer than it need be by a block. If the
    /// lattice is `moving` its interior nodes, the forces on these stay in the scratch for [`Lattice::advance`], and
    /// only those on the others are written. Returns whether the laws hold for all volumes.
    ///
    /// # Safety
    /// The nodes exist.
    #[inline(always)]
    pub unsafe fn assemble<P: Pack<Real = R>>(
        &mut self,
        scratch: &mut Scratch<R>,
        positions: &[Row<R>],
        nodes: &[u32],
        constants: &Shapes<R>,
        stress: Stress<P>,
        moving: bool,
    ) -> bool {
        let Self { shape, layout, rows, interior } = self;
        let mut forces = scratch.forces.field(*layout);
        let mut interior = interior.as_mut().filter(|_| moving);
        // SAFETY of these: the caller's promise.
        let mut field = if let Some(interior) = &mut interior {
            unsafe { interior.load_boundary::<P>(positions, nodes) }
        } else {
            let mut field = scratch.positions.field(*layout);
            for k in 0..layout.planes {
                unsafe { field.load::<P>(k, positions, nodes) };
            }
            field
        };
        let valid = unsafe {
            if P::Real::PARTS > 1 && constants.vary() {
                walk::<P, true>(*shape, &mut field, &mut forces, constants, stress)
            } else {
                walk::<P, false>(*shape, &mut field, &mut forces, constants, stress)
            }
        };
        if let Some(interior) = interior {
            interior.store_boundary::<P>(&mut forces, rows);
        } else {
            for k in 0..layout.planes {
                forces.store::<P>(k, &mut rows[k * layout.plane..]);
            }
        }
        valid
    }

    /// Moves the interior nodes on by a step, s.
    pub fn advance(&mut self, scratch: &mut Scratch<R>, step: f64) {
        let forces = scratch.forces.field(self.layout);
        if let Some(interior) = &mut self.interior {
            R::dispatch(Advance { interior, forces, step });
        }
    }

    /// Kinetic energy of the interior nodes between their velocities before and after such a step, J.
    pub fn kinetic(&mut self, scratch: &mut Scratch<R>, step: f64) -> R {
        let forces = scratch.forces.field(self.layout);
        let kinetic = |interior| R::dispatch(Kinetic { interior, forces, step });
        self.interior.as_mut().map_or(R::zero(), kinetic)
    }

    /// Shows every element to `visitor`, at the positions that [`Lattice::assemble`] has loaded if it may.
    ///
    /// # Safety
    /// As for [`Lattice::assemble`].
    #[inline(always)]
    pub unsafe fn visit<P: Pack<Real = R>, W: Visitor<P>>(
        &mut self,
        positions: &[Row<R>],
        nodes: &[u32],
        shapes: &Shapes<R>,
        loaded: bool,
        visitor: &mut W,
    ) {
        let nk = self.shape[2];
        let places = Places::new(self.shape);
        let mut scratch = Scratch::new();
        let mut field = if let Some(interior) = self.interior.as_mut().filter(|_| loaded) {
            interior.positions()
        } else {
            let mut field = scratch.positions.field(self.layout);
            for k in 0..self.layout.planes {
                // SAFETY: the caller's promise.
                unsafe { field.load::<P>(k, positions, nodes) };
            }
            field
        };
        for (column, blocks) in shapes.blocks().chunks_exact(nk).enumerate() {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = places.quads::<P>(column * BLOCK + first);
                for (k, block) in blocks.iter().enumerate() {
                    // SAFETY: `at` is within the columns.
                    let (low, high) =
                        unsafe { (face::<P>(&mut field, k, &at), face::<P>(&mut field, k + 1, &at)) };
                    let constants = Constants::new(shapes, column * nk + k, block, first);
                    let lane = (column * nk + k) * BLOCK + first;
                    visitor.visit(lane, &constants, &Hexahedron::new(&constants, &low, &high));
                    if (k + 1).is_multiple_of(RUN) || k + 1 == nk {
                        visitor.end_run(BLOCK);
                    }
                }
            }
        }
    }
}

/// Forces of a lattice of elements of the given shape, and whether the laws hold for all volumes.
///
/// Each pack of elements goes up through some layers in several loops: patterns, deformation, stress, forces. One
/// loop would be a long chain of operations, which wait for each other and for more registers than there are.
/// Patterns and forces go component by component, since the numbers of one fit the registers: constants are loaded
/// thrice, but nothing else is put aside. Numbers with derivatives go through these two part by part, for the same
/// reason.
///
/// # Safety
/// The fields are those of the lattice.
#[inline(always)]
unsafe fn walk<P: Pack, const SLOPES: bool>(
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
    let nothing = [[[<P::Value as Pack>::Quad::zero(); 2]; DEPTH + 1]; 3];
    let mut carry = P::Real::each_part(nothing);
    let mut below = [empty::<P>(); BLOCK];
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
                        unsafe { stack.modes::<P, P::Pair>(positions, axis, pass, &mut elements) };
                    } else {
                        unsafe { stack.modes::<P, P::Value>(positions, axis, pass, &mut elements) };
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
                        let under =
                            if start == 0 { [P::Value::zero(); 4] } else { part(&below[first][axis], pass) };
                        let all = (&elements, &points.stresses);
                        let over = if stack.pattern_varies(pass) {
                            unsafe { stack.push::<P, P::Pair>(forces, axis, pass, under, all, carry) }
                        } else {
                            unsafe { stack.push::<P, P::Value>(forces, axis, pass, under, all, carry) }
                        };
                        set_part(&mut below[first][axis], pass, &over);
                        if start + blocks.len() == nk {
                            unsafe { add(forces, nk, axis, pass, &stack.at, over, &mut carry[nk]) };
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
        let of = |(layer, block)| Constants::new(self.shapes, self.number + layer, block, self.first);
        self.blocks.iter().enumerate().map(of)
    }

    /// Whether hourglass shapes and mean gradients depend on the variable of a pass.
    #[inline(always)]
    fn pattern_varies(&self, pass: usize) -> bool {
        SLOPES && self.shapes.pattern_varies(pass)
    }

    /// One pass of a component of the modes.
    ///
    /// # Safety
    /// As for [`side`].
    #[inline(always)]
    unsafe fn modes<P: Pack<Real = R>, G: Part<P>>(
        &self,
        positions: &mut Field<R>,
        axis: usize,
        pass: usize,
        elements: &mut [Hexahedron<P>; RUN],
    ) {
        let Self { start, at, .. } = self;
        // SAFETY of these: the caller's promise.
        let mut low = unsafe { side::<G, _>(positions, *start, axis, G::places(pass), at) };
        for (layer, (constants, element)) in self.constants().zip(elements).enumerate() {
            let high = unsafe { side::<G, _>(positions, start + layer + 1, axis, G::places(pass), at) };
            let component = Component::new(&constants.shape::<P, G>(pass), &low, &high);
            element.components[axis].set_part(pass, &component);
            low = high;
        }
    }

    /// One pass of a component of the forces, added to those on the nodes; returns those on the upper side of the
    /// highest, given those on the lower side of the lowest. Elements are loads by now if there are more passes.
    ///
    /// # Safety
    /// As for [`side`].
    #[inline(always)]
    unsafe fn push<P: Pack<Real = R>, G: Part<P>>(
        &self,
        forces: &mut Field<R>,
        axis: usize,
        pass: usize,
        mut under: Sums<P::Value>,
        (elements, stresses): (&[Hexahedron<P>; RUN], &[Symmetric<P>; RUN]),
        carry: &mut [[<P::Value as Pack>::Quad; 2]; DEPTH + 1],
    ) -> Sums<P::Value> {
        for (layer, (constants, element)) in self.constants().zip(elements).enumerate() {
            let component = &element.components[axis];
            let (force, above) = if R::PARTS == 1 {
                let loads = component.loads(&constants, &stresses[layer]);
                loads.part_of_forces::<G, SLOPES>(&constants, pass, &under)
            } else {
                component.part_of_forces::<G, SLOPES>(&constants, pass, &under)
            };
            let k = self.start + layer;
            // SAFETY: the caller's promise.
            unsafe { add(forces, k, axis, pass, &self.at, force, &mut carry[k]) };
            under = above;
        }
        under
    }
}
