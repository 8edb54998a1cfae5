//! Patches of four-node shells of one material: their data.
//!
//! A shell's node has a second row in the structure, for its rotation: its mass is the rotary inertia, its velocity
//! the angular velocity, its position the rotation vector summed up, which nothing reads. Stresses, or their
//! resultants, are kept in the frame of the element and grow by the strain of every step.

use super::layers::Layers;
use super::material::ShellMaterial;
use super::modes::CORNERS;
use super::quadrature::Rule;
use super::section::ElasticSection;
use crate::block::{BLOCK, Eight};
use crate::material::eight_alike;
use crate::mesh::ShellMesh;
use clubface_math::{Pack, Real, Row, Vec3};
use std::collections::HashMap;

/// Most shells a patch: few enough that many threads share them, many enough that most nodes lie inside, where a
/// patch moves them with its forces still in the fast caches. As for solids, it does not depend on the number of
/// threads.
pub const SHELL_PATCH: usize = 544;

/// Where the nodes of a shell mesh stand among the rows of a structure.
#[derive(Clone, Copy, Debug)]
pub struct ShellRows {
    /// Row of the position of the mesh's first node.
    pub positions: u32,
    /// Row of the rotation of the mesh's first node.
    pub rotations: u32,
}

/// Some shells of one material, in blocks of eight.
pub struct ShellPatch<R: Real> {
    pub(super) material: ShellMaterial<R>,
    /// Rows of positions, then rows of rotations.
    pub(super) nodes: Vec<u32>,
    /// Places in the first half of `nodes`, by block, corner and lane, and rows of positions.
    pub(super) corners: Vec<[u32; CORNERS * BLOCK]>,
    pub(super) rows: Vec<[u32; CORNERS * BLOCK]>,
    /// How far behind its position the rotation of a node stands.
    pub(super) behind: usize,
    /// Largest row of a position.
    last: u32,
    pub(super) thickness: Vec<Eight<R>>,
    /// Reference areas, m2.
    pub(super) areas: Vec<R>,
    /// Points through the thickness (places from -1 to 1, weights), none for resultants alone.
    pub(super) points: Vec<(f64, f64)>,
    /// By block, number and lane.
    pub(super) state: Vec<Eight<R>>,
    pub(super) state_length: usize,
    /// Number of the first element in the mesh, and how many there are.
    pub(super) first: usize,
    pub(super) elements: usize,
    pub(super) forces: Vec<Row<R>>,
}

impl<R: Real> ShellPatch<R> {
    /// From some elements of a mesh, free of stress.
    ///
    /// # Panics
    /// If rotations stand before positions.
    pub fn new(
        mesh: &ShellMesh<R>,
        elements: std::ops::Range<usize>,
        material: ShellMaterial<R>,
        rows: ShellRows,
    ) -> Self {
        let mut local = Vec::new();
        let mut place = HashMap::new();
        let blocks = elements.len().div_ceil(BLOCK);
        let mut corners = vec![[0; CORNERS * BLOCK]; blocks];
        let mut rows_of = corners.clone();
        let mut thickness = vec![Eight::alike(R::zero()); blocks];
        let mut areas = Vec::with_capacity(blocks * BLOCK);
        for slot in 0..blocks * BLOCK {
            // The last block is filled up with copies of the last element, too thin to matter.
            let element = elements.start + slot.min(elements.len() - 1);
            for (corner, &node) in mesh.quads[element].iter().enumerate() {
                let (block, at) = (slot / BLOCK, corner * BLOCK + slot % BLOCK);
                rows_of[block][at] = node + rows.positions;
                corners[block][at] = *place.entry(node).or_insert_with(|| {
                    local.push(node);
                    local.len() as u32 - 1
                });
            }
            if slot < elements.len() {
                thickness[slot / BLOCK].set(slot % BLOCK, mesh.thickness[element]);
            }
            areas.push(R::from_f64(mesh.area(element)));
        }
        let nodes: Vec<u32> = (local.iter().map(|n| n + rows.positions))
            .chain(local.iter().map(|n| n + rows.rotations))
            .collect();
        let points = material.rule().map_or(vec![], Rule::points);
        let start = if points.is_empty() {
            vec![R::zero(); ElasticSection::LENGTH]
        } else {
            Layers::<R>::start(points.len(), material.hardening.as_ref())
        };
        assert!(rows.rotations >= rows.positions, "rotations stand behind positions");
        let last = rows_of.iter().flatten().copied().max().unwrap_or(0);
        Self {
            material,
            corners,
            rows: rows_of,
            behind: (rows.rotations - rows.positions) as usize,
            last,
            thickness,
            areas,
            state: eight_alike(&start).repeat(blocks),
            state_length: start.len(),
            points,
            first: elements.start,
            elements: elements.len(),
            forces: vec![Row::zero(); nodes.len()],
            nodes,
        }
    }

    /// The promise that every row exists, on which unchecked reads rely.
    pub(super) fn check(&self, positions: &[Row<R>]) {
        assert!((self.last as usize) < positions.len(), "a patch of another mesh");
    }
}

/// Vectors of the corners of `LANES` elements of a block.
///
/// # Safety
/// All of the block's rows exist.
#[inline(always)]
pub(super) unsafe fn gather<P: Pack>(
    field: &[Row<P::Real>],
    rows: &[u32; CORNERS * BLOCK],
    first: usize,
) -> [Vec3<P>; CORNERS] {
    let mut x = [Vec3::zero(); CORNERS];
    for corner in 0..CORNERS {
        // SAFETY: the caller's promise.
        x[corner] = unsafe { P::gather(field, &rows[corner * BLOCK + first..]) };
    }
    x
}
