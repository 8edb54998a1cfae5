//! The second phase of a step: every node sums the forces on it, in an order that does not depend on threads, and moves.

use clubface_math::{Pack, PackKernel, Real, Row, Scalar};

/// Nodes a task.
const CHUNK: usize = 512;

/// Where the forces on some nodes stand. Nodes with the same number of forces follow each other, so that a CPU guesses right how often to
/// add.
pub(super) struct Shares {
    /// Number of nodes with no force, one, two, ...
    counts: Vec<usize>,
    nodes: Vec<u32>,
    /// List of each force, and place in it, node by node in the order of the lists.
    slots: Vec<(u32, u32)>,
}

/// All nodes but those that `skip` names, by the lists of nodes that forces act on.
pub(super) fn shares<'a>(
    count: usize,
    lists: impl Iterator<Item = &'a [u32]>,
    skip: impl Fn(usize) -> bool,
) -> Vec<Shares> {
    let mut on_node: Vec<Vec<(u32, u32)>> = vec![Vec::new(); count];
    for (list, nodes) in lists.enumerate() {
        for (place, &node) in nodes.iter().enumerate() {
            on_node[node as usize].push((list as u32, place as u32));
        }
    }
    let nodes: Vec<usize> = (0..count).filter(|&node| !skip(node)).collect();
    nodes.chunks(CHUNK).map(|chunk| Shares::new(chunk, &on_node)).collect()
}

impl Shares {
    fn new(chunk: &[usize], on_node: &[Vec<(u32, u32)>]) -> Self {
        let most = chunk.iter().map(|&node| on_node[node].len()).max().unwrap_or(0);
        let mut shares = Self { counts: vec![0; most + 1], nodes: Vec::new(), slots: Vec::new() };
        for count in 0..=most {
            for &node in chunk.iter().filter(|&&node| on_node[node].len() == count) {
                shares.counts[count] += 1;
                shares.nodes.push(node as u32);
                shares.slots.extend(&on_node[node]);
            }
        }
        shares
    }
}

/// Forces in the order of a list of nodes.
#[derive(Clone, Copy)]
pub(super) struct Forces<R>(*const Row<R>);

// SAFETY: read by all threads while none writes.
unsafe impl<R: Sync> Sync for Forces<R> {}
unsafe impl<R: Sync> Send for Forces<R> {}

impl<R> Forces<R> {
    /// Not known yet.
    pub(super) fn none() -> Self {
        Self(std::ptr::null())
    }
    /// Of a slice that must have the given length.
    pub(super) fn new(rows: &[Row<R>], length: usize) -> Self {
        assert_eq!(rows.len(), length, "a patch has as many forces as nodes");
        Self(rows.as_ptr())
    }
}

/// Fields of all nodes, whose parts are moved on by different threads.
#[derive(Clone, Copy)]
pub(super) struct Fields<R> {
    positions: *mut Row<R>,
    velocities: *mut Row<R>,
    inverse_masses: *const R,
    count: usize,
}

// SAFETY: every node is in one chunk.
unsafe impl<R: Send> Sync for Fields<R> {}
unsafe impl<R: Send> Send for Fields<R> {}

impl<R: Real> Fields<R> {
    pub(super) fn new(positions: &mut [Row<R>], velocities: &mut [Row<R>], inverse_masses: &[R]) -> Self {
        let count = positions.len();
        assert!(count == velocities.len() && count == inverse_masses.len());
        Self {
            positions: positions.as_mut_ptr(),
            velocities: velocities.as_mut_ptr(),
            inverse_masses: inverse_masses.as_ptr(),
            count,
        }
    }
    /// Positions and velocities, to read.
    ///
    /// # Safety
    /// Nobody writes them while they are read, and they are still there.
    pub(super) unsafe fn read<'a>(&self) -> (&'a [Row<R>], &'a [Row<R>]) {
        // SAFETY: the caller's promise.
        unsafe {
            (
                std::slice::from_raw_parts(self.positions, self.count),
                std::slice::from_raw_parts(self.velocities, self.count),
            )
        }
    }
}

impl Shares {
    /// Moves the nodes by a step.
    ///
    /// # Safety
    /// Fields and forces are still there, of the nodes and lists that the shares were made for, and nobody else uses these nodes of the fields.
    pub(super) unsafe fn advance<R: Real>(&self, fields: Fields<R>, forces: &[Forces<R>], step: R) {
        R::dispatch(Advance { shares: self, fields, forces, step });
    }
}

struct Advance<'a, R> {
    shares: &'a Shares,
    fields: Fields<R>,
    forces: &'a [Forces<R>],
    step: R,
}

impl<R: Real> PackKernel<R> for Advance<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let Advance { shares, fields, forces, step } = self;
        let (mut node, mut slot) = (0, 0);
        for (count, &nodes) in shares.counts.iter().enumerate() {
            for _ in 0..nodes {
                // SAFETY: the promise of `Shares::advance`.
                unsafe {
                    let n = *shares.nodes.get_unchecked(node) as usize;
                    debug_assert!(n < fields.count);
                    let mut sum = Row::zero();
                    for i in slot..slot + count {
                        let (list, place) = *shares.slots.get_unchecked(i);
                        let force = &*forces.get_unchecked(list as usize).0.add(place as usize);
                        add(&mut sum, force, R::one());
                    }
                    let (x, v) = (&mut *fields.positions.add(n), &mut *fields.velocities.add(n));
                    add(v, &sum, *fields.inverse_masses.add(n) * step);
                    add(x, v, step);
                }
                node += 1;
                slot += count;
            }
        }
    }
}

/// `sum += s v`, all four numbers, so that one instruction does it.
#[inline(always)]
fn add<R: Scalar>(sum: &mut Row<R>, v: &Row<R>, s: R) {
    for c in 0..4 {
        sum.0[c] += v.0[c] * s;
    }
}
