//! The second stage of a step: every node sums the forces on it, in an order that does not depend on threads, and
//! moves.

use clubface_math::{Pack, PackKernel, Real, Row};

/// Most nodes of a gather list.
const CHUNK: usize = 512;

/// Number of steps for which the forces of a subcycled patch act.
pub(super) const PERIOD: f64 = 2.0;

/// A patch (or the contact) and a position in its forces.
type Slot = (u32, u32);

/// Consecutive nodes with the same number of forces, so that the CPU predicts correctly how often to add.
struct NodeGroup {
    nodes: usize,
    /// Forces a node of subcycled patches, and of the others.
    slow: usize,
    fast: usize,
}

impl NodeGroup {
    /// Whether these nodes move in every second step only.
    fn subcycled(&self) -> bool {
        self.slow > 0 && self.fast == 0
    }
}

/// Some nodes, and where to find the forces on each.
pub(super) struct GatherList {
    /// Patch (or contact) of the first forces.
    pub(super) owner: usize,
    groups: Vec<NodeGroup>,
    nodes: Vec<u32>,
    /// Where the forces are, node by node: first those of subcycled patches, in the order of the patches.
    slots: Vec<Slot>,
}

/// Gather lists of all nodes.
pub(super) struct GatherLists {
    /// Nodes on which one patch alone acts, by patch.
    pub(super) single: Vec<GatherList>,
    /// The others.
    pub(super) shared: Vec<GatherList>,
}

/// Gather lists of `count` nodes without those that `skip` names. `forces` gives for each patch, and the contact at the
/// end, the nodes on which its forces act; `subcycled` says which of them are subcycled. The first `patches` of them
/// get lists of the nodes on which they alone act.
pub(super) fn gather_lists<'a>(
    count: usize,
    forces: impl Iterator<Item = &'a [u32]>,
    patches: usize,
    subcycled: impl Fn(usize) -> bool,
    skip: impl Fn(usize) -> bool,
) -> GatherLists {
    let mut on_node: Vec<[Vec<Slot>; 2]> = vec![[Vec::new(), Vec::new()]; count];
    for (patch, nodes) in forces.enumerate() {
        for (index, &node) in nodes.iter().enumerate() {
            on_node[node as usize][usize::from(!subcycled(patch))].push((patch as u32, index as u32));
        }
    }
    // Nodes that are subcycled come first, so that whole chunks of them have nothing to do. Then patch by patch: the
    // worker that has computed the forces has them at hand.
    let slow = |node: &usize| on_node[*node][1].is_empty() && !on_node[*node][0].is_empty();
    let first = |node: usize| on_node[node].iter().flatten().min().copied();
    let owner = |node: usize| first(node).map(|(patch, _)| patch);
    let mut single = vec![Vec::new(); patches];
    let mut nodes = Vec::new();
    for node in (0..count).filter(|&node| !skip(node)) {
        let mut slots = on_node[node].iter().flatten();
        match (slots.next(), slots.next()) {
            (Some(&(patch, _)), None) if (patch as usize) < patches => single[patch as usize].push(node),
            _ => nodes.push(node),
        }
    }
    nodes.sort_by_key(|&node| first(node));
    let (slow, fast): (Vec<usize>, Vec<usize>) = nodes.into_iter().partition(slow);
    // One owner a chunk: the worker that moves the nodes has computed the first forces on all of them.
    let parts = [slow, fast];
    let runs = parts.iter().flat_map(|nodes| nodes.chunk_by(|&a, &b| owner(a) == owner(b)));
    GatherLists {
        single: single.iter().map(|nodes| GatherList::new(nodes, &on_node)).collect(),
        shared: runs
            .flat_map(|nodes| nodes.chunks(CHUNK))
            .map(|chunk| GatherList::new(chunk, &on_node))
            .collect(),
    }
}

impl GatherList {
    fn new(chunk: &[usize], on_node: &[[Vec<Slot>; 2]]) -> Self {
        let key = |node: usize| on_node[node].each_ref().map(Vec::len);
        let mut order = chunk.to_vec();
        order.sort_by_key(|&node| key(node));
        let slot = chunk.first().and_then(|&node| on_node[node].iter().flatten().min());
        let owner = slot.map_or(0, |slot| slot.0 as usize);
        let mut list = Self { owner, groups: Vec::new(), nodes: Vec::new(), slots: Vec::new() };
        for group in order.chunk_by(|&a, &b| key(a) == key(b)) {
            let [slow, fast] = key(group[0]);
            list.groups.push(NodeGroup { nodes: group.len(), slow, fast });
            for &node in group {
                list.nodes.push(node as u32);
                list.slots.extend(on_node[node].iter().flatten());
            }
        }
        list
    }

    /// Whether all of its nodes move in every second step only.
    pub(super) fn subcycled(&self) -> bool {
        self.groups.iter().all(NodeGroup::subcycled)
    }

    /// Moves the nodes by a step. In a `full` step the forces of subcycled patches act, for all of their steps at once.
    ///
    /// # Safety
    /// The fields and all forces still exist and are those of the nodes and patches for which the list was made; nobody
    /// else uses these nodes of the fields, or writes forces on them, at the same time.
    pub(super) unsafe fn advance<R: Real>(
        &self,
        fields: Fields<R>,
        forces: *const Forces<R>,
        step: f64,
        full: bool,
    ) {
        R::dispatch(Advance { list: self, fields, forces, step, full });
    }
}

/// Forces of a patch or of the contact, in the order of its nodes.
#[derive(Clone, Copy)]
pub(super) struct Forces<R: Real>(*const Row<R>);

// SAFETY: read by all threads while none writes.
unsafe impl<R: Real> Sync for Forces<R> {}
unsafe impl<R: Real> Send for Forces<R> {}

impl<R: Real> Forces<R> {
    /// Not known yet.
    pub(super) fn none() -> Self {
        Self(std::ptr::null())
    }
    /// Forces in a slice that must have `count` rows.
    pub(super) fn new(rows: &[Row<R>], count: usize) -> Self {
        assert_eq!(rows.len(), count, "a patch has as many forces as nodes");
        Self(rows.as_ptr())
    }
}

/// Positions, velocities and inverse masses of all nodes, of which different threads move different nodes.
#[derive(Clone, Copy)]
pub(super) struct Fields<R: Real> {
    positions: *mut Row<R>,
    velocities: *mut Row<R>,
    inverse_masses: *const R,
    count: usize,
}

// SAFETY: every node is in one list.
unsafe impl<R: Real> Sync for Fields<R> {}
unsafe impl<R: Real> Send for Fields<R> {}

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
    /// The fields still exist, and nobody else uses this node at the same time.
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
    /// The fields still exist, and nobody writes what is read at the same time.
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

struct Advance<'a, R: Real> {
    list: &'a GatherList,
    fields: Fields<R>,
    forces: *const Forces<R>,
    step: f64,
    full: bool,
}

impl<R: Real> PackKernel<R> for Advance<'_, R> {
    type Output = ();
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) {
        let Advance { list, fields, forces, step, full } = self;
        let (mut node, mut slot) = (0, 0);
        for group in &list.groups {
            let NodeGroup { nodes, slow, fast } = *group;
            if group.subcycled() && !full {
                (node, slot) = (node + nodes, slot + nodes * slow);
                continue;
            }
            let step = if group.subcycled() { step * PERIOD } else { step };
            for _ in 0..nodes {
                // SAFETY: the promise of `GatherList::advance`.
                unsafe {
                    let n = *list.nodes.get_unchecked(node) as usize;
                    debug_assert!(n < fields.count);
                    let mut sum = Row::zero();
                    let gather = |from: usize, to: usize, sum: &mut Row<R>| {
                        for i in from..to {
                            let (patch, index) = *list.slots.get_unchecked(i);
                            sum.add_times(&*(*forces.add(patch as usize)).0.add(index as usize), 1.0);
                        }
                    };
                    if slow > 0 && full {
                        gather(slot, slot + slow, &mut sum);
                        if fast > 0 {
                            let once = sum;
                            sum = Row::zero();
                            sum.add_times(&once, PERIOD);
                        }
                    }
                    gather(slot + slow, slot + slow + fast, &mut sum);
                    let (x, v) = (&mut *fields.positions.add(n), &mut *fields.velocities.add(n));
                    v.add_scaled(&sum, *fields.inverse_masses.add(n) * step);
                    x.add_times(v, step);
                }
                node += 1;
                slot += slow + fast;
            }
        }
    }
}
