//! A deforming surface of quadrilaterals and triangles with a normal that is continuous across their edges.
//!
//! A triangle is listed with its last corner twice. Its reference coordinates are two of the barycentric ones, less the
//! third that they have at its middle.

use super::Grooves;
use crate::material::{cross, dot};
use clubface_math::{Real, Row, Vec3};

/// How far outside a quadrilateral, in reference coordinates, a point still belongs to it. Neighbours share an edge
/// and its normals, so they agree on which side of it a point lies to the accuracy of the projection, a thousandth of
/// this: a point on an edge or a corner belongs to all that meet there, and none falls between them.
const TOLERANCE: f64 = 1e-9;
/// Newton step, in reference coordinates, after which a projection is exact to 1e-12, since each step squares the
/// error: the second of a node that was searched in the last time step, the third or fourth in a new quadrilateral.
const LAST_STEP: f64 = 1e-6;
/// Most Newton steps in one quadrilateral; no quadrilateral near a point needs as many.
const MOST_STEPS: usize = 12;
/// Largest reference coordinate of a projection outside its quadrilateral.
const LIMIT: f64 = 3.0;
/// Most quadrilaterals that a search passes through.
const LONGEST_SEARCH: usize = 64;

/// Reference coordinates of a quadrilateral's corners.
const SIGNS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// A quadrilateral or a triangle.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shape {
    Quadrilateral,
    Triangle,
}

impl Shape {
    #[inline(always)]
    fn new(corners: [u32; 4]) -> Self {
        if corners[2] == corners[3] { Self::Triangle } else { Self::Quadrilateral }
    }
    /// What is given at the corners, by powers of the reference coordinates: constant, along xi, along eta, both.
    #[inline(always)]
    fn modes<R: Real>(self, x: &[Vec3<R>; 4]) -> [Vec3<R>; 4] {
        match self {
            Self::Quadrilateral => {
                let quarter = R::from_f64(0.25);
                let (a, b, c, d) = (x[0] + x[1], x[2] + x[3], x[1] - x[0], x[2] - x[3]);
                [(a + b) * quarter, (c + d) * quarter, (b - a) * quarter, (d - c) * quarter]
            }
            Self::Triangle => {
                let middle = (x[0] + x[1] + x[2]) * R::from_f64(1.0 / 3.0);
                [middle, x[1] - x[0], x[2] - x[0], Vec3::zero()]
            }
        }
    }
    /// Weights of the corners.
    #[inline(always)]
    fn weights<R: Real>(self, [xi, eta]: [R; 2]) -> [R; 4] {
        match self {
            Self::Quadrilateral => SIGNS.map(|[s, t]| (xi * s + 1.0) * (eta * t + 1.0) * 0.25),
            Self::Triangle => {
                let third = R::from_f64(1.0 / 3.0);
                [third - xi - eta, third + xi, third + eta, R::zero()]
            }
        }
    }
    /// Newton step after which a projection is exact to 1e-12. In a triangle the normal turns faster than in a
    /// quadrilateral of the same sides, and what a step leaves is more.
    #[inline(always)]
    fn last_step(self) -> f64 {
        if self == Self::Triangle { 0.01 * LAST_STEP } else { LAST_STEP }
    }
    /// How far a point lies outside, in reference coordinates; negative inside.
    #[inline(always)]
    fn excess<R: Real>(self, at: [R; 2]) -> f64 {
        let [xi, eta] = at.map(clubface_math::Scalar::re);
        match self {
            Self::Quadrilateral => xi.abs().max(eta.abs()) - 1.0,
            Self::Triangle => (xi + eta).max(-xi).max(-eta) - 1.0 / 3.0,
        }
    }
    /// Sides beyond which a point lies, each by the number of its first corner, the one it is farther beyond first.
    fn sides_beyond<R: Real>(self, at: [R; 2]) -> impl Iterator<Item = usize> {
        let [xi, eta] = at.map(clubface_math::Scalar::re);
        let third = 1.0 / 3.0;
        let mut sides = match self {
            Self::Quadrilateral => {
                let (x, y) = (if xi > 0.0 { 1 } else { 3 }, if eta > 0.0 { 2 } else { 0 });
                [(eta.abs() - 1.0, y), (xi.abs() - 1.0, x), (-1.0, 0)]
            }
            Self::Triangle => [(xi + eta - third, 1), (-xi - third, 3), (-eta - third, 0)],
        };
        sides.sort_by(|(one, _), (other, _)| other.total_cmp(one));
        sides.into_iter().filter(|(beyond, _)| *beyond > 0.0).map(|(_, side)| side)
    }
    /// The nearest reference coordinates that are not outside, give or take.
    fn inside<R: Real>(self, at: [R; 2]) -> [R; 2] {
        match self {
            Self::Quadrilateral => at.map(|c| c.min(R::one()).max(-R::one())),
            Self::Triangle => {
                let [a, b, c, _] = self.weights(at).map(|weight| weight.max(R::zero()));
                let (sum, third) = ((a + b + c).recip(), R::from_f64(1.0 / 3.0));
                [b * sum - third, c * sum - third]
            }
        }
    }
}

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

/// A point that no normal of the surface leads to.
#[derive(Clone, Copy, Debug)]
pub struct Beyond {
    /// Quadrilateral at the edge.
    pub quad: u32,
    /// Distance from it, m.
    pub distance: f64,
}

/// Normals at the nodes of a surface, each computed at most once in a step.
pub struct Normals<R> {
    normals: Vec<Vec3<R>>,
    /// Step in which each was computed.
    computed_at: Vec<u32>,
    step: u32,
}

impl<R: Real> Normals<R> {
    /// Normals of a surface with `count` nodes.
    pub fn new(count: usize) -> Self {
        Self { normals: vec![Vec3::zero(); count], computed_at: vec![0; count], step: 0 }
    }
    /// Begins another step, in which normals are computed anew.
    pub fn begin_step(&mut self) {
        self.step += 1;
    }
    #[inline(always)]
    fn at(&mut self, node: usize, compute: impl FnOnce() -> Vec3<R>) -> Vec3<R> {
        if self.computed_at[node] != self.step {
            self.computed_at[node] = self.step;
            self.normals[node] = compute();
        }
        self.normals[node]
    }
}

/// The outer side of some shells, half their thickness outside their nodes.
pub struct Surface<R> {
    /// Corners of the quadrilaterals and triangles, as indices of its nodes.
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
}

impl<R: Real> Surface<R> {
    /// From quadrilaterals, counterclockwise seen from outside, with the thickness (m) of each, between nodes of the
    /// given rows.
    pub fn new(quads: Vec<[u32; 4]>, thickness: &[R], nodes: Vec<u32>) -> Self {
        let mut edges = std::collections::HashMap::new();
        for (q, quad) in quads.iter().enumerate() {
            for k in (0..4).filter(|&k| quad[k] != quad[(k + 1) % 4]) {
                edges.insert((quad[k], quad[(k + 1) % 4]), q as u32);
            }
        }
        let neighbours = quads
            .iter()
            .map(|quad| [0, 1, 2, 3].map(|k| *edges.get(&(quad[(k + 1) % 4], quad[k])).unwrap_or(&u32::MAX)))
            .collect();
        let mut around = vec![Vec::new(); nodes.len()];
        for (q, quad) in quads.iter().enumerate() {
            let corners = if Shape::new(*quad) == Shape::Triangle { &quad[..3] } else { &quad[..] };
            for &node in corners {
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
        Self { quads, neighbours, first, round, offsets, grooves: None, nodes }
    }

    /// Position of a node, m. Read only where it is needed: most nodes are far from the ball, and in the cache of
    /// another core.
    #[inline(always)]
    pub fn position(&self, rows: &[Row<R>], node: u32) -> Vec3<R> {
        rows[self.nodes[node as usize] as usize].vec()
    }

    #[inline(always)]
    fn shape(&self, quad: u32) -> Shape {
        Shape::new(self.quads[quad as usize])
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

    /// Quadrilateral whose centre is closest to a point.
    pub fn closest(&self, rows: &[Row<R>], point: Vec3<R>) -> u32 {
        let mut best = (f64::INFINITY, 0);
        for quad in 0..self.quads.len() as u32 {
            let distance = self.distance_from_centre(rows, point, quad);
            if distance < best.0 {
                best = (distance, quad);
            }
        }
        best.1
    }

    /// Projection of a point, searched from a quadrilateral and reference coordinates in it.
    ///
    /// # Errors
    /// [`Beyond`] if the point is beyond the surface's edge.
    pub fn projection(
        &self,
        normals: &mut Normals<R>,
        rows: &[Row<R>],
        point: Vec3<R>,
        quad: u32,
        at: [R; 2],
    ) -> Result<Projection<R>, Beyond> {
        let mut normal = |n: usize| normals.at(n, || self.compute_normal(rows, n));
        self.search(rows, point, quad, at, &mut normal)
    }

    /// The same from the middle of a quadrilateral, without keeping the normals; none beyond the edge.
    pub fn projection_from(&self, rows: &[Row<R>], point: Vec3<R>, quad: u32) -> Option<Projection<R>> {
        self.search(rows, point, quad, [R::zero(); 2], &mut |n| self.compute_normal(rows, n)).ok()
    }

    /// Gradients of the weights along the surface at a projection on its lands, 1/m.
    pub fn slopes(&self, rows: &[Row<R>], projection: &Projection<R>) -> [Vec3<R>; 4] {
        let shape = self.shape(projection.quad);
        let [_, x1, x2, x3] = shape.modes(&self.corners(rows, projection.quad));
        let ([xi, eta], n) = (projection.at, projection.normal);
        let (a, b) = (x1 + x3 * eta, x2 + x3 * xi);
        let scale = dot(cross(a, b), n).recip();
        match shape {
            Shape::Quadrilateral => {
                let scale = scale * 0.25;
                let (along_xi, along_eta) = (cross(b, n) * scale, cross(n, a) * scale);
                SIGNS.map(|[s, t]| along_xi * ((eta * t + 1.0) * s) + along_eta * ((xi * s + 1.0) * t))
            }
            Shape::Triangle => {
                let (along_xi, along_eta) = (cross(b, n) * scale, cross(n, a) * scale);
                [-(along_xi + along_eta), along_xi, along_eta, Vec3::zero()]
            }
        }
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

    /// Projection of a point, given how to compute the normal at a node.
    #[inline(always)]
    fn search<F: FnMut(usize) -> Vec3<R>>(
        &self,
        rows: &[Row<R>],
        point: Vec3<R>,
        quad: u32,
        at: [R; 2],
        normal: &mut F,
    ) -> Result<Projection<R>, Beyond> {
        let foot = self.foot(rows, point, quad, at, normal);
        if foot.excess <= TOLERANCE {
            return Ok(self.project(&foot));
        }
        self.walk(rows, point, foot, normal)
    }

    /// The search from a quadrilateral in which the point is not: across the edges that it lies beyond; where they end,
    /// or lead back, round the corners of the nearest quadrilateral.
    #[cold]
    #[inline(never)]
    fn walk<F: FnMut(usize) -> Vec3<R>>(
        &self,
        rows: &[Row<R>],
        point: Vec3<R>,
        start: Foot<R>,
        normal: &mut F,
    ) -> Result<Projection<R>, Beyond> {
        let mut visited = [start.quad; LONGEST_SEARCH];
        let (mut here, mut count) = (start, 1);
        while let Some(next) = self.across(&here, &visited[..count]) {
            here = self.foot(rows, point, next, [R::zero(); 2], normal);
            if here.excess <= TOLERANCE {
                return Ok(self.project(&here));
            }
            if count == LONGEST_SEARCH {
                break;
            }
            visited[count] = next;
            count += 1;
        }
        let quad = self.nearest_from(rows, point, here.quad);
        if quad != here.quad {
            here = self.foot(rows, point, quad, [R::zero(); 2], normal);
        }
        if here.excess <= TOLERANCE {
            return Ok(self.project(&here));
        }
        let mut beyond = Beyond { quad, distance: self.distance(rows, point, &here) };
        // What is farther away than some elements is not worth the search yet.
        let [a, _, c, _] = self.corners(rows, quad);
        if beyond.distance < 2.0 * (c - a).norm_squared().re().sqrt() {
            for other in self.around(quad) {
                let foot = self.foot(rows, point, other, [R::zero(); 2], normal);
                if foot.excess <= TOLERANCE {
                    return Ok(self.project(&foot));
                }
                let distance = self.distance(rows, point, &foot);
                if distance < beyond.distance {
                    beyond = Beyond { quad: other, distance };
                }
            }
        }
        Err(beyond)
    }

    /// A quadrilateral not yet visited across an edge that a foot lies beyond, the one it is farther beyond first.
    fn across(&self, foot: &Foot<R>, visited: &[u32]) -> Option<u32> {
        self.shape(foot.quad)
            .sides_beyond(foot.at)
            .map(|side| self.neighbours[foot.quad as usize][side])
            .find(|next| *next != u32::MAX && !visited.contains(next))
    }

    /// Quadrilaterals that share corners with one.
    fn around(&self, quad: u32) -> impl Iterator<Item = u32> + '_ {
        self.quads[quad as usize].into_iter().flat_map(|n| {
            self.round[self.first[n as usize] as usize..self.first[n as usize + 1] as usize].iter().copied()
        })
    }

    /// Quadrilateral whose centre is closest to a point among those round it, searched from one.
    fn nearest_from(&self, rows: &[Row<R>], point: Vec3<R>, quad: u32) -> u32 {
        let (mut here, mut least) = (quad, self.distance_from_centre(rows, point, quad));
        loop {
            let before = here;
            for other in self.around(before) {
                let distance = self.distance_from_centre(rows, point, other);
                if distance < least {
                    (here, least) = (other, distance);
                }
            }
            if here == before {
                return here;
            }
        }
    }

    /// Square of four times the distance of a point from the centre of a quadrilateral, m2.
    fn distance_from_centre(&self, rows: &[Row<R>], point: Vec3<R>, quad: u32) -> f64 {
        let mut away = point * R::from_f64(-4.0);
        for node in self.quads[quad as usize] {
            away += self.position(rows, node);
        }
        away.norm_squared().re()
    }

    /// Distance of a point from a quadrilateral where that is nearest to a foot, m.
    fn distance(&self, rows: &[Row<R>], point: Vec3<R>, foot: &Foot<R>) -> f64 {
        let shape = self.shape(foot.quad);
        let [xi, eta] = shape.inside(foot.at);
        let [x0, x1, x2, x3] = shape.modes(&self.corners(rows, foot.quad));
        let away = point - (x0 + x1 * xi + (x2 + x3 * xi) * eta);
        away.norm_squared().re().sqrt()
    }

    /// Point of a quadrilateral's middle surface whose interpolated normal leads to `point`.
    #[inline(always)]
    fn foot<F: FnMut(usize) -> Vec3<R>>(
        &self,
        rows: &[Row<R>],
        point: Vec3<R>,
        quad: u32,
        start: [R; 2],
        normal: &mut F,
    ) -> Foot<R> {
        let normals = self.quads[quad as usize].map(|n| normal(n as usize));
        let shape = self.shape(quad);
        let ([x0, x1, x2, x3], [n0, n1, n2, n3]) =
            (shape.modes(&self.corners(rows, quad)), shape.modes(&normals));
        let mut at = start;
        let mut height = dot(point - x0, n0);
        let mut excess = f64::INFINITY;
        for _ in 0..MOST_STEPS {
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
            let step = (at[0] - xi).re().abs().max((at[1] - eta).re().abs());
            if step < shape.last_step() {
                excess = shape.excess(at);
                break;
            }
        }
        let [xi, eta] = at;
        Foot { quad, at, height, normal: n0 + n1 * xi + (n2 + n3 * xi) * eta, excess }
    }

    /// The projection with its foot in a quadrilateral.
    #[inline(always)]
    fn project(&self, foot: &Foot<R>) -> Projection<R> {
        let &Foot { quad, at, height, normal, .. } = foot;
        let size = dot(normal, normal).sqrt();
        let weights = self.shape(quad).weights(at);
        let mut offset = R::zero();
        for (node, &weight) in self.quads[quad as usize].into_iter().zip(&weights) {
            offset += weight * self.offsets[node as usize];
        }
        Projection { quad, at, gap: height * size - offset, normal: normal * size.recip(), weights }
    }
}

/// Point of a quadrilateral's middle surface from which its interpolated normal leads to a point.
#[derive(Clone, Copy)]
struct Foot<R> {
    quad: u32,
    at: [R; 2],
    /// Distance in lengths of the normal, m.
    height: R,
    /// Normal, as interpolated between nodes.
    normal: Vec3<R>,
    /// How far it lies outside the quadrilateral, in reference coordinates; infinite if there is no such point.
    excess: f64,
}

#[inline(always)]
fn limited<R: Real>(c: R) -> R {
    c.min(R::from_f64(LIMIT)).max(R::from_f64(-LIMIT))
}
