//! A deforming surface of quadrilaterals with a normal that is continuous across their edges.

use super::Grooves;
use crate::material::{cross, dot};
use clubface_math::{Real, Row, Vec3};

/// Largest reference coordinate at which a point still belongs to a quadrilateral.
const INSIDE: f64 = 1.0 + 1e-9;
/// Most quadrilaterals that a search passes through.
const LONGEST_SEARCH: usize = 64;
/// Newton iterations in one quadrilateral: starting from the result of the last time step, the second is exact to
/// rounding.
const NEWTON_ITERATIONS: usize = 2;

/// Reference coordinates of a quadrilateral's corners.
const SIGNS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Closest-point projection of a point on the surface.
#[derive(Clone, Copy, Debug)]
pub struct Projection<R> {
    /// Quadrilateral below the point.
    pub quad: u32,
    /// Reference coordinates in it.
    pub at: [R; 2],
    /// Distance from the outer side of the shell along the normal, m.
    pub gap: R,
    /// Outward unit normal.
    pub normal: Vec3<R>,
    /// Bilinear weights of the corners.
    pub weights: [R; 4],
}

/// The outer side of some shells, half their thickness outside their nodes.
pub struct Surface<R> {
    /// Corners of the quadrilaterals, as indices of its nodes.
    pub quads: Vec<[u32; 4]>,
    /// Neighbour across each edge (corner to next corner), or `u32::MAX`.
    neighbours: Vec<[u32; 4]>,
    /// Quadrilaterals round node `n`: `round[first[n]..first[n + 1]]`.
    first: Vec<u32>,
    round: Vec<u32>,
    /// Half the thickness at each node, m.
    offsets: Vec<R>,
    /// Row of each node.
    nodes: Vec<u32>,
    /// Grooves, and the height of each node up the undeformed face, m.
    pub grooves: Option<(Grooves, Vec<f64>)>,
    normals: Vec<Vec3<R>>,
    /// Step in which each normal was computed.
    computed_at: Vec<u32>,
    step: u32,
}

impl<R: Real> Surface<R> {
    /// From quadrilaterals, counterclockwise seen from outside, with the thickness (m) of each, between nodes of the
    /// given rows.
    pub fn new(quads: Vec<[u32; 4]>, thickness: &[R], nodes: Vec<u32>) -> Self {
        let mut edges = std::collections::HashMap::new();
        for (q, quad) in quads.iter().enumerate() {
            for k in 0..4 {
                edges.insert((quad[k], quad[(k + 1) % 4]), q as u32);
            }
        }
        let neighbours = quads
            .iter()
            .map(|quad| [0, 1, 2, 3].map(|k| *edges.get(&(quad[(k + 1) % 4], quad[k])).unwrap_or(&u32::MAX)))
            .collect();
        let mut around = vec![Vec::new(); nodes.len()];
        for (q, quad) in quads.iter().enumerate() {
            for &node in quad {
                around[node as usize].push(q as u32);
            }
        }
        let (mut first, mut round) = (vec![0], Vec::new());
        let mut offsets = Vec::new();
        for list in around {
            let mut sum = R::zero();
            for &q in &list {
                sum += thickness[q as usize];
            }
            offsets.push(sum * (0.5 / list.len() as f64));
            round.extend(list);
            first.push(round.len() as u32);
        }
        Self {
            quads,
            neighbours,
            first,
            round,
            offsets,
            grooves: None,
            normals: vec![Vec3::zero(); nodes.len()],
            computed_at: vec![0; nodes.len()],
            step: 0,
            nodes,
        }
    }

    /// Begins another step, in which normals are computed anew.
    pub fn begin_step(&mut self) {
        self.step += 1;
    }

    /// Position of a node, m. Read only where it is needed: most nodes are far from the ball, and in the cache of
    /// another core.
    #[inline(always)]
    pub fn position(&self, rows: &[Row<R>], node: u32) -> Vec3<R> {
        rows[self.nodes[node as usize] as usize].vec()
    }

    /// Positions of the corners of a quadrilateral, m.
    #[inline(always)]
    fn corners(&self, rows: &[Row<R>], quad: u32) -> [Vec3<R>; 4] {
        self.quads[quad as usize].map(|node| self.position(rows, node))
    }

    /// Normal at a node: the sum of the area vectors of the quadrilaterals round it, to unit length.
    fn compute_normal(&self, rows: &[Row<R>], node: usize) -> Vec3<R> {
        let mut sum = Vec3::zero();
        for &q in &self.round[self.first[node] as usize..self.first[node + 1] as usize] {
            let [a, b, c, d] = self.corners(rows, q);
            sum += cross(c - a, d - b);
        }
        sum * dot(sum, sum).sqrt().recip()
    }

    /// Normals at a quadrilateral's corners in this step.
    fn normals(&mut self, rows: &[Row<R>], quad: u32) -> [Vec3<R>; 4] {
        self.quads[quad as usize].map(|node| {
            let node = node as usize;
            if self.computed_at[node] != self.step {
                self.computed_at[node] = self.step;
                self.normals[node] = self.compute_normal(rows, node);
            }
            self.normals[node]
        })
    }

    /// Quadrilateral whose centre is closest to a point.
    pub fn closest(&self, rows: &[Row<R>], point: Vec3<R>) -> u32 {
        let distance = |quad: &[u32; 4]| {
            let mut away = point * R::from_f64(-4.0);
            for &node in quad {
                away += self.position(rows, node);
            }
            away.norm_squared().re()
        };
        let mut best = (f64::INFINITY, 0);
        for (q, quad) in self.quads.iter().enumerate() {
            let d = distance(quad);
            if d < best.0 {
                best = (d, q as u32);
            }
        }
        best.1
    }

    /// Projection of a point, searched from a quadrilateral and reference coordinates in it; none if the point is
    /// beyond the surface's edge.
    pub fn projection(
        &mut self,
        rows: &[Row<R>],
        point: Vec3<R>,
        quad: u32,
        at: [R; 2],
    ) -> Option<Projection<R>> {
        let (mut quad, mut at) = (quad, at);
        for _ in 0..LONGEST_SEARCH {
            let normals = self.normals(rows, quad);
            let projection = self.project(rows, point, quad, at, &normals);
            match self.neighbour_beyond(&projection) {
                None => return Some(projection),
                Some(u32::MAX) => return None,
                Some(neighbour) => quad = neighbour,
            }
            at = [R::zero(); 2];
        }
        None
    }

    /// Gradients of the weights along the surface at a projection on its lands, 1/m.
    pub fn slopes(&self, rows: &[Row<R>], projection: &Projection<R>) -> [Vec3<R>; 4] {
        let [_, x1, x2, x3] = modes(&self.corners(rows, projection.quad));
        let ([xi, eta], n) = (projection.at, projection.normal);
        let (a, b) = (x1 + x3 * eta, x2 + x3 * xi);
        let scale = dot(cross(a, b), n).recip() * 0.25;
        let (along_xi, along_eta) = (cross(b, n) * scale, cross(n, a) * scale);
        SIGNS.map(|[s, t]| along_xi * ((eta * t + 1.0) * s) + along_eta * ((xi * s + 1.0) * t))
    }

    /// The projection in the grooves of the face, if it has any: distance and normal of their walls and floors.
    pub fn in_grooves(&self, rows: &[Row<R>], projection: Projection<R>) -> Projection<R> {
        let Some((grooves, heights)) = &self.grooves else { return projection };
        let nodes = self.quads[projection.quad as usize];
        let h = nodes.map(|n| heights[n as usize]);
        let mut height = R::zero();
        for k in 0..4 {
            height += projection.weights[k] * h[k];
        }
        let (depth, slope) = grooves.relief(height);
        if depth.re() <= 0.0 {
            return projection;
        }
        // The distance is n . (x - projection) + depth(height): its gradient has a part up the face.
        let mut gradient = projection.normal;
        for (rise, at) in self.slopes(rows, &projection).into_iter().zip(h) {
            gradient += rise * (slope * at);
        }
        let steep = dot(gradient, gradient).sqrt().recip();
        Projection { gap: (projection.gap + depth) * steep, normal: gradient * steep, ..projection }
    }

    /// The same from the middle of a quadrilateral, without keeping the normals.
    pub fn projection_from(&self, rows: &[Row<R>], point: Vec3<R>, quad: u32) -> Option<Projection<R>> {
        let mut quad = quad;
        for _ in 0..LONGEST_SEARCH {
            let normals = self.quads[quad as usize].map(|node| self.compute_normal(rows, node as usize));
            let rough = self.project(rows, point, quad, [R::zero(); 2], &normals);
            match self.neighbour_beyond(&rough) {
                None => return Some(self.project(rows, point, quad, rough.at, &normals)),
                Some(u32::MAX) => return None,
                Some(neighbour) => quad = neighbour,
            }
        }
        None
    }

    /// Neighbour in whose direction a projection lies outside its quadrilateral, if it does: across the edge that is
    /// passed by more.
    fn neighbour_beyond(&self, projection: &Projection<R>) -> Option<u32> {
        let [xi, eta] = projection.at.map(clubface_math::Scalar::re);
        if xi.abs() <= INSIDE && eta.abs() <= INSIDE {
            return None;
        }
        let side = match (xi.abs() > eta.abs(), xi > 0.0, eta > 0.0) {
            (true, true, _) => 1,
            (true, false, _) => 3,
            (false, _, true) => 2,
            (false, _, false) => 0,
        };
        Some(self.neighbours[projection.quad as usize][side])
    }

    /// Point of a quadrilateral whose interpolated normal leads to `point`.
    fn project(
        &self,
        rows: &[Row<R>],
        point: Vec3<R>,
        quad: u32,
        start: [R; 2],
        normals: &[Vec3<R>; 4],
    ) -> Projection<R> {
        let nodes = self.quads[quad as usize];
        let x = self.corners(rows, quad);
        let ([x0, x1, x2, x3], [n0, n1, n2, n3]) = (modes(&x), modes(normals));
        let mut at = start;
        let mut height = dot(point - x0, n0);
        for _ in 0..NEWTON_ITERATIONS {
            let [xi, eta] = at;
            let (n, nx, ny) = (n0 + n1 * xi + (n2 + n3 * xi) * eta, n1 + n3 * eta, n2 + n3 * xi);
            let position = x0 + x1 * xi + (x2 + x3 * xi) * eta;
            let residual = point - position - n * height;
            let (a, b) = (x1 + x3 * eta + nx * height, x2 + x3 * xi + ny * height);
            let (ab, bn, na) = (cross(a, b), cross(b, n), cross(n, a));
            let scale = dot(ab, n).recip();
            // Far outside, a full step would leave the neighbourhood where the element means anything.
            at = [limited(xi + dot(bn, residual) * scale), limited(eta + dot(na, residual) * scale)];
            height += dot(ab, residual) * scale;
        }
        let [xi, eta] = at;
        let n = n0 + n1 * xi + (n2 + n3 * xi) * eta;
        let size = dot(n, n).sqrt();
        let weights = SIGNS.map(|[s, t]| (xi * s + 1.0) * (eta * t + 1.0) * 0.25);
        let mut offset = R::zero();
        for k in 0..4 {
            offset += weights[k] * self.offsets[nodes[k] as usize];
        }
        Projection { quad, at, gap: height * size - offset, normal: n * size.recip(), weights }
    }
}

#[inline(always)]
fn limited<R: Real>(c: R) -> R {
    c.min(R::from_f64(3.0)).max(R::from_f64(-3.0))
}

/// Bilinear map by powers: constant, along xi, along eta, both.
#[inline(always)]
fn modes<R: Real>(x: &[Vec3<R>; 4]) -> [Vec3<R>; 4] {
    let quarter = R::from_f64(0.25);
    let (a, b, c, d) = (x[0] + x[1], x[2] + x[3], x[1] - x[0], x[2] - x[3]);
    [(a + b) * quarter, (c + d) * quarter, (b - a) * quarter, (d - c) * quarter]
}
