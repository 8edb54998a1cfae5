//! Meshes of four-node shells.

use clubface_math::{Real, Vec3};
use std::ops::Range;

/// Least rotary inertia of a node over its mass and the element's area. In thin shells it replaces the section's own
/// `t^2 / 12`, so that transverse shear does not govern the stable step (Hughes, Cohen and Haroun, Nucl. Eng. Des. 46,
/// 1978).
pub const ROTARY: f64 = 0.125;

/// Quadrilaterals with thickness: the middle surface of a thin body.
#[derive(Clone, Debug)]
pub struct ShellMesh<R> {
    /// Node positions, m.
    pub nodes: Vec<Vec3<f64>>,
    /// Corner nodes of each element, counterclockwise seen from outside.
    pub quads: Vec<[u32; 4]>,
    /// Thickness of each element, m.
    pub thickness: Vec<R>,
}

/// How far a quadrilateral is from folding: the smallest of the triangles at its corners over half its area. This is 1
/// for a parallelogram and 0 with an angle of 180 degrees.
#[inline]
pub(super) fn convexity([a, b, c, d]: [Vec3<f64>; 4]) -> f64 {
    let out = (c - a).cross(d - b);
    let corners = [(d, a, b), (a, b, c), (b, c, d), (c, d, a)];
    let triangles = corners.map(|(before, at, after)| (at - before).cross(after - at).dot(out));
    triangles.into_iter().fold(f64::INFINITY, f64::min) / out.norm_squared()
}

/// Masses of the nodes of a shell mesh.
#[derive(Clone, Debug)]
pub struct ShellMasses<R> {
    /// Masses, kg.
    pub translation: Vec<R>,
    /// Rotary inertias, kg m2.
    pub rotation: Vec<R>,
}

impl<R: Real> ShellMesh<R> {
    /// Vector of the area of an element along its outward normal, m2.
    #[must_use]
    pub fn area_vector(&self, element: usize) -> Vec3<f64> {
        let [a, b, c, d] = self.quads[element].map(|n| self.nodes[n as usize]);
        (c - a).cross(d - b) * 0.5
    }
    /// Area of an element, m2.
    #[must_use]
    pub fn area(&self, element: usize) -> f64 {
        self.area_vector(element).norm()
    }
    /// Masses of the nodes, each with a quarter of the mass of its elements, given the density (kg/m3) of ranges of
    /// elements.
    pub fn masses(&self, densities: impl Iterator<Item = (Range<usize>, R)>) -> ShellMasses<R> {
        let mut masses = ShellMasses {
            translation: vec![R::zero(); self.nodes.len()],
            rotation: vec![R::zero(); self.nodes.len()],
        };
        for (element, density) in densities.flat_map(|(range, density)| range.map(move |e| (e, density))) {
            let (quad, t, area) = (&self.quads[element], self.thickness[element], self.area(element));
            let mass = density * t * (area * 0.25);
            let gyration = (t * t * (1.0 / 12.0)).max(R::from_f64(area * ROTARY));
            for &node in quad {
                masses.translation[node as usize] += mass;
                masses.rotation[node as usize] += mass * gyration;
            }
        }
        masses
    }
}
