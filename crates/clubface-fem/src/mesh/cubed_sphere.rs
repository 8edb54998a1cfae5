//! The mesh of a ball: a cube of hexahedra inside, six blocks of layers around it out to the sphere.

use super::{CORNERS, SolidMesh};
use clubface_math::{Scalar, Vec3};
use std::collections::HashMap;

/// How fine the mesh of a ball is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fineness {
    /// Elements along each edge of the inner cube.
    pub cube: usize,
    /// Element layers between the cube and the boundary of the innermost piece, then of each further piece.
    pub layers: Vec<usize>,
}

/// Half edge of the inner cube over the radius of the innermost piece.
const CUBE: f64 = 0.48;
/// How far the cube is swollen towards a sphere: 0 is a cube.
const SWELL: f64 = 0.35;

/// A ball about the origin, made of pieces with the given outer radii (m), innermost first.
#[must_use]
pub fn cubed_sphere<R: Scalar>(radii: &[R], fineness: &Fineness) -> SolidMesh<R> {
    let n = fineness.cube;
    let mut builder = Builder { n, nodes: Vec::new(), index: HashMap::new() };
    let mut mesh = SolidMesh { nodes: Vec::new(), elements: Vec::new(), layer: Vec::new() };
    let core = radii[0];
    for k in 0..n {
        for j in 0..n {
            for i in 0..n {
                let mut element = [0; CORNERS];
                for corner in 0..CORNERS {
                    let at = [i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2 & 1)];
                    element[corner] = builder.node(at, 0, |q| scaled(inner(q), core));
                }
                mesh.elements.push(element);
                mesh.layer.push(0);
            }
        }
    }
    let mut depth = 0;
    let mut from = None;
    for (piece, (&radius, &count)) in radii.iter().zip(&fineness.layers).enumerate() {
        // Side by side, so that the elements of each make a lattice.
        for side in 0..6 {
            for layer in 0..count {
                for v in 0..n {
                    for u in 0..n {
                        let mut element = [0; CORNERS];
                        for corner in 0..CORNERS {
                            // The third coordinate runs outward; on the low sides the first two are exchanged, to keep
                            // the map right-handed.
                            let level = depth + layer + (corner >> 2);
                            let fraction = (layer + (corner >> 2)) as f64 / count as f64;
                            let at = on_side(side, u + (corner & 1), v + (corner >> 1 & 1), n);
                            element[corner] = builder.node(at, level, |q| {
                                let start =
                                    from.map_or_else(|| scaled(inner(q), core), |r| scaled(outer(q), r));
                                start * R::from_f64(1.0 - fraction) + scaled(outer(q), radius * fraction)
                            });
                        }
                        mesh.elements.push(element);
                        mesh.layer.push(piece as u32);
                    }
                }
            }
        }
        depth += count;
        from = Some(radius);
    }
    mesh.nodes = builder.nodes;
    mesh
}

struct Builder<R> {
    n: usize,
    nodes: Vec<Vec3<R>>,
    /// Nodes by lattice point of the cube and level outside it.
    index: HashMap<([usize; 3], usize), u32>,
}

impl<R: Scalar> Builder<R> {
    fn node(&mut self, at: [usize; 3], level: usize, position: impl Fn([f64; 3]) -> Vec3<R>) -> u32 {
        let n = self.n;
        let nodes = &mut self.nodes;
        *self.index.entry((at, level)).or_insert_with(|| {
            // Exactly opposite on opposite sides.
            nodes.push(position(at.map(|i| (2.0 * i as f64 - n as f64) / n as f64)));
            (nodes.len() - 1) as u32
        })
    }
}

/// Lattice point (u, v) of one of the cube's six sides.
fn on_side(side: usize, u: usize, v: usize, n: usize) -> [usize; 3] {
    let axis = side / 2;
    let high = side % 2 == 1;
    let (a, b) = if high { (u, v) } else { (v, u) };
    let mut at = [0; 3];
    at[axis] = if high { n } else { 0 };
    at[(axis + 1) % 3] = a;
    at[(axis + 2) % 3] = b;
    at
}

/// Point of the swollen cube, in units of the innermost piece's radius.
fn inner(q: [f64; 3]) -> Vec3<f64> {
    let t = q.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
    if t == 0.0 {
        return Vec3::zero();
    }
    let flat = Vec3::from_f64(q) * CUBE;
    let round = outer(q.map(|c| c / t)) * (CUBE * t * 1.25);
    let fraction = SWELL * t;
    flat * (1.0 - fraction) + round * fraction
}

/// Point of the unit sphere for a point of the cube's surface, equal angles apart.
fn outer(q: [f64; 3]) -> Vec3<f64> {
    let p = q.map(|c| (c * std::f64::consts::FRAC_PI_4).tan());
    // In the order of their size, so that sides differ by a rotation to the last bit: their elements then share their
    // constants.
    let mut squares = p.map(|c| c * c);
    squares.sort_by(f64::total_cmp);
    Vec3::from_f64(p) * (1.0 / squares.iter().sum::<f64>().sqrt())
}

/// A point in units of a radius.
fn scaled<R: Scalar>(point: Vec3<f64>, radius: R) -> Vec3<R> {
    Vec3::new(radius * point.x, radius * point.y, radius * point.z)
}
