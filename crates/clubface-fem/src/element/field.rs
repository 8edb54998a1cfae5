//! Vector fields on the nodes of a lattice, component by component.

use crate::block::{Aligned, BLOCK};
use clubface_math::{Pack, Real, Row, Vec3};
use std::marker::PhantomData;

/// Layout of a field: in every plane of nodes three components, one after the other. Each has the values in the order
/// of the nodes, then each derivative likewise.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Nodes a row.
    pub row: usize,
    /// Nodes a plane.
    pub plane: usize,
    /// Planes.
    pub planes: usize,
    /// Numbers that a part of a component takes in each plane.
    pub stride: usize,
}

impl Layout {
    /// Blocks of numbers that a field takes.
    fn blocks<R: Real>(&self) -> usize {
        self.stride / BLOCK * R::PARTS * 3 * self.planes
    }
    /// Place of a component of a node.
    pub fn place<R: Real>(&self, node: usize, axis: usize) -> usize {
        (3 * (node / self.plane) + axis) * R::PARTS * self.stride + node % self.plane
    }
}

/// Storage of fields, which grows to what is asked for.
#[derive(Clone, Debug)]
pub struct Storage<R> {
    numbers: Vec<Aligned<[f64; BLOCK]>>,
    number: PhantomData<R>,
}

impl<R: Real> Storage<R> {
    /// None yet.
    pub fn new() -> Self {
        Self { numbers: Vec::new(), number: PhantomData }
    }
    /// A field in it, as the last one left it.
    pub fn field(&mut self, layout: Layout) -> Field<'_, R> {
        let blocks = layout.blocks::<R>();
        if self.numbers.len() < blocks {
            self.numbers.resize(blocks, Aligned([0.0; BLOCK]));
        }
        Field { storage: &mut self.numbers[..blocks], layout, number: PhantomData }
    }
}

/// Storage that a thread works in; it serves one patch after the other.
#[derive(Clone, Debug)]
pub struct Scratch<R: Real> {
    pub(super) positions: Storage<R>,
    pub(super) forces: Storage<R>,
}

impl<R: Real> Scratch<R> {
    /// None yet.
    #[must_use]
    pub fn new() -> Self {
        Self { positions: Storage::new(), forces: Storage::new() }
    }
}

impl<R: Real> Default for Scratch<R> {
    fn default() -> Self {
        Self::new()
    }
}

/// A field.
pub struct Field<'a, R> {
    storage: &'a mut [Aligned<[f64; BLOCK]>],
    layout: Layout,
    number: PhantomData<R>,
}

impl<R: Real> Field<'_, R> {
    /// Nodes a row.
    #[inline(always)]
    pub fn row(&self) -> usize {
        self.layout.row
    }

    /// How far the parts of a number stand apart.
    #[inline(always)]
    pub fn stride(&self) -> usize {
        self.layout.stride
    }

    /// Where a component starts in plane `k`.
    ///
    /// # Safety
    /// `k` is a plane.
    #[inline(always)]
    pub unsafe fn at(&mut self, k: usize, axis: usize) -> *mut f64 {
        debug_assert!(k < self.layout.planes);
        // SAFETY: there is room for three components a plane.
        unsafe { self.storage.as_mut_ptr().cast::<f64>().add((3 * k + axis) * R::PARTS * self.layout.stride) }
    }

    /// The vectors of a pack of nodes from place `at` of plane `k` on.
    ///
    /// # Safety
    /// They are within the stride of a plane.
    #[inline(always)]
    pub unsafe fn vector<P: Pack<Real = R>>(&mut self, k: usize, at: usize) -> Vec3<P> {
        let stride = self.layout.stride;
        // SAFETY: the caller's promise.
        unsafe {
            Vec3::new(
                P::read_parts(self.at(k, 0).add(at), stride),
                P::read_parts(self.at(k, 1).add(at), stride),
                P::read_parts(self.at(k, 2).add(at), stride),
            )
        }
    }

    /// The vector whose first component stands at `place`.
    ///
    /// # Safety
    /// It is the place of the first component of a node.
    #[inline(always)]
    pub unsafe fn get_at(&self, place: usize) -> Row<R> {
        let stride = self.layout.stride;
        let component = R::PARTS * stride;
        // SAFETY: the caller's promise.
        unsafe {
            let from = self.storage.as_ptr().cast::<f64>().add(place);
            Row::from_vec(Vec3::new(
                R::from_parts(from, stride),
                R::from_parts(from.add(component), stride),
                R::from_parts(from.add(2 * component), stride),
            ))
        }
    }

    /// Sets the vector whose first component stands at `place`.
    ///
    /// # Safety
    /// As for [`Field::get_at`].
    #[inline(always)]
    pub unsafe fn set_at(&mut self, place: usize, row: &Row<R>) {
        let stride = self.layout.stride;
        // SAFETY: the caller's promise.
        unsafe {
            let to = self.storage.as_mut_ptr().cast::<f64>().add(place);
            for axis in 0..3 {
                row.get(axis).put_parts(to.add(axis * R::PARTS * stride), stride);
            }
        }
    }

    /// Takes the rows of the nodes of plane `k`. `nodes` is longer than the list of all nodes by a block.
    ///
    /// # Safety
    /// The nodes exist.
    #[inline(always)]
    pub unsafe fn load<P: Pack<Real = R>>(&mut self, k: usize, rows: &[Row<R>], nodes: &[u32]) {
        let Layout { plane, planes, stride, .. } = self.layout;
        assert!(k < planes && nodes.len() >= plane * planes + BLOCK);
        // SAFETY: the last pack of a plane overruns by less than a block, into room that both the list and the field
        // have.
        unsafe {
            let to = [self.at(k, 0), self.at(k, 1), self.at(k, 2)];
            for at in (0..plane).step_by(P::LANES) {
                let x = P::gather(rows, nodes.get_unchecked(k * plane + at..)).array();
                for axis in 0..3 {
                    x[axis].write_parts(to[axis].add(at), stride);
                }
            }
            for at in (plane.next_multiple_of(P::LANES)..stride).step_by(P::LANES) {
                for axis in 0..3 {
                    P::zero().write_parts(to[axis].add(at), stride);
                }
            }
        }
    }

    /// Writes the nodes of plane `k` as rows. There is room for them and a block.
    #[inline(always)]
    pub fn store<P: Pack<Real = R>>(&mut self, k: usize, rows: &mut [Row<R>]) {
        let Layout { plane, planes, .. } = self.layout;
        assert!(k < planes && rows.len() >= plane + BLOCK);
        for at in (0..plane).step_by(P::LANES) {
            // SAFETY: a component has room for a whole pack at the end of its plane.
            let value = unsafe { self.vector::<P>(k, at) };
            P::put_rows(&mut rows[at..], value);
        }
    }
}
