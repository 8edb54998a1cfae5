//! Where the surface of one part lies on that of another whose nodes are not the same.

use clubface_math::Vec3;
use std::collections::BTreeMap;

/// A node on a triangle of another part.
#[derive(Clone, Copy, Debug)]
pub struct BondedNode {
    /// The node.
    pub node: u32,
    /// Part of the bonded surface that belongs to it, m2.
    pub area: f64,
    /// Number of the triangle.
    pub triangle: usize,
    /// Weights of its corners at the nearest point.
    pub weights: [f64; 3],
    /// The nearest point, m.
    pub place: Vec3<f64>,
}

/// Nodes of a surface of triangles that lie on another one, given the places of all nodes (m): those of triangles all
/// of whose corners are at most `within` (m) away from it.
#[must_use]
pub fn bonded_nodes(
    nodes: &[Vec3<f64>],
    surface: &[[u32; 3]],
    other: &[[u32; 3]],
    within: f64,
) -> Vec<BondedNode> {
    let corners = |triangle: &[u32; 3]| triangle.map(|n| nodes[n as usize]);
    let targets: Vec<_> = other.iter().map(corners).collect();
    let balls: Vec<_> = targets.iter().map(enclosing).collect();
    let nearest = |point: Vec3<f64>| {
        let mut best = (within, None);
        for (number, (target, (centre, radius))) in targets.iter().zip(&balls).enumerate() {
            if (point - *centre).norm() > radius + best.0 {
                continue;
            }
            let weights = nearest_weights(point, target);
            let place = combined(target, weights);
            let distance = (point - place).norm();
            if distance <= best.0 {
                best = (distance, Some((number, weights, place)));
            }
        }
        best.1
    };
    let mut near = BTreeMap::new();
    for &node in surface.as_flattened() {
        near.entry(node).or_insert_with(|| nearest(nodes[node as usize]));
    }
    let mut areas = BTreeMap::new();
    for triangle in surface.iter().filter(|triangle| triangle.iter().all(|node| near[node].is_some())) {
        let [a, b, c] = corners(triangle);
        for &node in triangle {
            *areas.entry(node).or_insert(0.0) += (b - a).cross(c - a).norm() / 6.0;
        }
    }
    let bonded = |(node, area)| {
        let (triangle, weights, place) = near[&node]?;
        Some(BondedNode { node, area, triangle, weights, place })
    };
    areas.into_iter().filter_map(bonded).collect()
}

/// A ball that holds a triangle: its middle and radius.
fn enclosing(corners: &[Vec3<f64>; 3]) -> (Vec3<f64>, f64) {
    let middle = combined(corners, [1.0 / 3.0; 3]);
    (middle, corners.iter().map(|corner| (*corner - middle).norm()).fold(0.0, f64::max))
}

fn combined(corners: &[Vec3<f64>; 3], weights: [f64; 3]) -> Vec3<f64> {
    corners.iter().zip(weights).fold(Vec3::zero(), |sum, (corner, weight)| sum + *corner * weight)
}

/// Weights of the corners of a triangle at its point nearest to `point`.
fn nearest_weights(point: Vec3<f64>, corners: &[Vec3<f64>; 3]) -> [f64; 3] {
    let [a, b, c] = *corners;
    let normal = (b - a).cross(c - a);
    let size = normal.norm_squared();
    // Areas of the triangles that the point makes with the sides.
    let weights =
        [(b, c), (c, a), (a, b)].map(|(one, two)| (one - point).cross(two - point).dot(normal) / size);
    if weights.iter().all(|weight| *weight >= 0.0) {
        return weights;
    }
    let on_side = |from: usize| {
        let to = (from + 1) % 3;
        let along = corners[to] - corners[from];
        let share = ((point - corners[from]).dot(along) / along.norm_squared()).clamp(0.0, 1.0);
        let mut weights = [0.0; 3];
        (weights[from], weights[to]) = (1.0 - share, share);
        weights
    };
    let away = |weights: &[f64; 3]| (point - combined(corners, *weights)).norm_squared();
    let sides = [0, 1, 2].map(on_side);
    sides.into_iter().min_by(|one, other| away(one).total_cmp(&away(other))).unwrap_or([1.0, 0.0, 0.0])
}
