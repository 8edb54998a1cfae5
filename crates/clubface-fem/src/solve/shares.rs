//! The second phase of a step: every node sums the forces on it, in an order that does not depend on threads, and moves.

use clubface_math::{Pack, PackKernel, Real, Row, Scalar};

/// Nodes a task.
const CHUNK: usize = 512;

/// Steps a resting list's forces hold for.
pub(super) const PERIOD: f64 = 2.0;

/// Nodes that follow each other and have as many forces, so that a CPU guesses right how often to add.
struct Alike {
    nodes: usize,
    /// Forces of lists that rest in every second step, and of the others.
    slow: usize,
    fast: usize,
}

impl Alike {
    /// Whether these nodes rest in every second step.
    fn rest(&self) -> bool {
        self.slow > 0 && self.fast == 0
    }
}

/// Where the forces on some nodes stand.
pub(super) struct Shares {
    /// List that the first forces stand in.
    pub(super) owner: usize,
    groups: Vec<Alike>,
    nodes: Vec<u32>,
    /// List of each force, and place in it, node by node: those of resting lists first, in the order of the lists.
    slots: Vec<(u32, u32)>,
}

/// Nodes apart.
pub(super) struct Split {
    /// Those that forces of one list alone act on, by list.
    pub(super) inner: Vec<Shares>,
    /// The others.
    pub(super) outer: Vec<Shares>,
}

/// All nodes but those that `skip` names, by the lists of nodes that forces act on, of which some rest in every second step. The first `alone` lists have
/// inner nodes.
pub(super) fn split<'a>(
    count: usize,
    lists: impl Iterator<Item = &'a [u32]>,
    alone: usize,
    rests: impl Fn(usize) -> bool,
    skip: impl Fn(usize) -> bool,
) -> Split {
    let mut on_node: Vec<[Vec<(u32, u32)>; 2]> = vec![[Vec::new(), Vec::new()]; count];
    for (list, nodes) in lists.enumerate() {
        for (place, &node) in nodes.iter().enumerate() {
            on_node[node as usize][usize::from(!rests(list))].push((list as u32, place as u32));
        }
    }
    // Nodes that rest together come first: whole chunks of them have nothing to do. Then list by list: who has made the forces has them at hand.
    let rest = |node: &usize| on_node[*node][1].is_empty() && !on_node[*node][0].is_empty();
    let first = |node: usize| on_node[node].iter().flatten().min().copied();
    let list = |node: usize| first(node).map(|(list, _)| list);
    let mut inner = vec![Vec::new(); alone];
    let mut nodes = Vec::new();
    for node in (0..count).filter(|&node| !skip(node)) {
        let mut slots = on_node[node].iter().flatten();
        match (slots.next(), slots.next()) {
            (Some(&(list, _)), None) if (list as usize) < alone => inner[list as usize].push(node),
            _ => nodes.push(node),
        }
    }
    nodes.sort_by_key(|&node| first(node));
    let (resting, others): (Vec<usize>, Vec<usize>) = nodes.into_iter().partition(rest);
    // Those of one list in each chunk: whoever moves them has made the first forces on all of them.
    let parts = [resting, others];
    let lists = parts.iter().flat_map(|nodes| nodes.chunk_by(|&a, &b| list(a) == list(b)));
    Split {
        inner: inner.iter().map(|nodes| Shares::new(nodes, &on_node)).collect(),
        outer: lists
            .flat_map(|nodes| nodes.chunks(CHUNK))
            .map(|chunk| Shares::new(chunk, &on_node))
            .collect(),
    }
}

impl Shares {
    fn new(chunk: &[usize], on_node: &[[Vec<(u32, u32)>; 2]]) -> Self {
        let key = |node: usize| on_node[node].each_ref().map(Vec::len);
        let mut order = chunk.to_vec();
        order.sort_by_key(|&node| key(node));
        let slot = chunk.first().and_then(|&node| on_node[node].iter().flatten().min());
        let owner = slot.map_or(0, |slot| slot.0 as usize);
        let mut shares = Self { owner, groups: Vec::new(), nodes: Vec::new(), slots: Vec::new() };
        for group in order.chunk_by(|&a, &b| key(a) == key(b)) {
            let [slow, fast] = key(group[0]);
            shares.groups.push(Alike { nodes: group.len(), slow, fast });
            for &node in group {
                shares.nodes.push(node as u32);
                shares.slots.extend(on_node[node].iter().flatten());
            }
        }
        shares
    }

    /// Whether all of its nodes rest in every second step.
    pub(super) fn rest(&self) -> bool {
        self.groups.iter().all(Alike::rest)
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
    /// Sets the position and velocity of a node.
    ///
    /// # Safety
    /// The fields are still there, and nobody else uses this node.
    pub(super) unsafe fn set(&self, node: u32, position: Row<R>, velocity: Row<R>) {
        assert!((node as usize) < self.count);
        // SAFETY: the caller's promise, and the node exists.
        unsafe {
            *self.positions.add(node as usize) = position;
            *self.velocities.add(node as usize) = velocity;
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
    /// Moves the nodes by a step; in a `whole` one the forces of resting lists act, for as many steps as they hold.
    ///
    /// # Safety
    /// Fields and the forces of all lists are still there, of the nodes and lists that the shares were made for, and nobody else uses these nodes of the
    /// fields or writes forces on them.
    pub(super) unsafe fn advance<R: Real>(
        &self,
        fields: Fields<R>,
        forces: *const Forces<R>,
        step: R,
        whole: bool,
    ) {
        R::dispatch(Advance { shares: self, fields, forces, step, whole });
    }
}

struct Advance<'a, R> {
    shares: &'a Shares,
    fields: Fields<R>,
    forces: *const Forces<R>,
    step: R,
    whole: bool,
}

impl<R: Real> PackKernel<R> for Advance<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let Advance { shares, fields, forces, step, whole } = self;
        let (mut node, mut slot) = (0, 0);
        for group in &shares.groups {
            let Alike { nodes, slow, fast } = *group;
            if group.rest() && !whole {
                (node, slot) = (node + nodes, slot + nodes * slow);
                continue;
            }
            let step = if group.rest() { step * PERIOD } else { step };
            for _ in 0..nodes {
                // SAFETY: the promise of `Shares::advance`.
                unsafe {
                    let n = *shares.nodes.get_unchecked(node) as usize;
                    debug_assert!(n < fields.count);
                    let mut sum = Row::zero();
                    let take = |from: usize, to: usize, sum: &mut Row<R>| {
                        for i in from..to {
                            let (list, place) = *shares.slots.get_unchecked(i);
                            add(sum, &*(*forces.add(list as usize)).0.add(place as usize), R::one());
                        }
                    };
                    if slow > 0 && whole {
                        take(slot, slot + slow, &mut sum);
                        if fast > 0 {
                            sum = Row(sum.0.map(|force| force * PERIOD));
                        }
                    }
                    take(slot + slow, slot + slow + fast, &mut sum);
                    let (x, v) = (&mut *fields.positions.add(n), &mut *fields.velocities.add(n));
                    add(v, &sum, *fields.inverse_masses.add(n) * step);
                    add(x, v, step);
                }
                node += 1;
                slot += slow + fast;
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
