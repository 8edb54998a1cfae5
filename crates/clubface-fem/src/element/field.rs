//! Vector fields on the nodes of a lattice, component by component.

use crate::block::{Aligned, BLOCK};
use clubface_math::{Pack, Real, Row, Vec3};

/// Layout of a field: in every plane of nodes three components, one after the other, each in the order of the nodes.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Nodes a row.
    pub row: usize,
    /// Nodes a plane.
    pub plane: usize,
    /// Planes.
    pub planes: usize,
    /// Numbers a component takes in each plane.
    pub stride: usize,
}

impl Layout {
    /// Blocks of numbers that a field takes.
    pub fn blocks(&self) -> usize {
        self.stride / BLOCK * 3 * self.planes
    }
    /// Place of a component of a node.
    pub fn place(&self, node: usize, axis: usize) -> usize {
        (3 * (node / self.plane) + axis) * self.stride + node % self.plane
    }
}

/// Storage of fields, which grows to what is asked for.
#[derive(Clone, Debug)]
pub struct Storage<R>(Vec<Aligned<[R; BLOCK]>>);

impl<R: Real> Storage<R> {
    /// None yet.
    pub fn new() -> Self {
        Self(Vec::new())
    }
    /// A field in it, as the last one left it.
    pub fn field(&mut self, layout: Layout) -> Field<'_, R> {
        let blocks = layout.blocks();
        if self.0.len() < blocks {
            self.0.resize(blocks, Aligned([R::zero(); BLOCK]));
        }
        Field { storage: &mut self.0[..blocks], layout }
    }
}

/// Storage that a thread works in; it serves one patch after the other.
#[derive(Clone, Debug)]
pub struct Scratch<R> {
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
    storage: &'a mut [Aligned<[R; BLOCK]>],
    layout: Layout,
}

impl<R: Real> Field<'_, R> {
    /// Nodes a row.
    #[inline(always)]
    pub fn row(&self) -> usize {
        self.layout.row
    }

    /// Where a component starts in plane `k`.
    ///
    /// # Safety
    /// `k` is a plane.
    #[inline(always)]
    pub unsafe fn at(&mut self, k: usize, axis: usize) -> *mut R {
        debug_assert!(k < self.layout.planes);
        // SAFETY: there is room for three components a plane.
        unsafe { self.storage.as_mut_ptr().cast::<R>().add((3 * k + axis) * self.layout.stride) }
    }

    /// The vectors of a pack of nodes from place `at` of plane `k` on.
    ///
    /// # Safety
    /// They are within the stride of a plane.
    #[inline(always)]
    pub unsafe fn vector<P: Pack<Real = R>>(&mut self, k: usize, at: usize) -> Vec3<P> {
        // SAFETY: the caller's promise.
        unsafe {
            Vec3::new(
                P::read(self.at(k, 0).add(at)),
                P::read(self.at(k, 1).add(at)),
                P::read(self.at(k, 2).add(at)),
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
        // SAFETY: the caller's promise.
        unsafe {
            let from = self.storage.as_ptr().cast::<R>().add(place);
            Row([*from, *from.add(stride), *from.add(2 * stride), R::zero()])
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
            let to = self.storage.as_mut_ptr().cast::<R>().add(place);
            *to = row.0[0];
            *to.add(stride) = row.0[1];
            *to.add(2 * stride) = row.0[2];
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
                    x[axis].write(to[axis].add(at));
                }
            }
            for at in (plane.next_multiple_of(P::LANES)..stride).step_by(P::LANES) {
                for axis in 0..3 {
                    P::zero().write(to[axis].add(at));
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
