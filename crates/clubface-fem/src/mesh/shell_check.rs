//! Checks of a shell mesh.

use super::ShellMesh;
use super::shell_mesh::convexity;
use crate::error::FemError;
use clubface_math::{Real, Vec3};
use std::collections::HashMap;

/// Smallest and largest size of a head, m. Beyond them the unit of length is probably another.
const SIZES: (f64, f64) = (0.02, 0.4);
/// Smallest and largest thickness of a wall, m.
const WALLS: (f64, f64) = (2e-4, 0.02);
/// Smallest convexity of an element.
const CONVEXITY: f64 = 0.02;

/// Checks the thickness of a wall, m. `name` says which it is, and `place` where.
///
/// # Errors
/// [`FemError::Input`] for a wall that is too thin or too thick.
pub fn check_wall(name: &str, thickness: f64, place: &str) -> Result<(), FemError> {
    if (WALLS.0..=WALLS.1).contains(&thickness) {
        return Ok(());
    }
    Err(FemError::input(name, format!("{} mm{place}", thickness * 1e3), "it must be 0.2 to 20 mm"))
}

impl<R: Real> ShellMesh<R> {
    /// Checks that an element of a part is convex, and that no corner is repeated.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the element.
    pub fn check_shape(&self, element: usize, part: &str) -> Result<(), FemError> {
        let least = convexity(self.quads[element].map(|n| self.nodes[n as usize]));
        if least > CONVEXITY && least.is_finite() {
            return Ok(());
        }
        let allowed = "its corners must be in order and make angles below 180 degrees; \
                       correct or refine the mesh there";
        Err(FemError::input(format!("element {element} of {part}"), "inverted or degenerate", allowed))
    }

    /// Checks the size of the mesh.
    ///
    /// # Errors
    /// [`FemError::Input`] with the size.
    pub fn check_size(&self) -> Result<(), FemError> {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for node in &self.nodes {
            for (axis, x) in node.array().into_iter().enumerate() {
                (low[axis], high[axis]) = (low[axis].min(x), high[axis].max(x));
            }
        }
        let size = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        if (SIZES.0..=SIZES.1).contains(&size) {
            return Ok(());
        }
        let value = format!("{size:.3} m across");
        let allowed = "it must be 20 to 400 mm; is the unit of length right?";
        Err(FemError::input("size of the head", value, allowed))
    }

    /// Checks that every edge belongs to two elements at most, which go through it in opposite directions.
    ///
    /// # Errors
    /// [`FemError::Input`] that names two elements.
    pub fn check_edges(&self) -> Result<(), FemError> {
        let mut edges = HashMap::new();
        for (element, quad) in self.quads.iter().enumerate() {
            for k in 0..4 {
                let edge = (quad[k], quad[(k + 1) % 4]);
                if let Some(other) = edges.insert(edge, element) {
                    let name = format!("edge of elements {other} and {element}");
                    let allowed = "an edge belongs to two elements at most, which list its nodes in opposite order \
                                   so that all normals point outwards";
                    return Err(FemError::input(name, "used twice in the same direction", allowed));
                }
            }
        }
        Ok(())
    }

    /// Checks that all nodes are connected.
    ///
    /// # Errors
    /// [`FemError::Input`] that names a node.
    pub fn check_connected(&self) -> Result<(), FemError> {
        check_connected(&self.nodes, self.quads.iter().map(<[u32; 4]>::as_slice))
    }
}

/// Checks that all nodes are connected by groups of them, such as elements.
///
/// # Errors
/// [`FemError::Input`] that names a node.
pub fn check_connected<'a>(
    nodes: &[Vec3<f64>],
    groups: impl Iterator<Item = &'a [u32]>,
) -> Result<(), FemError> {
    let mut root: Vec<usize> = (0..nodes.len()).collect();
    fn find(root: &mut [usize], mut n: usize) -> usize {
        while root[n] != n {
            root[n] = root[root[n]];
            n = root[n];
        }
        n
    }
    for group in groups {
        let first = find(&mut root, group[0] as usize);
        for &node in &group[1..] {
            let other = find(&mut root, node as usize);
            root[other] = first;
        }
    }
    let whole = find(&mut root, 0);
    let apart = (0..nodes.len()).find(|&n| find(&mut root, n) != whole);
    apart.map_or(Ok(()), |n| {
        let Vec3 { x, y, z } = nodes[n] * 1e3;
        let value = format!("node {n} at ({x:.1}, {y:.1}, {z:.1}) mm, which is connected to no other part");
        Err(FemError::input("mesh of the head", value, "it must be in one piece; merge coincident nodes"))
    })
}
