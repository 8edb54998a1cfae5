//! What no head can be made of.

use super::{DeformableHead, ShellHead};
use crate::element::Kernels;
use crate::error::FemError;
use crate::mesh::convexity;
use clubface_math::Vec3;
use std::collections::HashMap;

/// Largest size of a head, m: beyond it the unit of length is likely to be another.
const SIZES: (f64, f64) = (0.02, 0.4);
/// Walls, m.
const WALLS: (f64, f64) = (2e-4, 0.02);

impl<R: Kernels> ShellHead<R> {
    /// Checks the mesh, its thickness and its metals.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first element, node or value that is not allowed.
    pub(super) fn check_shells(&self) -> Result<(), FemError> {
        for part in &self.parts {
            part.material.check(&part.name)?;
            for element in part.elements.clone() {
                let t = self.shells.thickness[element].re();
                if !(WALLS.0..=WALLS.1).contains(&t) {
                    let name = format!("thickness of {}", part.name);
                    let value = format!("{} mm in element {element}", t * 1e3);
                    return Err(FemError::input(name, value, "0.2 to 20 mm is allowed"));
                }
                self.check_shape(element, &part.name)?;
            }
        }
        if !self.parts.iter().any(|part| part.face && !part.elements.is_empty()) {
            return Err(FemError::input(
                "face",
                "no elements",
                "at least one element must be the ball's to touch",
            ));
        }
        self.check_size()?;
        self.check_sides()?;
        self.check_face()?;
        self.check_connected()
    }

    /// An element is convex, and no corner is repeated.
    fn check_shape(&self, element: usize, part: &str) -> Result<(), FemError> {
        let least = convexity(self.shells.quads[element].map(|n| self.shells.nodes[n as usize]));
        if least > 0.02 && least.is_finite() {
            return Ok(());
        }
        let allowed = "its corners must go round once and make no angle of 180 degrees or more; \
                       mend or refine the mesh there";
        Err(FemError::input(format!("element {element} of {part}"), "inverted or degenerate", allowed))
    }

    fn check_size(&self) -> Result<(), FemError> {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for node in &self.shells.nodes {
            for (axis, x) in node.array().into_iter().enumerate() {
                (low[axis], high[axis]) = (low[axis].min(x), high[axis].max(x));
            }
        }
        let size = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        if (SIZES.0..=SIZES.1).contains(&size) {
            return Ok(());
        }
        let value = format!("{:.3} m across", size);
        let allowed = "20 to 400 mm is allowed; is the unit of length right?";
        Err(FemError::input("size of the head", value, allowed))
    }

    /// Every side of an element belongs to one more at most, which runs through it the other way.
    fn check_sides(&self) -> Result<(), FemError> {
        let mut sides = HashMap::new();
        for (element, quad) in self.shells.quads.iter().enumerate() {
            for k in 0..4 {
                let side = (quad[k], quad[(k + 1) % 4]);
                if let Some(other) = sides.insert(side, element) {
                    let allowed =
                        "neighbours must run through their common side in opposite directions (all normals \
                                   outwards), and no more than two may share it";
                    let value = format!("elements {other} and {element}");
                    return Err(FemError::input("side of two elements", value, allowed));
                }
            }
        }
        Ok(())
    }

    /// All nodes hang together.
    fn check_connected(&self) -> Result<(), FemError> {
        let count = self.shells.nodes.len();
        let mut root: Vec<usize> = (0..count).collect();
        fn find(root: &mut [usize], mut n: usize) -> usize {
            while root[n] != n {
                root[n] = root[root[n]];
                n = root[n];
            }
            n
        }
        for quad in &self.shells.quads {
            let first = find(&mut root, quad[0] as usize);
            for &corner in &quad[1..] {
                let other = find(&mut root, corner as usize);
                root[other] = first;
            }
        }
        let whole = find(&mut root, self.shells.quads[0][0] as usize);
        let apart = (0..count).find(|&n| find(&mut root, n) != whole);
        apart.map_or(Ok(()), |n| {
            let Vec3 { x, y, z } = self.shells.nodes[n] * 1e3;
            let value = format!("node {n} at ({x:.1}, {y:.1}, {z:.1}) mm hangs on no other part");
            Err(FemError::input("mesh of the head", value, "it must be in one piece: merge coincident nodes"))
        })
    }
}
