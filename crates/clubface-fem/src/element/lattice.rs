//! Elements in rows, columns and layers: neighbours share what they read and write.
//!
//! Positions and forces stand component by component in the order of the lattice, so that the corners of consecutive elements are
//! consecutive numbers. The last node of a row makes an element with the first of the next, which exists only to keep the packs full: it has no
//! volume. Each pack of elements walks up through the layers and carries the side it shares with the next one along.

use super::one_point::{empty, spread, sums, Face};
use super::point::{Forces, Look};
use super::{Aligned, BLOCK};
use crate::mesh::CORNERS;
use clubface_math::{Pack, Real, Row, Vec3};

/// Most layers.
pub const DEPTH: usize = 6;

/// A lattice of elements.
pub struct Lattice<R> {
    /// Elements along the three directions.
    shape: [usize; 3],
    /// Numbers a component takes in each plane of nodes.
    stride: usize,
    /// Forces by node, with room for a pack to overrun.
    rows: Vec<Row<R>>,
}

/// Components of a vector field on the nodes of a lattice, one after the other in every plane of nodes.
struct Field<R> {
    memory: Vec<Aligned<[R; BLOCK]>>,
    stride: usize,
}

impl<R: Real> Field<R> {
    /// Not yet written. It lives only while a patch is worked on: the memory it leaves to the next patch is in the fast caches.
    fn new(lattice: &Lattice<R>) -> Self {
        let stride = lattice.stride;
        Self { memory: Vec::with_capacity(stride / BLOCK * 3 * (lattice.shape[2] + 1)), stride }
    }
    /// Where a component starts in plane `k`.
    ///
    /// # Safety
    /// `k` is a plane of the lattice.
    #[inline(always)]
    unsafe fn at(&mut self, k: usize, axis: usize) -> *mut R {
        // SAFETY: there is room for three components a plane.
        unsafe { self.memory.as_mut_ptr().cast::<R>().add((3 * k + axis) * self.stride) }
    }
}

/// Number of elements, from the first one on, that make rows, columns and layers, element after element in the order of the corners.
pub fn shape(elements: &[[u32; CORNERS]]) -> [usize; 3] {
    let joined = |a: usize, b: usize, bit: usize| {
        (0..CORNERS)
            .filter(|corner| corner & bit == 0)
            .all(|corner| elements[a][corner | bit] == elements[b][corner])
    };
    let mut shape = [1; 3];
    let mut size = 1;
    for axis in 0..3 {
        let whole = |n: usize| {
            // The next row (or layer) hangs together like the first and joins the last.
            (n + 1) * size <= elements.len()
                && (0..size).all(|e| joined((n - 1) * size + e, n * size + e, 1 << axis))
                && (axis == 0 || {
                    (1..size).all(|e| e % shape[0] == 0 || joined(n * size + e - 1, n * size + e, 1))
                })
                && (axis < 2 || (shape[0]..size).all(|e| joined(n * size + e - shape[0], n * size + e, 2)))
        };
        let mut n = 1;
        while whole(n) {
            n += 1;
        }
        shape[axis] = n;
        size *= n;
    }
    shape
}

impl<R: Real> Lattice<R> {
    /// From the elements of a lattice by their corners; also the nodes, and the element in every lane of the blocks.
    pub fn new(shape: [usize; 3], elements: &[[u32; CORNERS]]) -> (Self, Vec<u32>, Vec<Option<usize>>) {
        let [ni, nj, nk] = shape;
        let mut nodes = Vec::new();
        for k in 0..=nk {
            for j in 0..=nj {
                for i in 0..=ni {
                    let (ei, ej, ek) = (i.min(ni - 1), j.min(nj - 1), k.min(nk - 1));
                    let corner = (i - ei) + 2 * (j - ej) + 4 * (k - ek);
                    nodes.push(elements[(ek * nj + ej) * ni + ei][corner]);
                }
            }
        }
        let row = ni + 1;
        let columns = (row * nj).div_ceil(BLOCK);
        let mut lanes = Vec::new();
        for column in 0..columns {
            for k in 0..nk {
                for lane in 0..BLOCK {
                    let at = column * BLOCK + lane;
                    let (i, j) = (at % row, at / row);
                    lanes.push((i < ni && j < nj).then_some((k * nj + j) * ni + i));
                }
            }
        }
        // A pack reads as far as the corner after the next row.
        let stride = (columns * BLOCK + row + 1).next_multiple_of(BLOCK);
        let rows = vec![Row::zero(); nodes.len() + BLOCK];
        (Self { shape, stride, rows }, nodes, lanes)
    }

    /// Nodes of a plane.
    fn plane(&self) -> usize {
        (self.shape[0] + 1) * (self.shape[1] + 1)
    }

    /// Positions of the nodes; `nodes` is longer than their list by a block.
    ///
    /// # Safety
    /// The nodes exist.
    #[inline(always)]
    unsafe fn load<P: Pack<Real = R>>(&self, positions: &[Row<R>], nodes: &[u32]) -> Field<R> {
        let plane = self.plane();
        assert!(nodes.len() >= plane * (self.shape[2] + 1) + BLOCK);
        let mut field = Field::new(self);
        for k in 0..=self.shape[2] {
            // SAFETY: the last pack of a plane overruns by less than a block, into room that both the list and the field have.
            unsafe {
                let to = [field.at(k, 0), field.at(k, 1), field.at(k, 2)];
                for at in (0..plane).step_by(P::LANES) {
                    let x = P::gather(positions, nodes.get_unchecked(k * plane + at..)).array();
                    for axis in 0..3 {
                        x[axis].write(to[axis].add(at));
                    }
                }
                for at in (plane.next_multiple_of(P::LANES)..self.stride).step_by(P::LANES) {
                    for axis in 0..3 {
                        P::zero().write(to[axis].add(at));
                    }
                }
            }
        }
        field
    }

    /// Forces on the nodes.
    pub fn forces(&self) -> &[Row<R>] {
        &self.rows[..self.rows.len() - BLOCK]
    }

    /// One side of a pack of elements from place `at` of plane `k` on.
    ///
    /// # Safety
    /// `at + LANES` is within the columns, and `k` is a plane.
    #[inline(always)]
    unsafe fn side<P: Pack<Real = R>>(&self, positions: &mut Field<R>, k: usize, at: usize) -> Face<P> {
        let row = self.shape[0] + 1;
        let mut face = empty();
        for axis in 0..3 {
            // SAFETY: the stride has room for a pack of the next row.
            unsafe {
                let from = positions.at(k, axis).add(at);
                let next = from.add(row);
                face[axis] = sums([P::read(from), P::read(from.add(1)), P::read(next), P::read(next.add(1))]);
            }
        }
        face
    }

    /// Adds forces to one side of a pack of elements. Every number is written first from the row before it, then added to from its own
    /// row; what belongs to the node after the last lane waits in `carry` for the next pack.
    ///
    /// # Safety
    /// As for [`Lattice::side`].
    #[inline(always)]
    unsafe fn add<P: Pack<Real = R>>(
        &self,
        forces: &mut Field<R>,
        k: usize,
        at: usize,
        face: &Face<P>,
        carry: &mut [[P; 2]; 3],
    ) {
        let row = self.shape[0] + 1;
        for axis in 0..3 {
            let [c0, c1, c2, c3] = spread(face[axis]);
            // SAFETY: as in `side`.
            unsafe {
                let to = forces.at(k, axis).add(at);
                (c2 + c3.after(carry[axis][1])).write(to.add(row));
                (P::read(to) + (c0 + c1.after(carry[axis][0]))).write(to);
            }
            carry[axis] = [c1, c3];
        }
    }

    /// Forces of all elements for the positions of their nodes, a list longer than it need be by a block.
    ///
    /// # Safety
    /// The nodes exist.
    #[inline(always)]
    pub unsafe fn assemble<P: Pack<Real = R>, W: Forces<P>>(
        &mut self,
        positions: &[Row<R>],
        nodes: &[u32],
        mut point: W,
    ) {
        let [ni, nj, nk] = self.shape;
        assert!(nk <= DEPTH);
        let row = ni + 1;
        // SAFETY: the caller's promise.
        let mut positions = unsafe { self.load::<P>(positions, nodes) };
        let mut forces = Field::new(self);
        for k in 0..=nk {
            for axis in 0..3 {
                for at in (0..row).step_by(P::LANES) {
                    // SAFETY: the stride has room for two rows.
                    unsafe { P::zero().write(forces.at(k, axis).add(at)) };
                }
            }
        }
        let mut carry = [[[P::zero(); 2]; 3]; DEPTH + 1];
        for column in 0..(row * nj).div_ceil(BLOCK) {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = column * BLOCK + first;
                // SAFETY of these: `at` is within the columns.
                let mut low = unsafe { self.side::<P>(&mut positions, 0, at) };
                let mut below = empty();
                for layer in 0..nk {
                    let high = unsafe { self.side::<P>(&mut positions, layer + 1, at) };
                    let (force, above) = point.forces(column * nk + layer, first, &low, &high, &below);
                    unsafe { self.add(&mut forces, layer, at, &force, &mut carry[layer]) };
                    (low, below) = (high, above);
                }
                unsafe { self.add(&mut forces, nk, at, &below, &mut carry[nk]) };
            }
        }
        self.store::<P>(&mut forces);
    }

    /// Writes the forces node by node.
    #[inline(always)]
    fn store<P: Pack<Real = R>>(&mut self, forces: &mut Field<R>) {
        let plane = self.plane();
        for k in 0..=self.shape[2] {
            for at in (0..plane).step_by(P::LANES) {
                // SAFETY: a component has room for a whole pack at the end of its plane, and packs of elements have written there.
                let force = unsafe {
                    Vec3::new(
                        P::read(forces.at(k, 0).add(at)),
                        P::read(forces.at(k, 1).add(at)),
                        P::read(forces.at(k, 2).add(at)),
                    )
                };
                P::put_rows(&mut self.rows[k * plane + at..], force);
            }
        }
    }

    /// Shows every element to `point`.
    ///
    /// # Safety
    /// As for [`Lattice::assemble`].
    #[inline(always)]
    pub unsafe fn visit<P: Pack<Real = R>, W: Look<P>>(
        &self,
        positions: &[Row<R>],
        nodes: &[u32],
        point: &mut W,
    ) {
        let [ni, nj, nk] = self.shape;
        // SAFETY: the caller's promise.
        let mut positions = unsafe { self.load::<P>(positions, nodes) };
        for column in 0..((ni + 1) * nj).div_ceil(BLOCK) {
            for first in (0..BLOCK).step_by(P::LANES) {
                let at = column * BLOCK + first;
                for layer in 0..nk {
                    // SAFETY: `at` is within the columns.
                    let sides = unsafe {
                        [self.side::<P>(&mut positions, layer, at), self.side(&mut positions, layer + 1, at)]
                    };
                    point.see(column * nk + layer, first, &sides[0], &sides[1]);
                }
            }
        }
    }
}
