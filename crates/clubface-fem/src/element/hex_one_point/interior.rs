//! Interior nodes of a lattice, on which nothing else acts: the lattice moves them itself, where their positions and
//! forces are at hand, and the fields of all nodes do not follow until they are stored there.

use crate::element::field::{Field, Layout, Storage};
use crate::moments::{Moments, Origin};
use clubface_math::{Pack, PackKernel, Real, Row};

/// Motion of the interior nodes of a lattice.
pub struct Interior<R> {
    layout: Layout,
    /// Nodes inside: places, and where the first component stands in a field.
    inside: Vec<(u32, u32)>,
    /// The others in the planes between the first and the last: places, and where the first component stands in a
    /// field.
    boundary: Vec<(u32, u32)>,
    /// Positions of all nodes.
    positions: Storage<R>,
    /// Zero but inside.
    velocities: Storage<R>,
    /// Plane by plane in the order of a field's component, and as its parts; zero but inside.
    inverse_masses: Vec<f64>,
}

impl<R: Real> Interior<R> {
    /// For a lattice of nodes, given for each node whether nothing but the lattice acts on it, and its inverse mass
    /// (1/kg). None if something acts on a node inside, or nothing is inside.
    pub fn new(layout: Layout, alone: &[bool], inverse_masses: &[R]) -> Option<Self> {
        let Layout { row, plane, planes, stride } = layout;
        let between = |place: usize, count: usize| place > 0 && place + 1 < count;
        let (inside, boundary): (Vec<usize>, Vec<usize>) = (plane..plane * (planes - 1))
            .partition(|node| between(node % plane / row, plane / row) && between(node % row, row));
        if inside.is_empty() || !inside.iter().all(|&node| alone[node]) {
            return None;
        }
        let mut masses = vec![0.0; planes * R::PARTS * stride];
        for &node in &inside {
            let at = &mut masses[node / plane * R::PARTS * stride + node % plane..];
            // SAFETY: there is as much room for each part.
            unsafe { inverse_masses[node].put_parts(at.as_mut_ptr(), stride) };
        }
        let place = |node: usize| (node as u32, layout.place::<R>(node, 0) as u32);
        Some(Self {
            layout,
            inside: inside.into_iter().map(place).collect(),
            boundary: boundary.into_iter().map(place).collect(),
            positions: Storage::new(),
            velocities: Storage::new(),
            inverse_masses: masses,
        })
    }

    /// Places of the nodes inside.
    pub fn inside(&self) -> Vec<u32> {
        self.inside.iter().map(|&(place, _)| place).collect()
    }

    /// Takes the motion of the nodes inside from the rows of all nodes; `nodes` is the lattice's list.
    pub fn load(&mut self, positions: &[Row<R>], velocities: &[Row<R>], nodes: &[u32]) {
        let mut x = self.positions.field(self.layout);
        let mut v = self.velocities.field(self.layout);
        for &(place, at) in &self.inside {
            let node = nodes[place as usize] as usize;
            // SAFETY of both: every place inside is a node of the lattice.
            unsafe {
                x.set_at(at as usize, &positions[node]);
                v.set_at(at as usize, &velocities[node]);
            }
        }
    }

    /// Moments of the nodes inside.
    pub fn moments(&mut self, origin: &Origin<R>) -> Moments<R> {
        R::dispatch(Sum { interior: self, origin })
    }

    /// Stores it by `give`: each node's number, its position and its velocity.
    pub fn store(&mut self, nodes: &[u32], give: &mut dyn FnMut(u32, Row<R>, Row<R>)) {
        let x = self.positions.field(self.layout);
        let v = self.velocities.field(self.layout);
        for &(place, at) in &self.inside {
            // SAFETY: every place inside is a node of the lattice.
            let (x, v) = unsafe { (x.get_at(at as usize), v.get_at(at as usize)) };
            give(nodes[place as usize], x, v);
        }
    }

    /// Positions of all nodes, those not inside from the rows of all nodes. `nodes` is longer than the list of the
    /// lattice by a block.
    ///
    /// # Safety
    /// The nodes exist.
    #[inline(always)]
    pub unsafe fn load_boundary<P: Pack<Real = R>>(
        &mut self,
        rows: &[Row<R>],
        nodes: &[u32],
    ) -> Field<'_, R> {
        let Layout { planes, .. } = self.layout;
        let mut field = self.positions.field(self.layout);
        // SAFETY of these: the caller's promise; every place of the boundary is a node of the lattice.
        unsafe {
            field.load::<P>(0, rows, nodes);
            field.load::<P>(planes - 1, rows, nodes);
            for &(place, at) in &self.boundary {
                let node = *nodes.get_unchecked(place as usize);
                field.set_at(at as usize, rows.get_unchecked(node as usize));
            }
        }
        field
    }

    /// Positions of all nodes, as of the last [`Interior::load_boundary`].
    pub fn positions(&mut self) -> Field<'_, R> {
        self.positions.field(self.layout)
    }

    /// Writes the forces on the nodes that are not inside, one after the other in the order of all. There is room for
    /// all nodes and a block.
    #[inline(always)]
    pub fn store_boundary<P: Pack<Real = R>>(&self, forces: &mut Field<R>, rows: &mut [Row<R>]) {
        let Layout { plane, planes, .. } = self.layout;
        // A plane overruns into what follows.
        forces.store::<P>(0, rows);
        let (between, last) = rows[plane..].split_at_mut(self.boundary.len());
        for (row, &(_, at)) in between.iter_mut().zip(&self.boundary) {
            // SAFETY: the place of a node of the lattice.
            *row = unsafe { forces.get_at(at as usize) };
        }
        forces.store::<P>(planes - 1, last);
    }
}

/// Moves the nodes inside by a step.
pub struct Advance<'a, R> {
    /// Whose nodes they are.
    pub interior: &'a mut Interior<R>,
    /// Forces, N.
    pub forces: Field<'a, R>,
    /// The step, s.
    pub step: f64,
}

impl<R: Real> PackKernel<R> for Advance<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(mut self) {
        let Interior { layout, positions, velocities, inverse_masses, .. } = self.interior;
        let Layout { row, plane, planes, stride } = *layout;
        let (mut x, mut v) = (positions.field(*layout), velocities.field(*layout));
        let step = self.step;
        for k in 1..planes - 1 {
            // Whole rows, whose ends have neither velocity nor inverse mass; a pack may overrun into the last row,
            // which has none either.
            for at in (row..plane - row).step_by(P::LANES) {
                // SAFETY: a whole block follows within the stride.
                unsafe {
                    let inverse = inverse_masses.as_ptr().add(k * P::Real::PARTS * stride + at);
                    let scale = P::read_parts(inverse, stride) * step;
                    for axis in 0..3 {
                        let (f, v, x) =
                            (self.forces.at(k, axis).add(at), v.at(k, axis).add(at), x.at(k, axis).add(at));
                        // Product and sum apart, as where all nodes move: the same bits.
                        let velocity = P::read_parts(v, stride) + P::read_parts(f, stride).product(scale);
                        velocity.write_parts(v, stride);
                        (P::read_parts(x, stride) + velocity * step).write_parts(x, stride);
                    }
                }
            }
        }
    }
}

/// Kinetic energy of the nodes inside between their velocities before and after a step, J.
pub struct Kinetic<'a, R> {
    /// Before [`Advance`].
    pub interior: &'a mut Interior<R>,
    /// Forces, N.
    pub forces: Field<'a, R>,
    /// The step, s.
    pub step: f64,
}

impl<R: Real> PackKernel<R> for Kinetic<'_, R> {
    type Output = R;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(mut self) -> R {
        let Interior { layout, velocities, inverse_masses, .. } = self.interior;
        let Layout { row, plane, planes, stride } = *layout;
        let (mut v, step, mut sum) = (velocities.field(*layout), self.step, P::zero());
        for k in 1..planes - 1 {
            for at in (row..plane - row).step_by(P::LANES) {
                // SAFETY: as in `Advance`.
                unsafe {
                    let inverse = inverse_masses.as_ptr().add(k * R::PARTS * stride + at);
                    let inverse = P::read_parts(inverse, stride);
                    let mass = P::select(inverse.gt(P::zero()), inverse.recip(), P::zero());
                    let before = v.vector(k, at);
                    let after = before + self.forces.vector(k, at) * (inverse * step);
                    sum += before.dot(after) * mass;
                }
            }
        }
        (0..P::LANES).fold(R::zero(), |total, lane| total + sum.real(lane)) * R::from_f64(0.5)
    }
}

struct Sum<'a, R> {
    interior: &'a mut Interior<R>,
    origin: &'a Origin<R>,
}

impl<R: Real> PackKernel<R> for Sum<'_, R> {
    type Output = Moments<R>;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Moments<R> {
        let Interior { layout, positions, velocities, inverse_masses, .. } = self.interior;
        let Layout { row, plane, planes, stride } = *layout;
        let (mut x, mut v) = (positions.field(*layout), velocities.field(*layout));
        let origin = self.origin.splat::<P>();
        let mut sum = Moments::zero();
        for k in 1..planes - 1 {
            for at in (row..plane - row).step_by(P::LANES) {
                // SAFETY: as in `Advance`.
                unsafe {
                    let inverse = inverse_masses.as_ptr().add(k * R::PARTS * stride + at);
                    let inverse = P::read_parts(inverse, stride);
                    let mass = P::select(inverse.gt(P::zero()), inverse.recip(), P::zero());
                    sum.add(&origin, mass, x.vector(k, at), v.vector(k, at));
                }
            }
        }
        sum.total()
    }
}
